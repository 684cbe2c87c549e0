//! Where impacts begin: the free orbit ends at its grazing, and the orbits that are hit leave from there.

use std::f64::consts::TAU;

use nalgebra::Complex;
use stickslip::continuation::Kind;
use stickslip::field::Design;
use stickslip::flow::{EventKind, Flow, Want};
use stickslip::model::Model;
use stickslip::study::{Along, BranchRecord, Case, Dynamics, OrbitRecord, Switch, System};

use crate::models::{Hammer, flow};

/// One impact each period of ẍ + c ẋ + x = A cos ωt at x = 1 with v⁺ = −e v⁻, in closed form (the demo `impact` of COCO).
///
/// With E the free flow over one period, P = (I − E)⁻¹ [(1, v⁻) − E (1, v⁺)] is the forced motion at the impact: affine in
/// v⁺, and so is A cos ωt₀ = (1 − ω²) P₁ + c P₂. Then A² = (P₁² + P₂²/ω²) ((1 − ω²)² + c²ω²), det M = e² exp(−cT) and
/// tr M = −e tr E + E₁₂ (1 + e) (A cos ωt₀ − 1)/v⁻.
struct Hit {
    omega: f64,
    flow: [[f64; 2]; 2],
    /// P at v⁺ = 0, and its slope.
    forced: [[f64; 2]; 2],
}

const E: f64 = 0.8;
const C: f64 = 0.1;

impl Hit {
    fn at(omega: f64) -> Self {
        let (time, b) = (TAU / omega, 0.5 * C);
        let own = (1.0 - b * b).sqrt();
        let (decay, cos, sin) = (
            (-b * time).exp(),
            (own * time).cos(),
            (own * time).sin() / own,
        );
        let flow = [
            [decay * (cos + b * sin), decay * sin],
            [-decay * sin, decay * (cos - b * sin)],
        ];
        let off = [
            [1.0 - flow[0][0], -flow[0][1]],
            [-flow[1][0], 1.0 - flow[1][1]],
        ];
        let det = off[0][0] * off[1][1] - off[0][1] * off[1][0];
        let solve = |[x, y]: [f64; 2]| {
            [
                (off[1][1] * x - off[0][1] * y) / det,
                (off[0][0] * y - off[1][0] * x) / det,
            ]
        };
        Self {
            omega,
            flow,
            forced: [
                solve([1.0 - flow[0][0], -flow[1][0]]),
                solve([-flow[0][1], -1.0 / E - flow[1][1]]),
            ],
        }
    }

    fn forced(&self, departure: f64) -> [f64; 2] {
        let [still, slope] = self.forced;
        [0, 1].map(|i| still[i] + departure * slope[i])
    }

    fn stiffness(&self) -> f64 {
        1.0 - self.omega * self.omega
    }

    /// A at which the orbit departs with v⁺ < 0.
    fn load(&self, departure: f64) -> f64 {
        let [x, v] = self.forced(departure);
        x.hypot(v / self.omega) * self.stiffness().hypot(C * self.omega)
    }

    /// A cos ωt₀ − 1.
    fn pull(&self, departure: f64) -> f64 {
        let [x, v] = self.forced(departure);
        self.stiffness() * x + C * v - 1.0
    }

    /// The phase ωt₀ of the impact.
    fn phase(&self, departure: f64) -> f64 {
        let ([x, v], w) = (self.forced(departure), self.omega);
        // x + i v/ω turns backwards against X exp(iωt), which lags the load by the angle of 1 − ω² + icω.
        (-v / w).atan2(x) + (C * w).atan2(self.stiffness())
    }

    fn determinant(&self) -> f64 {
        E * E * (-C * TAU / self.omega).exp()
    }

    fn trace(&self, departure: f64) -> f64 {
        let [[a, b], [_, d]] = self.flow;
        -E * (a + d) - b * (1.0 + E) * self.pull(departure) * E / departure
    }

    /// v⁺ at which 1 ∓ tr M + det M = 0, an equation that is linear in it: a fold, or a flip.
    fn turns(&self, sign: f64) -> f64 {
        let [[a, b], [_, d]] = self.flow;
        let (k, still) = (b * (1.0 + E), self.pull(0.0));
        let slope = self.pull(1.0) - still;
        -k * still / (k * slope + (sign * (1.0 + self.determinant()) + E * (a + d)) / E)
    }
}

fn branch(hammer: &Hammer, start: [f64; 3], (from, to): (f64, f64)) -> BranchRecord {
    let mut case = Case::declared(Hammer::INFO, Dynamics::Exact);
    case.parameters = hammer.values().as_ref().to_vec();
    case.start = Some(start.to_vec());
    case.accuracy = 1e-11;
    case.parameters[Hammer::load.index] = from;
    case.along = Some(Along {
        design: Design::Parameter(Hammer::load.index),
        from,
        to,
    });
    case.switch = Switch {
        flips: true,
        branch_points: false,
        depth: 1,
    };
    let branch = System::of::<Hammer, 3>().branch(&case);
    branch.unwrap()
}

/// The speed of departure of an orbit with one impact.
fn departure(hammer: &Hammer, orbit: &OrbitRecord, load: f64) -> f64 {
    let hammer = Hammer { load, ..*hammer };
    let flow = flow(&hammer, None);
    let start = std::array::from_fn(|i| orbit.state[i]);
    let place = flow.place(start).unwrap();
    let passage = flow.advance(&place, orbit.period, Want::default()).unwrap();
    let found = passage.events.iter().find_map(|event| match event.kind {
        EventKind::Impact { departure, .. } => Some(-departure),
        _ => None,
    });
    found.unwrap()
}

