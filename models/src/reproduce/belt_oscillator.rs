//! Thesis section 3.2: one mass on a moving belt.

mod equilibrium;
mod errors;
mod law;
mod tables;

use stickslip::field::Kernel;
use stickslip::report::{Axis, Curve, Figure, Marker, Panel, Section};
use stickslip::shooting::Orbit;

use equilibrium::figure_8;
use errors::{figure_7, figure_11};
use law::figure_5;
use tables::{ends, values};

use super::ReproduceError;
use super::cost::Cost;
use super::exact::{self, Exact};
use super::follow::{Drawn, Followed, draw, family, follow, search};
use super::words::power;
use crate::BeltOscillator;
use stickslip::study::parallel;

/// The smoothings are of size 10ⁱ.
const EXPONENTS: [i32; 6] = [2, 3, 4, 5, 6, 7];
/// Where the branches begin.
const SPEED: f64 = 0.2;
/// Where they shall end: near 0 the sticking phase, and with it the period, grows without bound.
const LEAST: f64 = 0.002;

/// One smooth copy: its orbit at the first speed, and its branch.
struct Copy {
    exponent: i32,
    cycle: Drawn<2>,
    branch: Followed<2>,
}

/// The section on the belt oscillator.
pub(super) fn section(costs: &mut Vec<Cost>) -> Result<Section, ReproduceError> {
    let copies: Vec<Copy> = parallel(&EXPONENTS, |&exponent| compute(exponent))
        .into_iter()
        .collect::<Result<_, _>>()?;
    for copy in &copies {
        let name = format!("mass on a belt, *ε* = {}", power(copy.exponent));
        costs.push(Cost::of(name, &copy.branch, "10 min"));
    }
    let exact = exact()?;
    let name = "mass on a belt, exact".to_owned();
    let points = exact.orbits.len();
    costs.push(Cost::counted(name, points, (&exact.work, exact.time), "–"));
    let errors = errors::all()?;
    Ok(Section::new("One mass on a belt")
        .sketch(
            include_str!("sketches/belt_oscillator.svg"),
            "A mass on a belt that runs at constant speed, held by a spring (Fig. 3.4 of the thesis).",
        )
        .text(
            "The belt drags the mass along until the spring pulls harder than friction can hold; the mass slips back, \
             is caught by the belt and dragged along again. Friction weakens with the sliding speed *v*_{rel} = *x*′ − \
             *v*_{dr}, which feeds the vibration. Mass, stiffness and the limit of friction are 1 (kg, N/m, N), and *δ* \
             = 3 s/m.",
        )
        .formula("*m* *x*″ + *k* *x* = *F*,   *F* = − *F*_{s} sgn(*v*_{rel}) / (1 + *δ* |*v*_{rel}|) while sliding,   |*F*| ≤ *F*_{s} while sticking")
        .text(
            "The smooth copies replace sgn(*v*_{rel}) by (2/π) arctan(*ε* *v*_{rel}). They cannot stick: they creep.",
        )
        .figure(figure_5()?)
        .figure(figure_6(&copies, &exact))
        .figure(figure_7(&errors))
        .figure(figure_8()?)
        .figure(figure_9(&copies, &exact))
        .figure(figure_10(&copies, &exact))
        .figure(figure_11(&errors))
        .table(errors::table(&errors))
        .table(ends(&copies)?)
        .text(
            "Close to *v*_{bif} the cycle does not simply shrink: it first creeps along the falling, unstable stretch of \
             the smoothed friction curve, and changes much while *v*_{dr} hardly changes at all (a *canard*). Shooting \
             once around the orbit loses its digits there, and ten shorter shots take over; for *ε* = 10^{4} even these \
             do not reach the end.",
        )
        .table(values(&copies)))
}

/// The belt oscillator with its declared friction.
type ExactBelt = Exact<BeltOscillator, 2>;

