//! Multipliers of orbits that are hit, against what impacts and damping make of volumes.

use std::f64::consts::TAU;

use nalgebra::Complex;
use stickslip::model;
use stickslip::model::Model;
use stickslip::study::{Case, Dynamics, System};
use stickslip_models::press::Rigid;
use stickslip_tests::random::Random;

/// Random models that are asked.
const ASKED: u64 = 60;

model! {
    /// Two masses on springs between which there is a gap, the first beside a wall.
    pub(crate) struct Bumpers {
        state x = 0.0;
        state v = 0.0;
        state y = 0.0;
        state w = 0.0;
        param load = 1.0;
        param omega = 0.9 where omega > 0.0;
        param b = 0.1 where b >= 0.0;
        param c = 0.1 where c >= 0.0;
        param k = 2.0 where k > 0.0;
        param m = 2.0 where m > 0.0;
        param wall = 1.0;
        param gap = 0.5;
        param e = 0.8 where 0.0 < e <= 1.0;
        param f = 0.6 where 0.0 < f <= 1.0;
        drive phi at omega;
        press R = Rigid { restitution: e } closing wall - x;
        press S = Rigid { restitution: f } closing gap + x - y;
        der(x) = v;
        der(v) = load * cos(phi) - x - b * v - R + S;
        der(y) = w;
        der(w) = (-k * y - c * w - S) / m;
    }
}

/// det M = e²ⁱ f²ʲ exp(−(b + c/m) T) with i and j impacts, whatever the orbit.
#[test]
fn multipliers_agree_with_the_volume_that_impacts_and_damping_leave() {
    let (mut both, mut wide) = (0, 0);
    for seed in 0..ASKED {
        let mut dice = Random::new(seed);
        let bumpers = Bumpers {
            load: dice.between(0.3, 1.5),
            omega: dice.between(0.5, 2.0),
            b: dice.between(0.05, 0.4),
            c: dice.between(0.05, 0.4),
            m: dice.positive(0.3, 3.0),
            gap: dice.between(0.1, 0.6),
            e: dice.between(0.2, 0.9),
            f: dice.between(0.2, 0.9),
            ..Default::default()
        };
        let mut case = Case::declared(Bumpers::INFO, Dynamics::Exact);
        case.parameters = bumpers.values().as_ref().to_vec();
        case.period = Some(TAU / bumpers.omega);
        let Ok(orbit) = System::of::<Bumpers, 5>().orbit(&case) else {
            continue;
        };
        let word = orbit.word.clone().unwrap_or_default();
        let [i, j] = ["impact(R)", "impact(S)"].map(|hit| word.matches(hit).count() as f64);
        if word.contains("rest") || i + j == 0.0 {
            continue;
        }
        let Bumpers { b, c, m, e, f, .. } = bumpers;
        let log = 2.0 * (i * e.ln() + j * f.ln()) - (b + c / m) * orbit.period;
        let multipliers = &orbit.floquet.multipliers;
        let product: Complex<f64> = multipliers.iter().product();
        let off = (product.re / log.exp() - 1.0).abs();
        assert!(off < 1e-9, "{seed}: {word}: {off:e}, {multipliers:?}");
        both += usize::from(i * j > 0.0);
        let [most, least] = [multipliers[0], multipliers[3]].map(|one| one.norm());
        wide += usize::from(most > 1e4 * least);
    }
    println!("{both} hit both, {wide} of widely different multipliers");
    assert!(both > 3 && wide > 0, "{both}, {wide}");
}
