//! Names that clash with constants, generics and locals; places where a declaration may stand; and no
//! warning from generated code, whatever the user's crate forbids.
#![deny(warnings)]
#![deny(clippy::all, clippy::pedantic, missing_docs, nonstandard_style, unused)]
#![allow(clippy::float_cmp)]

use stickslip::friction::{ContactRule, ForceSlopes, FrictionLaw, SlopeRule};
use stickslip::model::Model;
use stickslip::scalar::Scalar;
use stickslip::{friction_law, model};
use stickslip_tests::lanes::linearised;

#[allow(non_upper_case_globals)]
const g: f64 = 9.81;
#[allow(non_upper_case_globals)]
const s: f64 = -1.0;
#[allow(non_upper_case_globals, dead_code)]
static params: f64 = -1.0;
#[allow(non_upper_case_globals, dead_code)]
const contacts: f64 = -1.0;

/// Every contact slides forwards.
#[derive(Clone)]
struct Forward;

impl<D: Scalar> ContactRule<D> for Forward {
    fn force<L: FrictionLaw<D>>(&mut self, _contact: usize, law: &L, speed: D) -> D {
        -law.slip(speed)
    }
}

impl SlopeRule for Forward {
    fn force<L: FrictionLaw<f64>>(
        &mut self,
        _contact: usize,
        law: &L,
        along: &L,
        speed: f64,
    ) -> ForceSlopes {
        let law = law.slopes(along, speed);
        ForceSlopes {
            force: -law.slip,
            by_speed: -law.slip_by_speed,
            along: -law.slip_along,
            by_design: 0.0,
        }
    }
}

friction_law! {
    /// Its fields and its speed are called like constants, types and methods.
    pub struct Awkward {
        param g: N;
        param A: s/m where A >= 0.0;
        param D: N where 0.0 <= D;
        param Self_: 1;
        param limit: 1;
        stick = g * limit;
        slip(s) = Self_ * g / (1.0 + A * s) + D;
    }
}

friction_law! {
    /// Has no parameters.
    pub struct Unit {
        stick = 1.0;
        slip(s) = 2.0 / (1.0 + s);
    }
}

model! {
    /// Every name is somebody else's.
    pub struct Model_ {
        state params = 1.0;
        state contacts = 2.0;
        state s = 3.0;
        param D = 1.0;
        param A = 2.0;
        param N = 3.0;
        param T = 4.0;
        param L = 5.0;
        param P = 6.0;
        param g = 7.0;
        param q = 8.0;
        param self_ = 9.0;
        param r#type = 10.0;
        param None = 11.0;
        param Some = 12.0;
        param Ok = 13.0;
        param f64 = 14.0;
        param core = 15.0;
        param stickslip = 16.0;
        param ψ = 17.0;
        friction force = Awkward { g: g, A, D: 0.0, Self_: 1.0, limit: 2.0 } opposing s;
        friction unit = Unit {} opposing contacts;
        let state_ = D + A * N * T / (L + P) - q * self_ + r#type;
        let rates = None + Some * Ok / f64 - core * stickslip + ψ;
        der(params) = contacts;
        der(contacts) = (force + unit) - (state_);
        der(s) = -(-rates * s) + crate::awkward_names::g;
    }
}

