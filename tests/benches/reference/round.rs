//! Orbits of the reference systems, to be integrated once around with Φ and ∂φ/∂r.

use stickslip::continuation::Settings;
use stickslip::field::{Design, SmoothField, Smoothing};
use stickslip::flow::{ExactFamily, Flow as _, Passage, Place, SmoothFamily, Want};
use stickslip::integrate::Tolerance;
use stickslip::model::Model;
use stickslip::motion::Family;
use stickslip::shooting::{Orbit, OrbitBranch, Search, closest};
use stickslip_models::{BeltOscillator, BeltPair, DrillString, VanDerPol};

/// Φ and ∂φ/∂r.
pub(crate) type Sensitivities<const N: usize> = ([[f64; N]; N], [f64; N]);

/// Once around an orbit of a system, smooth or smoothed.
pub(crate) struct Round<M, const N: usize> {
    pub(crate) model: M,
    pub(crate) smoothing: Option<&'static str>,
    pub(crate) design: usize,
    pub(crate) r: f64,
    pub(crate) start: [f64; N],
    pub(crate) period: f64,
}

/// Once around an exact orbit: a place may stick.
pub(crate) struct ExactRound<M: Model<N>, const N: usize> {
    model: M,
    design: usize,
    orbit: Orbit,
}

const DERIVATIVES: Want = Want::DERIVATIVES;

/// An orbit as it is asked for: near a start, at a value of the design variable, perhaps followed from another.
struct Asked<M, const N: usize> {
    model: M,
    design: usize,
    from: f64,
    to: f64,
    start: [f64; N],
    period: Option<f64>,
}

const VAN_DER_POL: Asked<VanDerPol, 2> = Asked {
    model: VanDerPol { nu: 5.0 },
    design: VanDerPol::nu.index,
    from: 5.0,
    to: 5.0,
    start: [2.0, 0.0],
    period: None,
};

fn asked_belt() -> Asked<BeltOscillator, 2> {
    Asked {
        model: BeltOscillator::default(),
        design: BeltOscillator::v_dr.index,
        from: 0.2,
        to: 0.2,
        start: [1.0, 0.0],
        period: None,
    }
}

/// The unstable out-of-phase orbit at v_dr = 0.14: followed from where it is stable.
fn asked_belt_pair() -> Asked<BeltPair, 4> {
    Asked {
        model: BeltPair::default(),
        design: BeltPair::v_dr.index,
        from: 0.35,
        to: 0.14,
        start: [-0.02611, 0.0, 0.6785, 0.3067],
        period: Some(4.205),
    }
}

fn asked_drill_string() -> Asked<DrillString, 2> {
    Asked {
        model: DrillString::default(),
        design: DrillString::eta.index,
        from: 4.0,
        to: 4.0,
        start: [6.0, 0.0],
        period: None,
    }
}

pub(crate) fn van_der_pol() -> Round<VanDerPol, 2> {
    VAN_DER_POL.round(None)
}

pub(crate) fn belt(smoothing: &'static str) -> Round<BeltOscillator, 2> {
    asked_belt().round(Some(smoothing))
}

pub(crate) fn belt_pair() -> Round<BeltPair, 4> {
    asked_belt_pair().round(Some("arctan:1e5"))
}

pub(crate) fn drill_string() -> Round<DrillString, 2> {
    asked_drill_string().round(Some("quartic:1e-3"))
}

pub(crate) fn exact_belt() -> ExactRound<BeltOscillator, 2> {
    asked_belt().exact()
}

pub(crate) fn exact_belt_pair() -> ExactRound<BeltPair, 4> {
    asked_belt_pair().exact()
}

pub(crate) fn exact_drill_string() -> ExactRound<DrillString, 2> {
    asked_drill_string().exact()
}

impl<M: Model<N>, const N: usize> Asked<M, N> {
    fn round(self, smoothing: Option<&'static str>) -> Round<M, N> {
        let orbit = self.find(&family(self.model, smoothing, self.design).into());
        Round {
            model: self.model,
            smoothing,
            design: self.design,
            r: self.to,
            start: std::array::from_fn(|j| orbit.place.state[j]),
            period: orbit.period,
        }
    }

    fn exact(self) -> ExactRound<M, N> {
        let tolerance = Tolerance::for_accuracy(1e-10);
        ExactRound {
            model: self.model,
            design: self.design,
            orbit: self.find(&exact_family(self.model, self.design, tolerance)),
        }
    }

