//! The bilinear oscillator: half a period of each of its two frequencies.

use std::f64::consts::PI;

use stickslip::field::exact::Mode;
use stickslip::flow::{EventKind, Flow, Peaks, Want};

use crate::models::{Bilinear, flow};

#[test]
fn each_spring_lasts_half_of_its_period() {
    for (wall, mass) in [(8.0, 1.0), (1e4, 0.3), (1e-3, 2.0)] {
        let bilinear = Bilinear {
            wall,
            mass,
            ..Default::default()
        };
        let (free, pressed) = (PI * f64::sqrt(mass), PI * f64::sqrt(mass / (1.0 + wall)));
        let flow = flow(&bilinear, None);
        let place = flow.place([0.0, 1.0]).unwrap();
        assert_eq!(place.mode.as_slice(), [Mode::Open]);
        let want = Want {
            extrema: Peaks::All,
            ..Want::default()
        };
        let passage = flow.advance(&place, 1.5 * (free + pressed), want).unwrap();
        let switches = passage.events.iter().filter(|event| event.kind.is_switch());
        let found: Vec<_> = switches.map(|event| (event.kind, event.time)).collect();
        let expected = [
            (EventKind::Closing, free),
            (EventKind::Opening, free + pressed),
        ];
        assert_eq!(found.len(), 2 + usize::from(free < 0.5 * (free + pressed)));
        for (found, expected) in found.iter().zip(expected) {
            assert_eq!(found.0, expected.0);
            assert!(
                (found.1 - expected.1).abs() < 1e-11,
                "{found:?} {expected:?}"
            );
        }
    }
}

/// A damper makes the force begin with a jump and end before the gap opens: m ẍ + c ẋ + K x = 0 while the force lasts.
#[test]
fn a_damped_wall_lets_go_before_its_gap_opens() {
    let (wall, c) = (8.0, 0.9);
    let bilinear = Bilinear {
        wall,
        c,
        k: 1e-12,
        ..Default::default()
    };
    let flow = flow(&bilinear, None);
    let place = flow.place([0.5, -1.0]).unwrap();
    let passage = flow.advance(&place, 2.0, Want::EXTREMA).unwrap();
    let switches = passage.events.iter().filter(|event| event.kind.is_switch());
    let switches: Vec<_> = switches.collect();
    let [close, open] = switches.as_slice() else {
        panic!("{switches:?}");
    };
    assert!((close.time - 0.5).abs() < 1e-10);
    // With δ'' + c δ' + K δ = 0, δ = e^(-s t) sin(q t)/q, the force K δ + c δ' = -δ'' vanishes where tan(q t) = 2 s q/(s² - q²).
    let s = 0.5 * c;
    let q = f64::sqrt(wall - s * s);
    let lasts = (2.0 * s * q).atan2(s * s - q * q) / q;
    assert!((open.time - close.time - lasts).abs() < 1e-10);
    assert_eq!(open.mode, Mode::Parted);
    let penetration = (-s * lasts).exp() * (q * lasts).sin() / q;
    assert!(penetration > 0.01 && (open.state[0] + penetration).abs() < 1e-10);
    let leaves = passage.end.state[1];
    let speed = (-s * lasts).exp() * ((q * lasts).cos() - s / q * (q * lasts).sin());
    assert!((leaves + speed).abs() < 1e-9, "{leaves} {speed}");
    assert!(leaves < 1.0 && leaves > 0.0);
    assert_eq!(passage.end.mode.as_slice(), [Mode::Open]);
}
