//! Laws that end along a motion: a field that depends on states leaves its bounds.

use stickslip::equilibrium::find;
use stickslip::field::Design;
use stickslip::flow::{ExactFamily, FlowError, SmoothFamily, Want};
use stickslip::integrate::Tolerance;
use stickslip::model;
use stickslip::model::Model;
use stickslip::motion::Family;
use stickslip_models::friction::{Coulomb, LuGre};
use stickslip_models::press::Rigid;
use stickslip_tests::exact;

model! {
    /// A mass on a belt; what presses it down swings: n = 1 + a sin t.
    struct Pressed {
        state x: m = 0.0;
        state v: m/s = 0.0;
        state s: 1 = 0.0;
        state c: 1 = 1.0;
        param a: 1 = 2.0;
        param rate: 1/s = 1.0;
        param mass: kg = 1.0;
        param k: N/m = 1.0;
        param belt: m/s = 3.0;
        param load: N = 1.0;
        let pressing = load * (1.0 + a * s);
        friction F: N = Coulomb { level: pressing } opposing v - belt;
        der(x) = v;
        der(v) = (F - k * x) / mass;
        der(s) = rate * c;
        der(c) = -rate * s;
    }
}

model! {
    /// The same with bristles.
    struct Bristled {
        state s = 0.0;
        state c = 1.0;
        state z = 0.0;
        state v = 0.0;
        param a = 2.0;
        friction F = LuGre {
            stiffness: 10.0, damping: 0.1, viscous: 0.1, kinetic: 1.0 + a * s, peak: 2.0 + a * s, stribeck: 0.1
        } opposing v - 1.0 with z;
        der(s) = c;
        der(c) = -s;
        der(v) = F;
    }
}

fn families(a: f64) -> [Family; 3] {
    let model = Pressed {
        a,
        ..Pressed::default()
    };
    let exact = ExactFamily {
        model,
        design: None,
        tolerance: Tolerance::for_accuracy(1e-9),
        magnitude: [1.0; 4],
    };
    let smooth = |size: &str| SmoothFamily {
        model,
        smoothing: Some(size.parse().expect("a smoothing")),
        design: Design::None,
        tolerance: Tolerance::for_accuracy(1e-9),
        magnitude: [1.0; 4],
    };
    [
        exact.into(),
        smooth("tanh:10").into(),
        smooth("arctan:1e5").into(),
    ]
}

fn outcome(family: &Family, start: &[f64], time: f64) -> Result<(), FlowError> {
    let flow = family.at(0.0)?;
    let want = Want::default();
    flow.advance(&flow.place(start)?, time, want).map(|_| ())
}

const START: [f64; 4] = [0.0, 0.0, 0.0, 1.0];

#[test]
fn friction_ends_where_its_normal_force_does() {
    for family in families(2.0) {
        let Err(FlowError::OutOfLaw {
            force,
            law,
            bound,
            value,
            passes,
            time,
            ..
        }) = outcome(&family, &START, 10.0)
        else {
            panic!("it went on");
        };
        assert_eq!((force, law, bound.as_str()), ("F", "Coulomb", "level >= 0"));
        let expected = std::f64::consts::PI * 7.0 / 6.0;
        assert!((time - expected).abs() < 1e-8, "{time}");
        assert_eq!((value, passes), (0.0, true));
    }
}

#[test]
fn a_normal_force_that_only_comes_near_zero_ends_nothing() {
    for family in families(0.999_999) {
        assert_eq!(outcome(&family, &START, 20.0), Ok(()));
    }
    // It falls for 0.09 time units only: shorter than a step.
    for family in families(1.001) {
        let ended = outcome(&family, &START, 10.0);
        let Err(FlowError::OutOfLaw { time, .. }) = ended else {
            panic!("{ended:?}");
        };
        let expected = std::f64::consts::PI + (1.0 / 1.001_f64).asin();
        assert!((time - expected).abs() < 1e-6, "{time} {expected}");
    }
}

#[test]
fn the_start_is_asked_too() {
    for family in families(2.0) {
        let ended = outcome(&family, &[0.0, 0.0, -1.0, 0.0], 1.0);
        let Err(error @ FlowError::OutOfLaw { .. }) = ended else {
            panic!("{ended:?}");
        };
        let told = error.to_string();
        assert!(
            told.contains(
                "`F` has no law at t = 0: `Coulomb` wants level >= 0, and there it is -1"
            ),
            "{told}"
        );
        assert!(
            told.ends_with("where x = 0, v = 0, s = -1, c = 0"),
            "{told}"
        );
    }
}

