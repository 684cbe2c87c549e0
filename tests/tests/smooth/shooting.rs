//! Shooting for the periodic orbit of each reference system.

use nalgebra::DVector;
use stickslip::bifurcation::Stability;
use stickslip::continuation::{Corrected, correct};
use stickslip::field::{Design, Field};
use stickslip::flow::Want;
use stickslip::model::Model;
use stickslip::motion::{Flow, Place};
use stickslip::shooting::{
    Division, Guess, Orbit, OrbitError, OrbitProblem, Phase, Search, Shot, closest,
};
use stickslip_tests::on_every_reference_system;
use stickslip_tests::subject::{ACCURACY, Subject, TIGHT};

on_every_reference_system! {
    orbits_close,
    newton_converges_quadratically_from_the_section,
    newton_converges_quadratically_off_the_section,
    segments_do_not_matter,
    the_period_is_minimal,
    an_equilibrium_is_no_orbit,
}

/// The subject's flow, whatever moves.
fn flow<M: Model<N>, const N: usize>(subject: &Subject<M, N>) -> Box<dyn Flow> {
    let family = subject.family(Design::None, TIGHT);
    family.at(0.0).expect("parameters within bounds")
}

/// Shoots from `guess` in `segments` segments, r held.
fn shoot<M: Model<N>, const N: usize>(
    subject: &Subject<M, N>,
    guess: &Guess,
    phase: Phase,
    segments: usize,
) -> Corrected<Shot> {
    let flow = flow(subject);
    let division = Division::equal(flow.as_ref(), guess.place.clone(), guess.period, segments);
    let division = division.expect("a motion that can be followed");
    let family = subject.family(Design::None, TIGHT);
    let magnitude = guess.magnitude.clone();
    let mut problem = OrbitProblem::new(family, phase, &division, guess.period, magnitude);
    let z = OrbitProblem::unknowns(&division.starts, guess.period);
    let mut normal = DVector::zeros(z.len() + 1);
    normal[z.len()] = 1.0;
    correct(&mut problem, z, 0.0, &normal, 1.0, ACCURACY).expect("Newton converges")
}

fn orbits_close<M: Model<N>, const N: usize>(subject: &Subject<M, N>) {
    let orbit = subject.orbit();
    let end = flow(subject).advance(&orbit.place, orbit.period, Want::default());
    let end = end.expect("a motion that can be followed").end.state;
    for j in 0..N {
        let extent = orbit.max[j] - orbit.min[j];
        let gap = (end[j] - orbit.place.state[j]).abs() / extent;
        assert!(gap < 1e-8, "state {j} comes back {gap:e} off");
    }
    let trivial = orbit.floquet.trivial_error;
    assert!(trivial < 1e-6, "the trivial multiplier is {trivial:e} off");
    assert_ne!(orbit.floquet.stability, Stability::Undecided);
    assert_eq!(orbit.period_count, 1);
}

/// |c₍k+1₎| ≤ C |c₍k₎|² until the corrections reach the noise of the integration.
fn assert_quadratic(corrections: &[f64]) {
    const NOISE: f64 = 1e-9;
    assert!(
        corrections[0] > 1e-6,
        "there was nothing to correct: {corrections:?}"
    );
    let first = corrections
        .iter()
        .position(|&size| size < 1e-2)
        .expect("convergence");
    let pairs: Vec<_> = corrections[first..]
        .windows(2)
        .map(|pair| (pair[0], pair[1]))
        .filter(|pair| pair.0 > 10.0 * NOISE)
        .collect();
    assert!(!pairs.is_empty(), "{corrections:?}");
    for (before, after) in pairs {
        assert!(after <= 300.0 * before * before + NOISE, "{corrections:?}");
    }
}

fn newton_converges_quadratically_from_the_section<M: Model<N>, const N: usize>(
    subject: &Subject<M, N>,
) {
    let orbit = subject.orbit();
    let mut guess = subject.beside(&orbit, std::array::from_fn(|j| [1e-4, -2e-4][j % 2]));
    guess.period *= 1.0 + 1e-4;
    assert_quadratic(&shoot(subject, &guess, Phase::Section(0), 1).corrections);
}