/// Every orbit with an impact is one of the closed form, and has its multipliers.
fn agrees(hammer: &Hammer, branch: &BranchRecord) -> usize {
    let hit = Hit::at(hammer.omega);
    let mut hits = 0;
    for point in &branch.points {
        if point.word.as_deref() != Some("impact(R)") {
            continue;
        }
        let load = point.r.unwrap();
        let speed = departure(hammer, point, load);
        assert!(speed < 0.0, "never through the wall");
        assert!((hit.load(speed) - load).abs() < 1e-9, "{load} {speed}");
        let multipliers = &point.floquet.multipliers;
        let trace = (multipliers[0] + multipliers[1]).re;
        let size = 1.0 + trace.abs();
        // The saltation grows the error of the orbit by (1 + e)/|v|.
        let grown = 2.0 * (1.0 + E) / speed.abs();
        assert!(
            (trace - hit.trace(speed)).abs() < (1e-8 * size + point.error_estimate * grown) * size,
            "{trace} at {load}"
        );
        hits += 1;
    }
    hits
}

/// det M = e²ⁿ exp(−cT) with n impacts on every orbit of a branch and of those that leave it; how many there are.
fn volumes(branch: &BranchRecord) -> usize {
    for point in &branch.points {
        let hits = point
            .word
            .as_deref()
            .map_or(0, |word| word.matches("impact(R)").count());
        let det: Complex<f64> = point.floquet.multipliers.iter().product();
        let log = 2.0 * hits as f64 * E.ln() - C * point.period;
        let off = (det.re / log.exp() - 1.0).abs();
        assert!(off < 1e-9, "{off:e} at {:?}: {:?}", point.r, point.word);
    }
    branch.points.len() + branch.branches.iter().map(volumes).sum::<usize>()
}

#[test]
fn impacts_begin_in_a_saddle_that_turns_back_and_folds() {
    let hammer = Hammer::default();
    let branch = branch(&hammer, [0.0, 0.0, 0.0], (0.05, 0.2));
    let kinds: Vec<Kind> = branch.special.iter().map(|special| special.kind).collect();
    assert!(
        kinds.starts_with(&[Kind::Grazing, Kind::Fold]),
        "{kinds:?} {}",
        branch.ended.reason
    );
    assert!((branch.special[0].r - 0.1).abs() < 1e-9);
    assert!((branch.special[1].r - 0.09997075362831327).abs() < 1e-9);
    assert!((Hit::at(1.0).load(Hit::at(1.0).turns(1.0)) - 0.09997075362831327).abs() < 1e-14);
    assert!(agrees(&hammer, &branch) > 5);
    assert!(volumes(&branch) >= branch.points.len());
}

#[test]
fn away_from_resonance_impacts_begin_beyond_the_grazing_and_settle_in_a_flip() {
    let hammer = Hammer {
        omega: 0.9,
        ..Default::default()
    };
    let branch = branch(&hammer, [0.0, 0.0, 0.0], (0.1, 0.7));
    let kinds: Vec<Kind> = branch.special.iter().map(|special| special.kind).collect();
    assert_eq!(kinds, [Kind::Grazing, Kind::Flip]);
    assert!((branch.special[0].r - 0.21023796041628634).abs() < 1e-9);
    let hit = Hit::at(0.9);
    let flip = hit.load(hit.turns(-1.0));
    assert!((flip - 0.5707287665132044).abs() < 1e-13, "{flip}");
    assert!(
        (branch.special[1].r - flip).abs() < 1e-9,
        "{}",
        branch.special[1].r
    );
    assert!(agrees(&hammer, &branch) > 5);
    // The doubled orbits are hit twice, and have their volume, too.
    assert!(volumes(&branch) > branch.points.len() + 5);
}

/// Both orbits between the fold and the grazing: one is stable, the other a saddle near to where its multiplier is infinite.
#[test]
fn two_orbits_are_hit_between_fold_and_grazing() {
    let hammer = Hammer {
        load: 0.09999,
        ..Default::default()
    };
    for (speed, saddle) in [
        (-0.005957441202954261, None),
        (-0.0006210078273581231, Some([12.124025306, 0.028161635239])),
    ] {
        let mut case = Case::declared(Hammer::INFO, Dynamics::Exact);
        case.parameters = hammer.values().as_ref().to_vec();
        let phase = Hit::at(1.0).phase(speed).rem_euclid(TAU);
        let flow = flow(&hammer, None);
        let parts = flow.place([1.0, speed, phase]).unwrap();
        let turns = flow.advance(&parts, TAU - phase, Want::default()).unwrap();
        let [x, v, _] = turns.end.state;
        case.start = Some(vec![x, v, 0.0]);
        case.period = Some(TAU);
        case.accuracy = 1e-11;
        let orbit = System::of::<Hammer, 3>().orbit(&case).unwrap();
        let found = departure(&hammer, &orbit, hammer.load);
        assert!((found - speed).abs() < 1e-10, "{found} {speed}");
        let trace: f64 = orbit.floquet.multipliers.iter().map(|m| m.re).sum();
        // An impact so slow passes on rounding errors of its speed 2·10⁴ times.
        assert!((trace - Hit::at(1.0).trace(speed)).abs() < 2e-8, "{trace}");
        if let Some(saddle) = saddle {
            for (found, expected) in orbit.floquet.multipliers.iter().zip(saddle) {
                assert!((found.re - expected).abs() < 2e-8, "{found} {expected}");
            }
            assert_eq!(orbit.floquet.unstable, 1);
        } else {
            assert_eq!(orbit.floquet.unstable, 0);
        }
    }
}
