//! Friction along the way of a press that does not give way: where both hold, the motion is still one.

use std::f64::consts::TAU;

use stickslip::field::Design;
use stickslip::field::exact::Mode;
use stickslip::flow::{EventKind, Flow, Want};
use stickslip::model;
use stickslip::model::Model;
use stickslip::study::{Along, Case, Dynamics, System};
use stickslip_models::friction::Coulomb;
use stickslip_models::press::Rigid;
use stickslip_tests::random::Random;

use crate::derivatives::{Tally, compare};
use crate::models::flow;

model! {
    /// A hammer in a guide that rubs.
    pub(crate) struct Punch {
        state x: m = 0.0;
        state v: m/s = 0.0;
        param m: kg = 1.0 where m > 0.0;
        param k: N/m = 0.0 where k >= 0.0;
        param c: N*s/m = 0.0 where c >= 0.0;
        param load: N = 1.0;
        param omega: rad/s = 1.0 where omega > 0.0;
        param preload: N = 0.3;
        param dry: N = 0.25 where dry >= 0.0;
        param gap: m = 0.0;
        param e: 1 = 0.0 where 0.0 <= e <= 1.0;
        drive phi at omega;
        press N: N = Rigid { restitution: e } closing gap - x;
        friction S: N = Coulomb { level: dry } opposing v;
        der(x) = v;
        der(v) = (load * cos(phi) + preload - k * x - c * v - N + S) / m;
    }
}

model! {
    /// A mass that a force draws off its wall, held by a guide that rubs.
    pub(crate) struct Latch {
        state x = 0.5;
        state v = 0.0;
        param k = 1.0 where k > 0.0;
        param c = 0.3 where c >= 0.0;
        param preload = 1.0;
        param dry = 0.4 where dry >= 0.0;
        param wall = 0.5;
        param e = 0.6 where 0.0 <= e <= 1.0;
        press N = Rigid { restitution: e } closing wall - x;
        friction S = Coulomb { level: dry } opposing v;
        der(x) = v;
        der(v) = preload - k * x - c * v - N + S;
    }
}

model! {
    /// A mass that a force presses on a wall that moves, over ground that rubs.
    pub(crate) struct Pushed {
        state x = 0.2;
        state v = 0.0;
        param m = 1.3 where m > 0.0;
        param throw = 0.2;
        param omega = 1.5 where omega > 0.0;
        param preload = 1.6;
        param dry = 0.4 where dry >= 0.0;
        param e = 0.2 where 0.0 <= e < 1.0;
        drive phi at omega;
        press N = Rigid { restitution: e } closing x - throw * cos(phi);
        friction S = Coulomb { level: dry } opposing v;
        der(x) = v;
        der(v) = (N - preload + S) / m;
    }
}

/// Where the wall turns, friction turns with it and holds nothing: the mass stays at the wall as long as its load exceeds
/// friction and inertia, m throw ω² < preload − dry.
#[test]
fn ground_that_rubs_does_not_hold_what_a_wall_leads() {
    let pushed = Pushed::default();
    let mut case = Case::declared(Pushed::INFO, Dynamics::Exact);
    case.accuracy = 1e-11;
    let orbit = System::of::<Pushed, 3>().orbit(&case).unwrap();
    assert_eq!(orbit.word.as_deref(), Some("slip-(S) slip+(S)"));
    assert!((orbit.max[0] - 0.2).abs() < 1e-10 && (orbit.min[0] + 0.2).abs() < 1e-10);
    assert!(orbit.floquet.multipliers.iter().all(|m| m.norm() == 0.0));
    // m (ẍ) = N − P + S: with S = +dry while it goes back, N = P − dry − m throw ω² cos φ.
    let flow = flow(&pushed, None);
    let place = flow.place([0.2, 0.0, 0.0]).unwrap();
    let passage = flow.advance(&place, 20.0, Want::default()).unwrap();
    let off = passage.end.state[0] - 0.2 * passage.end.state[2].cos();
    assert!(off.abs() < 1e-12, "{off}");
}