fn newton_converges_quadratically_off_the_section<M: Model<N>, const N: usize>(
    subject: &Subject<M, N>,
) {
    let mut orbit = subject.orbit();
    let flow = flow(subject);
    orbit.place = middle(flow.as_ref(), &orbit);
    let guess = subject.beside(&orbit, [1e-4; N]);
    let velocity = flow.velocity(&guess.place).expect("a finite field").f;
    let at = guess.place.state.clone();
    let phase = Phase::orthogonal(at, &velocity, &guess.magnitude);
    assert_quadratic(&shoot(subject, &guess, phase, 1).corrections);
}

/// A point of the orbit away from its section: where it slides fastest of a few.
fn middle(flow: &dyn Flow, orbit: &Orbit) -> Place {
    let later = |share: f64| {
        let passage = flow.advance(&orbit.place, share * orbit.period, Want::default());
        passage.expect("a motion that can be followed").end
    };
    let middle = (orbit.max[0] + orbit.min[0]) / 2.0;
    let off = |place: &Place| (place.state[0] - middle).abs();
    (1..20)
        .map(|k| later(f64::from(k) / 20.0))
        .min_by(|a, b| off(a).total_cmp(&off(b)))
        .expect("twenty places")
}

fn segments_do_not_matter<M: Model<N>, const N: usize>(subject: &Subject<M, N>) {
    let search = |segments| Search {
        segments,
        ..subject.search()
    };
    let family = subject.family(Design::None, TIGHT);
    let simple = subject.orbit();
    for segments in [2, 3, 5] {
        let orbit = closest(&family, 0.0, &search(segments)).expect("the same orbit");
        let error = (orbit.period / simple.period - 1.0).abs();
        assert!(error < 1e-9, "{segments} segments: period {error:e} off");
        for j in 0..N {
            let extent = simple.max[j] - simple.min[j];
            let error = (orbit.max[j] - simple.max[j]).abs() / extent;
            assert!(error < 1e-8, "{segments} segments: state {j} {error:e} off");
        }
        let (a, b) = (&orbit.floquet, &simple.floquet);
        for (a, b) in a.multipliers.iter().zip(&b.multipliers) {
            assert!(
                (a - b).norm() < 1e-6,
                "{segments} segments: {a} against {b}"
            );
        }
    }
}

fn the_period_is_minimal<M: Model<N>, const N: usize>(subject: &Subject<M, N>) {
    let orbit = subject.orbit();
    let family = subject.family(Design::None, TIGHT);
    for times in [2.0, 3.0] {
        let search = Search {
            start: orbit.place.state.clone(),
            period: Some(times * orbit.period),
            ..subject.search()
        };
        let found = closest(&family, 0.0, &search).expect("the same orbit");
        let error = (found.period / orbit.period - 1.0).abs();
        assert!(
            error < 1e-9,
            "from {times} periods: {} against {}",
            found.period,
            orbit.period
        );
    }
}

/// Theory, section 9: Newton started on an equilibrium must not call it an orbit of a senseless period.
fn an_equilibrium_is_no_orbit<M: Model<N>, const N: usize>(subject: &Subject<M, N>) {
    let search = Search {
        start: equilibrium(subject).to_vec(),
        period: Some(5.0),
        ..subject.search()
    };
    let found = closest(&subject.family(Design::None, TIGHT), 0.0, &search);
    assert!(
        matches!(found, Err(OrbitError::Equilibrium { .. })),
        "{found:?}"
    );
}

/// Newton on f from rest.
fn equilibrium<M: Model<N>, const N: usize>(subject: &Subject<M, N>) -> [f64; N] {
    let field = subject.field();
    let mut state = [0.0; N];
    for _ in 0..50 {
        let linear = field.linearise(&state);
        let jacobian = nalgebra::DMatrix::from_fn(N, N, |i, j| linear.jacobian[i][j]);
        let right = DVector::from_column_slice(&linear.f);
        let step = jacobian.lu().solve(&right).expect("a regular Jacobian");
        state = std::array::from_fn(|j| state[j] - step[j]);
    }
    let rest = field
        .f(&state)
        .iter()
        .fold(0.0_f64, |largest, f| largest.max(f.abs()));
    assert!(rest < 1e-9, "no equilibrium: f = {rest:e}");
    state
}
