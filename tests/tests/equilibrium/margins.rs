//! Margins of stability: undamped and weakly damped systems, and where their modes couple.

use std::f64::consts::TAU;
use std::ops::ControlFlow;

use stickslip::bifurcation::Stability;
use stickslip::continuation::{Ending, Kind, Stop, Walked};
use stickslip::equilibrium::{EquilibriumPoint, find, follow, settings};
use stickslip::field::Design;
use stickslip::flow::{FlowError, SmoothFamily};
use stickslip::integrate::Tolerance;
use stickslip::model;
use stickslip::model::{Model, ParamId};
use stickslip::motion::Family;

model! {
    /// Mode coupling with two dampers: Hoffmann, Fischer, Allgaier and Gaul, Wear 253 (2002) 721.
    struct Coupled {
        state x = 0.0;
        state y = 0.0;
        state u = 0.0;
        state v = 0.0;
        param b = 2.0;
        param c = 0.0;
        param d = 0.0;
        param mu = 0.0;
        der(x) = u;
        der(y) = v;
        der(u) = -2 * x - (1 - mu * 4 / 3) * y - c * u;
        der(v) = -x - b * y - d * v;
    }
}

model! {
    /// An unstable position held by a spin: stable for g > 1 + √2 (gyroscopic stabilisation, Thomson and Tait).
    struct Held {
        state x = 0.0;
        state y = 0.0;
        state u = 0.0;
        state v = 0.0;
        param g = 3.0;
        der(x) = u;
        der(y) = v;
        der(u) = x + g * v;
        der(v) = 2 * y - g * u;
    }
}

model! {
    /// A rotor with as much damping inside as outside, isotropic: its whirl grows beyond a spin of 2.
    struct Whirl {
        state x = 0.0;
        state y = 0.0;
        state u = 0.0;
        state v = 0.0;
        param damping = 1e-8;
        param spin = 0.5;
        der(x) = u;
        der(y) = v;
        der(u) = -x - damping * u - damping * (u + spin * y);
        der(v) = -y - damping * v - damping * (v - spin * x);
    }
}

model! {
    /// A ring of six equal masses, each on a spring of its own: all frequencies but two are double.
    struct Ring {
        state x[6] = 0.0;
        state v[6] = 0.0;
        param own = 0.5;
        param c = 0.0;
        param load = 0.0;
        for i in 0..6 {
            der(x[i]) = v[i];
        }
        der(v[0]) = load - own * x[0] - (2 * x[0] - x[5] - x[1]) - c * v[0] - powi(x[0], 3);
        for i in 1..5 {
            der(v[i]) = load - own * x[i] - (2 * x[i] - x[i - 1] - x[i + 1]) - c * v[i] - powi(x[i], 3);
        }
        der(v[5]) = load - own * x[5] - (2 * x[5] - x[4] - x[0]) - c * v[5] - powi(x[5], 3);
    }
}

type Found = Walked<EquilibriumPoint, FlowError>;

/// The branch of the equilibrium at the origin, or next to it, to its end.
fn followed<M: Model<N>, const N: usize>(model: M, along: ParamId<M>, ends: (f64, f64)) -> Found {
    let family = Family::from(SmoothFamily {
        model,
        smoothing: None,
        design: Design::Parameter(along.index),
        tolerance: Tolerance::for_accuracy(1e-9),
        magnitude: [1.0; N],
    });
    let (from, to) = ends;
    let found = find(&family, from, &[vec![0.0; N]], |_| vec![vec![]]);
    let first = found.first().expect("an equilibrium");
    let mut go_on = |_: &_| ControlFlow::Continue(());
    let (walked, _) =
        follow(&family, &first.place, settings(from, to), &mut go_on).expect("a branch");
    assert_eq!(walked.ending, Ending::Stopped(Stop::ReachedEnd));
    walked
}

fn special(found: &Found) -> Vec<(Kind, f64)> {
    found.located.iter().map(|at| (at.kind, at.r)).collect()
}

fn only(found: &Found, kind: Kind, r: f64, frequency: f64) {
    let [at] = found.located.as_slice() else {
        panic!("{:?}", special(found));
    };
    assert_eq!(at.kind, kind);
    assert!((at.r - r).abs() < 1e-9, "{} against {r}", at.r);
    let found = at.point.frequency().expect("a frequency");
    assert!((found - frequency).abs() < 1e-7, "{found}");
}

#[test]
fn two_undamped_modes_couple_at_three_quarters_either_way() {
    for ends in [(0.0, 1.2), (1.2, 0.0), (0.74, 0.76), (0.7, 0.75 + 1e-9)] {
        let found = followed(
            Coupled {
                b: 2.0,
                c: 0.0,
                d: 0.0,
                mu: 0.0,
            },
            Coupled::mu,
            ends,
        );
        only(&found, Kind::Flutter, 0.75, f64::sqrt(2.0));
        for point in &found.points {
            let wanted = if point.r < 0.75 {
                Stability::Undecided
            } else {
                Stability::Unstable
            };
            assert_eq!(point.spectrum.stability, wanted, "{}", point.r);
            let axis = point
                .spectrum
                .eigenvalues
                .iter()
                .filter(|value| value.re == 0.0);
            assert_eq!(axis.count(), if point.r < 0.75 { 4 } else { 0 });
        }
    }
    let found = followed(
        Coupled {
            b: 3.0,
            c: 0.0,
            d: 0.0,
            mu: 0.0,
        },
        Coupled::mu,
        (0.0, 1.2),
    );
    only(&found, Kind::Flutter, 15.0 / 16.0, f64::sqrt(2.5));
}

