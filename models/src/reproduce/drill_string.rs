//! Thesis chapter 4: a drill string in torsion.

use stickslip::field::Kernel;
use stickslip::report::numerals::{decimals, power};
use stickslip::report::{Curve, Manuscript, Marker, Section};
use stickslip::study::Dynamics;

use super::ReproduceError;
use super::ask::Subject;
use super::branch::at;
use super::copies::{Copies, copy, stability};
use super::equilibrium::{drawn, hopf};
use super::errors::{Measured, Thesis, printed};
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

/// What the thesis prints of the errors of its copies.
static THESIS: Thesis = Thesis {
    kernel: Kernel::Quartic,
    size: "size of the smoothing *ε*",
    middle: -2.0,
    errors: [
        (
            "*e_{ψ}*",
            [
                printed(1.0, 0.63, 0.30, "equal but for the last digit of *a*"),
                printed(2.0, 0.55, 0.25, "flatter: larger errors at small *ε*"),
                printed(3.0, 0.54, 0.28, "flatter: larger errors at small *ε*"),
                printed(
                    4.0,
                    0.59,
                    0.30,
                    "equal; after Fig. 4.5 printed as log_{10} *b* = −0.53",
                ),
            ],
        ),
        (
            "*e_{f}*",
            [
                printed(1.0, 0.63, 0.22, "flatter: larger errors at small *ε*"),
                printed(2.0, 0.51, 0.16, "far flatter: noise of the old solver"),
                printed(3.0, 0.46, 0.093, "far flatter: noise of the old solver"),
                printed(
                    4.0,
                    0.62,
                    0.086,
                    "equal; after Fig. 4.5 printed as log_{10} *b* = −1.1",
                ),
            ],
        ),
    ],
};

/// The section on the drill string.
pub(super) fn section(costs: &mut Vec<Vec<String>>) -> Result<Section, ReproduceError> {
    let drill = Subject::new(DrillString::eta);
    let sizes = (Kernel::Quartic, &EXPONENTS[..], "");
    let copies = Copies::find(&drill, sizes, (SPEED, &[LEAST, MOST]))?;
    costs.extend(copies.costs("drill string", "*η*", "6"));
    let errors = Measured::measure(&drill, &THESIS)?;
    let rest = drill.equilibria(copy(Kernel::Quartic, 0), REST)?;
    let exact = drill.equilibria(Dynamics::Exact, REST)?;
    let [first, second] = hopf(&rest);
    let equilibrium = Curve::points("stable equilibrium", 0, Marker::Cross, vec![[0.0, 0.0]]);
    let hopf = "Hopf points: artefacts of smoothing";
    let orbits = copies.exact.points();
    let tip = orbits.last().map(|orbit| [at(orbit), orbit.max_abs[0]]);
    let grazes = tip.map_or(f64::NAN, |point| point[0]);
    let tip = tip.into_iter().collect();
    let tip = Curve::points("end by grazing", 0, Marker::Diamond, tip);
    let last = copies.exact.branches.last();
    let end = last.map_or(f64::NAN, |branch| branch.end);
    let manuscript = Manuscript::new(include_str!("drill_string.md"))
        .sketch(include_str!("sketches/drill_string.svg"))
        .curves("4.3", [frictions(&drill)])
        .curves("4.4", [[copies.planes(), vec![equilibrium]].concat()])
        .panels("4.5", errors.against_size())
        .value("first", format!("{first:.4}"))
        .value("second", format!("{second:.4}"))
        .curves(
            "4.6",
            [drawn(
                (&rest, hopf),
                (&exact, "exact, stable at every speed"),
            )],
        )
        .value("grazes", format!("{grazes:.5}"))
        .curves("4.7", [[copies.amplitudes(), vec![tip]].concat()])
        .curves("4.8", [copies.frequencies()])
        .curves("4.9", errors.against_parameter())
        .rows("drill-string-fits", errors.rows())
        .value("end", decimals(end, 4))
        .rows("drill-string-ends", ends(&copies))
        .value("first exactly", decimals(first, 6))
        .value("second exactly", decimals(second, 6))
        .value("stability", stability(copies.points()));
    Ok(manuscript.section()?)
}

/// The friction term against the twist rate.
fn frictions(drill: &Subject) -> Vec<Curve> {
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
    let exact = Curve::line("exact, *η* = 4", 0, exact);
    [exact].into_iter().chain(copies).collect()
}

fn ends(copies: &Copies) -> Vec<Vec<String>> {
    let rows = copies.copies.iter().filter_map(|(exponent, copy)| {
        let [down, up] = copy.branches.as_slice() else {
            return None;
        };
        let first = &copy.cycle.orbit;
        let last = down.points.last()?;
        let ([low, below], [high, above]) = (down.ending(), up.ending());
        Some(vec![
            power(*exponent),
            decimals(1.0 / first.period, 7),
            decimals(first.max_abs[0], 6),
            low,
            decimals(last.max_abs[0], 4),
            below,
            high,
            above,
        ])
    });
    rows.collect()
}
