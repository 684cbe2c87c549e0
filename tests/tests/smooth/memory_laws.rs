//! Laws with internal state: what the papers say of them, closed forms, and their derivatives.

use stickslip::field::{Design, SmoothField};
use stickslip::flow::{Flow, SmoothFamily, Want};
use stickslip::friction::{ContactRule, FrictionLaw};
use stickslip::integrate::Tolerance;
use stickslip::model;
use stickslip::model::Model;
use stickslip::scalar::Scalar;
use stickslip::shooting::closest;
use stickslip_models::BristleOscillator;
use stickslip_models::friction::{BoucWen, BoucWenPower, Coulomb, Dahl, ElastoPlastic, LuGre};
use stickslip_tests::exact;
use stickslip_tests::lanes::{linearised, tangents};
use stickslip_tests::random::Random;

use super::followed::{close, declared, followed};

model! {
    /// A contact that swings, and what each law makes of it.
    struct Swinging {
        state q = -1.0;
        state p = 0.0;
        state dahl = 0.0;
        state y = 0.0;
        state z = 0.0;
        state y_2 = 0.0;
        state z_2 = 0.0;
        param stiffness = 2.0 where stiffness > 0.0;
        param level = 0.7 where level > 0.0;
        param beta = 0.9 where beta > 0.0;
        param gamma = 0.4;
        friction F: 1 = Dahl { stiffness, level } opposing p with dahl;
        friction G: 1 = BoucWen {
            stiffness, left: 0.1, slope: 1.3, beta, gamma
        } opposing p with y, z;
        friction H: 1 = BoucWenPower {
            stiffness, left: 0.1, slope: 1.3, beta, gamma, exponent: 2.0, scale: 0.5
        } opposing p with y_2, z_2;
        let force = F;
        let hysteresis = G + H;
        der(q) = p;
        der(p) = -q;
    }
}

model! {
    /// A body under a force that grows steadily, on bristles.
    struct Pulled {
        state x: m = 0.0;
        state v: m/s = 0.0;
        state z: m = 0.0;
        state load: N = 0.0;
        param m: kg = 1.0 where m > 0.0;
        param rate: N/s = 1.0 where rate > 0.0;
        friction F: N = LuGre {
            stiffness: 1e5, damping: 316.227766016838, viscous: 0.4, kinetic: 1.0, peak: 1.5, stribeck: 0.001
        } opposing v with z;
        let friction_force = -F;
        der(x) = v;
        der(v) = (load + F) / m;
        der(load) = rate;
    }
}

model! {
    /// A body that a force below break-away shakes, on bristles of two kinds.
    struct Shaken {
        state c = 1.0;
        state s = 0.0;
        state x1: m = 0.0;
        state v1: m/s = 0.0;
        state z1: m = 0.0;
        state x2: m = 0.0;
        state v2: m/s = 0.0;
        state z2: m = 0.0;
        param m: kg = 1.0 where m > 0.0;
        param bias: N = 0.5;
        param swing: N = 0.3;
        param omega: 1/s = 20.0;
        friction F1: N = LuGre {
            stiffness: 1e3, damping: 30.0, viscous: 0.4, kinetic: 1.0, peak: 1.5, stribeck: 0.01
        } opposing v1 with z1;
        friction F2: N = ElastoPlastic {
            stiffness: 1e3, damping: 30.0, viscous: 0.4, kinetic: 1.0, peak: 1.5, stribeck: 0.01, elastic: 0.9e-3
        } opposing v2 with z2;
        let load = bias + swing * s;
        der(c) = -omega * s;
        der(s) = omega * c;
        der(x1) = v1;
        der(v1) = (load + F1) / m;
        der(x2) = v2;
        der(v2) = (load + F2) / m;
    }
}

model! {
    /// Bristles below, dry friction above: both kinds in one model.
    struct Stacked {
        state x = 0.4;
        state v = 0.0;
        state z = 0.0;
        state u = 0.5;
        param level = 0.3 where level >= 0.0;
        param stiffness = 50.0 where stiffness > 0.0;
        friction below = Dahl { stiffness: stiffness * (1 + x * x), level: 0.2 } opposing v - 0.1 * x with z;
        friction between = Coulomb { level } opposing u - v;
        der(x) = v;
        der(v) = below - between - x;
        der(u) = between;
    }
}

