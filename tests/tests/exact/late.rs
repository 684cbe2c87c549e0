//! Motions late in their passage, where the time and the phase of a drive have few digits left for what happens next.

use std::f64::consts::{PI, TAU};

use stickslip::flow::exact::ExactFlow;
use stickslip::flow::{Flow, FlowError, Want};
use stickslip::integrate::{IntegrationError, Tolerance};
use stickslip::model;
use stickslip_models::friction::Coulomb;
use stickslip_models::press::{Compliant, Rigid};

model! {
    /// A tool that dry friction holds until a tooth cuts: once in each turn.
    struct Milling {
        state x: m = 0.0;
        state v: m/s = 0.0;
        param mass: kg = 0.04 where mass > 0.0;
        param k: N/m = 1.3e6;
        param c: N*s/m = 6.0;
        param cut: N/m = 4e5 where cut > 0.0;
        param feed: m = 1e-4;
        param hold: N = 2.0 where hold >= 0.0;
        drive phi at 2000.0;
        press C: N = Compliant { stiffness: cut, damping: 0.0 } closing x - feed * sin(phi);
        friction F: N = Coulomb { level: hold } opposing v;
        der(x) = v;
        der(v) = (C + F - k * x - c * v) / mass;
    }
}

model! {
    /// A follower that rests on its cam all along, and is at its turn where the cam's turn begins.
    struct Follower {
        state x: m = -0.011;
        state v: m/s = 0.0;
        drive phi at 100.0;
        press R: N = Rigid { restitution: 0.3 } closing x + 0.01 * cos(phi) + 0.001 * cos(2.0 * phi);
        friction F: N = Coulomb { level: 4.0 } opposing v;
        der(x) = v;
        der(v) = (R + F - 4e3 * x - 5.0 * v - 60.0) / 0.3;
    }
}

model! {
    /// A mass between springs that rubs.
    struct Rung {
        state x = 1.0;
        state v = 0.0;
        friction F = Coulomb { level: 0.1 } opposing v;
        der(x) = v;
        der(v) = F + 0.5 * v - 100.0 * x - powi(v, 3);
    }
}

fn flow<M: stickslip::model::Model<N> + Default, const N: usize>() -> ExactFlow<M, N> {
    ExactFlow::new(&M::default(), None, Tolerance::for_accuracy(1e-12)).unwrap()
}

/// Rounding errors of the phase move the force by more than what a contact is released to.
#[test]
fn contacts_let_go_at_any_phase_of_the_drive() {
    let tool = flow::<Milling, 3>();
    for k in 0..40 {
        let late = 1025.0 + 23.0 * f64::from(k);
        let from = |phase: f64| {
            let start = tool.place([0.0, 0.0, phase]).unwrap();
            tool.advance(&start, 0.02, Want::default())
        };
        let (late, early) = (from(late).unwrap(), from(late.rem_euclid(TAU)).unwrap());
        assert!(late.segments.len() > 2, "it never lets go");
        for j in 0..2 {
            let (late, early) = (late.end.state[j], early.end.state[j]);
            assert!((late - early).abs() < 1e-8, "{late} {early}");
        }
    }
}

#[test]
fn a_turn_that_ends_just_where_friction_turns_ends() {
    let follower = flow::<Follower, 3>();
    for speed in [0.0, 1e-17, -1e-17, 3.4e-15, -3e-15] {
        let start = follower.place([-0.011, speed, 0.0]).unwrap();
        let turn = follower.advance(&start, 0.02 * PI, Want::default());
        let end = turn.unwrap().end.state;
        assert!((end[0] + 0.011).abs() < 1e-12, "{end:?}");
    }
}

/// However long a passage is meant to be, events at the usual distance are no chatter.
#[test]
fn events_of_a_swing_are_no_chatter_in_a_long_passage() {
    let rung = flow::<Rung, 2>();
    let start = rung.place([1.0, 0.0]).unwrap();
    let followed = rung.advance(&start, 1e12, Want::default());
    let few = matches!(
        followed,
        Err(FlowError::Integration(
            IntegrationError::TooManySteps { .. }
        ))
    );
    assert!(few, "{:?}", followed.map(|passage| passage.time));
}
