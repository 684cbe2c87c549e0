use super::*;
use crate::field::Linear;
use crate::integrate::Motion;

/// y₁' = r y₁ (1 − y₁), y₂' = y₁ y₂: nonlinear, with every derivative in closed form.
struct Logistic {
    rate: f64,
}

impl Field<2> for Logistic {
    fn f(&self, y: &[f64; 2]) -> [f64; 2] {
        [self.rate * y[0] * (1.0 - y[0]), y[0] * y[1]]
    }

    fn linearise(&self, y: &[f64; 2]) -> Linear<2> {
        Linear {
            f: self.f(y),
            jacobian: [[self.rate * (1.0 - 2.0 * y[0]), 0.0], [y[1], y[0]]],
            design: [y[0] * (1.0 - y[0]), 0.0],
        }
    }
}

impl Logistic {
    fn exact(&self, y: [f64; 2], t: f64) -> Motion<2> {
        let (r, e) = (self.rate, (self.rate * t).exp());
        let d = 1.0 + y[0] * (e - 1.0);
        let end = [y[0] * e / d, y[1] * d.powf(1.0 / r)];
        let power = y[0] * t * e / (d * r) - d.ln() / (r * r);
        Motion {
            state: end,
            tangent: [
                [e / (d * d), 0.0],
                [end[1] * (e - 1.0) / (r * d), end[1] / y[1]],
            ],
            design: [t * y[0] * (1.0 - y[0]) * e / (d * d), end[1] * power],
            trace: r * t - 2.0 * d.ln() + d.ln() / r,
        }
    }
}

const FIELD: Logistic = Logistic { rate: 1.7 };
const START: [f64; 2] = [0.08, 0.5];

fn tight(relative: f64) -> Settings {
    Settings::new(Tolerance {
        relative,
        absolute: relative,
    })
}

fn error_after(steps: u32, span: f64) -> f64 {
    let mut stepper = Stepper::new(&FIELD, tight(1e-6), START, 0.0, span);
    for _ in 0..steps {
        stepper.shorten(span / f64::from(steps)).unwrap();
        stepper.commit();
    }
    distance(stepper.from(), &FIELD.exact(START, span).state)
}

fn distance<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    a.iter()
        .zip(b)
        .map(|(a, b)| (a - b).abs())
        .fold(0.0, f64::max)
}

#[test]
fn steps_converge_with_order_8() {
    let order = (error_after(12, 6.0) / error_after(24, 6.0)).log2();
    assert!((7.6..9.0).contains(&order), "{order}");
}

#[test]
fn dense_output_converges_with_order_8_inside_a_step() {
    let local = |length: f64| {
        let mut stepper = Stepper::new(&FIELD, tight(1e-6), START, 0.0, 1.0);
        stepper.shorten(length).unwrap();
        let dense = stepper.dense();
        let thetas = [0.1, 0.3, 0.55, 0.8, 0.95];
        thetas
            .map(|theta| {
                distance(
                    &dense.state(theta),
                    &FIELD.exact(START, theta * length).state,
                )
            })
            .into_iter()
            .fold(0.0, f64::max)
    };
    let order = (local(0.4) / local(0.2)).log2();
    assert!((7.5..9.0).contains(&order), "{order}");
}

#[test]
fn dense_output_meets_both_ends() {
    let mut stepper = Stepper::new(&FIELD, tight(1e-9), START, 0.0, 1.0);
    stepper.attempt(1.0).unwrap();
    let dense = stepper.dense();
    assert_eq!(dense.state(0.0), START);
    assert!(distance(&dense.state(1.0), stepper.end()) < 1e-16);
    let ends = dense.component(1);
    assert_eq!(ends.coefficients()[0], START[1]);
    assert!((ends.value(0.37) - dense.state(0.37)[1]).abs() < 1e-15);
}

#[test]
fn tangents_are_those_of_the_closed_form() {
    let mut work = Work::default();
    let from = Motion::from(START);
    let end = integrate(&FIELD, tight(1e-12), from, 5.0, &mut work, |_| {
        ControlFlow::Continue(())
    })
    .unwrap();
    let exact = FIELD.exact(START, 5.0);
    assert!(distance(&end.state, &exact.state) < 1e-11);
    assert!(distance(&end.design, &exact.design) < 1e-10);
    assert!(distance(&end.tangent[0], &exact.tangent[0]) < 1e-10);
    assert!(distance(&end.tangent[1], &exact.tangent[1]) < 1e-9);
    assert!((end.trace - exact.trace).abs() < 1e-11);
    assert_eq!(work.evaluations, 1, "only the guess of the first step");
    assert!(work.steps > 5 && work.linearisations >= 12 * work.steps);
}

#[test]
fn errors_follow_the_tolerance() {
    for relative in [1e-5, 1e-7, 1e-9, 1e-11] {
        let mut work = Work::default();
        let end = integrate(&FIELD, tight(relative), START, 5.0, &mut work, |_| {
            ControlFlow::Continue(())
        })
        .unwrap();
        let error = distance(&end, &FIELD.exact(START, 5.0).state);
        assert!(error < 40.0 * relative, "{relative:e}: {error:e}");
    }
}

