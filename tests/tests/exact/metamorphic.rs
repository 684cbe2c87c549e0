//! The same exact motion told in other ways: theory, section 10.

use stickslip::continuation::correct;
use stickslip::flow::Want;
use stickslip::integrate::Tolerance;
use stickslip::model::Model;
use stickslip::motion::{Family, Flow};
use stickslip::shooting::{Division, Orbit, OrbitProblem, Phase, Search, closest};
use stickslip_models::{BeltOscillator, BeltPair, DrillString};
use stickslip_tests::exact;

const ACCURACY: f64 = 1e-11;
/// Period-1, in phase, at the declared speed of the belt.
const IN_PHASE: [f64; 4] = [-0.5976, 0.0, -0.4604, -0.1607];

fn family<M: Model<N>, const N: usize>(model: M) -> Family {
    exact::family(model, ACCURACY).into()
}

fn flow<M: Model<N>, const N: usize>(model: M) -> Box<dyn Flow> {
    family(model).at(0.0).expect("parameters within bounds")
}

fn orbit<M: Model<N>, const N: usize>(model: M, start: [f64; N], period: Option<f64>) -> Orbit {
    let search = Search {
        period,
        ..exact::search(&start, ACCURACY)
    };
    closest(&family(model), 0.0, &search).expect("an orbit")
}

fn pair() -> Orbit {
    orbit(BeltPair::default(), IN_PHASE, Some(16.14))
}

fn near(a: f64, b: f64, what: &str) {
    let error = (a - b).abs() / b.abs().max(1.0);
    assert!(error < 1e-9, "{what}: {a} against {b}");
}

fn same_multipliers(a: &Orbit, b: &Orbit) {
    for (a, b) in a.floquet.multipliers.iter().zip(&b.floquet.multipliers) {
        assert!((a - b).norm() < 1e-7, "{a} against {b}");
    }
}

#[test]
fn an_uncoupled_pair_is_two_oscillators() {
    let pair = BeltPair {
        alpha: 0.0,
        ..BeltPair::default()
    };
    let (start, time) = ([1.0, 0.0, 0.3, -0.2], 40.0);
    let single = |force: f64, start: [f64; 2]| {
        let model = BeltOscillator {
            F_s: force,
            delta: pair.gamma,
            v_dr: pair.v_dr,
            ..BeltOscillator::default()
        };
        let flow = flow(model);
        let place = flow.place(&start).unwrap();
        flow.advance(&place, time, Want::default())
            .unwrap()
            .end
            .state
    };
    let flow = flow(pair);
    let place = flow.place(&start).unwrap();
    let both = flow
        .advance(&place, time, Want::default())
        .unwrap()
        .end
        .state;
    let first = single(1.0, [start[0], start[1]]);
    let second = single(pair.beta, [start[2], start[3]]);
    for (j, alone) in first.into_iter().chain(second).enumerate() {
        near(both[j], alone, "state");
    }
}

/// X = x k/F_s, τ = t √(k/m), V = v √(km)/F_s, γ = δ F_s/√(km), over 24 decades of mass and stiffness.
#[test]
fn dimensions_do_not_matter() {
    let plain = BeltOscillator::default();
    let reference = orbit(plain, [1.0, 0.0], None);
    for (m, k, force) in [(2.5, 40.0, 7.0), (3e-3, 2e2, 5e-2), (4e2, 1e-1, 9.0)] {
        let m: f64 = m;
        let (length, speed, time) = (force / k, force / (k * m).sqrt(), (m / k).sqrt());
        let model = BeltOscillator {
            m,
            k,
            F_s: force,
            v_dr: plain.v_dr * speed,
            delta: plain.delta / speed,
        };
        let other = orbit(model, [length, 0.0], None);
        near(other.period / time, reference.period, "period");
        near(other.max[0] / length, reference.max[0], "max x");
        near(other.min[1] / speed, reference.min[1], "min v");
    }
}

/// (y, v_dr) → −(y, v_dr).
#[test]
fn a_belt_that_runs_the_other_way_mirrors_the_motion() {
    let mirrored = BeltPair {
        v_dr: -BeltPair::default().v_dr,
        ..BeltPair::default()
    };
    let reference = pair();
    let other = orbit(mirrored, IN_PHASE.map(|y| -y), Some(16.14));
    near(other.period, reference.period, "period");
    same_multipliers(&other, &reference);
    for j in 0..4 {
        near(other.min[j], -reference.max[j], "minimum");
    }
}

