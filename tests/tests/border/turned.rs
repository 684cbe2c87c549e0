//! A branch that turns at once where a stretch vanishes.

use stickslip::continuation::Kind;
use stickslip::model;
use stickslip_models::friction::Weakening;
use stickslip_models::press::Rigid;
use stickslip_tests::branches::branch;

model! {
    /// A block on a belt before a wall: U. Andreaus, P. Casini, Journal of Sound and Vibration 245 (2001) 685.
    struct Block {
        state x = 0.0;
        state v = 0.1;
        param wall = 0.9;
        friction F = Weakening { limit: 1.0, decay: 2.0 } opposing v - 0.3;
        press N = Rigid { restitution: 0.7 } closing wall - x;
        der(x) = v;
        der(v) = -x - 0.04 * v + F - N;
    }
}

/// Where the block no longer sticks before it meets the wall, and the period there: by the return map of its speed at the wall,
/// with 25 digits.
const WALL: f64 = 0.295_405_427_630_22;
const PERIOD: f64 = 1.256_073_324_06;

#[test]
fn a_branch_turns_where_a_stretch_vanishes_from_wherever_it_comes() {
    for (from, to, accuracy) in [
        (0.9, 0.25, 1e-9),
        (0.5, 0.25, 1e-9),
        (0.35, 0.25, 1e-9),
        (0.32, 0.29, 1e-9),
        (0.9, 0.25, 1e-7),
        (0.9, 0.25, 1e-5),
    ] {
        let found = branch::<Block, _>(&[], Block::wall, (from, to), |case| {
            case.accuracy = accuracy;
        });
        let [met] = &found.special[..] else {
            panic!("{from}: {:?}", found.special)
        };
        assert_eq!(met.kind, Kind::VanishingSegment, "{from}");
        let (off, error) = ((met.r - WALL).abs(), met.error.unwrap());
        assert!(
            off <= error && error < 10.0 * accuracy,
            "{from}: {off:e} {error:e}"
        );
        assert!((met.period - PERIOD).abs() < 100.0 * accuracy, "{from}");
        let sticks = found.points[0].floquet.multipliers[0].norm() == 0.0;
        let last = found.points.last().unwrap().floquet.multipliers[0].re;
        assert!(sticks && last > 1.3, "{from}: {last}");
    }
}
