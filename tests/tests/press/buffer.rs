//! Where a press with a damper is only touched: its force begins with the speed, and ends before the gap opens.
//!
//! Of ẍ + c ẋ + x = A cos ωt − N beside a buffer at x = 1, A at the touch is |1 − ω² + icω|. With E the free flow over one
//! period, the orbits that touch lose the speed d·δx there, d being the damping of the buffer: their multipliers are those
//! of [1 0; −d 1] E, of the same determinant and the trace tr E − d E₁₂.

use std::f64::consts::TAU;

use stickslip::continuation::Kind;
use stickslip::model;
use stickslip::study::{BranchRecord, Case, System};
use stickslip_models::press::Compliant;

model! {
    /// A driven mass beside a buffer.
    struct Buffered {
        state x = 0.0;
        state v = 0.0;
        param load = 0.3;
        param omega = 1.2 where omega > 0.0;
        param c = 0.1;
        param spring = 1.0 where spring > 0.0;
        param damper = 0.5 where damper >= 0.0;
        drive phi at omega;
        press N = Compliant { stiffness: spring, damping: damper } closing 1.0 - x;
        der(x) = v;
        der(v) = load * cos(phi) - c * v - x - N;
    }
}

impl Buffered {
    fn touches(&self) -> f64 {
        let stiffness = 1.0 - self.omega * self.omega;
        stiffness.hypot(self.c * self.omega)
    }

    /// tr E, E₁₂ and det E.
    fn free(&self) -> [f64; 3] {
        let (time, b) = (TAU / self.omega, 0.5 * self.c);
        let own = (1.0 - b * b).sqrt();
        let decay = (-b * time).exp();
        [
            2.0 * decay * (own * time).cos(),
            decay * (own * time).sin() / own,
            decay * decay,
        ]
    }
}

fn followed(model: &Buffered, (from, to): (f64, f64), accuracy: f64) -> BranchRecord {
    let mut case = Case::of(&Buffered {
        load: from,
        ..*model
    })
    .following(Buffered::load, from..to);
    case.accuracy = accuracy;
    System::of::<Buffered, _>().branch(&case).unwrap()
}

/// The grazing, where it is to its error; the others.
fn grazing(branch: &BranchRecord, at: f64) -> Vec<Kind> {
    let mut kinds = Vec::new();
    for special in &branch.special {
        if special.kind == Kind::Grazing {
            let (off, error) = ((special.r - at).abs(), special.error.unwrap());
            assert!(off <= error, "{off:e} {error:e}");
        }
        kinds.push(special.kind);
    }
    kinds
}

#[test]
fn a_buffer_is_touched_at_one_load_from_either_side() {
    for omega in [1.2, 0.9] {
        let model = Buffered {
            omega,
            ..Default::default()
        };
        let at = model.touches();
        for accuracy in [1e-7, 1e-9, 1e-10] {
            for ends in [(0.8 * at, 1.2 * at), (1.2 * at, 0.8 * at)] {
                let branch = followed(&model, ends, accuracy);
                assert_eq!(grazing(&branch, at), [Kind::Grazing], "{ends:?} {accuracy}");
                assert_eq!(branch.ended.word(), "reached-end");
            }
        }
    }
}

/// What is off falls by the root of the distance: two distances tell the limit.
#[test]
fn the_damper_of_a_touch_jumps_into_the_multipliers() {
    for (omega, damper) in [(1.2, 0.5), (0.9, 0.5), (0.9, 2.0)] {
        let model = Buffered {
            omega,
            damper,
            ..Default::default()
        };
        let [trace, across, volume] = model.free();
        let seen = [4e-8, 1e-8].map(|beyond| {
            let load = model.touches() * (1.0 + beyond);
            let mut case = Case::of(&Buffered { load, ..model });
            case.accuracy = 1e-11;
            let orbit = System::of::<Buffered, _>().orbit(&case).unwrap();
            assert_eq!(orbit.word.as_deref(), Some("close(N) open(N)"));
            let multipliers = &orbit.floquet.multipliers;
            let product = (multipliers[0] * multipliers[1]).re;
            // The damper takes volume while it lasts.
            assert!((product / volume - 1.0).abs() < 1e-3, "{product} {volume}");
            (multipliers[0] + multipliers[1]).re
        });
        let limit = 2.0 * seen[1] - seen[0];
        let expected = trace - damper * across;
        assert!((limit - expected).abs() < 1e-6, "{limit} {expected}");
    }
}

/// Where 1 − tr + det changes its sign, both orbits lie on one side; where 1 + tr + det does, orbits double.
#[test]
fn a_strong_damper_turns_the_branch_where_it_is_touched() {
    let model = Buffered {
        damper: 2.0,
        ..Default::default()
    };
    let [trace, across, volume] = model.free();
    let side = |damper: f64| 1.0 - trace + damper * across + volume;
    assert!(side(0.0) > 0.0 && side(model.damper) < 0.0);
    let at = model.touches();
    for accuracy in [1e-7, 1e-9, 1e-10] {
        let branch = followed(&model, (0.8 * at, 1.2 * at), accuracy);
        let kinds = grazing(&branch, at);
        assert_eq!(kinds[0], Kind::Grazing, "{kinds:?} {accuracy}");
        let touching = branch.points.iter();
        let next = touching
            .clone()
            .find(|point| point.word.as_deref() == Some("close(N) open(N)"));
        let next = next.unwrap();
        assert!(next.r.unwrap() < at && next.floquet.unstable == 1);
    }
}

model! {
    /// A driven mass with play between two buffers, pushed towards one of them.
    struct Slot {
        state x = 0.0;
        state v = 0.0;
        param omega = 25.3 where omega > 0.0;
        drive phi at omega;
        press L = Compliant { stiffness: 400, damping: 2 } closing x + 0.01;
        press R = Compliant { stiffness: 400, damping: 2 } closing 0.01 - x;
        der(x) = v;
        der(v) = 5 * cos(phi) - 0.5 * v - 20 * x + 2 + L - R;
    }
}

/// Orbits that go around twice: their second push against R parts from the first, and then its gap opens between both. There
/// a multiplier jumps back that has passed −1 just before.
#[test]
fn a_press_lets_go_for_a_moment_and_then_its_gap_opens() {
    let expected = [
        (Kind::Grazing, 25.198724296),
        (Kind::Flip, 25.174777419),
        (Kind::Grazing, 25.174628857),
        (Kind::Flip, 25.165246047),
    ];
    for accuracy in [1e-7, 1e-9, 1e-10] {
        let mut case = Case::of(&Slot::default()).following(Slot::omega, 25.3..25.0);
        case.accuracy = accuracy;
        let system = System::of::<Slot, _>();
        let there = system.branch(&case).unwrap();
        let mut back = case.clone().following(Slot::omega, 25.0..25.3);
        let last = there.points.last().unwrap();
        back.parameters[Slot::omega.index] = 25.0;
        (back.start, back.period) = (Some(last.state.clone()), Some(last.period));
        let back = system.branch(&back).unwrap();
        let mut found = [there.special, back.special];
        found[1].reverse();
        for special in found {
            let kinds: Vec<Kind> = special.iter().map(|one| one.kind).collect();
            assert_eq!(kinds, expected.map(|one| one.0), "{accuracy}");
            for (one, (_, r)) in special.iter().zip(expected) {
                let (off, error) = ((one.r - r).abs(), one.error.unwrap());
                assert!(off <= error + 1e-8, "{r} {off:e} {error:e}");
            }
        }
    }
}
