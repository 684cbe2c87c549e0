//! The reference systems as subjects of one questionnaire.

use stickslip::field::{Design, Kernel, SmoothField, Smoothing};
use stickslip::flow::{SmoothFamily, SmoothFlow};
use stickslip::integrate::Tolerance;
use stickslip::model::Model;
use stickslip::motion::{Family, Place};
use stickslip::shooting::{Guess, Orbit, Search, closest};
use stickslip_models::{BeltOscillator, BeltPair, DrillString, VanDerPol};

use crate::exact;

/// A model at its defaults, with a smoothing of moderate size where it has friction.
#[derive(Debug, Clone, Copy)]
pub struct Subject<M, const N: usize> {
    /// The model.
    pub model: M,
    /// The smoothing that suits its laws.
    pub smoothing: Option<Smoothing>,
}

/// Accuracy of the orbits that are asked about.
pub const ACCURACY: f64 = 1e-10;

/// A tolerance at which the integration's errors hardly show.
pub const TIGHT: Tolerance = Tolerance {
    relative: 1e-11,
    absolute: 1e-11,
};

/// [`VanDerPol`].
#[must_use]
pub fn van_der_pol() -> Subject<VanDerPol, 2> {
    plain(None)
}

/// [`BeltOscillator`].
#[must_use]
pub fn belt_oscillator() -> Subject<BeltOscillator, 2> {
    plain(Some(Smoothing {
        kernel: Kernel::Arctan,
        size: 1e3,
    }))
}

/// [`BeltPair`].
#[must_use]
pub fn belt_pair() -> Subject<BeltPair, 4> {
    plain(Some(Smoothing {
        kernel: Kernel::Cubic,
        size: 1e3,
    }))
}

/// [`DrillString`].
#[must_use]
pub fn drill_string() -> Subject<DrillString, 2> {
    plain(Some(Smoothing {
        kernel: Kernel::Quartic,
        size: 1e-1,
    }))
}

fn plain<M: Model<N>, const N: usize>(smoothing: Option<Smoothing>) -> Subject<M, N> {
    Subject {
        model: M::default(),
        smoothing,
    }
}

impl<M: Model<N>, const N: usize> Subject<M, N> {
    /// The state from which the model is declared to start.
    #[must_use]
    pub fn start(&self) -> [f64; N] {
        std::array::from_fn(|j| M::INFO.states[j].start)
    }

    /// Every design variable that the subject has, with its value: each parameter, and the size of the smoothing.
    #[must_use]
    pub fn designs(&self) -> Vec<(Design, f64)> {
        let parameters = self.model.values();
        let parameters = parameters.as_ref().iter().enumerate();
        let size = self.smoothing.map(|smoothing| smoothing.size.ln());
        parameters
            .map(|(index, &value)| (Design::Parameter(index), value))
            .chain(size.map(|size| (Design::Smoothing, size)))
            .collect()
    }

    /// The subject's flows along a design variable, for whoever need not know what moves.
    #[must_use]
    pub fn family(&self, design: Design, tolerance: Tolerance) -> Family {
        self.smooth(design, tolerance).into()
    }

    /// The subject's flows along a design variable.
    #[must_use]
    pub fn smooth(&self, design: Design, tolerance: Tolerance) -> SmoothFamily<M, N> {
        SmoothFamily {
            model: self.model,
            smoothing: self.smoothing,
            design,
            tolerance,
            magnitude: [1.0; N],
        }
    }

    /// Its field, with derivatives with respect to nothing but the state.
    ///
    /// # Panics
    /// Its smoothing does not suit it.
    #[must_use]
    pub fn field(&self) -> SmoothField<M, N> {
        SmoothField::new(&self.model, self.smoothing, Design::None).expect("a suitable smoothing")
    }

    /// Its flow.
    ///
    /// # Panics
    /// Its parameters are out of bounds.
    #[must_use]
    pub fn flow(&self, tolerance: Tolerance) -> SmoothFlow<M, N> {
        let family = self.smooth(Design::None, tolerance);
        family.at(0.0).expect("parameters within bounds")
    }

    /// What is asked of the search for its orbit.
    #[must_use]
    pub fn search(&self) -> Search {
        exact::search(&self.start(), ACCURACY)
    }

    /// The periodic orbit that is reached from the declared start.
    ///
    /// # Panics
    /// There is none.
    #[must_use]
    pub fn orbit(&self) -> Orbit {
        closest(&self.family(Design::None, TIGHT), 0.0, &self.search())
            .unwrap_or_else(|error| panic!("{}: {error}", M::INFO.name))
    }

    /// An orbit as a guess, its start displaced by `by` times half the extent of each state.
    #[must_use]
    pub fn beside(&self, orbit: &Orbit, by: [f64; N]) -> Guess {
        let magnitude: Vec<f64> = (0..N)
            .map(|j| 0.5 * (orbit.max[j] - orbit.min[j]))
            .collect();
        let displaced = |j: usize| orbit.place.state[j] + by[j] * magnitude[j];
        Guess {
            place: Place {
                state: (0..N).map(displaced).collect(),
                modes: orbit.place.modes.clone(),
            },
            period: orbit.period,
            magnitude,
            pins: Vec::new(),
            shift: None,
            division: None,
        }
    }
}