#[test]
fn laws_with_memory_keep_their_bounds_as_well() {
    let family = Family::from(SmoothFamily {
        model: Bristled::default(),
        smoothing: None,
        design: Design::None,
        tolerance: Tolerance::for_accuracy(1e-9),
        magnitude: [1.0; 4],
    });
    let ended = outcome(&family, &[0.0, 1.0, 0.0, 0.0], 10.0);
    let Err(FlowError::OutOfLaw {
        law, bound, time, ..
    }) = ended
    else {
        panic!("{ended:?}");
    };
    assert_eq!((law, bound.as_str()), ("LuGre", "kinetic > 0"));
    assert!(
        (time - std::f64::consts::PI * 7.0 / 6.0).abs() < 1e-8,
        "{time}"
    );
}

model! {
    /// A pad that its own friction would lift: it rests at y = −2, where the normal force is 1 + y.
    struct Lifted {
        state x = 0.0;
        state u = 0.0;
        state y = -2.0;
        param mu = 0.3;
        friction F = Coulomb { level: mu * (1.0 + y) } opposing u - 1.0;
        der(x) = u;
        der(u) = F - x - u;
        der(y) = -2.0 - y;
    }
}

#[test]
fn no_equilibrium_lies_beyond_a_bound() {
    let family = Family::from(ExactFamily {
        model: Lifted::default(),
        design: None,
        tolerance: Tolerance::for_accuracy(1e-9),
        magnitude: [1.0; 3],
    });
    let modes = vec![stickslip::field::exact::Mode::SlideBackward];
    assert_eq!(
        find(&family, 0.0, &[vec![0.0, 0.0, -2.0]], |_| vec![
            modes.clone()
        ]),
        []
    );
}

model! {
    /// v = 1/(1 − t), beside a block that rubs.
    pub struct Runaway {
        state u = 1.0;
        state v = 1.0;
        param level = 0.3 where level >= 0.0;
        friction F = Coulomb { level: level } opposing u;
        der(u) = F;
        der(v) = powi(v, 2);
    }
}

model! {
    /// A term that has no value at rest, beside a block that rubs.
    pub struct Aged {
        state u = 1.0;
        state v = 1.0;
        param strength = 0.1;
        friction F = Coulomb { level: 0.3 } opposing u;
        der(u) = F;
        der(v) = -1 + strength * ln(v);
    }
}

model! {
    /// A block that falls over one of its two corners, and has no side to fall on.
    pub struct Falling {
        state y = 0.03;
        state th = 0.3;
        state v = 0.0;
        state w = 0.0;
        press A = Rigid { restitution: 0.0 } closing y + 0.1 * th;
        press B = Rigid { restitution: 0.0 } closing y - 0.1 * th;
        der(y) = v;
        der(th) = w;
        der(v) = A + B - 10.0;
        der(w) = 0.1 * (A - B) + 10.0 * th;
    }
}

fn simulated<M: Model<N>, const N: usize>(model: M, start: [f64; N], time: f64) -> FlowError {
    let family: Family = exact::family(model, 1e-9).into();
    let flow = family.at(0.0).expect("parameters within bounds");
    let place = flow.place(&start).expect("a start");
    let ended = flow.advance(&place, time, Want::default());
    ended.expect_err("it has an end")
}

#[test]
fn what_grows_without_bound_is_said_to() {
    let error = simulated(Runaway::default(), [1.0, 1.0], 10.0);
    let FlowError::Unbounded { state, time, .. } = error else {
        panic!("{error:?}");
    };
    assert_eq!(state, "v");
    assert!((time - 1.0).abs() < 1e-6, "{time}");
    let told = error.to_string();
    assert!(
        told.starts_with("the motion grows without bound: `v` passed "),
        "{told}"
    );
}

/// Where numbers overflow, the corner on which it turns has no force that could be told; it has fallen long before.
#[test]
fn what_falls_for_ever_grows_without_bound() {
    let error = simulated(Falling::default(), [0.03, 0.3, 0.0, 0.0], 1e4);
    let FlowError::Unbounded { value, .. } = error else {
        panic!("{error:?}");
    };
    assert!(value > 1e100, "{value}");
}

/// From v = 1 it falls to 0 in the time ∫ dv/(1 − a ln v) < 1, where ln has no value; or begins there.
#[test]
fn a_formula_without_a_value_is_named_with_its_line() {
    for (v, latest) in [(1.0, 1.0), (0.0, 0.0)] {
        let error = simulated(Aged::default(), [1.0, v], 10.0);
        let FlowError::Undefined { time, .. } = error else {
            panic!("{error:?}");
        };
        assert!(time <= latest, "{time}");
        let told = error.to_string();
        assert!(
            told.contains("`der(v)`") && told.contains("ln(v)"),
            "{told}"
        );
    }
}