#[test]
fn the_step_map_is_the_step() {
    let mut stepper = Stepper::new(&FIELD, tight(1e-9), START, 0.0, 1.0);
    stepper.attempt(1.0).unwrap();
    let end = stepper.step_map(0.31);
    stepper.shorten(0.31).unwrap();
    assert_eq!(&end, stepper.end());
}

/// y' = −λ (y − cos-like slow part).
struct Stiff;

impl Field<1> for Stiff {
    fn f(&self, y: &[f64; 1]) -> [f64; 1] {
        [-1e5 * (y[0] - 1.0)]
    }

    fn linearise(&self, y: &[f64; 1]) -> Linear<1> {
        Linear {
            f: self.f(y),
            jacobian: [[-1e5]],
            design: [0.0],
        }
    }
}

/// y' = y²: infinite at t = 1/y₀.
struct BlowUp;

impl Field<1> for BlowUp {
    fn f(&self, y: &[f64; 1]) -> [f64; 1] {
        [y[0] * y[0]]
    }

    fn linearise(&self, y: &[f64; 1]) -> Linear<1> {
        Linear {
            f: self.f(y),
            jacobian: [[2.0 * y[0]]],
            design: [0.0],
        }
    }
}

fn end_of<F: Field<1>>(field: &F, settings: Settings, from: f64) -> Result<f64, IntegrationError> {
    let mut work = Work::default();
    let go_on = |_: &mut Stepper<'_, F, [f64; 1], 1>| ControlFlow::Continue(());
    integrate(field, settings, [from], 2.0, &mut work, go_on).map(|y| y[0])
}

#[test]
fn stiffness_is_noticed() {
    let outcome = end_of(&Stiff, tight(1e-6), 2.0);
    assert!(
        matches!(outcome, Err(IntegrationError::Stiff { .. })),
        "{outcome:?}"
    );
}

#[test]
fn failures_are_typed() {
    let outcome = end_of(&BlowUp, tight(1e-6), 1.0);
    assert!(
        matches!(
            outcome,
            Err(IntegrationError::StepTooSmall { .. } | IntegrationError::NotFinite { .. })
        ),
        "{outcome:?}"
    );
    let outcome = end_of(&BlowUp, tight(1e-6), f64::NAN);
    assert!(
        matches!(outcome, Err(IntegrationError::NotFinite { .. })),
        "{outcome:?}"
    );
    let few = Settings {
        steps: 7,
        ..tight(1e-12)
    };
    let outcome = end_of(&BlowUp, few, 1.0);
    assert!(
        matches!(
            outcome,
            Err(IntegrationError::TooManySteps { steps: 7, .. })
        ),
        "{outcome:?}"
    );
}

#[test]
fn a_motion_at_rest_stays() {
    assert_eq!(end_of(&Stiff, tight(1e-6), 1.0), Ok(1.0));
    assert_eq!(end_of(&BlowUp, tight(1e-6), 0.0), Ok(0.0));
}

/// A pendulum that hangs, y₁'' = −ω² y₁ − 2 δ y₁', with ω = 1000 and δ = 20.
struct Hanging;

const OMEGA: f64 = 1000.0;
const DELTA: f64 = 20.0;

impl Field<2> for Hanging {
    fn f(&self, y: &[f64; 2]) -> [f64; 2] {
        [y[1], -OMEGA * OMEGA * y[0] - 2.0 * DELTA * y[1]]
    }

    fn linearise(&self, y: &[f64; 2]) -> Linear<2> {
        Linear {
            f: self.f(y),
            jacobian: [[0.0, 1.0], [-OMEGA * OMEGA, -2.0 * DELTA]],
            design: [0.0, 0.0],
        }
    }
}

#[test]
fn a_motion_that_keeps_still_has_the_derivatives_of_what_would_move() {
    let mut work = Work::default();
    let from = Motion::from([0.0, 0.0]);
    let span = 0.1;
    let end = integrate(&Hanging, tight(1e-12), from, span, &mut work, |_| {
        ControlFlow::Continue(())
    })
    .unwrap();
    let ring = (OMEGA * OMEGA - DELTA * DELTA).sqrt();
    let (sin, cos) = (ring * span).sin_cos();
    let fall = (-DELTA * span).exp();
    let exact = [
        [cos + DELTA / ring * sin, sin / ring],
        [-OMEGA * OMEGA / ring * sin, cos - DELTA / ring * sin],
    ];
    for (i, j, size) in [(0, 0, 1.0), (0, 1, 1e-3), (1, 0, 1e3), (1, 1, 1.0)] {
        let off = (end.tangent[i][j] - fall * exact[i][j]).abs();
        assert!(
            off < 1e-7 * size,
            "{i} {j}: {off:e} in {} steps",
            work.steps
        );
    }
}
