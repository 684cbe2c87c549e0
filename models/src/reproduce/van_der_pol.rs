//! Thesis section 3.1: a limit cycle without friction.

use stickslip::report::numerals::{decimals, scientific};
use stickslip::report::{Curve, Manuscript, Marker, Section};
use stickslip::study::{Dynamics, OrbitRecord};

use super::ReproduceError;
use super::ask::Subject;
use super::branch::at;
use super::copies::{Member, stability};
use crate::VanDerPol;

/// How near to ν = 0 the branch is followed: at 0 itself every motion is periodic.
const LEAST: f64 = 1e-3;
const MOST: f64 = 15.0;

/// The section on the Van der Pol equation.
pub(super) fn section(costs: &mut Vec<Vec<String>>) -> Result<Section, ReproduceError> {
    let oscillator = Subject::new(VanDerPol::nu);
    let ends = (1.0, &[LEAST, MOST][..]);
    let cycles = Member::find(&oscillator, Dynamics::Smooth, ends, String::new())?;
    costs.extend(cycles.costs("Van der Pol, *ν*", "15"));
    let orbits = cycles.points();
    let second = orbits.iter();
    let second = second.filter_map(|orbit| Some([at(orbit), log10_modulus(orbit)?]));
    let manuscript = Manuscript::new(include_str!("van_der_pol.md"))
        .curves(
            "3.1",
            [vec![
                cycles.plane("limit cycle", 0),
                Curve::points("unstable equilibrium", 2, Marker::Cross, vec![[0.0, 0.0]]),
            ]],
        )
        .curves(
            "3.2",
            [vec![
                cycles.along("max |*x*|", 1, |orbit| orbit.max_abs[0]),
                cycles.along("max |*x*′|", 2, |orbit| orbit.max_abs[1]),
            ]],
        )
        .curves(
            "3.3",
            [
                vec![cycles.along("", 0, |orbit| 1.0 / orbit.period)],
                vec![
                    cycles.along("*λ*_{1} = 1, the trivial one", 1, |_| 0.0),
                    Curve::smooth("*λ*_{2}", 2, second.collect()),
                ],
            ],
        );
    Ok(values(manuscript, &cycles.cycle.orbit, &orbits).section()?)
}

fn log10_modulus(orbit: &OrbitRecord) -> Option<f64> {
    let log = *orbit.floquet.log_moduli.first()?;
    log.map(|log| log / std::f64::consts::LN_10)
}

/// The values beside those of the thesis, of the orbit at 1 and of those along the branch.
fn values(manuscript: Manuscript, orbit: &OrbitRecord, all: &[&OrbitRecord]) -> Manuscript {
    let multiplier = orbit.floquet.multipliers.first().map_or(f64::NAN, |m| m.re);
    let [slow, fast] = [all.first(), all.last()];
    let number = |orbit: Option<&&OrbitRecord>, of: fn(&OrbitRecord) -> f64, count| {
        decimals(orbit.map_or(f64::NAN, |orbit| of(orbit)), count)
    };
    manuscript
        .value(
            "least",
            decimals(
                fast.and_then(|orbit| log10_modulus(orbit))
                    .unwrap_or(f64::NAN),
                0,
            ),
        )
        .value("max", decimals(orbit.max_abs[0], 8))
        .value("period", decimals(orbit.period, 8))
        .value("multiplier", decimals(1e3 * multiplier, 6))
        .value("trivial", scientific(orbit.floquet.trivial_error, 0))
        .value(
            "slow frequency",
            number(slow, |orbit| 1.0 / orbit.period, 6),
        )
        .value("slow max", number(slow, |orbit| orbit.max_abs[1], 6))
        .value("fast max", number(fast, |orbit| orbit.max_abs[1], 4))
        .value("stability", stability(all.iter().copied()))
}
