//! The smooth vector field of a declared model: without friction, or with every contact smoothed.

mod dip;
mod gradients;
mod readout;
mod rest;
mod rules;

use super::smoothing::{Sloped, Smoothed, Smoothing, SmoothingError};
use super::{Field, Linear, Stops, memory};
use crate::integrate::Tolerance;
use crate::model::{Model, Rates};
use crate::scalar::{Inline, filled};
use gradients::Gradients;
use rules::{Layer, Speeds, accept};

/// What a derivative with respect to "the design variable" means.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Design {
    /// Nothing: no such derivative is asked for.
    #[default]
    None,
    /// The model's parameter of this index.
    Parameter(usize),
    /// The natural logarithm of the size of the smoothing.
    Smoothing,
}

/// A model at given parameters, its friction replaced by a smoothing.
#[derive(Clone, Copy)]
pub struct SmoothField<M: Model<N>, const N: usize> {
    values: M::Params<f64>,
    seeds: M::Params<f64>,
    smoothing: Smoothing,
    rule: Smoothed<f64>,
    sloped: Sloped,
    gradients: Gradients<M, N>,
    magnitude: [f64; N],
    /// Number of borders of layers of presses, and of kinks of laws with internal state, the guards of their stops being
    /// the last.
    corners: usize,
    stops: Stops<N>,
}

/// Layer widths within which a contact is held.
const INSIDE: f64 = 4.0;
/// Layer widths that no single step from inside may reach.
const BEYOND: f64 = 40.0;

/// A smoothing that no contact will ever ask: for models without friction.
const UNUSED: Smoothing = Smoothing {
    kernel: super::Kernel::Tanh,
    size: 1.0,
};

impl<M: Model<N>, const N: usize> SmoothField<M, N> {
    /// Both borders of the layer in which each press sets in, and of that in which it turns: there steps end.
    const BORDERS: usize = 4 * M::INFO.presses.len();

    /// The field of `model`, with derivatives ∂/∂r for `design`.
    ///
    /// `smoothing` may be left out for models without friction only; models with friction then have no contact to ask.
    ///
    /// # Errors
    /// The smoothing would falsify a law at these parameters.
    pub fn new(
        model: &M,
        smoothing: Option<Smoothing>,
        design: Design,
    ) -> Result<Self, SmoothingError> {
        let values = model.values();
        let smoothing = smoothing.unwrap_or(UNUSED);
        accept::<M, N>(&values, &smoothing)?;
        let (kernel, sharpness) = (smoothing.kernel, smoothing.sharpness());
        let moves = f64::from(design == Design::Smoothing);
        let sign = if kernel.is_bump() { -1.0 } else { 1.0 };
        let seeds = Inline::from_fn(|i| f64::from(design == Design::Parameter(i)));
        let stops = Stops::of::<M>(&values, &seeds);
        Ok(Self {
            values,
            seeds,
            smoothing,
            rule: Smoothed { kernel, sharpness },
            sloped: Sloped {
                kernel,
                sharpness,
                seed: moves * sign * sharpness,
            },
            gradients: Gradients::of(&values),
            magnitude: memory::bounded::<M, N>(&values, [1.0; N]),
            corners: Self::BORDERS + memory::corners::<M, N>(&values) + stops.guards(),
            stops,
        })
    }

    /// What states are measured against where they pass through zero.
    pub(crate) fn magnitude(&self) -> &[f64; N] {
        &self.magnitude
    }

    /// The same field, its states measured against these magnitudes where they pass through zero.
    #[must_use]
    pub fn with_magnitude(mut self, magnitude: [f64; N]) -> Self {
        self.magnitude = memory::bounded::<M, N>(&self.values, magnitude);
        self
    }

    /// How fast the friction layers pull (∞-norm of the Jacobian inside all of them), and how fast the rest of the
    /// field changes at the declared start.
    #[must_use]
    pub fn rates(&self) -> (f64, f64) {
        let start: [f64; N] = filled(|i| M::INFO.states[i].start);
        let rate = |steepness: f64| {
            let mut sums = [0.0; N];
            let entry = |row: usize, _, slope: f64| sums[row] += slope.abs();
            let _ = M::entries(
                &self.values,
                &self.seeds,
                start,
                &mut Layer { steepness },
                entry,
            );
            sums.into_iter().fold(0.0, f64::max)
        };
        (
            rate(self.smoothing.steepness() * self.smoothing.sharpness()),
            rate(0.0),
        )
    }

    /// f and ∂f/∂r at `y`, and each entry of the Jacobian that can differ from zero, as [`Model::entries`] gives them.
    pub fn entries(&self, y: &[f64; N], mut entry: impl FnMut(usize, usize, f64)) -> Rates<N> {
        let kept = |row: usize, column: usize, slope| {
            let slope = if Self::STOPS && self.stops.rests(row) {
                0.0
            } else {
                slope
            };
            entry(row, column, slope);
        };
        let mut rates = M::entries(&self.values, &self.seeds, *y, &mut { self.sloped }, kept);
        if Self::STOPS {
            self.stops.hold(&mut rates.f);
            self.stops.hold(&mut rates.design);
        }
        rates
    }

