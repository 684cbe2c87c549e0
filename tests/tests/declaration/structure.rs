//! A structure beside the same one in its own coordinates: all modes kept, the motions are the same.

use stickslip::model;
use stickslip::model::Model;
use stickslip::study::{Case, OrbitRecord, System};
use stickslip_models::friction::Coulomb;

model! {
    /// Four masses in a row, by their modes: `chain.structure` was made of their matrices.
    pub struct ByModes {
        structure chain = "tests/declaration/chain.structure";
        param push: N = 1.0;
        param level: N = 0.4 where level >= 0.0;
        param omega: rad/s = 0.8 where omega > 0.0;
        drive phi at omega;
        friction F: N = Coulomb { level } opposing der(chain.rub);
        load chain.rub = F;
        load chain.end = push * cos(phi);
    }
}

model! {
    /// Four unit masses in a row, each with a unit spring and a damper to the one before it.
    pub struct ByMasses {
        state x[4]: m = 0.0;
        state v[4]: m/s = 0.0;
        param k: N/m = 1.0;
        param c: N*s/m = 0.02;
        param m: kg = 1.0;
        param push: N = 1.0;
        param level: N = 0.4 where level >= 0.0;
        param omega: rad/s = 0.8 where omega > 0.0;
        drive phi at omega;
        friction F: N = Coulomb { level } opposing v[1];
        let pull_0 = k * x[0] + c * v[0];
        for i in 1..4 {
            let pull[i] = k * (x[i] - x[i - 1]) + c * (v[i] - v[i - 1]);
        }
        for i in 0..4 {
            der(x[i]) = v[i];
        }
        der(v[0]) = (pull[1] - pull_0) / m;
        der(v[1]) = (pull[2] - pull[1] + F) / m;
        der(v[2]) = (pull[3] - pull[2]) / m;
        der(v[3]) = (push * cos(phi) - pull[3]) / m;
    }
}

fn orbit<M: Model<N>, const N: usize>(model: &M) -> OrbitRecord {
    System::of::<M, N>()
        .orbit(&Case::of(model))
        .expect("an orbit")
}

/// The place of mass 4 or 2, from the amplitudes of the modes.
fn displaced(state: &[f64], shape: [f64; 4]) -> f64 {
    (0..4).map(|k| shape[k] * state[2 * k]).sum()
}

#[test]
fn a_structure_moves_as_the_masses_of_which_it_was_made() {
    for (omega, level) in [(0.8, 0.4), (1.2, 0.9)] {
        let modes = orbit(&ByModes {
            omega,
            level,
            ..Default::default()
        });
        let masses = orbit(&ByMasses {
            omega,
            level,
            ..Default::default()
        });
        assert_eq!(modes.word, masses.word, "at {omega}");
        let mut both: Vec<[f64; 2]> = Vec::new();
        let mut found: Vec<f64> = modes
            .floquet
            .multipliers
            .iter()
            .map(|one| one.norm())
            .collect();
        let mut known: Vec<f64> = masses
            .floquet
            .multipliers
            .iter()
            .map(|one| one.norm())
            .collect();
        found.sort_by(f64::total_cmp);
        known.sort_by(f64::total_cmp);
        both.extend(found.iter().zip(&known).map(|(a, b)| [*a, *b]));
        let end = [
            6.565385020081385e-1,
            5.773502691896258e-1,
            4.2852507312435945e-1,
            2.2801342888377833e-1,
        ];
        let rub = [
            4.2852507312435945e-1,
            -5.77350269189626e-1,
            -2.2801342888377833e-1,
            6.565385020081385e-1,
        ];
        both.push([displaced(&modes.state, end), masses.state[3]]);
        both.push([displaced(&modes.state, rub), masses.state[1]]);
        for [found, known] in both {
            assert!(
                (found - known).abs() < 1e-7 * (1.0 + known.abs()),
                "at {omega}: {found} is not {known}"
            );
        }
    }
}

#[test]
fn a_structure_is_data_like_any_other_line() {
    let info = ByModes::INFO;
    let names: Vec<&str> = info.states.iter().map(|state| state.name).collect();
    assert_eq!(names[..3], ["chain_mode_0", "chain_rate_0", "chain_mode_1"]);
    let damping = info
        .parameters
        .iter()
        .find(|one| one.name == "chain_damping_2");
    assert!((damping.expect("a damping").default - 0.0153208).abs() < 1e-6);
}
