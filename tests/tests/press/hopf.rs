//! Where steady sliding begins to squeal: a closed form for any two dampers.

use std::ops::ControlFlow;

use stickslip::continuation::{Ending, Kind};
use stickslip::equilibrium::{find, follow, settings};
use stickslip::field::exact::Mode;
use stickslip::flow::ExactFamily;
use stickslip::integrate::Tolerance;
use stickslip::model::Model;
use stickslip::motion::Family;
use stickslip::study::{Case, Dynamics, System};
use stickslip_tests::random::Random;

use crate::models::Squeal;

/// μ and ω of the Hopf point: k₁₂ (k₁₂ − μ k₃) = A B + r² − r (A + B + P), ω² = r, for a mass of one.
pub(crate) fn closed_form(model: &Squeal) -> (f64, f64) {
    let Squeal {
        a,
        b,
        k12,
        k3,
        c1,
        c2,
        ..
    } = *model;
    let (b, sum, product) = (b + k3, c1 + c2, c1 * c2);
    let r = (a * c2 + b * c1) / sum;
    let right = a * b + r * r - r * (a + b + product);
    ((k12 - right / k12) / k3, r.sqrt())
}

/// Random stiffness, damping and load.
pub(crate) fn drawn(random: &mut Random) -> Squeal {
    Squeal {
        a: random.between(1.5, 3.0),
        b: random.between(0.4, 1.5),
        k12: random.between(0.5, 1.2),
        k3: random.between(0.8, 1.6),
        c1: random.between(0.02, 0.3),
        c2: random.between(0.02, 0.3),
        load: random.positive(0.1, 10.0),
        ..Default::default()
    }
}

fn found(model: Squeal, until: f64) -> (f64, f64) {
    let family = Family::from(ExactFamily {
        model,
        design: Some(Squeal::mu.index),
        tolerance: Tolerance::for_accuracy(1e-9),
        magnitude: [1.0; 4],
    });
    let modes = vec![Mode::SlideBackward, Mode::Closed];
    let start = vec![0.0, 0.3, 0.0, 0.0];
    let first = find(&family, 0.0, &[start], |_| vec![modes.clone()]);
    let first = &first.first().expect("steady sliding").place;
    let (walked, _) = follow(&family, first, settings(0.0, until), &mut |_| {
        ControlFlow::Continue(())
    })
    .expect("a branch");
    let hopf: Vec<_> = walked
        .located
        .iter()
        .filter(|found| found.kind == Kind::Hopf)
        .collect();
    assert_eq!(hopf.len(), 1, "{walked:?}");
    (hopf[0].point.r, hopf[0].point.frequency().unwrap())
}

#[test]
fn squeal_begins_where_the_closed_form_says() {
    let symmetric = Squeal {
        c1: 0.2,
        c2: 0.1,
        ..Default::default()
    };
    let (mu, omega) = closed_form(&symmetric);
    assert!((mu - 0.78).abs() < 1e-14 && (omega - 2.0_f64.sqrt()).abs() < 1e-14);
    let mut random = Random::new(2002);
    for _ in 0..10 {
        let model = drawn(&mut random);
        let (mu, omega) = closed_form(&model);
        let (found, frequency) = found(model, 1.5 * mu);
        assert!(
            (found - mu).abs() < 1e-9 * mu,
            "{found} against {mu}: {model:?}"
        );
        assert!(
            (frequency - omega).abs() < 1e-9 * omega,
            "{frequency} against {omega}"
        );
    }
}

/// y = P/(B − k₁₂ (k₁₂ − μ k₃)/A): without a load nothing presses.
#[test]
fn steady_sliding_ends_where_nothing_presses() {
    let model = Squeal {
        mu: 0.3,
        load: 2.0,
        ..Default::default()
    };
    let family = Family::from(ExactFamily {
        model,
        design: Some(Squeal::load.index),
        tolerance: Tolerance::for_accuracy(1e-9),
        magnitude: [1.0; 4],
    });
    let modes = vec![Mode::SlideBackward, Mode::Closed];
    let first = find(&family, 2.0, &[vec![0.0, 0.3, 0.0, 0.0]], |_| {
        vec![modes.clone()]
    });
    let place = &first[0].place;
    let Squeal {
        a, b, k12, k3, mu, ..
    } = model;
    let depth = 2.0 / (b + k3 - k12 * (k12 - mu * k3) / a);
    assert!((place.state[1] - depth).abs() < 1e-13);
    let (walked, _) = follow(&family, place, settings(2.0, -1.0), &mut |_| {
        ControlFlow::Continue(())
    })
    .expect("a branch");
    assert!(matches!(
        walked.ending,
        Ending::At(Kind::BoundaryEquilibrium, _)
    ));
    let last = walked.points.last().unwrap();
    assert_eq!(last.margin().map(|(contact, _)| contact), Some(1));
    assert!(last.r.abs() < 1e-12, "{}", last.r);
}

/// Sliding, sticking and open: what is pressed by nothing neither slides nor sticks.
#[test]
fn equilibria_are_found_in_every_mode() {
    let system = System::of::<Squeal, 4>();
    let mut case = Case::declared(Squeal::INFO, Dynamics::Exact);
    let mut modes = |parameter: usize, value: f64| {
        case.parameters[parameter] = value;
        let found = system.equilibria(&case).unwrap().into_iter();
        found.map(|one| one.mode.unwrap()).collect::<Vec<_>>()
    };
    assert_eq!(modes(Squeal::mu.index, 0.3), ["slip-(F) close(N)"]);
    assert_eq!(modes(Squeal::belt.index, 0.0), ["stick(F) close(N)"]);
    assert_eq!(modes(Squeal::load.index, -1.0), ["loose(F) open(N)"]);
}