    fn find(&self, family: &Family) -> Orbit {
        let search = Search {
            start: self.start.to_vec(),
            modes: Vec::new(),
            period: self.period,
            accuracy: 1e-9,
            segments: 1,
        };
        let first = closest(family, self.from, &search).expect("an orbit");
        if self.from == self.to {
            return first;
        }
        let settings = Settings::new(self.from, self.to, search.accuracy);
        let branch = OrbitBranch::start(family, &first, &search, settings).expect("its branch");
        let last = branch.last().expect("a point");
        assert!((last.r - self.to).abs() < 1e-12, "it ends at {}", last.r);
        last
    }
}

fn family<M: Model<N>, const N: usize>(
    model: M,
    smoothing: Option<&'static str>,
    design: usize,
) -> SmoothFamily<M, N> {
    SmoothFamily {
        model,
        smoothing: smoothing.map(|word| word.parse::<Smoothing>().expect("a smoothing")),
        design: Design::Parameter(design),
        tolerance: Tolerance::for_accuracy(1e-10),
        magnitude: [1.0; N],
    }
}

/// Relative and absolute alike.
pub(crate) fn both(tolerance: f64) -> Tolerance {
    Tolerance {
        relative: tolerance,
        absolute: tolerance,
    }
}

impl<M: Model<N>, const N: usize> Round<M, N> {
    /// By the flow that the program uses.
    pub(crate) fn go(&self, tolerance: f64) -> Passage<N, ()> {
        self.try_go(tolerance).expect("once around")
    }

    pub(crate) fn try_go(&self, tolerance: f64) -> Option<Passage<N, ()>> {
        let family = SmoothFamily {
            tolerance: both(tolerance),
            ..family(self.model, self.smoothing, self.design)
        };
        let from = Place {
            state: self.start,
            mode: (),
        };
        let flow = family.at(self.r).expect("a value within bounds");
        flow.advance(&from, self.period, DERIVATIVES).ok()
    }

    /// The field itself, at r.
    pub(crate) fn field(&self) -> SmoothField<M, N> {
        let family = family(self.model, self.smoothing, self.design);
        *family.at(self.r).expect("a value within bounds").field()
    }

    /// Φ and ∂φ/∂r of a run that is tighter by far.
    pub(crate) fn truth(&self) -> Sensitivities<N> {
        let derivatives = self.go(1e-13).derivatives.expect("what was wanted");
        (derivatives.state, derivatives.design)
    }
}

impl<M: Model<N>, const N: usize> ExactRound<M, N> {
    pub(crate) fn go(&self, tolerance: f64) -> Option<Sensitivities<N>> {
        let family = exact_family(self.model, self.design, both(tolerance));
        let flow = family.at(self.orbit.r).ok()?;
        let passage = flow.advance(&self.orbit.place, self.orbit.period, DERIVATIVES);
        let derivatives = passage.ok()?.derivatives?;
        let state = |i, j| derivatives.state[(i, j)];
        Some((
            std::array::from_fn(|i| std::array::from_fn(|j| state(i, j))),
            std::array::from_fn(|i| derivatives.design[i]),
        ))
    }
}

fn exact_family<M: Model<N>, const N: usize>(
    model: M,
    design: usize,
    tolerance: Tolerance,
) -> Family {
    let family = ExactFamily {
        model,
        design: Some(design),
        tolerance,
        magnitude: [1.0; N],
    };
    family.into()
}

/// Largest errors of Φ and ∂φ/∂r, relative to the largest entries.
pub(crate) fn errors<const N: usize>(
    (state, design): &Sensitivities<N>,
    (true_state, true_design): &Sensitivities<N>,
) -> (f64, f64) {
    let largest = |entries: &mut dyn Iterator<Item = f64>| {
        entries.fold(0.0_f64, |largest, entry| largest.max(entry.abs()))
    };
    let phi = largest(&mut true_state.iter().flatten().copied());
    let by_r = largest(&mut true_design.iter().copied());
    let pairs = state.iter().flatten().zip(true_state.iter().flatten());
    let columns = design.iter().zip(true_design);
    (
        largest(&mut pairs.map(|(a, b)| (a - b) / phi)),
        largest(&mut columns.map(|(a, b)| (a - b) / by_r)),
    )
}