/// With S = c + d, P = c d and ρ = (A d + B c)/S: Hopf where k (k − 4μ/3) = A B + ρ² − ρ (A + B + P), ω² = ρ.
#[test]
fn damped_modes_couple_where_the_closed_form_says() {
    let dampers = [
        (0.2, 0.1),
        (0.1, 0.1),
        (1e-2, 3e-2),
        (1e-4, 1e-4),
        (1e-4, 3e-4),
        (1e-6, 3e-6),
        (1e-8, 1e-8),
        (1e-8, 3e-8),
    ];
    for (b, (c, d)) in [2.0, 3.0]
        .into_iter()
        .flat_map(|b| dampers.map(|pair| (b, pair)))
    {
        let rho = (2.0 * d + b * c) / (c + d);
        let coupled = 2.0 * b + rho * rho - rho * (2.0 + b + c * d);
        let expected = 0.75 * (1.0 - coupled);
        let model = Coupled { b, c, d, mu: 0.0 };
        only(
            &followed(model, Coupled::mu, (0.0, 1.2)),
            Kind::Hopf,
            expected,
            rho.sqrt(),
        );
    }
}

#[test]
fn a_spin_that_falls_lets_go_by_flutter() {
    let found = followed(Held { g: 3.0 }, Held::g, (3.0, 1.5));
    only(
        &found,
        Kind::Flutter,
        1.0 + f64::sqrt(2.0),
        f64::sqrt(f64::sqrt(2.0)),
    );
}

#[test]
fn a_rotor_whirls_beyond_twice_its_frequency_however_weak_its_damping() {
    for damping in [1e-8, 1e-4, 1e-2] {
        let found = followed(Whirl { damping, spin: 0.5 }, Whirl::spin, (0.5, 3.0));
        let [at] = found.located.as_slice() else {
            panic!("{:?}", special(&found));
        };
        assert_eq!(at.kind, Kind::Hopf);
        assert!((at.r - 2.0).abs() < 1e-15 / damping + 1e-9, "{}", at.r);
    }
    // Without any damping the frequencies are double, and nothing happens.
    let found = followed(
        Whirl {
            damping: 0.0,
            spin: 0.5,
        },
        Whirl::spin,
        (0.5, 3.0),
    );
    assert_eq!(special(&found), []);
}

#[test]
fn equal_frequencies_by_symmetry_are_no_collision() {
    let ring = Ring {
        own: 0.5,
        c: 0.0,
        load: 0.1,
    };
    let found = followed(ring, Ring::load, (0.1, 3.0));
    assert_eq!(special(&found), []);
    let undecided = |point: &EquilibriumPoint| point.spectrum.stability == Stability::Undecided;
    assert!(found.points.iter().all(undecided));
}

/// Own frequencies λ + 2 − 2 cos(2πj/6): all masses at 0, pairs of waves at −1 and −3, opposite ones at −4.
#[test]
fn modes_that_are_double_by_symmetry_buckle_two_at_a_time() {
    for c in [0.0, 0.1] {
        let found = followed(
            Ring {
                own: 0.1,
                c,
                load: 0.0,
            },
            Ring::own,
            (0.1, -5.0),
        );
        let expected = [0.0, -1.0, -1.0, -3.0, -3.0, -4.0];
        assert_eq!(found.located.len(), expected.len(), "{:?}", special(&found));
        for (at, r) in found.located.iter().zip(expected) {
            assert_eq!(at.kind, Kind::BranchPoint);
            assert!((at.r - r).abs() < 1e-9, "{} against {r}", at.r);
        }
    }
}

#[test]
fn all_pairs_that_cross_at_once_are_hopf_points() {
    let found = followed(
        Ring {
            own: 0.5,
            c: 1.0,
            load: 0.0,
        },
        Ring::c,
        (1.0, -1.0),
    );
    assert_eq!(found.located.len(), 6, "{:?}", special(&found));
    for at in &found.located {
        assert_eq!(at.kind, Kind::Hopf);
        assert!(at.r.abs() < 1e-12, "{}", at.r);
    }
    let mut frequencies: Vec<f64> = found
        .located
        .iter()
        .filter_map(|at| at.point.frequency())
        .collect();
    frequencies.sort_by(f64::total_cmp);
    let wave = |j: f64| (2.5 - 2.0 * (TAU * j / 6.0).cos()).sqrt();
    for (found, j) in frequencies.into_iter().zip([0.0, 1.0, 1.0, 2.0, 2.0, 3.0]) {
        assert!((found - wave(j)).abs() < 1e-9, "{found}");
    }
}
