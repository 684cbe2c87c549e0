//! What a crossing costs a smooth copy: it passes its layer later or earlier than the exact contact passes zero.

use std::ops::ControlFlow;

use super::layer::edge;
use super::scalar::{Local, Scalar, TIGHT};
use crate::field::{Field, Linear, Work};
use crate::integrate::IntegrationError;
use crate::integrate::explicit::{Settings, integrate};

/// A crossing of the exact orbit: a contact that slides the other way at once.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Crossing {
    /// u̇ = G (stick − F(u)) with u counted in the direction after it and `stick` the force of the rest of the system.
    pub(super) local: Local,
    /// When, from the start of the orbit.
    pub(super) time: f64,
    /// u̇ before and after it.
    pub(super) rates: [f64; 2],
    /// How long the contact slides before and after it.
    pub(super) room: [f64; 2],
}

/// What becomes of it in the copy.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Passing {
    /// How much later than the exact contact the copy has the speed with which it leaves the layer.
    pub(super) delay: f64,
    /// How long before and after the crossing what the copy's force lacks is accounted for by that.
    pub(super) window: [f64; 2],
    /// The time that the layer takes.
    pub(super) layer: f64,
}

impl Crossing {
    /// ∫ (1/u̇ − 1/u̇_exact) du across the layer, at the load that the crossing has.
    pub(super) fn solve(&self, exact: Scalar) -> Result<Passing, IntegrationError> {
        let (kernel, sharpness) = (exact.smoothing.kernel, exact.smoothing.sharpness());
        let copy = Scalar {
            copied: true,
            ..exact
        };
        let layers = self.rates.map(|rate| 1.0 / (sharpness * rate));
        let mut window = [0.0; 2];
        let mut delay = 0.0;
        for (i, side) in [-1.0, 1.0].into_iter().enumerate() {
            window[i] = match edge(kernel) {
                Some(edge) => edge * layers[i],
                None => (layers[i] * self.room[i]).sqrt().min(self.room[i]),
            };
            let half = HalfLayer {
                copy,
                exact,
                side,
                unit: layers[i],
            };
            delay += half.delay(window[i] / layers[i])?;
        }
        Ok(Passing {
            delay,
            window,
            layer: layers[0].max(layers[1]),
        })
    }
}

/// One side of the layer; its unknowns are |z| = κ |u| and the delay so far, in units of the time that the layer takes.
struct HalfLayer<'a> {
    copy: Scalar<'a>,
    exact: Scalar<'a>,
    /// −1 before the crossing, 1 after it.
    side: f64,
    unit: f64,
}

impl HalfLayer<'_> {
    fn delay(&self, until: f64) -> Result<f64, IntegrationError> {
        let mut work = Work::default();
        let settings = Settings {
            stiff_steps: u32::MAX,
            ..Settings::new(TIGHT)
        };
        let end = integrate(self, settings, [0.0; 2], until, &mut work, |_| {
            ControlFlow::Continue(())
        })?;
        Ok(end[1] * self.unit)
    }

    /// z on this side: at 0, too, the exact force is that of this side.
    fn scaled(&self, distance: f64) -> f64 {
        self.side * distance.max(f64::MIN_POSITIVE)
    }
}

impl Field<2> for HalfLayer<'_> {
    fn f(&self, y: &[f64; 2]) -> [f64; 2] {
        let z = self.scaled(y[0]);
        let [copy, exact] = [&self.copy, &self.exact].map(|law| 1.0 / law.speeding(z).0);
        [1.0, (copy - exact) / self.unit]
    }

    fn linearise(&self, y: &[f64; 2]) -> Linear<2> {
        let z = self.scaled(y[0]);
        let slope = |law: &Scalar| {
            let (rate, by_z) = law.speeding(z);
            -by_z / (rate * rate)
        };
        let by_distance = self.side * (slope(&self.copy) - slope(&self.exact)) / self.unit;
        Linear {
            f: self.f(y),
            jacobian: [[0.0, 0.0], [by_distance, 0.0]],
            design: [0.0; 2],
        }
    }
}
