//! What rests on bent bristles lies on the corner of their law.

use stickslip::bifurcation::Stability;
use stickslip::model;
use stickslip::study::{Case, EquilibriumRecord, System};
use stickslip_models::friction::LuGre;

const STIFFNESS: f64 = 100.0;
const DAMPING: f64 = 4.0;

model! {
    /// A mass that is pushed by less than what its bristles bear, and driven by its own speed.
    struct Held {
        state v = 0.0;
        state z = 0.005;
        param push = 0.5;
        param drag = 1.0;
        friction F = LuGre { stiffness: 100.0, damping: 4.0, viscous: 0.0, kinetic: 1.0, peak: 1.0, stribeck: 1.0 } opposing v with z;
        der(v) = push - drag * v + F;
    }
}

/// How fast a swing grows over both halves of its turn, on the sides on which bristles yield by the share 1 ∓ push of the way:
/// λ² + (drag + σ₁ (1 ∓ push)) λ + σ₀ (1 ∓ push) = 0.
fn growth(drag: f64) -> f64 {
    let half = |yields: f64| {
        let rate = -0.5 * (drag + DAMPING * yields);
        rate / (STIFFNESS * yields - rate * rate).sqrt()
    };
    half(0.5) + half(1.5)
}

/// Where it begins to swing, by bisection.
fn onset() -> f64 {
    let (mut low, mut high) = (-6.0, -2.0);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if growth(middle) > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    0.5 * (low + high)
}

/// The one side is stable from −2 on and the other from −6: the one of them that rounding chose was told to ten digits.
#[test]
fn a_corner_leaves_open_what_its_sides_do_not_agree_on() {
    let onset = onset();
    assert!(onset < -2.5 && onset > -5.5, "{onset}");
    for ends in [1.0..-20.0, -20.0..1.0] {
        let mut case = Case::of(&Held::default()).following(Held::drag, ends.clone());
        case.parameters[Held::drag.index] = ends.start;
        let branch = System::of::<Held, _>().equilibria_along(&case).unwrap();
        for point in &branch.points {
            let r = point.r.unwrap();
            match point.stability {
                Stability::Stable => assert!(r > onset, "{r}"),
                Stability::Unstable => assert!(r < onset, "{r}"),
                Stability::Undecided => assert!((r - onset).abs() < 8.0, "{r}"),
            }
        }
        let open = |one: &&EquilibriumRecord| one.stability == Stability::Undecided;
        assert!(branch.points.iter().any(|one| open(&one)));
        for one in &branch.special {
            let off = (one.r - onset).abs();
            assert!(one.error.is_none_or(|error| off <= error), "{one:?}");
        }
    }
}