/// Turning points of the swing at ±1; between them z follows an exponential in q from where it turned.
#[test]
fn dahl_runs_round_its_closed_loop() {
    let model = Swinging::default();
    let limit = model.level / model.stiffness;
    let toward = |from: f64, way: f64, sign: f64| {
        sign * limit + (from - sign * limit) * (-way / limit).exp()
    };
    let passage = followed(&model, declared::<Swinging, 7>(), 19.0, 1e-10);
    let half = std::f64::consts::PI;
    let mut checked = 0;
    for sample in &passage.path {
        let turns = (sample.time / half).floor();
        let mut z = 0.0;
        let mut sign = 1.0;
        for _ in 0..turns as usize {
            z = toward(z, 2.0, sign);
            sign = -sign;
        }
        let way = (sample.state[0] + sign).abs();
        close(sample.state[2], toward(z, way, sign), 2e-8 * limit, "Dahl");
        checked += 1;
    }
    assert!(checked > 100, "only {checked} samples");
}

/// Bouc (n = 1): exponentials in the displacement; Wen (n = 2): hyperbolic tangents on loading.
#[test]
fn bouc_wen_follows_its_closed_forms() {
    let model = Swinging::default();
    let (slope, plus, minus) = (1.3, model.beta + model.gamma, model.beta - model.gamma);
    let passage = followed(&model, declared::<Swinging, 7>(), 4.0, 1e-10);
    let loading = |y: f64| slope / plus * (1.0 - (-plus * y).exp());
    let top = loading(2.0);
    let root = (slope * plus).sqrt();
    for sample in &passage.path {
        let [_, p, _, y, z, _, z_2] = sample.state;
        if p > 0.0 {
            close(z, loading(y), 1e-8, "loading");
            let tanh = (slope / plus).sqrt() * (root * y / 0.5).tanh();
            close(z_2, tanh, 1e-8, "loading, n = 2");
        } else if z > 0.0 {
            // ż = w (A + (β − γ) z) while w < 0 < z.
            let back = (y - 2.0) * minus;
            close(
                z,
                (top + slope / minus) * back.exp() - slope / minus,
                1e-8,
                "unloading",
            );
        }
    }
}

/// Canudas de Wit et al. 1995, Fig. 4: the faster the force rises, the less of it is needed.
#[test]
fn lugre_breaks_away_the_sooner_the_faster_it_is_pulled() {
    let break_away = |rate: f64| {
        let model = Pulled {
            rate,
            ..Pulled::default()
        };
        let passage = followed(&model, [0.0; 4], 2.5 / rate, 1e-8);
        let field = SmoothField::new(&model, None, Design::None).expect("no friction to smooth");
        let forces = passage
            .path
            .iter()
            .map(|sample| field.observables(&sample.state)[0]);
        forces.fold(0.0, f64::max)
    };
    let forces = [1.0, 2.0, 5.0, 10.0, 20.0, 50.0].map(break_away);
    assert!(forces.is_sorted_by(|slow, fast| slow > fast), "{forces:?}");
    assert!(forces[0] < 1.5 && forces[0] > 1.4, "{forces:?}");
    assert!(forces[5] < 1.4 && forces[5] > 1.0, "{forces:?}");
}

/// Dupont et al. 2002: a vibrating force below break-away moves LuGre on and on, and gives the other all back.
#[test]
fn elasto_plastic_bristles_do_not_drift() {
    let model = Shaken::default();
    let turn = std::f64::consts::TAU / model.omega;
    let mut state = declared::<Shaken, 8>();
    let mut places = Vec::new();
    for _ in 0..3 {
        state = followed(&model, state, 40.0 * turn, 1e-9).end.state;
        places.push((state[2], state[5]));
    }
    let drift = |place: fn(&(f64, f64)) -> f64| place(&places[2]) - place(&places[1]);
    let (lugre, elastic) = (drift(|place| place.0), drift(|place| place.1));
    assert!(lugre > 1e-4, "LuGre drifts by {lugre:e}");
    assert!(elastic.abs() < 1e-9, "the other by {elastic:e}");
}

/// A rule for models whose friction all has internal state: it is never asked.
#[derive(Clone)]
struct Never;

impl<D: Scalar> ContactRule<D> for Never {
    fn force<L: FrictionLaw<D>>(&mut self, _: usize, _: &L, _: D) -> D {
        unreachable!("no contact without internal state")
    }
}