/// What drives the hammer of k = c = 0 and m = 1, from φ₀ on at speed 0 with friction s: its speed and its way at φ.
pub(crate) fn flies(load: f64, bias: f64, from: f64, to: f64) -> [f64; 2] {
    let t = to - from;
    [
        load * (to.sin() - from.sin()) + bias * t,
        load * (from.cos() - to.cos() - from.sin() * t) + 0.5 * bias * t * t,
    ]
}

/// Units of time, length and mass in which the same motion is written.
const UNITS: [[f64; 3]; 4] = [
    [1.0; 3],
    [1e-3, 1e-6, 1e-3],
    [1e3, 1e3, 1e-6],
    [1.0, 1e-9, 1e6],
];

/// The hammer stays until what draws it off its wall exceeds what friction can hold, load cos φ = −(preload + dry), flies,
/// turns and hits: all in closed form.
#[test]
fn a_hammer_leaves_its_stop_where_friction_lets_it_go() {
    for [second, metre, kilogram] in UNITS {
        let newton = kilogram * metre / (second * second);
        let punch = Punch {
            m: kilogram,
            load: newton,
            preload: 0.3 * newton,
            dry: 0.25 * newton,
            omega: 1.0 / second,
            ..Default::default()
        };
        let flow = flow(&punch, None).with_magnitude([metre, metre / second, 1.0]);
        let place = flow.place([-0.1 * metre, 0.0, 0.0]).unwrap();
        let passage = flow.advance(&place, 2.0 * TAU * second, Want::default());
        let passage = passage.unwrap();
        let times = |kind: &dyn Fn(&EventKind) -> bool| -> Vec<f64> {
            let events = passage.events.iter().filter(|event| kind(&event.kind));
            events.map(|event| event.time / second).collect()
        };
        let opens = times(&|kind| matches!(kind, EventKind::Opening));
        let turns = times(&|kind| matches!(kind, EventKind::Crossing { .. }));
        let hits = times(&|kind| matches!(kind, EventKind::Impact { .. }));
        assert_eq!([opens.len(), turns.len(), hits.len()], [2, 2, 2]);
        assert!((opens[0] - (-0.55_f64).acos()).abs() < 1e-11, "{opens:?}");
        assert!((opens[1] - opens[0] - TAU).abs() < 1e-11, "{opens:?}");
        let [speed, turned] = flies(1.0, 0.55, opens[0], turns[0]);
        assert!(speed.abs() < 1e-11 && turned < -0.5, "{speed} {turned}");
        let [_, back] = flies(1.0, 0.05, turns[0], hits[1]);
        assert!((back + turned).abs() < 1e-11, "{back} {turned}");
        let pinned = [Mode::PinnedBackward, Mode::Rest];
        let rests = passage
            .segments
            .iter()
            .filter(|one| one.mode.as_slice() == pinned);
        assert_eq!(rests.count(), 2);
    }
}

#[test]
fn a_hammer_that_comes_and_goes_forgets_what_it_was() {
    let mut case = Case::declared(Punch::INFO, Dynamics::Exact);
    case.accuracy = 1e-11;
    let orbit = System::of::<Punch, 3>().orbit(&case).unwrap();
    assert!((orbit.period - TAU).abs() < 1e-9);
    assert!(orbit.floquet.multipliers.iter().all(|m| m.norm() == 0.0));
    let word = orbit.word.as_deref().unwrap();
    assert!(
        word.contains("pinned(S)") && word.contains("impact(N)"),
        "{word}"
    );
}