    /// f and its derivatives with the rows of the states that rest on their stops held.
    fn held(&self, y: &[f64; N]) -> Linear<N> {
        let mut linear = M::linearise(&self.values, &self.seeds, *y, &mut { self.sloped });
        self.stops.hold(&mut linear.f);
        self.stops.hold(&mut linear.design);
        let rows = linear.jacobian.iter_mut().enumerate();
        for (_, row) in rows.filter(|(i, _)| self.stops.rests(*i)) {
            *row = [0.0; N];
        }
        linear
    }

    /// The first contact that slides backwards beyond what a one-directional smoothing stands for,
    /// and its relative speed; `None` for sign-type smoothings.
    #[must_use]
    pub fn backwards(&self, y: &[f64; N]) -> Option<(usize, f64)> {
        if !self.smoothing.kernel.is_bump() {
            return None;
        }
        let mut first = None;
        self.speeds(y, |contact, speed| {
            if first.is_none() && speed * self.rule.sharpness < -1.0 {
                first = Some((contact, speed));
            }
        });
        first
    }

    /// Calls `visit` with the number and relative speed of each contact.
    fn speeds(&self, y: &[f64; N], visit: impl FnMut(usize, f64)) {
        let _ = M::rhs(&self.values, *y, &mut Speeds(visit));
    }
}

impl<M: Model<N>, const N: usize> Field<N> for SmoothField<M, N> {
    const KINEMATIC: [Option<usize>; N] = M::KINEMATIC;

    #[inline]
    fn f(&self, y: &[f64; N]) -> [f64; N] {
        let mut rates = self.free(y);
        if Self::STOPS {
            self.stops.hold(&mut rates);
        }
        rates
    }

    // Called, it costs a small model more than its formulas do.
    #[inline(always)]
    fn linearise(&self, y: &[f64; N]) -> Linear<N> {
        if Self::STOPS {
            return self.held(y);
        }
        M::linearise(&self.values, &self.seeds, *y, &mut { self.sloped })
    }

    #[inline]
    fn scale(&self, y: &[f64; N], tolerance: &Tolerance) -> [f64; N] {
        let plain =
            filled(|i| tolerance.relative * y[i].abs() + tolerance.absolute * self.magnitude[i]);
        if M::INFO.contacts.is_empty() {
            return plain;
        }
        let width = 1.0 / self.rule.sharpness;
        let allowed = |speed: f64| tolerance.absolute * width + tolerance.relative * speed.abs();
        self.gradients.tightened(plain, &self.values, y, allowed)
    }

    fn leaps(&self, from: &[f64; N], to: &[f64; N]) -> bool {
        let mut depths = M::PerContact::from_fn(|_| f64::INFINITY);
        self.speeds(from, |contact, speed| {
            depths.as_mut()[contact] = (speed * self.rule.sharpness).abs();
        });
        let mut leaps = false;
        self.speeds(to, |contact, speed| {
            let away = (speed * self.rule.sharpness).abs();
            leaps |= depths.as_ref()[contact] <= INSIDE && away > BEYOND;
        });
        leaps
    }

    fn kinks(&self) -> usize {
        self.corners + M::INFO.contacts.len() * self.smoothing.kernel.kinks().len()
    }

    fn corners(&self) -> usize {
        self.corners
    }

    #[inline]
    fn guard(&self, index: usize) -> Option<f64> {
        self.stops.terms(self.guard_number(index)?)
    }

    fn kink_size(&self, index: usize, from: f64, to: f64) -> f64 {
        if index < self.corners {
            (from - to).abs()
        } else {
            1.0
        }
    }

    fn kink(&self, index: usize, y: &[f64; N]) -> f64 {
        if let Some(guard) = self.guard_number(index) {
            return self.stops.guard(guard, y, |state| self.free(y)[state]);
        }
        if index < Self::BORDERS {
            let (press, border) = (index / 4, index % 4);
            let place = match border {
                0 | 1 => self.height(press, y),
                _ => self.turn(press, y),
            };
            return place - if border.is_multiple_of(2) { 1.0 } else { -1.0 };
        }
        if index < self.corners {
            return memory::corner::<M, N>(&self.values, index - Self::BORDERS, y);
        }
        let index = index - self.corners;
        let places = self.smoothing.kernel.kinks();
        let (wanted, place) = (index / places.len(), places[index % places.len()]);
        let mut at = 0.0;
        self.speeds(y, |contact, speed| {
            if contact == wanted {
                at = speed;
            }
        });
        let value = at * self.rule.sharpness - place;
        // In a thin layer the rounding of a speed is not small: what it cannot tell from the kink is on it.
        let terms = || self.gradients.terms(wanted, at, &self.values, y);
        if value.abs() < 1.0 && value.abs() <= f64::EPSILON * terms() * self.rule.sharpness {
            0.0
        } else {
            value
        }
    }
}
