//! Thesis section 3.2: one mass on a moving belt.

use stickslip::field::Kernel;
use stickslip::report::numerals::{decimals, power, scientific};
use stickslip::report::{Curve, Manuscript, Marker, Section};
use stickslip::study::{Dynamics, EquilibriaRecord};

use super::ReproduceError;
use super::ask::Subject;
use super::copies::{Copies, copy, stability};
use super::equilibrium::{drawn, hopf};
use super::errors::{FREQUENCY, Measured, Thesis, printed};
use crate::BeltOscillator;

/// The smoothings are of size 10ⁱ.
const EXPONENTS: [i32; 6] = [2, 3, 4, 5, 6, 7];
/// Where the branches begin.
const SPEED: f64 = 0.2;
/// Where they shall end: near 0 the sticking phase, and with it the period, grows without bound.
const LEAST: f64 = 0.002;

/// What the thesis prints of the errors of its copies.
static THESIS: Thesis = Thesis {
    kernel: Kernel::Arctan,
    size: "size of the smoothing *ε* (s/m)",
    middle: 4.5,
    errors: [
        (
            "*e_{x}*",
            [
                printed(0.05, -0.58, 4.7, "equal within its digits"),
                printed(0.1, -0.57, 3.5, "flatter; 4 % larger in the middle"),
                printed(0.15, -0.57, 3.2, "flatter; 7 % larger in the middle"),
                printed(0.2, -0.59, 3.3, "equal within the rounding of *a*"),
            ],
        ),
        (
            "*e_{f}*",
            [
                printed(0.05, -0.60, 11.0, "steeper; 6 % smaller in the middle"),
                printed(0.1, -0.61, 8.1, "equal within the rounding of *a*"),
                printed(
                    0.15,
                    -0.61,
                    5.6,
                    "equal in the middle: a steeper line has a larger *b*",
                ),
                printed(0.2, -0.60, 3.9, "equal within the rounding of *a*"),
            ],
        ),
    ],
};

/// The section on the belt oscillator.
pub(super) fn section(costs: &mut Vec<Vec<String>>) -> Result<Section, ReproduceError> {
    let belt = Subject::new(BeltOscillator::v_dr);
    let sizes = (Kernel::Arctan, &EXPONENTS[..], " s/m");
    let copies = Copies::find(&belt, sizes, (SPEED, &[LEAST]))?;
    costs.extend(copies.costs("mass on a belt", "*v*_{dr}", "10"));
    let errors = Measured::measure(&belt, &THESIS)?;
    let rest = |&exponent: &i32| belt.equilibria(copy(Kernel::Arctan, exponent), [SPEED, 0.0]);
    let rests: Vec<EquilibriaRecord> = EXPONENTS.iter().map(rest).collect::<Result<_, _>>()?;
    let exact = belt.equilibria(Dynamics::Exact, [SPEED, 0.0])?;
    let [v_bif] = hopf(&rests[0]);
    let equilibrium = Curve::points("unstable equilibrium", 0, Marker::Cross, vec![[0.625, 0.0]]);
    let hopf = "Hopf point: an artefact of smoothing";
    let wanted = errors.last(FREQUENCY);
    let wanted = wanted.map_or(f64::NAN, |fit| fit.size(1e-3));
    let first = copies.copies.first();
    let vanished = first.and_then(|(_, copy)| copy.branches[0].vanishes());
    let manuscript = Manuscript::new(include_str!("belt_oscillator.md"))
        .sketch(include_str!("sketches/belt_oscillator.svg"))
        .curves("3.5", [forces(&belt, 1.0), forces(&belt, 0.05)])
        .curves("3.6", [[copies.planes(), vec![equilibrium]].concat()])
        .panels("3.7", errors.against_size())
        .value("v_bif", format!("{v_bif:.4}"))
        .curves(
            "3.8",
            [drawn(
                (&rests[0], hopf),
                (&exact, "exact, unstable at every speed"),
            )],
        )
        .curves("3.9", [copies.amplitudes()])
        .curves("3.10", [copies.frequencies()])
        .curves("3.11", errors.against_parameter())
        .value("wanted", scientific(wanted, 2))
        .rows("belt-oscillator-fits", errors.rows())
        .rows("belt-oscillator-ends", ends(&copies, &rests))
        .value(
            "vanished",
            vanished.map_or("–".to_owned(), |r| decimals(r, 5)),
        )
        .value("stability", stability(copies.points()));
    Ok(manuscript.section()?)
}

/// Forces at sliding speeds up to `most` either way, dense where the copies are steep.
fn forces(belt: &Subject, most: f64) -> Vec<Curve> {
    let curve = |label: &str, series, dynamics| {
        let steps = (-300..=300).filter(|i| *i != 0);
        let speeds = steps.map(|i| most * (f64::from(i) / 300.0).powi(3));
        let points = speeds.map(|w| [w, -belt.force(dynamics, w)]);
        Curve::line(label, series, points.collect())
    };
    let copies = [2, 3, 4].into_iter().enumerate().map(|(i, exponent)| {
        let label = format!("*ε* = {} s/m", power(exponent));
        curve(&label, i + 1, copy(Kernel::Arctan, exponent))
    });
    [curve("exact", 0, Dynamics::Exact)]
        .into_iter()
        .chain(copies)
        .collect()
}

fn ends(copies: &Copies, rests: &[EquilibriaRecord]) -> Vec<Vec<String>> {
    let rows = copies.copies.iter().zip(rests);
    let rows = rows.filter_map(|((exponent, copy), rest)| {
        let ([v_bif], [branch]) = (hopf(rest), copy.branches.as_slice()) else {
            return None;
        };
        let first = &copy.cycle.orbit;
        let last = branch.points.last()?;
        let [end, why] = branch.ending();
        Some(vec![
            power(*exponent),
            decimals(1.0 / first.period, 7),
            decimals(first.max_abs[0], 6),
            decimals(v_bif, 7),
            end,
            decimals(1.0 / last.period, 5),
            decimals(last.max_abs[0], 4),
            why,
        ])
    });
    rows.collect()
}
