//! The same motion told in other ways: theory, section 10.

use stickslip::field::{Design, Smoothing};
use stickslip::model::Model;
use stickslip::shooting::{Orbit, Search, closest};
use stickslip_models::{BeltOscillator, BeltPair};
use stickslip_tests::on_every_reference_system;
use stickslip_tests::subject::{self, Subject, TIGHT};
use stickslip_tests::transformed::{PACE, Transformed, stretch};

on_every_reference_system! {
    units_do_not_matter,
    a_shifted_start_gives_the_same_orbit,
}

fn orbit_from<M: Model<N>, const N: usize>(subject: &Subject<M, N>, start: [f64; N]) -> Orbit {
    let search = Search {
        start: start.to_vec(),
        ..subject.search()
    };
    closest(&subject.family(Design::None, TIGHT), 0.0, &search).expect("an orbit")
}

fn near(a: f64, b: f64, scale: f64, what: &str) {
    let error = (a - b).abs() / scale;
    assert!(error < 1e-8, "{what}: {a} against {b}");
}

fn same_multipliers(a: &Orbit, b: &Orbit) {
    for (a, b) in a.floquet.multipliers.iter().zip(&b.floquet.multipliers) {
        assert!((a - b).norm() < 1e-6, "{a} against {b}");
    }
}

fn units_do_not_matter<M: Model<N>, const N: usize>(subject: &Subject<M, N>) {
    let orbit = subject.orbit();
    let other = Subject {
        model: Transformed(subject.model),
        smoothing: subject.smoothing,
    };
    let start = subject.start();
    let other = orbit_from(&other, std::array::from_fn(|j| stretch(j) * start[j]));
    near(PACE * other.period, orbit.period, orbit.period, "period");
    same_multipliers(&other, &orbit);
    for j in 0..N {
        let extent = orbit.max[j] - orbit.min[j];
        near(other.max[j] / stretch(j), orbit.max[j], extent, "maximum");
        near(other.min[j] / stretch(j), orbit.min[j], extent, "minimum");
    }
}

fn a_shifted_start_gives_the_same_orbit<M: Model<N>, const N: usize>(subject: &Subject<M, N>) {
    let orbit = subject.orbit();
    let start = subject.start();
    let shifted = orbit_from(subject, std::array::from_fn(|j| start[j] * 0.98));
    near(shifted.period, orbit.period, orbit.period, "period");
    same_multipliers(&shifted, &orbit);
    for j in 0..N {
        let extent = orbit.max[j] - orbit.min[j];
        near(
            shifted.place.state[j],
            orbit.place.state[j],
            extent,
            "anchor",
        );
    }
}

/// X = x k/F_s, τ = t √(k/m), V = v √(km)/F_s, γ = δ F_s/√(km).
#[test]
fn a_dimensional_belt_oscillator_is_the_nondimensional_one() {
    let plain = subject::belt_oscillator();
    let (m, k, force) = (2.5_f64, 40.0_f64, 7.0_f64);
    let (length, speed, time) = (force / k, force / (k * m).sqrt(), (m / k).sqrt());
    let BeltOscillator { v_dr, delta, .. } = plain.model;
    let model = BeltOscillator {
        m,
        k,
        F_s: force,
        v_dr: v_dr * speed,
        delta: delta / speed,
    };
    let Smoothing { kernel, size } = plain.smoothing.unwrap();
    let size = size / speed;
    let dimensional = Subject {
        model,
        smoothing: Some(Smoothing { kernel, size }),
    };
    let (orbit, other) = (plain.orbit(), orbit_from(&dimensional, [length, 0.0]));
    near(other.period / time, orbit.period, orbit.period, "period");
    near(other.max[0] / length, orbit.max[0], 1.0, "max x");
    near(other.min[1] / speed, orbit.min[1], 1.0, "min v");
}

/// (y, v_dr) → −(y, v_dr).
#[test]
fn a_belt_that_runs_the_other_way_mirrors_the_motion() {
    let plain = subject::belt_pair();
    let mut mirrored = plain;
    mirrored.model.v_dr = -plain.model.v_dr;
    let (orbit, other) = (
        plain.orbit(),
        orbit_from(&mirrored, plain.start().map(|y| -y)),
    );
    near(other.period, orbit.period, orbit.period, "period");
    same_multipliers(&other, &orbit);
    for j in 0..4 {
        near(other.min[j], -orbit.max[j], 1.0, "minimum");
        near(other.max[j], -orbit.min[j], 1.0, "maximum");
    }
}

/// The masses swapped: β → 1/β, X → X/β, V → V/β, γ → γβ.
#[test]
fn swapped_masses_move_alike() {
    let plain = subject::belt_pair();
    let BeltPair {
        alpha,
        beta,
        gamma,
        v_dr,
    } = plain.model;
    let model = BeltPair {
        alpha,
        beta: 1.0 / beta,
        gamma: gamma * beta,
        v_dr: v_dr / beta,
    };
    let Smoothing { kernel, size } = plain.smoothing.unwrap();
    let size = size * beta;
    let swapped = Subject {
        model,
        smoothing: Some(Smoothing { kernel, size }),
    };
    let [x1, v1, x2, v2] = plain.start().map(|y| y / beta);
    let (orbit, other) = (plain.orbit(), orbit_from(&swapped, [x2, v2, x1, v1]));
    near(other.period, orbit.period, orbit.period, "period");
    same_multipliers(&other, &orbit);
    for j in 0..4 {
        near(other.max[(j + 2) % 4] * beta, orbit.max[j], 1.0, "maximum");
    }
}
