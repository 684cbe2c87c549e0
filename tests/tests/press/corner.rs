//! What is pinned where friction at rest exceeds that of sliding, and in a corner, where one wall loads the friction that helps
//! the other one.

use std::f64::consts::TAU;
use std::ops::ControlFlow;

use stickslip::field::exact::Mode;
use stickslip::flow::{EventKind, Flow, Want};
use stickslip::model;
use stickslip::model::Model;
use stickslip::study::{Case, Dynamics, Role, System, Topic};
use stickslip_models::friction::{Coulomb, CoulombStatic};
use stickslip_models::press::Rigid;
use stickslip_tests::random::Random;

use crate::derivatives::{Tally, compare};
use crate::models::flow;
use crate::pinned::flies;

model! {
    /// A hammer in a guide that holds more at rest than it rubs.
    pub(crate) struct Gripped {
        state x = 0.0;
        state v = 0.0;
        param load = 1.0;
        param preload = 0.3;
        param dry = 0.25 where dry >= 0.0;
        param grip = 0.4;
        param e = 0.0 where 0.0 <= e <= 1.0;
        drive phi at 1.0;
        press N = Rigid { restitution: e } closing -x;
        friction S = CoulombStatic { static_level: grip, kinetic_level: dry } opposing v;
        der(x) = v;
        der(v) = load * cos(phi) + preload - N + S;
    }
}

model! {
    /// A block in a corner, which a force draws off one wall; both rub.
    pub(crate) struct Corner {
        state x = 0.0;
        state vx = 0.0;
        state y = 0.0;
        state vy = 0.0;
        param load = 1.0;
        param preload = 0.3;
        param weight = 0.5 where weight > 0.0;
        param lift = 0.0;
        param floor = 0.5 where floor >= 0.0;
        param side = 0.3 where side >= 0.0;
        param e = 0.0 where 0.0 <= e <= 1.0;
        drive phi at 1.0;
        press W = Rigid { restitution: e } closing -x;
        press N = Rigid { restitution: e } closing y;
        friction F = Coulomb { level: floor * N } opposing vx;
        friction G = Coulomb { level: side * W } opposing vy;
        der(x) = vx;
        der(vx) = load * cos(phi) + preload - W + F;
        der(y) = vy;
        der(vy) = N - weight - lift * sin(phi) + G;
    }
}

/// What happens to a mass that stays until `held` is exceeded and then moves with `rubs`: it opens, turns, and hits.
fn leaves<M: Model<N>, const N: usize>(model: &M, start: [f64; N], [held, rubs]: [f64; 2]) {
    let flow = flow(model, None);
    let place = flow.place(start).unwrap();
    let passage = flow.advance(&place, 2.0 * TAU, Want::default()).unwrap();
    let times = |kind: &dyn Fn(&EventKind) -> bool| -> Vec<f64> {
        let events = passage.events.iter();
        let events = events.filter(|event| kind(&event.kind));
        events.map(|event| event.time).collect()
    };
    let opens = times(&|kind| matches!(kind, EventKind::Opening));
    let turns =
        times(&|kind| matches!(kind, EventKind::Crossing { .. } | EventKind::Landing { .. }));
    let hits = times(&|kind| matches!(kind, EventKind::Impact { .. }));
    assert!(opens.len() == 2 && !hits.is_empty(), "{:?}", passage.events);
    assert!((opens[0] - (-0.3 - held).acos()).abs() < 1e-11, "{opens:?}");
    assert!((opens[1] - opens[0] - TAU).abs() < 1e-11, "{opens:?}");
    let turn = turns.into_iter().find(|time| *time > opens[0]).unwrap();
    let hit = hits.into_iter().find(|time| *time > turn).unwrap();
    let [speed, turned] = flies(1.0, 0.3 + rubs, opens[0], turn);
    assert!(speed.abs() < 1e-11 && turned < -0.1, "{speed} {turned}");
    let [_, back] = flies(1.0, 0.3 - rubs, turn, hit);
    assert!((back + turned).abs() < 1e-11, "{back} {turned}");
}

#[test]
fn a_guide_that_grips_holds_longer_and_rubs_less() {
    leaves(&Gripped::default(), [0.0; 3], [0.4, 0.25]);
}

#[test]
fn a_block_leaves_its_corner_where_the_floor_lets_it_go() {
    for side in [0.0, 0.3] {
        let corner = Corner {
            side,
            ..Default::default()
        };
        let flow = flow(&corner, None);
        let place = flow.place([0.0; 5]).unwrap();
        let modes = place.mode.as_slice();
        assert_eq!(modes[0], Mode::PinnedBackward, "{modes:?}");
        assert_eq!(modes[2..], [Mode::Rest; 2], "{modes:?}");
        leaves(&corner, [0.0; 5], [0.25, 0.25]);
    }
}

#[test]
fn derivatives_pass_through_a_grip() {
    let mut random = Random::new(1785);
    let mut tally = Tally::default();
    for _ in 0..12 {
        let gripped = Gripped {
            grip: random.between(0.3, 0.5),
            e: random.between(0.0, 0.5),
            ..Default::default()
        };
        let start = [-random.between(0.1, 0.5), random.real(0.5), 0.3];
        compare(&gripped, start, random.between(2.5, 8.0), &mut tally);
    }
    assert!(tally.compared > 150, "{tally:?}");
    assert!(tally.events.contains_key("opening N"), "{tally:?}");
}

#[test]
fn derivatives_pass_through_a_corner() {
    let mut random = Random::new(1821);
    let mut tally = Tally::default();
    for _ in 0..12 {
        let corner = Corner {
            lift: random.between(0.0, 0.3),
            floor: random.between(0.2, 0.6),
            side: random.between(0.0, 0.4),
            e: random.between(0.0, 0.5),
            ..Default::default()
        };
        let start = [-random.between(0.1, 0.5), random.real(0.5), 0.0, 0.0, 0.3];
        compare(&corner, start, random.between(2.5, 8.0), &mut tally);
    }
    assert!(tally.compared > 150, "{tally:?}");
    assert!(tally.events.contains_key("opening W"), "{tally:?}");
}

/// The margin of what a wall pins is that of the wall.
#[test]
fn what_is_pinned_has_no_margin_of_its_own() {
    let held = Gripped {
        load: 0.3,
        ..Default::default()
    };
    let mut case = Case::declared(Gripped::INFO, Dynamics::Exact);
    case.parameters = held.values().to_vec();
    let system = System::of::<Gripped, 3>();
    let record = system.needs_watched(&case, &|topic| match topic {
        Topic::Copies => ControlFlow::Break(()),
        _ => ControlFlow::Continue(()),
    });
    let record = record.unwrap();
    let [friction, wall] = [0, 1].map(|i| &record.contacts[i]);
    assert_eq!((friction.role, friction.margin), (Role::NeverSlides, None));
    // N = 0.3 cos φ + 0.3 + 0.4.
    let margin = wall.margin.expect("a margin");
    assert!((margin - 0.4).abs() < 1e-2, "{margin}");
}
