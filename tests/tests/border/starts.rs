//! Where else an orbit may begin: not where contacts switch, as rounding would tell on which side it does.

use stickslip::model;
use stickslip_models::friction::Coulomb;
use stickslip_models::press::Compliant;
use stickslip_tests::branches::{branch, named};

model! {
    /// A check valve: a disc on a spring, between a damped seat and a stop, which rubs in its guide.
    struct Valve {
        state lift: m = 0.002;
        state v: m/s = 0.0;
        param m: kg = 0.1 where m > 0.0;
        param k: N/m = 200.0 where k > 0.0;
        param seat: N/m = 20000.0 where seat > 0.0;
        param c: N*s/m = 8.0 where c >= 0.0;
        param way: m = 0.006 where way > 0.0;
        param guide: N = 0.1 where guide >= 0.0;
        param mean: N = 0.4;
        param swing: N = 1.0;
        param omega: rad/s = 40.0 where omega > 0.0;
        drive phi at omega;
        press S: N = Compliant { stiffness: seat, damping: c } closing lift;
        press T: N = Compliant { stiffness: seat, damping: c } closing way - lift;
        friction F: N = Coulomb { level: guide } opposing v;
        der(lift) = v;
        der(v) = (mean + swing * cos(phi) - k * lift + S - T + F) / m;
    }
}

/// Its lift turns where its friction changes sign: begun anew there, it came back in another mode at 1e-6 to 1e-8.
#[test]
fn a_valve_that_rubs_is_followed_to_its_end_at_any_accuracy() {
    // At 1e-10.
    let known = [
        ("LP1", 49.271_752_586),
        ("VS1", 47.702_727_956),
        ("CS1", 51.791_621_2),
        ("SS1", 52.122_465_2),
        ("GS1", 52.215_644_4),
    ];
    for accuracy in [1e-6, 1e-8, 1e-10] {
        let found = branch(&[], Valve::omega, (40.0, 80.0), |case| {
            case.accuracy = accuracy
        });
        assert_eq!(found.ended.word(), "reached-end", "{}", found.ended.reason);
        let told = named(&found);
        assert_eq!(told.len(), known.len(), "{told:?} at {accuracy:e}");
        for ((name, r), (special, known)) in told.iter().zip(known) {
            let off = (r - known).abs();
            assert!(*name == special && off < 1e-3, "{told:?} at {accuracy:e}");
        }
    }
}
