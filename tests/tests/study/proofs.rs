//! Proofs of equilibria: the box holds the closed form, and what is no equilibrium is not proven.

use std::f64::consts::FRAC_2_PI;

use stickslip::equilibrium::{Proof, Unproven, find, prove};
use stickslip::field::exact::{Mode, Modes};
use stickslip::field::{EnclosedField, Unenclosed};
use stickslip::model::Model;
use stickslip_models::{BeltOscillator, BeltPair, BristleOscillator, DrillString, VanDerPol};
use stickslip_tests::chain::Chain10;
use stickslip_tests::exact;
use stickslip_tests::random::Random;

stickslip::model! {
    /// Two equilibria that meet at 0 where `gap` vanishes.
    pub struct Fold {
        state x = 0.0;
        param gap = 0.0;
        der(x) = powi(x, 2) - gap;
    }
}

stickslip::model! {
    /// Every function that a formula can have, with an equilibrium at x = 1.
    pub struct Functions {
        state x = 1.0;
        param all = 0.0;
        let here = exp(x) * sin(x) + ln(x) / cos(x) + sqrt(x) * tanh(x) - atan(x) + powf(x, 1.5) - cosh(x);
        let there = exp(all) * sin(all) + ln(all) / cos(all) + sqrt(all) * tanh(all) - atan(all) + powf(all, 1.5) - cosh(all);
        der(x) = here - there;
    }
}

/// Rounding errors of a closed form in doubles.
const ROUNDING: f64 = 1e-15;

/// The truth lies in the box, which is no wider than rounding errors make it.
fn holds(proof: &Proof, truth: &[f64], width: f64) {
    for (j, truth) in truth.iter().enumerate() {
        let (low, high) = (proof.low[j], proof.high[j]);
        let spare = ROUNDING * truth.abs();
        assert!(
            low - spare <= *truth && *truth <= high + spare,
            "state {j}: {truth} in {proof:?}"
        );
        assert!(high - low <= width, "state {j}: {proof:?}");
    }
}

fn sliding<M: Model<N>, const N: usize>(model: &M, mode: Mode) -> EnclosedField<M, N> {
    EnclosedField::sliding(model, Modes::from_fn(|_| mode))
}

#[test]
fn sliding_equilibria_are_where_the_closed_form_has_them() {
    let belt = BeltOscillator::default();
    let field = sliding(&belt, Mode::SlideBackward);
    // 1 / (1 + 3 · 0.2), the doubles taken as they are, is 0.625 but for rounding.
    holds(&prove(&field, &[0.625, 0.0]).unwrap(), &[0.625, 0.0], 1e-14);
    // Off by a little, the same one is found; off by more, it is not what was said.
    let near = prove(&field, &[0.625 + 1e-9, 1e-9]).unwrap();
    holds(&near, &[0.625, 0.0], 1e-12);
    let off = prove(&field, &[0.626, 0.0]).unwrap_err();
    assert!(matches!(off, Unproven::Elsewhere { .. }), "{off}");

    let drill = DrillString::default();
    let field = sliding(&drill, Mode::SlideForward);
    holds(&prove(&field, &[1e-16, 0.0]).unwrap(), &[0.0, 0.0], 1e-13);
}

#[test]
fn random_belt_pairs_slide_where_a_linear_equation_says() {
    let mut dice = Random::new(3);
    for _ in 0..300 {
        let pair = BeltPair {
            alpha: dice.positive(1e-3, 1e3),
            beta: dice.positive(1e-2, 1e2),
            gamma: dice.positive(1e-3, 1e3),
            v_dr: dice.positive(1e-6, 1e2),
        };
        // (1 + α) x₁ − α x₂ = f, −α x₁ + (1 + α) x₂ = β f.
        let force = 1.0 / (1.0 + pair.gamma * pair.v_dr);
        let determinant = 1.0 + 2.0 * pair.alpha;
        let x1 = force * (1.0 + pair.alpha + pair.alpha * pair.beta) / determinant;
        let x2 = force * (pair.beta * (1.0 + pair.alpha) + pair.alpha) / determinant;
        let truth = [x1, 0.0, x2, 0.0];
        let proof = prove(&sliding(&pair, Mode::SlideBackward), &truth);
        let proof = proof.unwrap_or_else(|reason| panic!("{pair:?}: {reason}"));
        let size = x1.abs().max(x2.abs());
        for (j, truth) in truth.iter().enumerate() {
            // The closed form itself loses digits where the coupling is strong.
            let spare = 8.0 * f64::EPSILON * (1.0 + pair.alpha) * size;
            assert!(
                proof.low[j] - spare <= *truth && *truth <= proof.high[j] + spare,
                "{pair:?}: {truth} in {proof:?}"
            );
            assert!(
                proof.high[j] - proof.low[j] < 1e-9 * size,
                "{pair:?} {proof:?}"
            );
        }
    }
}

