//! Contacts and parameters of models without structures.

use std::ops::ControlFlow;

use stickslip::model;
use stickslip::study::{Case, Lack, NeedsRecord, Role, System, Topic};
use stickslip_models::friction::Coulomb;
use stickslip_models::press::Compliant;
use stickslip_models::{BeltOscillator, systems};

model! {
    /// A driven mass that rubs; another one is held by its friction, a third slides along; a wall is far away.
    pub struct Idle {
        state x: m = 0.0;
        state v: m/s = 0.0;
        state u: m/s = 0.0;
        param m: kg = 1.0 where m > 0.0;
        param k: N/m = 2.0 where k > 0.0;
        param c: N*s/m = 0.3 where c >= 0.0;
        param push: N = 1.0;
        param level: N = 0.3 where level >= 0.0;
        param held: N = 5.0 where held >= 3.0;
        param belt: m/s = 9.0 where 8.0 <= belt <= 10.0;
        param far: m = 10.0 where 5.0 <= far <= 20.0;
        param stiff: N/m = 100.0 where stiff > 0.0;
        param omega: rad/s = 0.7 where omega > 0.0;
        drive phi at omega;
        friction rubs: N = Coulomb { level } opposing v;
        friction holds: N = Coulomb { level: held } opposing u;
        friction along: N = Coulomb { level: 0.1 } opposing v - belt;
        press wall: N = Compliant { stiffness: stiff, damping: 0.0 } closing far - x;
        der(x) = v;
        der(v) = (push * cos(phi) - k * x - c * v + rubs + along - wall) / m;
        der(u) = (k * x + holds) / m;
    }
}

model! {
    /// A mass on a belt, pressed by its own weight less what a spring lifts.
    pub struct Lifted {
        state x = 0.0;
        state v = 0.0;
        param weight = 1.0;
        param push = 1.0;
        param omega = 0.7 where omega > 0.0;
        drive phi at omega;
        let normal = weight - 0.9 * x;
        friction F = Coulomb { level: 0.2 * normal } opposing v;
        der(x) = v;
        der(v) = push * cos(phi) - x - 0.1 * v + F;
    }
}

/// All but the copies.
fn needs(system: &System, case: &Case, accuracy: f64) -> NeedsRecord {
    let asked = Case {
        accuracy,
        ..case.clone()
    };
    let record = system.needs_watched(&asked, &|topic| match topic {
        Topic::Copies => ControlFlow::Break(()),
        _ => ControlFlow::Continue(()),
    });
    record.expect("an answer")
}

#[test]
fn contacts_say_what_they_do() {
    let record = needs(&System::of::<Idle, _>(), &Case::of(&Idle::default()), 1e-3);
    let roles: Vec<_> = record
        .contacts
        .iter()
        .map(|one| (one.name, one.role))
        .collect();
    assert_eq!(
        roles[1..],
        [
            ("holds", Role::NeverSlides),
            ("along", Role::SlidesOneWay),
            ("wall", Role::NeverCloses)
        ]
    );
    assert!([Role::Switches, Role::NeverSticks].contains(&roles[0].1));
    // The spring pulls at most with k max |x|, and that is held by 5.
    let [held, wall] = [1, 3].map(|i| record.contacts[i].margin.expect("a margin"));
    assert!(
        (0.5..1.0).contains(&held) && (0.5..1.0).contains(&wall),
        "{held} {wall}"
    );
}

#[test]
fn parameters_that_do_not_matter_are_told() {
    let record = needs(&System::of::<Idle, _>(), &Case::of(&Idle::default()), 1e-3);
    let matters = |name: &str| {
        let mut all = record.parameters.iter();
        all.find(|one| one.name == name)
            .expect("a parameter")
            .matters
    };
    for name in ["held", "belt", "far", "stiff"] {
        assert!(!matters(name), "{name}: {:?}", record.parameters);
    }
    for name in ["m", "k", "c", "push", "level", "omega"] {
        assert!(matters(name), "{name}: {:?}", record.parameters);
    }
}

/// The largest relative change of period and extrema for a small step of a parameter, over that step.
fn by_differences(system: &System, case: &Case, parameter: usize) -> f64 {
    let step = 1e-4 * case.parameters[parameter].abs();
    let orbit = |by: f64| {
        let mut case = Case {
            accuracy: 1e-11,
            ..case.clone()
        };
        case.parameters[parameter] += by;
        let orbit = system.orbit(&case).expect("an orbit");
        (orbit.period, orbit.min, orbit.max)
    };
    let (at, low, high) = (orbit(0.0), orbit(-step), orbit(step));
    let period = (high.0 / at.0 - low.0 / at.0).abs();
    let extrema = (0..at.1.len()).flat_map(|j| {
        let size = at.1[j].abs().max(at.2[j].abs());
        [
            (high.1[j] - low.1[j]).abs() / size,
            (high.2[j] - low.2[j]).abs() / size,
        ]
    });
    extrema.fold(period, f64::max) / (2.0 * step)
}

#[test]
fn sensitivities_are_those_of_differences() {
    let system = systems::belt_oscillator();
    let case = Case::of(&BeltOscillator::default());
    let record = needs(&system, &case, 1e-4);
    for (index, need) in record.parameters.iter().enumerate() {
        let exact = *need.sensitivity.as_ref().expect("a derivative");
        let found = by_differences(&system, &case, index);
        assert!(
            (exact - found).abs() < 1e-4 * found,
            "{}: {exact} is not {found}",
            need.name
        );
    }
}

#[test]
fn a_contact_that_would_open_asks_for_a_press() {
    let case = Case::of(&Lifted::default());
    let record = needs(&System::of::<Lifted, _>(), &case, 1e-3);
    let [
        Lack::Press {
            force: "F", value, ..
        },
    ] = record.lacks[..]
    else {
        panic!("{:?}", record.lacks);
    };
    assert!(value <= 0.0 && record.places.is_empty());
}