/// The masses swapped: β → 1/β, X → X/β, V → V/β, γ → γβ.
#[test]
fn swapped_masses_move_alike() {
    let BeltPair {
        alpha,
        beta,
        gamma,
        v_dr,
    } = BeltPair::default();
    let swapped = BeltPair {
        alpha,
        beta: 1.0 / beta,
        gamma: gamma * beta,
        v_dr: v_dr / beta,
    };
    let [x1, v1, x2, v2] = IN_PHASE.map(|y| y / beta);
    let (reference, other) = (pair(), orbit(swapped, [x2, v2, x1, v1], None));
    near(other.period, reference.period, "period");
    same_multipliers(&other, &reference);
    for j in 0..4 {
        near(other.max[(j + 2) % 4] * beta, reference.max[j], "maximum");
    }
}

#[test]
fn a_doubled_period_squares_the_multipliers() {
    let reference = pair();
    let flow = flow(BeltPair::default());
    let want = Want {
        derivatives: true,
        ..Want::default()
    };
    let twice = flow
        .advance(&reference.place, 2.0 * reference.period, want)
        .unwrap();
    let velocity = flow.velocity(&reference.place).unwrap().f;
    let phi = twice.derivatives.unwrap().state;
    let doubled = stickslip::bifurcation::floquet(&phi, &velocity, None, 2, &[], 0, 1e-10);
    let once = reference.floquet.multipliers[0];
    assert!((doubled.multipliers[0] - once * once).norm() < 1e-8);
}

#[test]
fn a_shifted_start_changes_nothing() {
    let reference = pair();
    let flow = flow(BeltPair::default());
    for share in [0.1, 0.35, 0.8] {
        let shift = share * reference.period;
        let place = flow
            .advance(&reference.place, shift, Want::default())
            .unwrap()
            .end;
        let start = std::array::from_fn(|j| place.state[j]);
        let other = orbit(BeltPair::default(), start, Some(reference.period));
        near(other.period, reference.period, "period");
        same_multipliers(&other, &reference);
        for j in 0..4 {
            near(other.place.state[j], reference.place.state[j], "anchor");
        }
    }
}

/// Newton on exact orbits squares its corrections, down to 1e-13.
#[test]
fn shooting_converges_quadratically() {
    let reference = pair();
    for phase in [
        Phase::Section(0),
        Phase::orthogonal(
            reference.place.state.clone(),
            &flow(BeltPair::default())
                .velocity(&reference.place)
                .unwrap()
                .f,
            &reference.magnitude(),
        ),
    ] {
        let family = family(BeltPair::default()).with_tolerance(Tolerance {
            relative: 1e-11,
            absolute: 1e-11,
        });
        let extents = reference.max.iter().zip(&reference.min);
        let magnitude = extents.map(|(max, min)| 0.5 * (max - min)).collect();
        let mut problem = OrbitProblem::new(
            family,
            phase,
            &Division::whole(reference.place.clone()),
            reference.period,
            magnitude,
        );
        let mut start = reference.place.clone();
        start.state[0] += 2e-3;
        start.state[2] -= 1e-3;
        let z = OrbitProblem::unknowns(&[start], reference.period * 1.0005);
        let mut normal = nalgebra::DVector::zeros(6);
        normal[5] = 1.0;
        let found = correct(&mut problem, z, 0.0, &normal, 1.0, 1e-13).unwrap();
        let sizes = &found.corrections;
        assert!(found.residual < 1e-12, "{:e}", found.residual);
        for pair in sizes
            .windows(2)
            .filter(|pair| pair[0] < 2e-3 && pair[0] > 1e-6)
        {
            assert!(pair[1] <= 100.0 * pair[0] * pair[0] + 1e-12, "{sizes:?}");
        }
    }
}

/// The drill string's twist and torque in other units: only θ, ζ and η count, as long as the bit turns forward.
#[test]
fn the_kinetic_level_drops_out_of_forward_drilling() {
    let plain = orbit(DrillString::default(), [6.0, 0.0], None);
    let heavier = DrillString {
        kinetic: 9.0,
        ..DrillString::default()
    };
    near(
        orbit(heavier, [6.0, 0.0], None).period,
        plain.period,
        "period",
    );
}
