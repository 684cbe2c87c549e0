//! Models with random equations at random, hostile values, asked for everything: answers are finite, failures are typed,
//! and all of it comes to an end.

use stickslip::field::{Kernel, Smoothing};
use stickslip::study::{Along, Case, Dynamics, System};
use stickslip_models::friction::{CoulombStatic, Stribeck};
use stickslip_tests::random::Random;

stickslip::model! {
    /// Two bodies of which anything may act on anything: every coefficient is a parameter.
    pub struct Web {
        state x = 0.3;
        state v = 0.0;
        state y = -0.2;
        state w = 0.1;
        param a11 = -1.0;
        param a12 = 0.5;
        param a21 = 0.5;
        param a22 = -1.3;
        param c11 = 0.0;
        param c12 = 0.0;
        param c21 = 0.1;
        param c22 = 0.0;
        param b11 = 1.0;
        param b12 = 0.0;
        param b21 = 0.0;
        param b22 = 1.0;
        param cubic = 0.1;
        param belt = 0.2;
        param peak = 1.3 where peak >= 0.0;
        param level = 1.0 where level >= 0.0;
        param speed = 0.5 where speed > 0.0;
        friction f = CoulombStatic { static_level: peak, kinetic_level: level } opposing v - belt;
        friction g = Stribeck { static_level: peak, kinetic_level: level, speed: speed, exponent: 1.5, viscous: 0.05 }
            opposing w - belt * v;
        der(x) = v;
        der(v) = a11 * x + a12 * y + c11 * v + c12 * w + b11 * f + b12 * g - cubic * powi(x, 3);
        der(y) = w;
        der(w) = a21 * x + a22 * y + c21 * v + c22 * w + b21 * f + b22 * g;
    }
}

stickslip::model! {
    /// One state and a law that does not oppose its speed where `push` is negative.
    pub struct Slab {
        state v = 1.0;
        param push = 1.0;
        param peak = 1.0 where peak >= 0.0;
        param drag = 0.1;
        friction f = CoulombStatic { static_level: peak, kinetic_level: peak } opposing v;
        der(v) = push * f - drag * v + 0.5;
    }
}

const HOSTILE: [f64; 20] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    1e-8,
    1e8,
    -1e16,
    1e-16,
    f64::NAN,
    f64::INFINITY,
    f64::NEG_INFINITY,
    f64::MAX,
    f64::MIN,
    f64::MIN_POSITIVE,
    5e-324,
    1e100,
    -1e100,
    1e-100,
    1e99,
    0.5,
];

fn number(dice: &mut Random) -> f64 {
    if dice.unit() < 0.4 {
        HOSTILE[(HOSTILE.len() as f64 * dice.unit()) as usize]
    } else {
        dice.signed(1e-3, 1e3)
    }
}

fn case(dice: &mut Random, entry: &System) -> Case {
    const KERNELS: [Kernel; 6] = Kernel::ALL;
    let info = entry.info();
    let dynamics = if dice.unit() < 0.6 {
        Dynamics::Exact
    } else {
        let kernel = KERNELS[(6.0 * dice.unit()) as usize];
        let size = number(dice).abs();
        Dynamics::Smoothed(Smoothing { kernel, size })
    };
    let mut case = Case::declared(info, dynamics);
    for value in &mut case.parameters {
        if dice.unit() < 0.3 {
            *value = number(dice);
        }
    }
    if dice.unit() < 0.3 {
        case.start = Some(info.states.iter().map(|_| number(dice)).collect());
    }
    if dice.unit() < 0.1 {
        case.period = Some(number(dice));
    }
    if dice.unit() < 0.3 {
        case.accuracy =
            [1e-3, 1e-6, 1e-12, f64::NAN, 0.0, -1.0, 1e300][(7.0 * dice.unit()) as usize];
    }
    case
}

fn finite<'a>(what: &str, numbers: impl IntoIterator<Item = &'a f64>, case: &Case) {
    assert!(
        numbers.into_iter().all(|number| number.is_finite()),
        "{what}: {case:?}"
    );
}

fn ask(dice: &mut Random, entry: &System) -> bool {
    let mut case = case(dice, entry);
    match (5.0 * dice.unit()) as usize {
        0 => entry.motion(&case, number(dice)).is_ok_and(|motion| {
            finite("times", &motion.times, &case);
            finite("states", motion.states.iter().flatten(), &case);
            finite("forces", motion.forces.iter().flatten(), &case);
            true
        }),
        1 => entry.equilibria(&case).is_ok_and(|all| {
            finite("equilibria", all.iter().flat_map(|one| &one.state), &case);
            true
        }),
        2 => {
            let index = (case.parameters.len() as f64 * dice.unit()) as usize;
            let (from, to) = (case.parameters[index], number(dice));
            case.along = Some(Along {
                design: stickslip::field::Design::Parameter(index),
                from,
                to,
            });
            entry.equilibria_along(&case).is_ok()
        }
        _ => entry.orbit(&case).is_ok_and(|orbit| {
            finite(
                "orbit",
                [&orbit.period, &orbit.error_estimate, &orbit.residual],
                &case,
            );
            finite(
                "extrema",
                orbit.max.iter().chain(&orbit.min).chain(&orbit.state),
                &case,
            );
            true
        }),
    }
}

/// Asks these questions, each with its number as its seed: the same ones on every machine.
fn ask_all(questions: std::ops::Range<u64>) {
    let systems = [System::of::<Web, _>(), System::of::<Slab, _>()];
    let answered = questions.filter(|&number| {
        let mut dice = Random::new(number);
        let which = usize::from(dice.unit() < 0.2);
        ask(&mut dice, &systems[which])
    });
    assert!(answered.count() > 0, "no answer at all");
}

#[test]
fn something_may_be_asked_of_anything() {
    ask_all(10..50);
}

#[test]
#[ignore = "long"]
fn anything_may_be_asked_of_anything() {
    ask_all(0..100);
}

#[test]
#[ignore = "long"]
fn anything_else_may_be_asked_of_anything() {
    ask_all(100..200);
}
