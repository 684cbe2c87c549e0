//! Friction against fixed ground, where a relative speed has no term but itself.

use stickslip::flow::Want;
use stickslip::model;
use stickslip::model::Model;
use stickslip::motion::{Family, Flow};
use stickslip_models::friction::{Coulomb, Weakening};
use stickslip_tests::exact;
use stickslip_tests::random::Random;

const ACCURACY: f64 = 1e-11;

model! {
    /// Three blocks drawn over the ground by a plate.
    pub struct Drawn {
        state u[3] = 0.0;
        state v[3] = 0.0;
        param coupling = 2.0 where coupling >= 0.0;
        param plate = 0.1;
        param limit = 1.0 where limit >= 0.0;
        param decay = 2.0 where decay >= 0.0;
        for i in 0..3 {
            friction F[i] = Weakening { limit: limit * (1.0 + 0.07 * i), decay: decay } opposing v[i];
            der(u[i]) = plate - v[i];
        }
        der(v[0]) = u[0] + coupling * (u[0] - u[1]) + F[0];
        der(v[1]) = u[1] + coupling * (2 * u[1] - u[0] - u[2]) + F[1];
        der(v[2]) = u[2] + coupling * (u[2] - u[1]) + F[2];
    }
}

model! {
    /// The same as the plate sees it.
    pub struct Seen {
        state u[3] = 0.0;
        state w[3] = 0.0;
        param coupling = 2.0 where coupling >= 0.0;
        param plate = 0.1;
        param limit = 1.0 where limit >= 0.0;
        param decay = 2.0 where decay >= 0.0;
        for i in 0..3 {
            friction F[i] = Weakening { limit: limit * (1.0 + 0.07 * i), decay: decay } opposing plate - w[i];
            der(u[i]) = w[i];
        }
        der(w[0]) = -u[0] - coupling * (u[0] - u[1]) - F[0];
        der(w[1]) = -u[1] - coupling * (2 * u[1] - u[0] - u[2]) - F[1];
        der(w[2]) = -u[2] - coupling * (u[2] - u[1]) - F[2];
    }
}

model! {
    /// A sledge on the ground, drawn by its damping only.
    pub struct Sledge {
        state x = 0.0;
        state v = 1.0;
        param level = 1.0 where level >= 0.0;
        param damping = 1.0 where damping >= 0.0;
        friction F = Coulomb { level: level } opposing v;
        der(x) = v;
        der(v) = F - damping * v;
    }
}

fn flow<M: Model<N>, const N: usize>(model: M) -> Box<dyn Flow> {
    let family: Family = exact::family(model, ACCURACY).into();
    family.at(0.0).expect("parameters within bounds")
}

/// When which contact switched, and how.
fn switches(flow: &dyn Flow, start: &[f64], time: f64) -> Vec<(f64, usize, String)> {
    let place = flow.place(start).unwrap();
    let passage = flow.advance(&place, time, Want::default()).unwrap();
    let switches = passage.events.iter().filter(|event| event.kind.is_switch());
    switches
        .map(|event| (event.time, event.contact, event.mode.to_string()))
        .collect()
}

/// Galilei: what happens does not depend on who looks.
#[test]
fn ground_and_plate_see_the_same_events() {
    let mut random = Random::new(12);
    for _ in 0..40 {
        let (coupling, plate) = (random.positive(0.3, 10.0), random.signed(1e-3, 0.5));
        let (limit, decay) = (random.positive(0.5, 2.0), random.positive(0.1, 5.0));
        let drawn = flow(Drawn {
            coupling,
            plate,
            limit,
            decay,
        });
        let seen = flow(Seen {
            coupling,
            plate,
            limit,
            decay,
        });
        let u: [f64; 3] = random.array(|r| r.real(1.2));
        let from_ground = [u[0], u[1], u[2], 0.0, 0.0, 0.0];
        let from_plate = [u[0], u[1], u[2], plate, plate, plate];
        // Long enough for some slips, too short for chaos to speak.
        let time = (2.5 / plate.abs()).min(60.0);
        let ground = switches(&*drawn, &from_ground, time);
        let moving = switches(&*seen, &from_plate, time);
        assert_eq!(
            ground.len(),
            moving.len(),
            "{coupling} {plate} {limit} {decay}"
        );
        for (a, b) in ground.iter().zip(&moving) {
            assert!((a.0 - b.0).abs() < 1e-6 * time, "{a:?} against {b:?}");
            assert_eq!((a.1, &a.2), (b.1, &b.2));
        }
    }
}

/// v = (1 + L/c) exp(−c t) − L/c, at rest from t = ln(1 + c/L)/c on, over fifty decades of the level.
#[test]
fn a_sledge_comes_to_rest_at_any_level() {
    for exponent in (-50..=0).step_by(5) {
        let (level, damping) = (10_f64.powi(exponent), 1.0);
        let sledge = flow(Sledge { level, damping });
        let events = switches(&*sledge, &[0.0, 1.0], 1000.0);
        let [(time, 0, mode)] = &events[..] else {
            panic!("{level:e}: {events:?}");
        };
        assert_eq!(mode, "stick");
        // Below the tolerance of speeds the instant is not known better than their errors let it be.
        let known = 1e-9 + (1e-10 / level).ln_1p();
        let right = (damping / level).ln_1p() / damping;
        assert!(
            (time - right).abs() < known,
            "{level:e}: {time} against {right}"
        );
    }
    let slow = switches(&*flow(Sledge::default()), &[0.0, 1e-300], 1.0);
    assert_eq!(slow.len(), 1);
}

/// Friction that is turned off is no event: the same as a model without it, from rest too.
#[test]
fn a_contact_without_force_does_nothing() {
    let drawn = flow(Drawn {
        limit: 0.0,
        plate: 0.0,
        ..Drawn::default()
    });
    let start = [1e-3, 0.0, 0.0, 0.0, 0.0, 0.0];
    let place = drawn.place(&start).unwrap();
    let passage = drawn.advance(&place, 3.0, Want::default()).unwrap();
    assert!(passage.events.is_empty(), "{:?}", passage.events);
    // The middle mode of a row of equal blocks grows or swings by itself: u' = -v, v' = K u.
    let sum: f64 = passage.end.state[..3].iter().sum();
    assert!((sum - 1e-3 * 3.0_f64.cos()).abs() < 1e-12, "{sum}");
    let at_rest = drawn.place(&[0.0; 6]).unwrap();
    assert!(drawn.advance(&at_rest, 50.0, Want::default()).is_ok());
}
