//! Directions in which branches go on, against orbits and equilibria that are found beside them by themselves.

use stickslip::field::Smoothing;
use stickslip::model::Model;
use stickslip::study::{Case, Dynamics, OrbitRecord, System};
use stickslip_models::{BeltOscillator, BeltPair, DrillString, ForcedBelt, VanDerPol};

/// What is read off an orbit, and that of the one beside it to which it is compared.
fn readings(orbit: &OrbitRecord) -> Vec<f64> {
    let extent = orbit.max.iter().chain(&orbit.min).chain(&orbit.max_abs);
    let harmonics = orbit.harmonics.iter().flatten();
    let amplitudes = harmonics.flat_map(|one| one.amplitude.clone());
    // Of the section what is drawn: the other states of it may be zero but for their errors.
    let section = orbit.section.iter().filter_map(|state| state.first());
    let all = [orbit.period].into_iter().chain(extent.copied());
    all.chain(section.copied()).chain(amplitudes).collect()
}

/// The directions of a branch are slopes between orbits on both sides of each of its points, each found by itself. How many
/// were compared.
fn directions_are_slopes<M: Model<N>, const N: usize>(case: &Case) -> usize {
    let system = System::of::<M, N>();
    let branch = system.branch(case).expect("a branch");
    let inner = branch.points.len().saturating_sub(1);
    let mut compared = 0;
    for point in branch.points[..inner].iter().skip(1).step_by(4) {
        let (Some(r), Some(further)) = (point.r, point.further()) else {
            continue;
        };
        let step = 1e-4 * r.abs();
        let beside = [r - step, r + step].map(|r| {
            let near = Case {
                start: Some(point.state.clone()),
                period: Some(point.period),
                along: None,
                ..case.at(r)
            };
            system.orbit(&near).ok().filter(|orbit| {
                orbit.word == point.word && orbit.section.len() == point.section.len()
            })
        });
        let [Some(before), Some(after)] = beside else {
            continue;
        };
        let way = further.r.expect("a parameter") - r;
        let all = [&before, &after, point, &further].map(readings);
        for (i, here) in all[2].iter().enumerate() {
            let slope = (all[3][i] - here) / way;
            let expected = (all[1][i] - all[0][i]) / (2.0 * step);
            // Of what is drawn over r from 0 on, a thousandth of the picture's height.
            let size = here.abs().max(0.1) / r.abs();
            let off = (slope - expected).abs();
            assert!(
                off < 1e-3 * (size + expected.abs()),
                "at {r}, number {i}: {slope} is not {expected}"
            );
        }
        compared += 1;
    }
    compared
}

fn smoothed(smoothing: &str) -> Dynamics {
    let smoothing: Smoothing = smoothing.parse().expect("a smoothing");
    Dynamics::Smoothed(smoothing)
}

#[test]
fn of_a_smooth_system() {
    let case = Case::of(&VanDerPol::default()).following(VanDerPol::nu, 1.0..6.0);
    assert!(directions_are_slopes::<VanDerPol, 2>(&case) > 0);
}

#[test]
fn of_exact_friction() {
    let case = Case::of(&BeltOscillator::default()).following(BeltOscillator::v_dr, 0.2..0.05);
    assert!(directions_are_slopes::<BeltOscillator, 2>(&case) > 0);
    let case = Case::of(&DrillString::default()).following(DrillString::eta, 4.0..2.0);
    assert!(directions_are_slopes::<DrillString, 2>(&case) > 0);
}

#[test]
fn of_a_copy() {
    let case = Case {
        dynamics: smoothed("arctan:1e3"),
        ..Case::of(&BeltOscillator::default())
    };
    let case = case.following(BeltOscillator::v_dr, 0.2..0.05);
    assert!(directions_are_slopes::<BeltOscillator, 2>(&case) > 0);
}

#[test]
fn of_two_contacts() {
    let case = Case {
        start: Some(vec![-0.02798, 0.0, 0.678, 0.3089]),
        period: Some(4.211),
        ..Case::of(&BeltPair::default())
    };
    let case = case.following(BeltPair::v_dr, 0.35..0.26);
    assert!(directions_are_slopes::<BeltPair, 4>(&case) > 0);
}

#[test]
fn of_a_frequency_response() {
    let case = Case {
        harmonics: vec![1, 3],
        ..Case::of(&ForcedBelt::default())
    };
    let case = case.following(ForcedBelt::omega, 1.3..1.15);
    assert!(directions_are_slopes::<ForcedBelt, 3>(&case) > 0);
}

#[test]
fn of_equilibria() {
    let system = System::of::<BeltOscillator, 2>();
    let case = Case {
        dynamics: smoothed("arctan:100"),
        ..Case::of(&BeltOscillator::default())
    };
    let case = case.following(BeltOscillator::v_dr, 0.2..0.02);
    let branch = system.equilibria_along(&case).expect("a branch");
    assert!(branch.points.len() > 5);
    for point in &branch.points {
        let r = point.r.expect("a parameter");
        let step = 1e-4 * r;
        let [before, after] = [r - step, r + step].map(|r| {
            let near = Case {
                start: Some(point.state.clone()),
                along: None,
                ..case.at(r)
            };
            system.equilibria(&near).expect("an equilibrium")[0].state[0]
        });
        let (other, state) = point.beside.as_ref().expect("a direction");
        let slope = (state[0] - point.state[0]) / (other - r);
        let expected = (after - before) / (2.0 * step);
        assert!(
            (slope - expected).abs() < 1e-4 * (1.0 + expected.abs()),
            "{r}: {slope} is not {expected}"
        );
    }
}