fn exact() -> Result<ExactBelt, ReproduceError> {
    let start = (SPEED, [0.0, SPEED]);
    exact::follow(
        BeltOscillator::default(),
        BeltOscillator::v_dr,
        start,
        &[LEAST],
    )
    .map_err(ReproduceError::at("belt oscillator, exact"))
}

fn compute(exponent: i32) -> Result<Copy, ReproduceError> {
    let what = || ReproduceError::at(format!("belt oscillator, arctan:1e{exponent}"));
    let smoothing = Some((Kernel::Arctan, 10f64.powi(exponent)));
    let family = family(BeltOscillator::default(), BeltOscillator::v_dr, smoothing);
    let cycle = draw(&family, SPEED, &search([1.0, 0.0], None)).map_err(what())?;
    let branch = follow(&family, &cycle.orbit, LEAST).map_err(what())?;
    Ok(Copy {
        exponent,
        cycle,
        branch,
    })
}

fn label(copy: &Copy) -> String {
    format!("*ε* = {} s/m", power(copy.exponent))
}

fn figure_6(copies: &[Copy], exact: &ExactBelt) -> Figure {
    let cycles = copies.iter().enumerate().map(|(i, copy)| {
        let path = copy.cycle.path.iter().map(|sample| sample.state).collect();
        Curve::line(label(copy), i + 1, path)
    });
    let panel = Panel::new(
        Axis::new("displacement *x* (m)"),
        Axis::new("velocity *x*′ (m/s)"),
    )
    .curves(cycles)
    .curve(Curve::line("exact", 0, exact.path.clone()))
    .curve(Curve::points(
        "unstable equilibrium",
        0,
        Marker::Cross,
        vec![[0.625, 0.0]],
    ));
    Figure::new(
        "3.6",
        "Periodic solutions at *v*_{dr} = 0.2 m/s",
        "The straight top of each curve is the mass carried by the belt at 0.2 m/s, the arc below it slips. As *ε* \
         grows the curves tend to the exact one, in black: from 10^{5} on they are hard to tell from it. The smaller *ε*, the sooner the \
         mass slips, because the copy has lost the top of the friction peak.",
    )
    .panel(panel)
}

fn along(copies: &[Copy], of: fn(&Orbit<2, ()>) -> f64) -> impl Iterator<Item = Curve> {
    copies.iter().enumerate().map(move |(i, copy)| {
        let points = copy.branch.orbits.iter().map(|o| [o.r, of(o)]).collect();
        Curve::line(label(copy), i + 1, points)
    })
}

fn belt_speed() -> Axis {
    Axis::new("belt speed *v*_{dr} (m/s)").from(0.0, SPEED)
}

fn figure_9(copies: &[Copy], exact: &ExactBelt) -> Figure {
    Figure::new(
        "3.9",
        "Absolute maximum of *x*",
        "As the belt slows down, the mass should turn at *x* = *F*_{s}/*k* = 1 m, where the spring overcomes friction: \
         the copies come the closer the larger *ε* is. Each loses its cycle at a belt speed of its own, where the \
         curve plunges to the displacement of the equilibrium; the real system keeps vibrating at every speed.",
    )
    .panel(
        Panel::new(belt_speed(), Axis::new("max |*x*| (m)"))
            .curves(along(copies, |orbit| orbit.max_abs()[0]))
            .curve(Curve::line(
                "exact",
                0,
                exact.along(|orbit| orbit.max_abs()[0]),
            )),
    )
}

fn figure_10(copies: &[Copy], exact: &ExactBelt) -> Figure {
    Figure::new(
        "3.10",
        "Free frequency",
        "The slower the belt, the longer the mass sticks, and the frequency should fall to 0. Where a copy loses its \
         cycle, the frequency instead returns to that of the mass on its spring, 1/2π ≈ 0.159 Hz.",
    )
    .panel(
        Panel::new(belt_speed(), Axis::new("frequency *f* (Hz)").from(0.0, 0.2))
            .curves(along(copies, |orbit| 1.0 / orbit.period))
            .curve(Curve::line(
                "exact",
                0,
                exact.along(|orbit| 1.0 / orbit.period),
            )),
    )
}
