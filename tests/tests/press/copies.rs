//! Smooth copies of presses, and how fast they tend to the exact system.

use stickslip::field::{Design, Kernel, SmoothField, Smoothing, SmoothingError};
use stickslip::flow::{Flow, Want};
use stickslip::model::Model;
use stickslip::press_law;
use stickslip::study::{Along, Case, Dynamics, System};

use crate::models::{Bilinear, Ramp, Squeal, copy, falls, flow};

/// Those by which presses are rounded.
const KERNELS: [Kernel; 4] = [
    Kernel::Tanh,
    Kernel::Algebraic,
    Kernel::Cubic,
    Kernel::Quintic,
];

/// Where a damped force sets in with a jump and ends with a kink, rounding is an error of the second order; one that is
/// continuous and whose period does not depend on its energy feels less.
#[test]
fn a_rounded_contact_tends_to_the_exact_one() {
    for kernel in KERNELS {
        let error = |c: f64, size: f64| {
            let model = Bilinear {
                c,
                ..Default::default()
            };
            let (exact, copied) = (
                flow(&model, None),
                copy(&model, Smoothing { kernel, size }, Design::None),
            );
            let start = [0.5, -1.0];
            let place = exact.place(start).unwrap();
            let expected = exact.advance(&place, 6.0, Want::default()).unwrap();
            let place = copied.place(start).unwrap();
            let found = copied.advance(&place, 6.0, Want::default()).unwrap();
            found.end.state[0] - expected.end.state[0]
        };
        if kernel != Kernel::Algebraic {
            let ratio = falls([1e3, 1e4], |size| error(0.9, size));
            assert!((ratio - 100.0).abs() < 1.0, "{kernel}: {ratio}");
        }
        assert!(error(0.0, 1e3).abs() < 1e-6 && error(0.9, 1e5).abs() < 1e-8);
    }
}

/// Derivatives by states, by a restitution, a friction under a reaction, and by the size itself.
#[test]
fn copies_have_derivatives() {
    let ramp = Ramp::default();
    let start = [0.0, 0.3, 0.8, -0.2, 0.0];
    let time = 3.0;
    let smoothing: Smoothing = "tanh:3e2".parse().unwrap();
    let end = |ramp: &Ramp, smoothing: Smoothing, start: [f64; 5]| {
        let flow = copy(ramp, smoothing, Design::None);
        let passage = flow.advance(&flow.place(start).unwrap(), time, Want::default());
        passage.unwrap().end.state
    };
    let judge = |exact: f64, of: &dyn Fn(f64) -> f64, what: &str| {
        let h = 1e-4;
        let slope = (8.0 * (of(h) - of(-h)) - (of(2.0 * h) - of(-2.0 * h))) / (12.0 * h);
        let near = (exact - slope).abs() < 1e-5 * (1.0 + exact.abs());
        assert!(near, "{what}: {exact} by the flow, {slope} by differences");
    };
    for (design, name) in [
        (Design::Parameter(Ramp::e.index), "restitution"),
        (Design::Parameter(Ramp::mu.index), "friction"),
        (Design::Parameter(Ramp::slope.index), "slope"),
        (Design::Smoothing, "size"),
    ] {
        let flow = copy(&ramp, smoothing, design);
        let passage = flow.advance(&flow.place(start).unwrap(), time, Want::DERIVATIVES);
        let derivatives = passage.unwrap().derivatives.unwrap();
        for row in 0..4 {
            let moved = |h: f64| match design {
                Design::Parameter(parameter) => {
                    let mut values = ramp.values();
                    values.as_mut()[parameter] += h;
                    end(&Ramp::from_values(values), smoothing, start)[row]
                }
                _ => {
                    let size = smoothing.size * h.exp();
                    end(&ramp, Smoothing { size, ..smoothing }, start)[row]
                }
            };
            judge(derivatives.design[row], &moved, name);
            for column in 0..4 {
                let moved = |h: f64| {
                    let mut start = start;
                    start[column] += h;
                    end(&ramp, smoothing, start)[row]
                };
                judge(derivatives.state[row][column], &moved, "state");
            }
        }
    }
}

/// Squeal with lift-off: friction under a press that is rounded with it.
#[test]
fn friction_and_presses_are_copied_together() {
    let system = System::of::<Squeal, 4>();
    let model = Squeal {
        c3: 0.3,
        ..Default::default()
    };
    let mut case = Case::declared(Squeal::INFO, Dynamics::Exact);
    case.parameters = model.values().as_ref().to_vec();
    case.start = Some(vec![0.0, 0.5, 0.01, 0.0]);
    let exact = system.orbit(&case).unwrap();
    for (size, near) in [(1e3, 1e-2), (1e5, 1e-4), (1.1e5, 1e-4)] {
        let mut copied = case.clone();
        copied.dynamics = Dynamics::Smoothed(Smoothing {
            kernel: Kernel::Quintic,
            size,
        });
        copied.start = Some(exact.state.clone());
        copied.period = Some(exact.period);
        let found = system.orbit(&copied).unwrap();
        let error = found.period / exact.period - 1.0;
        assert!(error.abs() < near, "{size}: {error}");
    }
    // The size of a copy is followed like any parameter.
    case.dynamics = Dynamics::Smoothed("tanh:1e3".parse().unwrap());
    case.start = Some(exact.state.clone());
    case.period = Some(exact.period);
    case.along = Some(Along {
        design: Design::Smoothing,
        from: 1e3,
        to: 1e4,
    });
    let branch = system.branch(&case).unwrap();
    let last = branch.points.last().unwrap();
    let end = last.r.unwrap();
    assert!((end / 1e4 - 1.0).abs() < 1e-9, "{}", branch.ended.reason);
}

press_law! {
    /// What gives back less of a fast approach.
    pub(crate) struct Tired {
        param restitution: 1 where 0.0 <= restitution <= 1.0;

        rebound(v) = restitution * v / (1.0 + v);
    }
}

stickslip::model! {
    /// A ball on a floor that tires.
    pub(crate) struct Dribble {
        state y = 1.0;
        state v = 0.0;
        param e = 0.8 where 0.0 <= e <= 1.0;
        press R = Tired { restitution: e } closing y;
        der(y) = v;
        der(v) = R - 1.0;
    }
}

#[test]
fn what_no_force_can_know_is_refused() {
    let smoothing = "quintic:1e5".parse().unwrap();
    let refused = SmoothField::new(&Dribble::default(), Some(smoothing), Design::None).err();
    assert!(
        matches!(refused, Some(SmoothingError::Rebound { press: "R", slow, fast }) if slow > 0.79 && fast < 1e-3),
        "{refused:?}"
    );
}