fn slopes_agree<M: Model<N>, const N: usize, const P: usize>(size: [f64; N]) {
    let mut random = Random::new(7);
    for _ in 0..200 {
        let state = size.map(|size| random.real(size));
        let model = M::default();
        let written = tangents::<M, N, P>(&model, state, None);
        let dual = linearised::<M, N, P>(&model, state, Never);
        let pairs = written
            .jacobian
            .as_flattened()
            .iter()
            .zip(dual.jacobian.as_flattened());
        let pairs = pairs.chain(
            written
                .by_parameter
                .as_flattened()
                .iter()
                .zip(dual.by_parameter.as_flattened()),
        );
        for (a, b) in pairs {
            assert!(
                (a - b).abs() <= 1e-11 * (1.0 + b.abs()),
                "{a:e} {b:e} at {state:?}"
            );
        }
    }
}

#[test]
fn slopes_are_those_of_dual_numbers() {
    slopes_agree::<Swinging, 7, 4>([1.0; 7]);
    slopes_agree::<Pulled, 4, 2>([1.0, 0.002, 1.5e-5, 2.0]);
    slopes_agree::<Shaken, 8, 4>([1.0, 1.0, 1.0, 0.02, 1.5e-3, 1.0, 0.02, 1.5e-3]);
}

/// Φ through the kinks against central differences of the flow.
#[test]
fn motions_have_derivatives_through_kinks() {
    let model = Swinging::default();
    let start = [-1.0, 0.3, 0.1, 0.2, -0.1, 0.0, 0.1];
    let end = |state: [f64; 7]| followed(&model, state, 7.3, 1e-12);
    let phi = end(start).derivatives.expect("wanted").state;
    let h = 1e-5;
    for j in 0..7 {
        let moved = |by: f64| {
            let mut state = start;
            state[j] += by;
            end(state).end.state
        };
        let (up, down) = (moved(h), moved(-h));
        for i in 0..7 {
            let slope = (up[i] - down[i]) / (2.0 * h);
            close(phi[i][j], slope, 3e-6, &format!("Φ[{i}][{j}]"));
        }
    }
}

/// The published parameters; digits by an independent implicit integration at a relative tolerance of 1e-12.
#[test]
fn lugre_sticks_and_slips_as_published() {
    let family = SmoothFamily {
        model: BristleOscillator::default(),
        smoothing: None,
        design: Design::None,
        tolerance: Tolerance::for_accuracy(1e-9),
        magnitude: [1.0; 3],
    };
    let search = exact::search(&[0.0; 3], 1e-9);
    let orbit = closest(&family.into(), 0.0, &search).expect("the limit cycle");
    close(orbit.period, 6.362_719_821_065_5, 1e-7, "period");
    let (max, min) = (
        [0.753_993_916_647, 0.369_815_998_81, 1.476_427_969_26e-5],
        [0.370_619_586, -3.262_037_545_2e-4, 7.615_445_194_76e-6],
    );
    for j in 0..3 {
        close(orbit.max[j], max[j], 1e-7 * max[j], "maximum");
        close(orbit.min[j], min[j], 3e-7 * max[j], "minimum");
    }
    let multipliers = &orbit.floquet.multipliers;
    assert!(
        multipliers.iter().all(|m| m.norm() < 1e-5),
        "{multipliers:?}"
    );
}

/// Φ of an exact motion that sticks and slides above bristles, against differences.
#[test]
fn dry_friction_and_bristles_go_together() {
    let flow = exact::family(Stacked::default(), 1e-11)
        .at(0.0)
        .expect("a flow");
    let end = |state: [f64; 4]| {
        let want = Want {
            derivatives: true,
            ..Want::default()
        };
        flow.advance(&flow.place(state).expect("a place"), 5.0, want)
            .expect("a motion")
    };
    let start = [0.4, 0.05, 0.001, 0.5];
    let passage = end(start);
    assert!(!passage.events.is_empty(), "nothing switches");
    let phi = passage.derivatives.expect("wanted").state;
    let h = 1e-6;
    for j in 0..4 {
        let moved = |by: f64| {
            let mut state = start;
            state[j] += by;
            end(state).end.state
        };
        let (up, down) = (moved(h), moved(-h));
        for i in 0..4 {
            let slope = (up[i] - down[i]) / (2.0 * h);
            close(phi[i][j], slope, 1e-5, &format!("Φ[{i}][{j}]"));
        }
    }
}
