//! Thesis section 3.1: a limit cycle without friction.

use stickslip::report::{Axis, Curve, Figure, Marker, Panel, Section, Table};
use stickslip::study::{Dynamics, OrbitRecord};

use super::ReproduceError;
use super::ask::Subject;
use super::branch::at;
use super::copies::Member;
use super::cost::Cost;
use super::words::{beside, decimals, scientific, stability};
use crate::VanDerPol;

/// How near to ν = 0 the branch is followed: at 0 itself every motion is periodic.
const LEAST: f64 = 1e-3;
const MOST: f64 = 15.0;

/// The section on the Van der Pol equation.
pub(super) fn section(costs: &mut Vec<Cost>) -> Result<Section, ReproduceError> {
    let oscillator = Subject::new(VanDerPol::nu);
    let ends = (1.0, &[LEAST, MOST][..]);
    let cycles = Member::find(&oscillator, Dynamics::Smooth, ends, String::new())?;
    costs.extend(cycles.costs("Van der Pol, *ν*", "15 min, both"));
    Ok(Section::new("The Van der Pol oscillator")
        .text(
            "The oldest self-sustained oscillation, without any friction, tests the method. Its damping is negative for \
             small displacements and positive for large ones, so that every motion is drawn to one closed curve, the \
             limit cycle. (A prime is a derivative with respect to time.)",
        )
        .formula("*x*″ + *ν* (*x*^{2} − 1) *x*′ + *x* = 0")
        .figure(figure_1(&cycles))
        .figure(figure_2(&cycles))
        .figure(figure_3(&cycles))
        .table(table(&cycles)))
}

fn figure_1(cycles: &Member) -> Figure {
    let panel = Panel::new(
        Axis::new("displacement *x*").from(-3.0, 3.0),
        Axis::new("velocity *x*′").from(-3.0, 3.0),
    )
    .curve(Curve::line("limit cycle", 0, cycles.plane()))
    .curve(Curve::points(
        "unstable equilibrium",
        2,
        Marker::Cross,
        vec![[0.0, 0.0]],
    ));
    Figure::new(
        "3.1",
        "Limit cycle at *ν* = 1",
        "All motions but the equilibrium itself, from inside and from outside, end on this closed curve.",
    )
    .panel(panel)
}

fn figure_2(cycles: &Member) -> Figure {
    let speeds = cycles.along(|orbit| orbit.max_abs[1]);
    let panel = Panel::new(
        Axis::new("damping *ν*").from(0.0, MOST),
        Axis::new("absolute maximum").from(0.0, 25.0),
    )
    .curve(Curve::line("max |*x*|", 1, cycles.amplitudes()))
    .curve(Curve::line("max |*x*′|", 2, speeds));
    Figure::new(
        "3.2",
        "Absolute maxima of *x* and *x*′",
        "The displacement hardly knows about *ν*; the velocity grows almost in proportion. In the thesis max |*x*′| \
         ripples for *ν* > 10, because it was read off the output points, which miss the ever sharper peaks. Here it \
         is the maximum of the motion itself, and the ripple is gone.",
    )
    .panel(panel)
}

fn figure_3(cycles: &Member) -> Figure {
    let nu = || Axis::new("damping *ν*").from(0.0, MOST);
    let frequency = cycles.along(|orbit| 1.0 / orbit.period);
    let points = cycles.points().into_iter();
    let second = points.filter_map(|orbit| Some([at(orbit), log10_modulus(orbit)?]));
    let first = cycles.along(|_| 0.0);
    Figure::new(
        "3.3",
        "Free frequency and moduli of the Floquet multipliers",
        "Left: for *ν* → 0 the frequency tends to that of the linear oscillator, 1/2π ≈ 0.159, and falls to 0 as the \
         motion becomes a slow creep with sudden jumps. Right: the logarithm of |*λ*_{2}|. At *ν* = 15 a disturbance \
         shrinks by hundreds of orders of magnitude in one period, far beyond what a floating-point number can hold, \
         so it is found as the integral of the trace of the Jacobian along the orbit and not as an eigenvalue.",
    )
    .columns(2)
    .panel(
        Panel::new(nu(), Axis::new("frequency *f* = 1/*T*").from(0.0, 0.2))
            .curve(Curve::line("", 0, frequency)),
    )
    .panel(
        Panel::new(nu(), Axis::new("log_{10} |*λ*|"))
            .curve(Curve::line("*λ*_{1} = 1, the trivial one", 1, first))
            .curve(Curve::line("*λ*_{2}", 2, second.collect())),
    )
}

fn log10_modulus(orbit: &OrbitRecord) -> Option<f64> {
    let log = *orbit.floquet.log_moduli.first()?;
    log.map(|log| log / std::f64::consts::LN_10)
}

fn table(cycles: &Member) -> Table {
    let orbit = &cycles.cycle.orbit;
    let orbits = cycles.points();
    let multiplier = orbit.floquet.multipliers.first().map_or(f64::NAN, |m| m.re);
    let table = beside(
        "van-der-pol",
        "Van der Pol: values of the thesis beside ours.",
    )
    .row([
        "max |*x*| at *ν* = 1".into(),
        "2.0082".into(),
        decimals(orbit.max_abs[0], 8),
        "the thesis's is the guess from which it shot".to_owned(),
    ])
    .row([
        "period *T* at *ν* = 1".into(),
        "6.6634".into(),
        decimals(orbit.period, 8),
        "likewise a guess".to_owned(),
    ])
    .row([
        "*λ*_{2} at *ν* = 1".into(),
        "0.8597 × 10^{−3}".into(),
        format!("{} × 10^{{−3}}", decimals(1e3 * multiplier, 6)),
        "equal to all digits printed".to_owned(),
    ])
    .row([
        "|*λ*_{1} − 1| at *ν* = 1".into(),
        "0".into(),
        scientific(orbit.floquet.trivial_error, 0),
        "exactly 0 in theory: a measure of accuracy".to_owned(),
    ]);
    ends(table, &orbits).row([
        "stability for all *ν*".into(),
        "stable".into(),
        stability(orbits),
        "also for *ν* near 0, where *λ*_{2} tends to 1".to_owned(),
    ])
}

fn ends(table: Table, orbits: &[&OrbitRecord]) -> Table {
    let (Some(first), Some(last)) = (orbits.first(), orbits.last()) else {
        return table;
    };
    table
        .row([
            "*f* for *ν* → 0".into(),
            "0.16".into(),
            decimals(1.0 / first.period, 6),
            format!("at *ν* = {LEAST}; 1/2π = 0.159155"),
        ])
        .row([
            "max |*x*′| for *ν* → 0".into(),
            "2".into(),
            decimals(first.max_abs[1], 6),
            format!("at *ν* = {LEAST}"),
        ])
        .row([
            "max |*x*′| at *ν* = 15".into(),
            "about 20".into(),
            decimals(last.max_abs[1], 4),
            "read off a figure, with its ripple".to_owned(),
        ])
}
