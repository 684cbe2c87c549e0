//! A slender block that rocks on its two corners (Housner 1963).

use stickslip::field::exact::Mode;
use stickslip::flow::{EventKind, Flow, Want};
use stickslip::model;
use stickslip::study::{Case, Dynamics, System};
use stickslip_models::press::Rigid;

use crate::models::flow;

model! {
    /// Its angles are small, its ground does not let it slide.
    struct Block {
        state y: m = 0.0;
        state th: rad = 0.0;
        state v: m/s = 0.0;
        state w: rad/s = 0.0;
        param half: m = 0.2 where half > 0.0;
        param tall: m = 1.0 where tall > 0.0;
        param shake: m/s^2 = 0.2;
        let inertia = (half * half + tall * tall) / 3.0 + tall * tall;
        drive phi at 6.0;
        press A: m/s^2 = Rigid { restitution: 0.0 } closing y + half * th;
        press B: m/s^2 = Rigid { restitution: 0.0 } closing y - half * th;
        der(y) = v;
        der(th) = w;
        der(v) = A + B - 9.81;
        der(w) = (half * (A - B) + tall * (9.81 * th + shake * cos(phi))) / inertia;
    }
}

/// It rocks about one corner and then the other by the angles A and B < α = half/tall, 1 − (1 − B/α)² being 1 − (1 − A/α)²
/// times the square of what an impact leaves of its rate.
#[test]
fn what_an_impact_leaves_is_as_housner_says() {
    let system = System::of::<Block, _>();
    let mut case = Case::declared(system.info(), Dynamics::Exact);
    case.parameters[Block::shake.index] = 0.0;
    case.start = Some(vec![0.02, 0.1, 0.0, 0.0]);
    let motion = system.motion(&case, 2.0).unwrap();
    let slender: f64 = 0.2 * 0.2 / (0.2 * 0.2 + 1.0);
    let left = 1.0 - 1.5 * slender;
    let energy = left * left * (1.0 - 0.5 * 0.5);
    let angle = 0.2 * (1.0 - (1.0 - energy).sqrt());
    assert!((motion.min[1] + angle).abs() < 1e-8, "{:?}", motion.min);
}

/// Of its energy each impact leaves the same share, so that it rocks for 2 atanh √(e)/p between two of them, ever shorter, and is
/// at rest after infinitely many: whatever it began with is forgotten then.
#[test]
fn it_rocks_to_rest_in_a_finite_time() {
    let block = Block {
        shake: 0.0,
        ..Default::default()
    };
    let flow = flow(&block, None);
    let place = flow.place([0.02, 0.1, 0.0, 0.0, 0.0]).unwrap();
    let passage = flow.advance(&place, 20.0, Want::SHOT).unwrap();
    let slender: f64 = 0.2 * 0.2 / (0.2 * 0.2 + 1.0);
    let left = 1.0 - 1.5 * slender;
    let swing = |n: i32| (left.powi(n) * 0.75_f64.sqrt()).atanh();
    let rocking = swing(0) + 2.0 * (1..2000).map(swing).sum::<f64>();
    let stiff: f64 = 9.81 / ((0.2 * 0.2 + 1.0) / 3.0 + 1.0 + 0.2 * 0.2);
    let last = passage.events.last().unwrap();
    assert!(matches!(last.kind, EventKind::Settled { .. }), "{last:?}");
    let late = last.time - rocking / stiff.sqrt();
    assert!(late.abs() < 1e-5, "{late:e}");
    assert_eq!(passage.end.mode.as_slice(), [Mode::Rest, Mode::Rest]);
    let forgotten = passage.derivatives.unwrap().state;
    assert!(passage.end.state[..4].iter().all(|y| y.abs() < 1e-12));
    assert!(
        forgotten[..4]
            .iter()
            .flatten()
            .all(|slope| slope.abs() < 1e-12),
        "{forgotten:?}"
    );
}

/// Shaken by less than g α it keeps still, but for rounding errors of rounding errors, in which no orbit was found.
#[test]
fn it_keeps_still_while_it_is_shaken_little() {
    let system = System::of::<Block, _>();
    let case = Case::declared(system.info(), Dynamics::Exact);
    let orbit = system.orbit(&case).unwrap();
    assert_eq!(orbit.word.as_deref(), Some("rest(A) rest(B)"));
    assert!(orbit.max.iter().take(4).all(|most| most.abs() < 1e-12));
}
