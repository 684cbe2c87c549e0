//! Physics that no accepted step of an exact motion may break, over random starts and parameters.

use stickslip::field::exact::{ExactSystem, Mode, Modes};
use stickslip::flow::exact::ExactFlow;
use stickslip::flow::{Flow, Want};
use stickslip::integrate::Tolerance;
use stickslip::model::Model;
use stickslip_models::friction::{CoulombStatic, Stribeck};
use stickslip_tests::random::Random;

const TOLERANCE: Tolerance = Tolerance {
    relative: 1e-8,
    absolute: 1e-8,
};
const PATH: Want = Want {
    path: true,
    ..Want::EXTREMA
};

stickslip::model! {
    /// Two coupled masses on a moving belt, held back more at rest than in motion.
    pub struct Held {
        state x1 = 0.0;
        state v1 = 0.0;
        state x2 = 0.0;
        state v2 = 0.0;
        param v_dr = 0.2;
        param coupling = 1.2 where coupling >= 0.0;
        param damping = 0.1 where damping >= 0.0;
        param peak1 = 1.3 where peak1 >= 0.0;
        param level1 = 1.0 where level1 >= 0.0;
        param peak2 = 1.5 where peak2 >= 0.0;
        param level2 = 1.2 where level2 >= 0.0;
        friction f1 = CoulombStatic { static_level: peak1, kinetic_level: level1 } opposing v1 - v_dr;
        friction f2 = Stribeck { static_level: peak2, kinetic_level: level2, speed: 0.5, exponent: 2.0, viscous: 0.05 }
            opposing v2 - v_dr;
        let pull = coupling * (x1 - x2) + damping * (v1 - v2);
        der(x1) = v1;
        der(v1) = f1 - x1 - pull;
        der(x2) = v2;
        der(v2) = f2 - x2 + pull;
    }
}

stickslip::model! {
    /// A mass on a belt and another on top of it: the second contact rubs between them, so G is full.
    pub struct Stacked {
        state x1 = 0.0;
        state v1 = 0.0;
        state x2 = 0.0;
        state v2 = 0.0;
        param v_dr = 0.2;
        param upper = 0.6 where upper > 0.0;
        param spring = 1.5 where spring >= 0.0;
        param peak1 = 1.3 where peak1 >= 0.0;
        param level1 = 1.0 where level1 >= 0.0;
        param peak2 = 0.6 where peak2 >= 0.0;
        param level2 = 0.4 where level2 >= 0.0;
        friction ground = CoulombStatic { static_level: peak1, kinetic_level: level1 } opposing v1 - v_dr;
        friction between = CoulombStatic { static_level: peak2, kinetic_level: level2 } opposing v2 - v1;
        der(x1) = v1;
        der(v1) = ground - between - x1;
        der(x2) = v2;
        der(v2) = (between - spring * x2) / upper;
    }
}

/// Every sample lies between two events; its mode is that of its segment.
fn audit<M: Model<4>>(model: &M, dice: &mut Random) -> usize {
    let flow = ExactFlow::new(model, None, TOLERANCE).unwrap();
    let system = ExactSystem::new(model, None);
    let on_belt = model.values().as_ref()[0];
    let mut speed = || {
        if dice.between(0.0, 1.0) < 0.3 {
            on_belt
        } else {
            dice.between(-2.0, 2.0)
        }
    };
    let speeds = [speed(), speed()];
    let start = [
        dice.between(-3.0, 3.0),
        speeds[0],
        dice.between(-3.0, 3.0),
        speeds[1],
    ];
    let place = flow
        .place(start)
        .unwrap_or_else(|e| panic!("{model:?} {start:?}: {e}"));
    let passage = flow
        .advance(&place, 60.0, PATH)
        .unwrap_or_else(|e| panic!("{model:?} {start:?}: {e}"));
    let mut ends = Vec::new();
    let mut time = 0.0;
    for segment in &passage.segments {
        time += segment.duration;
        ends.push((time, segment.mode));
    }
    for sample in &passage.path {
        let at = ends
            .partition_point(|(end, _)| *end < sample.time)
            .min(ends.len() - 1);
        let near = |end: f64| (end - sample.time).abs() < 1e-9;
        if near(ends[at].0) || (at > 0 && near(ends[at - 1].0)) {
            continue;
        }
        judge(
            model,
            &system,
            &ends[at].1,
            sample.state,
            sample.time,
            start,
        );
    }
    passage.events.len()
}

fn judge<M: Model<4>>(
    model: &M,
    system: &ExactSystem<M, 4>,
    modes: &Modes<M, 4>,
    state: [f64; 4],
    time: f64,
    start: [f64; 4],
) {
    let contacts = system.contact_states(&state, modes).unwrap();
    for (i, contact) in contacts.as_ref().iter().enumerate() {
        let what =
            || format!("contact {i} {contact:?} at {time} {state:?} of {model:?} from {start:?}");
        match modes.as_slice()[i] {
            Mode::Stick => {
                assert!(contact.speed.abs() < 1e-12, "off its surface: {}", what());
                assert!(
                    contact.force.abs() <= contact.stick * (1.0 + 1e-6),
                    "too much: {}",
                    what()
                );
            }
            mode => {
                assert!(mode.sign() * contact.speed > -1e-7, "wrong way: {}", what());
                assert!(
                    contact.force * contact.speed <= 1e-7,
                    "gains energy: {}",
                    what()
                );
            }
        }
    }
}

/// What two contacts hold at rest, and in motion.
fn levels(dice: &mut Random) -> ([f64; 2], [f64; 2]) {
    let levels = [dice.between(0.1, 1.5), dice.between(0.1, 1.5)];
    let peaks = levels.map(|level| level * dice.between(1.0, 1.8));
    (peaks, levels)
}

fn held(dice: &mut Random) -> Held {
    let ([peak1, peak2], [level1, level2]) = levels(dice);
    Held {
        v_dr: dice.between(-1.0, 1.0),
        coupling: dice.between(0.0, 3.0),
        damping: dice.between(0.0, 0.5),
        peak1,
        level1,
        peak2,
        level2,
    }
}

fn stacked(dice: &mut Random) -> Stacked {
    let ([peak1, peak2], [level1, level2]) = levels(dice);
    Stacked {
        v_dr: dice.between(-1.0, 1.0),
        upper: dice.between(0.1, 3.0),
        spring: dice.between(0.0, 4.0),
        peak1,
        level1,
        peak2,
        level2,
    }
}

/// Friction never gives energy, and never holds too much.
fn audit_all<M: Model<4>>(runs: usize, seed: u64, model: impl Fn(&mut Random) -> M) {
    let mut dice = Random::new(seed);
    let events: usize = (0..runs).map(|_| audit(&model(&mut dice), &mut dice)).sum();
    assert!(
        events > 5 * runs,
        "only {events} events: the audit sees too little"
    );
}

#[test]
fn some_masses_side_by_side_get_no_energy() {
    audit_all(25, 1, held);
}

#[test]
fn some_masses_on_top_of_each_other_get_no_energy() {
    audit_all(25, 2, stacked);
}

#[test]
#[ignore = "long"]
fn masses_side_by_side_get_no_energy() {
    audit_all(250, 1, held);
}

#[test]
#[ignore = "long"]
fn masses_on_top_of_each_other_get_no_energy() {
    audit_all(250, 2, stacked);
}
