//! Thesis chapter 4: a drill string in torsion.

mod equilibrium;
mod errors;
mod law;
mod tables;

use stickslip::field::Kernel;
use stickslip::report::{Axis, Curve, Figure, Marker, Panel, Section};
use stickslip::shooting::Orbit;

use equilibrium::figure_6;
use errors::{figure_5, figure_9};
use law::figure_3;
use tables::{ends, values};

use super::ReproduceError;
use super::cost::Cost;
use super::exact::{self, Exact};
use super::follow::{Drawn, Followed, draw, family, follow, search};
use super::words::power;
use crate::DrillString;
use stickslip::study::parallel;

/// The smoothings are of size 10ⁱ.
const EXPONENTS: [i32; 5] = [0, -1, -2, -3, -4];
/// Where the branches begin.
const SPEED: f64 = 4.0;
/// Where they shall end: near 0 the sticking phase, and with it the period, grows without bound.
const LEAST: f64 = 0.02;
const MOST: f64 = 8.0;

/// One smooth copy: its orbit at the first speed, and its branch both ways.
struct Copy {
    exponent: i32,
    cycle: Drawn<2>,
    down: Followed<2>,
    up: Followed<2>,
}

/// The section on the drill string.
pub(super) fn section(costs: &mut Vec<Cost>) -> Result<Section, ReproduceError> {
    let copies: Vec<Copy> = parallel(&EXPONENTS, |&exponent| compute(exponent))
        .into_iter()
        .collect::<Result<_, _>>()?;
    for copy in &copies {
        let name = |way| format!("drill string, *ε* = {}, {way}", power(copy.exponent));
        costs.push(Cost::of(name("*η* falling"), &copy.down, "6 min, both"));
        costs.push(Cost::of(name("*η* rising"), &copy.up, "6 min, both"));
    }
    let exact = exact()?;
    let name = "drill string, exact, both ways".to_owned();
    let points = exact.orbits.len();
    costs.push(Cost::counted(name, points, (&exact.work, exact.time), "–"));
    let errors = errors::all()?;
    Ok(Section::new("A drill string")
        .sketch(
            include_str!("sketches/drill_string.svg"),
            "A drill string: a rotary table turns at a constant rate, a kilometre of pipe acts as a torsional spring, \
             and friction holds the bit (Fig. 4.1 of the thesis).",
        )
        .text(
            "The rotary table turns steadily; the bit sticks, the pipe winds up, the bit breaks loose and spins several \
             times as fast as the table, and sticks again. *ψ* is the twist of the pipe, measured from the twist of \
             steady drilling, in units without dimension; the bit's speed is *η* − *ψ*′, with *η* the speed of the \
             table. Friction at rest holds up to *θ* = 4.2 more than friction in motion, and the damping is *ζ* = 0.05.",
        )
        .formula("*ψ*″ + 2*ζ* *ψ*′ + *ψ* = *T*_{c},   *T*_{c} = 0 while the bit turns,   *T*_{c} ≤ *θ* while it sticks (*ψ*′ = *η*)")
        .figure(figure_3()?)
        .figure(figure_4(&copies, &exact))
        .figure(figure_5(&errors))
        .figure(figure_6()?)
        .figure(figure_7(&copies, &exact))
        .figure(figure_8(&copies, &exact))
        .figure(figure_9(&errors))
        .table(errors::table(&errors))
        .table(ends(&copies))
        .text(
            "In a fold the stable cycle meets an unstable one that comes to rest for a moment but does not stick. The \
             smaller *ε*, the sharper the fold: for *ε* ≤ 10^{−2} it is sharper than double precision, and path \
             following stops in front of it, within a thousandth of where the cycle ends.",
        )
        .table(values(&copies)?))
}

/// The drill string with its declared friction.
type ExactDrill = Exact<DrillString, 2>;

fn exact() -> Result<ExactDrill, ReproduceError> {
    let start = (SPEED, [0.0, SPEED]);
    exact::follow(
        DrillString::default(),
        DrillString::eta,
        start,
        &[LEAST, MOST],
    )
    .map_err(ReproduceError::at("drill string, exact"))
}

