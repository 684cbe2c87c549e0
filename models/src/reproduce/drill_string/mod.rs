//! Thesis chapter 4: a drill string in torsion.

mod errors;
mod tables;

use stickslip::field::Kernel;
use stickslip::report::{Axis, Curve, Figure, Marker, Panel, Section};
use stickslip::study::{Dynamics, EquilibriaRecord};

use errors::{THESIS, figure_5, figure_9};
use tables::{ends, values};

use super::ReproduceError;
use super::ask::Subject;
use super::copies::{Copies, copy};
use super::cost::Cost;
use super::equilibrium::{draw, hopf};
use super::errors::Measured;
use super::words::power;
use crate::DrillString;

/// The smoothings are of size 10ⁱ.
const EXPONENTS: [i32; 5] = [0, -1, -2, -3, -4];
/// Where the branches begin.
const SPEED: f64 = 4.0;
/// Where they shall end: near 0 the sticking phase, and with it the period, grows without bound.
const LEAST: f64 = 0.02;
const MOST: f64 = 8.0;
/// The speeds between which the equilibrium is drawn; at 0 itself the table stands still.
const REST: [f64; 2] = [5.0, 1e-3];

/// The section on the drill string.
pub(super) fn section(costs: &mut Vec<Cost>) -> Result<Section, ReproduceError> {
    let drill = Subject::new(DrillString::eta);
    let sizes = (Kernel::Quartic, &EXPONENTS[..], "");
    let copies = Copies::find(&drill, sizes, (SPEED, &[LEAST, MOST]))?;
    costs.extend(copies.costs("drill string", "*η*", "6 min, both"));
    let errors = Measured::measure(&drill, &THESIS)?;
    let rest = drill.equilibria(copy(Kernel::Quartic, 0), REST)?;
    Ok(Section::new("A drill string")
        .sketch(
            include_str!("../sketches/drill_string.svg"),
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
        .figure(figure_3(&drill))
        .figure(figure_4(&copies))
        .figure(figure_5(&errors))
        .figure(figure_6(&drill, &rest)?)
        .figure(figure_7(&copies))
        .figure(figure_8(&copies))
        .figure(figure_9(&errors))
        .table(errors::table(&errors))
        .table(ends(&copies))
        .text(
            "In a fold the stable cycle meets an unstable one that comes to rest for a moment but does not stick. The \
             smaller *ε*, the sharper the fold, until it is sharper than double precision: path following then stops in \
             front of it, within a thousandth of where the cycle ends.",
        )
        .table(values(&copies, &rest)))
}

fn figure_3(drill: &Subject) -> Figure {
    let DrillString {
        eta,
        theta,
        kinetic,
        ..
    } = DrillString::default();
    let exact = vec![[-1.0, 0.0], [eta, 0.0], [eta, theta], [eta, -4.0]];
    let copies = [0, -1].into_iter().enumerate().map(|(i, exponent)| {
        let friction = copy(Kernel::Quartic, exponent);
        let most = eta + 0.3 * 10f64.powi(exponent);
        let rates = (0..=600).map(|k| -1.0 + (most + 1.0) * f64::from(k) / 600.0);
        let points = rates.map(|omega| [omega, drill.force(friction, eta - omega) - kinetic]);
        Curve::line(
            format!("*ε* = {}", power(exponent)),
            i + 1,
            points.collect(),
        )
    });
    let panel = Panel::new(
        Axis::new("twist rate *ψ*′").from(-1.0, 5.0),
        Axis::new("friction term *T*_{c}").from(-4.0, 6.0),
    )
    .curve(Curve::line("exact, *η* = 4", 0, exact))
    .curves(copies);
    Figure::new(
        "4.3",
        "Friction term *T*_{c} and its smooth copies",
        "While the bit turns (*ψ*′ < *η*) the term is zero; where it sticks (*ψ*′ = *η*) the term takes any value up to \
         *θ* = 4.2. The copy climbs to the same peak at *ψ*′ = *η* − *ε* by a polynomial of fourth degree that begins \
         at *η* − 4*ε*. It stands for forward motion only.",
    )
    .panel(panel)
}

fn figure_4(copies: &Copies) -> Figure {
    let panel = Panel::new(Axis::new("twist *ψ*"), Axis::new("twist rate *ψ*′"))
        .curves(copies.planes())
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

fn figure_6(drill: &Subject, rest: &EquilibriaRecord) -> Result<Figure, ReproduceError> {
    let exact = drill.equilibria(Dynamics::Exact, REST)?;
    let [first, second] = hopf(rest);
    let axes = Panel::new(
        Axis::new("speed of the rotary table *η*").from(0.0, REST[0]),
        Axis::new("equilibrium *ψ*_{eq}").from(-0.5, 5.0),
    );
    Ok(Figure::new(
        "4.6",
        "Equilibrium of the copy *ε* = 1",
        format!(
            "Steady drilling, *ψ* = 0, is stable in the real system at every speed of the table. The copy lets friction \
             rise at speeds below 4*ε* already: its steady twist is off, and unstable between *η*_{{bif,2}} = {second:.4} \
             and *η*_{{bif,1}} = {first:.4} (thesis: 1.018 and 3.759). Both points are artefacts of smoothing."
        ),
    )
    .panel(draw(
        axes,
        (rest, "Hopf points: artefacts of smoothing"),
        (&exact, "exact, stable at every speed"),
    )))
}

fn table_speed() -> Axis {
    Axis::new("speed of the rotary table *η*").from(0.0, MOST)
}

fn figure_7(copies: &Copies) -> Figure {
    let end: Vec<[f64; 2]> = copies.exact.amplitudes().pop().into_iter().collect();
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
            .curves(copies.amplitudes())
            .curve(Curve::points("end by grazing", 0, Marker::Diamond, end)),
    )
}

fn figure_8(copies: &Copies) -> Figure {
    Figure::new(
        "4.8",
        "Free frequency",
        "The slower the table, the longer the bit sticks, and the frequency falls to 0. At high speed it approaches the \
         natural frequency, 1/2π ≈ 0.159.",
    )
    .panel(
        Panel::new(table_speed(), Axis::new("frequency *f*").from(0.0, 0.2))
            .curves(copies.frequencies()),
    )
}
