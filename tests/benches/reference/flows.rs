//! One period with Φ and ∂φ/∂r at ε = 1e5, at the tolerance at which Φ is good to 1e-7.

use std::time::Duration;

use stickslip::continuation::Settings;
use stickslip::field::{Design, Smoothing};
use stickslip::flow::{Derivatives, Family, Flow, Passage, Place, SmoothFamily, Want};
use stickslip::integrate::Tolerance;
use stickslip::model::Model;
use stickslip::shooting::{Orbit, OrbitBranch, Search, closest};
use stickslip_models::{BeltOscillator, BeltPair};

/// Error of Φ, relative to its largest entry, at which flows are compared.
pub(crate) const PHI: f64 = 1e-7;

/// One flow to be measured: from a place on an orbit, once around.
pub(crate) struct Round<M, const N: usize> {
    pub(crate) model: M,
    pub(crate) design: usize,
    pub(crate) r: f64,
    pub(crate) start: [f64; N],
    pub(crate) period: f64,
}

pub(crate) fn table() {
    println!("\nonce around at arctan:1e5 with Φ and ∂φ/∂r, at an error of Φ of at most {PHI:e}");
    println!(
        "{:<18}{:>10}{:>10}{:>8}{:>9}{:>7}{:>9}{:>10}{:>10}",
        "", "tolerance", "µs", "wanted", "steps", "rej.", "lin.", "err Φ", "err ∂r"
    );
    let belt = belt_round();
    let ours = row(&belt, 150.0);
    rival(&belt, ours);
    let pair = pair_round();
    let ours = row(&pair, 600.0);
    rival(&pair, ours);
}

fn family<M: Model<N>, const N: usize>(model: M, design: usize) -> SmoothFamily<M, N> {
    SmoothFamily {
        model,
        smoothing: "arctan:1e5".parse::<Smoothing>().ok(),
        design: Design::Parameter(design),
        tolerance: Tolerance::for_accuracy(1e-10),
        magnitude: [1.0; N],
    }
}

fn belt_round() -> Round<BeltOscillator, 2> {
    let (model, design) = (BeltOscillator::default(), BeltOscillator::v_dr.index);
    let search = Search {
        start: [1.0, 0.0],
        period: None,
        accuracy: 1e-10,
        segments: 1,
    };
    let orbit = closest(&family(model, design), 0.2, &search).expect("the belt oscillator's orbit");
    round(model, design, &orbit)
}

/// The unstable out-of-phase orbit at v_dr = 0.14: followed from where it is stable.
fn pair_round() -> Round<BeltPair, 4> {
    let (model, design) = (BeltPair::default(), BeltPair::v_dr.index);
    let family = family(model, design);
    let search = Search {
        start: [-0.02611, 0.0, 0.6785, 0.3067],
        period: Some(4.205),
        accuracy: 1e-9,
        segments: 1,
    };
    let first = closest(&family, 0.35, &search).expect("the belt pair's orbit at 0.35");
    let settings = Settings::new(0.35, 0.14, 1e-9);
    let branch = OrbitBranch::start(&family, &first, &search, settings).expect("its branch");
    let last = branch.last().expect("a point");
    assert!(
        (last.r - 0.14).abs() < 1e-12,
        "the branch ends at {}",
        last.r
    );
    round(model, design, &last)
}

fn round<M: Model<N>, const N: usize>(
    model: M,
    design: usize,
    orbit: &Orbit<N, ()>,
) -> Round<M, N> {
    Round {
        model,
        design,
        r: orbit.r,
        start: orbit.place.state,
        period: orbit.period,
    }
}

impl<M: Model<N>, const N: usize> Round<M, N> {
    fn go(&self, tolerance: f64) -> Passage<N, ()> {
        let tolerance = Tolerance {
            relative: tolerance,
            absolute: tolerance,
        };
        let family = family(self.model, self.design).with_tolerance(tolerance);
        let want = Want {
            derivatives: true,
            ..Want::default()
        };
        let from = Place {
            state: self.start,
            mode: (),
        };
        let flow = family.at(self.r).expect("a value within bounds");
        flow.advance(&from, self.period, want).expect("once around")
    }

    /// The model at r.
    #[cfg(feature = "diffsol")]
    pub(crate) fn model_at_r(&self) -> M {
        use stickslip::scalar::Inline;
        let values = self.model.values();
        M::from_values(M::Params::from_fn(|p| {
            if p == self.design {
                self.r
            } else {
                values.as_ref()[p]
            }
        }))
    }

    /// Φ and ∂φ/∂r of a run that is tighter by far.
    pub(crate) fn truth(&self) -> Derivatives<N> {
        self.go(1e-13).derivatives.expect("what was wanted")
    }
}

/// Largest errors of Φ and ∂φ/∂r, relative to the largest entries.
pub(crate) fn errors<const N: usize>(
    state: &[[f64; N]; N],
    design: &[f64; N],
    truth: &Derivatives<N>,
) -> (f64, f64) {
    let largest = |entries: &mut dyn Iterator<Item = f64>| {
        entries.fold(0.0_f64, |largest, entry| largest.max(entry.abs()))
    };
    let phi = largest(&mut truth.state.iter().flatten().copied());
    let by_r = largest(&mut truth.design.iter().copied());
    let pairs = state.iter().flatten().zip(truth.state.iter().flatten());
    let columns = design.iter().zip(&truth.design);
    (
        largest(&mut pairs.map(|(a, b)| (a - b) / phi)),
        largest(&mut columns.map(|(a, b)| (a - b) / by_r)),
    )
}

/// The loosest tolerance from which on every tighter one tried gives Φ to the error wanted.
pub(crate) fn loosest(error: impl Fn(f64) -> Option<f64>) -> Option<f64> {
    let tolerances = (24..=50)
        .rev()
        .map(|quarter| 10_f64.powf(-f64::from(quarter) / 4.0));
    let good = tolerances.take_while(|&tolerance| error(tolerance).is_some_and(|e| e <= PHI));
    good.last()
}

fn row<M: Model<N>, const N: usize>(round: &Round<M, N>, wanted: f64) -> f64 {
    let truth = round.truth();
    let error = |tolerance: f64| {
        let derivatives = round.go(tolerance).derivatives?;
        Some(errors(&derivatives.state, &derivatives.design, &truth))
    };
    let tolerance = loosest(|tolerance| error(tolerance).map(|error| error.0)).unwrap_or(1e-13);
    let (phi, by_r) = error(tolerance).unwrap_or((f64::NAN, f64::NAN));
    let work = round.go(tolerance).work;
    let seconds = super::clock::best(Duration::from_secs(1), || {
        std::hint::black_box(round.go(std::hint::black_box(tolerance)));
    });
    println!(
        "{:<18}{tolerance:>10.1e}{:>10.1}{wanted:>8}{:>9}{:>7}{:>9}{phi:>10.1e}{by_r:>10.1e}",
        M::INFO.command,
        seconds * 1e6,
        work.steps,
        work.rejected,
        work.linearisations,
    );
    seconds
}

#[cfg(feature = "diffsol")]
fn rival<M: Model<N>, const N: usize>(round: &Round<M, N>, ours: f64) {
    super::rival::row(round, ours);
}

#[cfg(not(feature = "diffsol"))]
fn rival<M: Model<N>, const N: usize>(_: &Round<M, N>, _: f64) {
    println!(
        "{:<18}not measured: `cargo bench --features diffsol`",
        "  diffsol"
    );
}
