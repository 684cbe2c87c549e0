use num_dual::Dual64;

use super::*;
use crate::examples::{Bumper, Wall};
use crate::friction::{ContactRule, SlopeRule};

const SHARPNESS: f64 = 40.0;

/// The derivatives of a copied press against dual numbers that move the gap, its rate, the fields, or the sharpness.
fn assert_slopes<L: PressLaw<f64>, D: PressLaw<Dual64>>(
    (law, along): (&L, &L),
    moving: impl Fn(f64) -> D,
    (gap, rate): (f64, f64),
) {
    for kernel in Kernel::ALL {
        let mut rule = Sloped {
            kernel,
            sharpness: SHARPNESS,
            seed: 0.7,
        };
        let found = rule.press(0, law, along, gap, rate);
        let plain = Smoothed {
            kernel,
            sharpness: SHARPNESS,
        };
        let bits = { plain }.press(0, law, gap, rate).to_bits();
        assert_eq!(found.force.to_bits(), bits);
        let by_dual = |[gap_moves, rate_moves, law_moves, size_moves]: [f64; 4]| {
            let mut rule = Smoothed {
                kernel,
                sharpness: Dual64::new(SHARPNESS, size_moves),
            };
            let gap = Dual64::new(gap, gap_moves);
            rule.press(0, &moving(law_moves), gap, Dual64::new(rate, rate_moves))
                .eps
        };
        for (slope, moves) in [
            (found.by_gap, [1.0, 0.0, 0.0, 0.0]),
            (found.by_rate, [0.0, 1.0, 0.0, 0.0]),
            (found.along, [0.0, 0.0, 1.0, 0.0]),
            (found.by_design, [0.0, 0.0, 0.0, 0.7]),
        ] {
            let expected = by_dual(moves);
            assert!(
                (slope - expected).abs() < 1e-12 * (1.0 + expected.abs()),
                "{kernel} {gap} {rate} {moves:?}: {slope} {expected}"
            );
        }
    }
}

#[test]
fn slopes_are_those_of_dual_numbers() {
    for i in -40..40 {
        let gap = 0.0013 * f64::from(i) + 1e-5;
        for rate in [-0.8, -0.02, 0.02, 0.3] {
            let bumper = |[stiffness, damping]: [f64; 2]| Bumper { stiffness, damping };
            let fields = (&bumper([3.0, 0.9]), &bumper([0.4, -0.2]));
            let moving = |moves: f64| Bumper {
                stiffness: Dual64::new(3.0, 0.4 * moves),
                damping: Dual64::new(0.9, -0.2 * moves),
            };
            assert_slopes(fields, moving, (gap, rate));
            let wall = |restitution| Wall { restitution };
            let moving = |moves: f64| Wall {
                restitution: Dual64::new(0.6, 0.3 * moves),
            };
            assert_slopes((&wall(0.6), &wall(0.3)), moving, (gap, rate));
        }
    }
}

#[test]
fn a_copy_pushes_and_tends_to_the_law() {
    let bumper = Bumper {
        stiffness: 3.0,
        damping: 0.9,
    };
    for kernel in Kernel::ALL {
        for i in -40..40 {
            let (gap, rate) = (0.01 * f64::from(i) + 1e-3, 0.7);
            for rate in [-rate, rate] {
                let copy = |sharpness: f64| {
                    let mut rule = Smoothed { kernel, sharpness };
                    rule.press(0, &bumper, gap, rate)
                };
                assert!(copy(SHARPNESS) >= 0.0, "{kernel} {gap}");
                let exact = crate::press::pressing(&bumper, gap, rate);
                assert!((copy(1e9) - exact).abs() < 1e-6, "{kernel} {gap}");
            }
        }
    }
}