#[test]
fn any_name_is_the_users() {
    let model = Model_ {
        g: 0.5,
        ..Default::default()
    };
    assert_eq!(Model_::r#type.index, 9);
    assert_eq!(Model_::INFO.parameters[9].name, "type");
    let rates = Model_::rhs(&model.values(), [1.0, 2.0, 3.0], &mut Forward);
    let state_ = 1.0 + 2.0 * 3.0 * 4.0 / 11.0 - 72.0 + 10.0;
    let force = -(0.5 / (1.0 + 2.0 * 3.0)) - 2.0 / 3.0;
    assert_eq!(rates[..2], [2.0, force - state_]);
    let slope = 11.0 + 12.0 * 13.0 / 14.0 - 240.0 + 17.0;
    assert_eq!(rates[2], slope * 3.0 + g);
    assert_eq!(s, -1.0);
}

#[test]
fn derivatives_know_every_name() {
    let (model, state) = (Model_::default(), [1.0, 2.0, 3.0]);
    let expected = linearised::<Model_, 3, 17>(&model, state, Forward);
    for (design, by_design) in expected.by_parameter.iter().enumerate() {
        let seeds = std::array::from_fn(|i| f64::from(i == design));
        let found = Model_::linearise(&model.values(), &seeds, state, &mut Forward);
        assert_eq!(found.f, expected.f);
        let rows = found.jacobian.as_flattened();
        let columns = rows.iter().chain(&found.design);
        let expected = expected.jacobian.as_flattened().iter().chain(by_design);
        for (a, b) in columns.zip(expected) {
            assert!((a - b).abs() <= 1e-14 * b.abs(), "{a:e}, by lanes {b:e}");
        }
    }
}

#[test]
fn a_declaration_may_stand_in_a_function() {
    friction_law! {
        struct Local {
            param level;
            stick = level;
            slip(s) = level + 0.0 * s;
        }
    }
    model! {
        struct Inner {
            state v = 1.0;
            param level: 1 = 2.0 where 0 < level <= 1e3;
            friction F: N = Local { level } opposing v;
            der(v) = F;
        }
    }
    let inner = Inner::default();
    assert_eq!(Inner::rhs(&inner.values(), [3.0], &mut Forward), [-2.0]);
    assert_eq!(Inner::level.index, 0);
}

macro_rules! oscillator {
    ($name:ident, $frequency:literal, $force:expr, $path:path) => {
        model! {
            /// Declared by another macro.
            struct $name {
                state x = 1.0;
                state v = -0.0;
                param omega = $frequency where 0.0 <= omega;
                friction F = $path { limit: $force, decay: 2.0 } opposing v;
                der(x) = v;
                der(v) = F - powi(omega, 2) * $force / 2 * x;
            }
        }
    };
}

mod laws {
    pub(crate) use stickslip_models::friction::Weakening;
}

oscillator!(FromMacro, 3.0, 1.0 + 1.0, laws::Weakening);

#[test]
fn a_declaration_may_come_from_a_macro() {
    let rates = FromMacro::rhs(&FromMacro::default().values(), [2.0, 1.0], &mut Forward);
    assert_eq!(rates, [1.0, -2.0 / 3.0 - 18.0]);
    let info = FromMacro::INFO;
    assert_eq!(info.command, "from-macro");
    assert_eq!(
        info.states[1].equation,
        "F - powi(omega, 2) * (1.0 + 1.0) / 2 * x"
    );
}

model! {
    /// Every function, each at a place where it is smooth.
    struct Functions {
        state x = 0.5;
        param p = 1.5;
        let trigonometric = acos(x) + asin(x) + atan(x) + cos(x) + sin(x) + tan(x);
        let hyperbolic = acosh(1 + x) + asinh(x) + atanh(x) + cosh(x) + sinh(x) + tanh(x);
        let powers = powi(x, 3) + powi(x, -2) + powf(x, 2.5) + powf(x, p) + powf(2, x) + powi(x, 0);
        let constants = sqrt(2.0) * std::f64::consts::PI - powi(2.0, 10) + powf(2.0, 0.5);
        let others = exp(x) + ln(x) + sqrt(x);
        der(x) = trigonometric + hyperbolic + powers + constants + others;
    }
}

fn functions(x: f64, p: f64) -> f64 {
    let trigonometric = x.acos() + x.asin() + x.atan() + x.cos() + x.sin() + x.tan();
    let hyperbolic = (1.0 + x).acosh() + x.asinh() + x.atanh() + x.cosh() + x.sinh() + x.tanh();
    let powers = x.powi(3) + x.powi(-2) + x.powf(2.5) + x.powf(p) + 2f64.powf(x) + 1.0;
    let root = 2f64.sqrt();
    let constants = root * std::f64::consts::PI - 1024.0 + root;
    trigonometric + hyperbolic + powers + constants + x.exp() + x.ln() + x.sqrt()
}

#[test]
fn functions_are_those_of_the_standard_library() {
    for (x, p) in [(0.5, 1.5), (0.1, -0.5), (0.9, 3.0)] {
        let found = linearised::<Functions, 1, 1>(&Functions { p }, [x], Forward);
        assert!((found.f[0] - functions(x, p)).abs() < 1e-12);
        let step = 1e-6;
        let by_x = (functions(x + step, p) - functions(x - step, p)) / (2.0 * step);
        let by_p = (functions(x, p + step) - functions(x, p - step)) / (2.0 * step);
        assert!((found.jacobian[0][0] - by_x).abs() < 1e-6 * by_x.abs());
        assert!((found.by_parameter[0][0] - by_p).abs() < 1e-6);
    }
}

#[test]
fn a_negative_zero_stays_one() {
    assert!(FromMacro::INFO.states[1].start.is_sign_negative());
}
