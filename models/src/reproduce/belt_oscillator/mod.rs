//! Thesis section 3.2: one mass on a moving belt.

mod errors;
mod tables;

use stickslip::field::Kernel;
use stickslip::report::{Axis, Curve, Figure, Marker, Panel, Section};
use stickslip::study::{Dynamics, EquilibriaRecord};

use errors::{THESIS, figure_7, figure_11};
use tables::{ends, values};

use super::ReproduceError;
use super::ask::Subject;
use super::copies::{Copies, copy};
use super::cost::Cost;
use super::equilibrium::{draw, hopf};
use super::errors::Measured;
use super::words::power;
use crate::BeltOscillator;

/// The smoothings are of size 10ⁱ.
const EXPONENTS: [i32; 6] = [2, 3, 4, 5, 6, 7];
/// Where the branches begin.
const SPEED: f64 = 0.2;
/// Where they shall end: near 0 the sticking phase, and with it the period, grows without bound.
const LEAST: f64 = 0.002;

/// The section on the belt oscillator.
pub(super) fn section(costs: &mut Vec<Cost>) -> Result<Section, ReproduceError> {
    let belt = Subject::new(BeltOscillator::v_dr);
    let sizes = (Kernel::Arctan, &EXPONENTS[..], " s/m");
    let copies = Copies::find(&belt, sizes, (SPEED, &[LEAST]))?;
    costs.extend(copies.costs("mass on a belt", "*v*_{dr}", "10 min"));
    let errors = Measured::measure(&belt, &THESIS)?;
    let rests = rests(&belt)?;
    Ok(Section::new("One mass on a belt")
        .sketch(
            include_str!("../sketches/belt_oscillator.svg"),
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
        .figure(figure_5(&belt))
        .figure(figure_6(&copies))
        .figure(figure_7(&errors))
        .figure(figure_8(&belt, &rests[0])?)
        .figure(figure_9(&copies))
        .figure(figure_10(&copies))
        .figure(figure_11(&errors))
        .table(errors::table(&errors))
        .table(ends(&copies, &rests))
        .text(
            "Close to *v*_{bif} the cycle does not simply shrink: it first creeps along the falling, unstable stretch of \
             the smoothed friction curve, and changes much while *v*_{dr} hardly changes at all (a *canard*). Shooting \
             loses its digits there, wherever on the orbit it begins; for *ε* = 10^{4} it does not reach the end.",
        )
        .table(values(&copies)))
}

/// The equilibria of all copies along the speed of the belt.
fn rests(belt: &Subject) -> Result<Vec<EquilibriaRecord>, ReproduceError> {
    let rest = |&exponent: &i32| belt.equilibria(copy(Kernel::Arctan, exponent), [SPEED, 0.0]);
    EXPONENTS.iter().map(rest).collect()
}

fn figure_5(belt: &Subject) -> Figure {
    Figure::new(
        "3.5",
        "Friction force *F* and its smooth copies",
        "Left: friction pushes against the direction of sliding, and weakens with speed; at rest it takes any value \
         between −1 N and 1 N. Right: the same near rest. The larger *ε*, the closer the copy; but its peak is always \
         lower than the limit at rest, and its slope there, −(2/π) *ε* *F*_{s}, is what makes the equations stiff.",
    )
    .columns(2)
    .panel(forces(belt, 1.0))
    .panel(forces(belt, 0.05))
}

/// Forces at sliding speeds up to `most` either way, dense where the copies are steep.
fn forces(belt: &Subject, most: f64) -> Panel {
    let curve = |label: &str, series, dynamics| {
        let steps = (-300..=300).filter(|i| *i != 0);
        let speeds = steps.map(|i| most * (f64::from(i) / 300.0).powi(3));
        let points = speeds.map(|w| [w, -belt.force(dynamics, w)]);
        Curve::line(label, series, points.collect())
    };
    let axes = Panel::new(
        Axis::new("sliding speed *v*_{rel} (m/s)").from(-most, most),
        Axis::new("friction force *F* (N)").from(-1.2, 1.2),
    );
    let copies = [2, 3, 4].into_iter().enumerate().map(|(i, exponent)| {
        let label = format!("*ε* = {} s/m", power(exponent));
        curve(&label, i + 1, copy(Kernel::Arctan, exponent))
    });
    axes.curve(curve("exact", 0, Dynamics::Exact))
        .curves(copies)
}

fn figure_6(copies: &Copies) -> Figure {
    let panel = Panel::new(
        Axis::new("displacement *x* (m)"),
        Axis::new("velocity *x*′ (m/s)"),
    )
    .curves(copies.planes())
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

fn figure_8(belt: &Subject, rest: &EquilibriaRecord) -> Result<Figure, ReproduceError> {
    let exact = belt.equilibria(Dynamics::Exact, [SPEED, 0.0])?;
    let [v_bif] = hopf(rest);
    let axes = Panel::new(
        belt_speed(),
        Axis::new("equilibrium *x*_{eq} (m)").from(0.0, 1.0),
    );
    Ok(Figure::new(
        "3.8",
        "Equilibrium of the copy *ε* = 10^{2}",
        format!(
            "The mass can rest where the spring balances friction. At every speed of the belt this rest is unstable in \
             the real system, because friction weakens as the belt slides faster. Near zero speed the copy's friction \
             rises instead, as it leads through zero; there its rest is stable. The change at *v*_{{bif}} = {v_bif:.4} m/s \
             (thesis: 0.052) is an artefact of smoothing, and so is the copy's silence below it."
        ),
    )
    .panel(draw(
        axes,
        (rest, "Hopf point: an artefact of smoothing"),
        (&exact, "exact, unstable at every speed"),
    )))
}

fn belt_speed() -> Axis {
    Axis::new("belt speed *v*_{dr} (m/s)").from(0.0, SPEED)
}

fn figure_9(copies: &Copies) -> Figure {
    Figure::new(
        "3.9",
        "Absolute maximum of *x*",
        "As the belt slows down, the mass should turn at *x* = *F*_{s}/*k* = 1 m, where the spring overcomes friction: \
         the copies come the closer the larger *ε* is. Each loses its cycle at a belt speed of its own, where the \
         curve plunges to the displacement of the equilibrium; the real system keeps vibrating at every speed.",
    )
    .panel(
        Panel::new(belt_speed(), Axis::new("max |*x*| (m)")).curves(copies.amplitudes()),
    )
}

fn figure_10(copies: &Copies) -> Figure {
    Figure::new(
        "3.10",
        "Free frequency",
        "The slower the belt, the longer the mass sticks, and the frequency should fall to 0. Where a copy loses its \
         cycle, the frequency instead returns to that of the mass on its spring, 1/2π ≈ 0.159 Hz.",
    )
    .panel(
        Panel::new(belt_speed(), Axis::new("frequency *f* (Hz)").from(0.0, 0.2))
            .curves(copies.frequencies()),
    )
}