#[test]
fn copies_are_proven_with_every_kernel() {
    let belt = BeltOscillator::default();
    let slip = 1.0 / (1.0 + 3.0 * 0.2);
    for (smoothing, share) in [
        ("arctan:1e5", FRAC_2_PI * (0.2 * 1e5_f64).atan()),
        ("tanh:10", (0.2 * 10_f64).tanh()),
        ("algebraic:10", 2.0 / 5.0_f64.sqrt()),
        ("cubic:4", 1.5 * 0.8 - 0.5 * 0.8_f64.powi(3)),
        ("cubic:1e5", 1.0),
        (
            "quintic:4",
            (15.0 * 0.8 - 10.0 * 0.8_f64.powi(3) + 3.0 * 0.8_f64.powi(5)) / 8.0,
        ),
        // Right at the kink, where the layer ends.
        ("quintic:5", 1.0),
    ] {
        let field = EnclosedField::smooth(&belt, Some(smoothing.parse().unwrap()));
        let truth = [slip * share, 0.0];
        holds(&prove(&field, &truth).unwrap(), &truth, 1e-12);
    }
    let field = EnclosedField::smooth(
        &DrillString::default(),
        Some("quartic:0.1".parse().unwrap()),
    );
    holds(&prove(&field, &[0.0, 0.0]).unwrap(), &[0.0, 0.0], 1e-12);
}

#[test]
fn other_models_are_proven_too() {
    for nu in [0.0, 1e-8, 1.0, 1e6] {
        let field = EnclosedField::smooth(&VanDerPol { nu }, None);
        holds(&prove(&field, &[1e-9, -1e-9]).unwrap(), &[0.0, 0.0], 1e-6);
        holds(&prove(&field, &[0.0, 0.0]).unwrap(), &[0.0, 0.0], 1e-300);
    }
    let all = 0.7;
    let field = EnclosedField::smooth(&Functions { all }, None);
    holds(&prove(&field, &[all]).unwrap(), &[all], 1e-12);

    let chain = Chain10::default();
    let family = exact::family(chain, 1e-9).into();
    let slides = |_: &[f64]| vec![vec![Mode::SlideBackward; 10]];
    let found = find(&family, 0.0, &[vec![0.0; 20]], slides);
    let state = &found[0].place.state;
    let proof = prove(&sliding(&chain, Mode::SlideBackward), state).unwrap();
    holds(&proof, state, 1e-11);
}

/// What is refused, and why.
#[test]
fn what_is_no_equilibrium_is_not_proven() {
    let refused = |answer: Result<Proof, Unproven>| answer.expect_err("no proof");
    let cycle = EnclosedField::smooth(&VanDerPol::default(), None);
    for false_one in [[2.0, 0.0], [1.0, 1.0], [-2.0, 3.0]] {
        let reason = refused(prove(&cycle, &false_one));
        let told = match &reason {
            Unproven::NotContracting { reach, .. } => *reach >= 1.0,
            Unproven::Elsewhere { state } => state.iter().all(|y| y.abs() < 1e-9),
            _ => false,
        };
        assert!(told, "{reason}");
    }
    // x² + 1 has no zero, x² has a double one, and x² − gap has two that a box of one must tell apart.
    let parabola = |gap: f64, x: f64| prove(&EnclosedField::smooth(&Fold { gap }, None), &[x]);
    assert_eq!(refused(parabola(0.0, 0.0)), Unproven::Singular);
    assert!(matches!(
        refused(parabola(-1.0, 0.1)),
        Unproven::NotContracting { .. }
    ));
    assert!(matches!(
        refused(parabola(1e-20, 1e-6)),
        Unproven::NotContracting { .. }
    ));
    holds(&parabola(1e-20, 1e-10).unwrap(), &[1e-10], 1e-20);
    let nowhere = refused(prove(&cycle, &[f64::NAN, 0.0]));
    assert!(matches!(nowhere, Unproven::Singular), "{nowhere}");
}

/// A mode in which a contact does not slide has no equilibrium, and one at rest has a set of them.
#[test]
fn a_mode_must_be_the_systems() {
    let belt = BeltOscillator::default();
    let rests = BeltOscillator { v_dr: 0.0, ..belt };
    let may_stick = Unproven::Field(Unenclosed::MayStick { name: "F" });
    for (model, mode, state) in [
        (belt, Mode::SlideForward, [-0.625, 0.0]),
        (belt, Mode::Stick, [0.625, 0.0]),
        (rests, Mode::SlideBackward, [1.0, 0.0]),
    ] {
        assert_eq!(
            prove(&sliding(&model, mode), &state),
            Err(may_stick.clone()),
            "{mode}"
        );
    }
    // Bristles slide steadily under F_c + σ₂ w, and are of two kinds at rest.
    let bristles = EnclosedField::smooth(&BristleOscillator::default(), None);
    let steady = [0.52, 0.1, 1e-5];
    holds(&prove(&bristles, &steady).unwrap(), &steady, 1e-12);
    let reason = prove(&bristles, &[0.52, 0.0, 1e-5]).unwrap_err();
    assert_eq!(reason, Unproven::Field(Unenclosed::MayTurn { name: "F" }));
}
