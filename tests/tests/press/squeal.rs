//! The limit cycle of squeal, bounded by stick or by lift-off, against a small event-driven run that is written by hand.

use stickslip::continuation::Kind;
use stickslip::field::Design;
use stickslip::model::Model;
use stickslip::study::{Along, Case, Dynamics, System};

use stickslip_tests::random::Random;

use crate::by_hand::period;
use crate::hopf::{closed_form, drawn};
use crate::models::Squeal;

fn case(model: &Squeal) -> Case {
    let mut case = Case::declared(Squeal::INFO, Dynamics::Exact);
    case.parameters = model.values().to_vec();
    case.start = Some(vec![0.0, 0.5 * model.load, 0.01, 0.0]);
    case.accuracy = 1e-10;
    case
}

fn orbit(model: &Squeal) -> (f64, String) {
    let orbit = System::of::<Squeal, 4>().orbit(&case(model)).unwrap();
    (orbit.period, orbit.word.unwrap())
}

#[test]
fn stick_or_lift_off_bounds_squeal() {
    let cases = [
        (1.0, 1.0, 0.0, "close(N) open(N)"),
        (3.0, 0.1, 0.0, "stick(F) slip-(F)"),
        (1.0, 1.0, 0.3, "stick(F) slip-(F) open(N) close(N)"),
    ];
    for (load, belt, c3, word) in cases {
        let model = Squeal {
            load,
            belt,
            c3,
            ..Default::default()
        };
        let (found, spelt) = orbit(&model);
        let expected = period(&model);
        assert!(
            (found - expected).abs() < 1e-8,
            "{found} against {expected}: {spelt}"
        );
        assert_eq!(spelt, word);
    }
}

/// Beyond the Hopf points of random sets: a slow belt is stuck to, from a fast one the mass lifts off. All but load and belt is
/// linear, so that their ratio decides: a fast belt and a small load are one.
#[test]
#[ignore = "long"]
fn stick_or_lift_off_bounds_squeal_of_any_stiffness_and_damping() {
    let mut random = Random::new(1915);
    let mut bounds = [0, 0];
    for _ in 0..10 {
        let drawn = drawn(&mut random);
        let (critical, _) = closed_form(&drawn);
        for speed in [0.03, 1.0] {
            let model = Squeal {
                mu: 1.3 * critical,
                belt: speed * drawn.load,
                ..drawn
            };
            let (found, word) = orbit(&model);
            let expected = period(&model);
            assert!(
                (found - expected).abs() < 1e-8,
                "{found} against {expected}: {word}, {model:?}"
            );
            bounds[0] += usize::from(word.contains("stick(F)"));
            bounds[1] += usize::from(word.contains("open(N)"));
        }
    }
    assert!(bounds.iter().all(|count| *count >= 5), "{bounds:?}");
}

/// Between what bounds it slowly and what bounds it fast lies a grazing: on its orbit the force just touches zero.
#[test]
fn a_branch_of_squeal_passes_from_stick_to_lift_off() {
    let model = Squeal {
        load: 3.0,
        belt: 0.1,
        ..Default::default()
    };
    let mut along = case(&model);
    along.accuracy = 1e-9;
    along.along = Some(Along {
        design: Design::Parameter(Squeal::belt.index),
        from: 0.1,
        to: 1.5,
    });
    let system = System::of::<Squeal, 4>();
    let branch = system.branch(&along).unwrap();
    let kinds: Vec<Kind> = branch.special.iter().map(|special| special.kind).collect();
    assert_eq!(kinds[0], Kind::Grazing);
    let graze = branch.special[0].r;
    for point in &branch.points {
        let (r, word) = (point.r.unwrap(), point.word.as_deref().unwrap());
        assert_eq!(r > graze, word.contains("open(N)"), "{r} {word}");
        assert_eq!(r > graze, point.min[1] < 0.0, "{r} {}", point.min[1]);
    }
    assert_eq!(
        branch.points.last().unwrap().word.as_deref(),
        Some("close(N) open(N)")
    );
    // Everything but the load and the belt is linear: at the grazing their ratio alone decides, and the gap just closes.
    let touching = Squeal {
        belt: graze,
        ..model
    };
    let orbit = system.orbit(&case(&touching)).unwrap();
    assert!(orbit.min[1].abs() < 1e-8, "{}", orbit.min[1]);
    let double = Squeal {
        belt: 2.0 * graze,
        load: 6.0,
        ..model
    };
    let orbit = system.orbit(&case(&double)).unwrap();
    assert!(orbit.min[1].abs() < 1e-8, "{}", orbit.min[1]);
}