/// Below load = preload + dry it rests for ever.
#[test]
fn a_hammer_that_is_held_for_ever_is_an_orbit_until_it_is_let_go() {
    for (m, gap) in [(1.0, 0.0), (1.3, 0.0), (0.7, 0.3)] {
        let mut case = Case::declared(Punch::INFO, Dynamics::Exact);
        case.parameters = Punch {
            m,
            gap,
            load: 0.3,
            ..Default::default()
        }
        .values()
        .as_ref()
        .to_vec();
        case.start = Some(vec![gap, 0.0, 0.0]);
        let design = Design::Parameter(Punch::load.index);
        case.along = Some(Along {
            design,
            from: 0.3,
            to: 1.0,
        });
        let branch = System::of::<Punch, 3>().branch(&case).unwrap();
        let lost = branch.special.first();
        let lost = lost.unwrap_or_else(|| panic!("{:?}", branch.ended)).r;
        assert!((lost - 0.55).abs() < 1e-8, "{lost}");
        for orbit in branch.points.iter().filter(|orbit| orbit.r.unwrap() < lost) {
            assert_eq!(orbit.word.as_deref(), Some("pinned(S) rest(N)"));
            assert!(orbit.floquet.multipliers.iter().all(|m| m.norm() == 0.0));
            assert_eq!([orbit.min[0], orbit.max[0]], [gap, gap]);
        }
    }
}

#[test]
fn derivatives_pass_through_what_is_pinned() {
    let mut random = Random::new(1835);
    let mut tally = Tally::default();
    for _ in 0..12 {
        let punch = Punch {
            m: random.between(0.5, 2.0),
            k: random.between(0.0, 0.5),
            c: random.between(0.0, 0.3),
            gap: random.real(0.2),
            e: random.between(0.0, 0.5),
            ..Default::default()
        };
        let start = [punch.gap - random.between(0.1, 0.5), random.real(0.5), 0.3];
        compare(&punch, start, random.between(2.5, 8.0), &mut tally);
    }
    assert!(tally.compared > 200, "{tally:?}");
    assert!(tally.events.contains_key("release S"), "{tally:?}");
    assert!(tally.events.contains_key("opening N"), "{tally:?}");
}

/// Friction and impacts only take energy.
#[test]
fn a_guided_mass_loses_energy_until_it_rests() {
    let mut random = Random::new(1699);
    let mut rests = 0;
    for _ in 0..60 {
        let latch = Latch {
            k: random.positive(0.1, 3.0),
            c: 0.0,
            dry: random.between(0.0, 0.5),
            preload: random.between(-0.5, 2.0),
            wall: random.real(0.5),
            e: random.between(0.0, 0.9),
        };
        let energy = |[x, v]: &[f64; 2]| 0.5 * (v * v + latch.k * x * x) - latch.preload * x;
        let flow = flow(&latch, None);
        let start = [latch.wall - random.between(0.0, 1.5), random.real(2.0)];
        let mut place = flow.place(start).unwrap();
        for _ in 0..12 {
            let end = flow.advance(&place, 2.5, Want::default());
            let end = end.unwrap_or_else(|error| panic!("{latch:?} from {start:?}: {error}"));
            let [before, after] = [&place.state, &end.end.state].map(energy);
            assert!(
                after <= before + 1e-9 * (1.0 + before.abs()),
                "{latch:?} from {start:?}"
            );
            assert!(
                end.end.state[0] <= latch.wall + 1e-9,
                "{latch:?} from {start:?}"
            );
            place = end.end;
        }
        if place.mode.as_slice()[1] == Mode::Rest {
            rests += 1;
            assert!(latch.preload - latch.k * latch.wall >= -latch.dry - 1e-9);
            assert_eq!(place.mode.as_slice()[0], Mode::PinnedBackward);
        }
    }
    assert!(rests > 5, "{rests}");
}

/// It stays at its wall while preload − k wall ≥ −dry.
#[test]
fn what_friction_helps_to_hold_is_an_equilibrium_up_to_its_limit() {
    let case = Case::declared(Latch::INFO, Dynamics::Exact);
    let held = |preload: f64| {
        let mut case = case.clone();
        case.parameters[Latch::preload.index] = preload;
        let found = System::of::<Latch, 2>().equilibria(&case).unwrap();
        let word = |one: Option<&str>| one == Some("pinned(S) rest(N)");
        found.iter().filter(|one| word(one.mode.as_deref())).count()
    };
    // k wall − dry = 0.1.
    assert_eq!([held(1.0), held(0.3), held(0.11), held(0.09)], [1, 1, 1, 0]);
}