fn compute(exponent: i32) -> Result<Copy, ReproduceError> {
    let what = || ReproduceError::at(format!("drill string, quartic:1e{exponent}"));
    let smoothing = Some((Kernel::Quartic, 10f64.powi(exponent)));
    let family = family(DrillString::default(), DrillString::eta, smoothing);
    let cycle = draw(&family, SPEED, &search([6.0, 0.0], None)).map_err(what())?;
    let down = follow(&family, &cycle.orbit, LEAST).map_err(what())?;
    let up = follow(&family, &cycle.orbit, MOST).map_err(what())?;
    Ok(Copy {
        exponent,
        cycle,
        down,
        up,
    })
}

fn label(copy: &Copy) -> String {
    format!("*ε* = {}", power(copy.exponent))
}

fn figure_4(copies: &[Copy], exact: &ExactDrill) -> Figure {
    let cycles = copies.iter().enumerate().map(|(i, copy)| {
        let path = copy.cycle.path.iter().map(|sample| sample.state).collect();
        Curve::line(label(copy), i + 1, path)
    });
    let panel = Panel::new(Axis::new("twist *ψ*"), Axis::new("twist rate *ψ*′"))
        .curves(cycles)
        .curve(Curve::line("exact", 0, exact.path.clone()))
        .curve(Curve::points(
            "stable equilibrium",
            0,
            Marker::Cross,
            vec![[0.0, 0.0]],
        ));
    Figure::new(
        "4.4",
        "Periodic solutions at *η* = 4",
        "Along the straight top the bit stands still and the pipe winds up at the speed of the table, 4; then the bit \
         breaks loose and the twist swings back. Inside lies steady drilling, which is stable as well: which of the \
         two happens depends on the start.",
    )
    .panel(panel)
}

fn along(copies: &[Copy], of: fn(&Orbit<2, ()>) -> f64) -> impl Iterator<Item = Curve> {
    copies.iter().enumerate().map(move |(i, copy)| {
        let down = copy.down.orbits.iter().rev();
        let up = copy.up.orbits.iter().skip(1);
        let points = down.chain(up).map(|o| [o.r, of(o)]).collect();
        Curve::line(label(copy), i + 1, points)
    })
}

fn table_speed() -> Axis {
    Axis::new("speed of the rotary table *η*").from(0.0, MOST)
}

fn figure_7(copies: &[Copy], exact: &ExactDrill) -> Figure {
    let branch = exact.along(|orbit| orbit.max_abs()[0]);
    let end: Vec<[f64; 2]> = branch.last().copied().into_iter().collect();
    let last = end.first().map_or(f64::NAN, |point| point[0]);
    Figure::new(
        "4.7",
        "Absolute maximum of *ψ*",
        format!(
            "At low speed the bit breaks loose at *ψ* = *θ* − 2*ζη* → 4.2. At high speed damping keeps the bit from ever \
             coming to rest again, and the cycle ends: the exact one at *η* = {last:.5}, where the bit comes to rest for \
             an instant only (*grazing*), the copies later, the later the larger *ε*. The copy *ε* = 1 is far from the \
             real system at both ends."
        ),
    )
    .panel(
        Panel::new(table_speed(), Axis::new("max |*ψ*|"))
            .curves(along(copies, |orbit| orbit.max_abs()[0]))
            .curve(Curve::line("exact", 0, branch))
            .curve(Curve::points("end by grazing", 0, Marker::Diamond, end)),
    )
}

fn figure_8(copies: &[Copy], exact: &ExactDrill) -> Figure {
    Figure::new(
        "4.8",
        "Free frequency",
        "The slower the table, the longer the bit sticks, and the frequency falls to 0. At high speed it approaches the \
         natural frequency, 1/2π ≈ 0.159.",
    )
    .panel(
        Panel::new(table_speed(), Axis::new("frequency *f*").from(0.0, 0.2))
            .curves(along(copies, |orbit| 1.0 / orbit.period))
            .curve(Curve::line(
                "exact",
                0,
                exact.along(|orbit| 1.0 / orbit.period),
            )),
    )
}
