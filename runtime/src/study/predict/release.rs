//! What a release costs a smooth copy: an offset in speed, or a delay where a static peak is smoothed.

use super::layer::{edge, inverse};
use super::scalar::{Local, Scalar};
use crate::field::{Kernel, Smoothing};
use crate::integrate::IntegrationError;

/// |a₁|, the first zero of Airy's function Ai.
const AIRY: f64 = 2.338_107_410_459_767;
/// Share of the static force up to which the sticking force is taken as linear in time before a release.
const NEAR: f64 = 0.5;
/// Halvings of the interval in which the delay lies.
const HALVINGS: usize = 50;

/// A release of the exact orbit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Release {
    pub(super) local: Local,
    pub(super) time: f64,
    /// |λ̇| before it.
    pub(super) load_rate: f64,
    /// slip(0⁺).
    pub(super) slip: f64,
    /// How long the contact has stuck.
    pub(super) stuck: f64,
    /// How long it slides afterwards.
    pub(super) slides: f64,
}

/// What becomes of it in the copy.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Loss {
    /// Δw: how much faster the copy is after the release, referred to the release.
    pub(super) offset: f64,
    /// How much later the copy lets go, for bumps.
    pub(super) delay: f64,
    /// z of the copy at the time of the exact release: where its creep ends.
    pub(super) creep_end: f64,
    /// The time that the layer takes.
    pub(super) layer: f64,
    /// How long after the release what the copy's force lacks is accounted for; `None` for good: compact kernels
    /// lack nothing until the contact lands, and what they lack there is forgotten as it sticks.
    pub(super) accounted: Option<f64>,
}

impl Release {
    /// The leading term in closed form (table in 7.1); `None` where there is none.
    pub(super) fn leading(&self, smoothing: &Smoothing) -> Option<Loss> {
        let Local {
            acceleration: a,
            compliance: g,
            stick,
            ..
        } = self.local;
        let epsilon = smoothing.size;
        let push = |c: f64, power: i32| c * g * stick / epsilon.powi(power);
        let (offset, delay) = match smoothing.kernel {
            Kernel::Arctan => {
                let b = push(std::f64::consts::FRAC_2_PI, 1);
                (2.0_f64.cbrt() * AIRY * b.powf(2.0 / 3.0) / a.cbrt(), 0.0)
            }
            Kernel::Algebraic => (1.8772 * push(0.5, 2).powf(0.4) / a.powf(0.2), 0.0),
            Kernel::Tanh => {
                let root = (std::f64::consts::PI * epsilon / a).sqrt();
                ((4.0 * g * stick * root).ln() / (2.0 * epsilon), 0.0)
            }
            Kernel::Cubic | Kernel::Quintic => (1.0 / epsilon, 0.0),
            Kernel::Quartic => {
                let curvature = 4.0 / 3.0 * (stick - self.slip);
                let cube = 2.0 * epsilon * epsilon / (curvature * g * g * self.load_rate);
                (0.0, AIRY * cube.cbrt())
            }
        };
        (offset.is_finite() && delay.is_finite()).then_some(Loss {
            offset,
            delay,
            creep_end: 0.0,
            layer: 0.0,
            accounted: None,
        })
    }

    /// The loss of the scalar problem with weakening, integrated numerically; `None` if the copy has not let go when the exact
    /// contact sticks again.
    pub(super) fn solve(&self, exact: Scalar) -> Result<Option<Loss>, IntegrationError> {
        let (kernel, sharpness) = (exact.smoothing.kernel, exact.smoothing.sharpness());
        let copy = Scalar {
            copied: true,
            ..exact
        };
        let range = if kernel.is_bump() {
            self.local.stick - self.slip
        } else {
            self.local.stick
        };
        let before = self.stuck.min(NEAR * range / self.load_rate);
        let share = 1.0 - self.load_rate * before / range;
        let start = (-before, inverse(kernel, share));
        let (_, creep_end) = copy.stiff(start, 0.0, |_| false)?;
        let scale = (2.0 * creep_end / sharpness / self.local.acceleration).sqrt();
        let border = edge(kernel);
        let until = match border {
            Some(_) => self.slides,
            None => (scale * self.slides).sqrt(),
        };
        let free = |z: f64| border.is_some_and(|edge| z >= edge);
        let (accounted, z) = copy.stiff((0.0, creep_end), until, free)?;
        if (border.is_some() && !free(z)) || scale >= self.slides {
            return Ok(None);
        }
        let delay = if kernel.is_bump() {
            self.delay(&exact, (accounted, z))?
        } else {
            0.0
        };
        let offset = if kernel.is_bump() {
            0.0
        } else {
            let (reached, growth) = exact.gentle(0.0, accounted)?;
            (z - reached) / growth / sharpness
        };
        Ok(Some(Loss {
            offset,
            delay,
            creep_end,
            layer: if kernel.is_bump() { delay } else { scale },
            accounted: border.is_none().then_some(accounted),
        }))
    }

    /// How much later an exact release would lead to the same speed at the same time.
    fn delay(&self, exact: &Scalar, (s, z): (f64, f64)) -> Result<f64, IntegrationError> {
        let (mut low, mut high) = (0.0, s);
        let mut delay = 0.5 * s;
        for _ in 0..HALVINGS {
            let (reached, _) = exact.gentle(delay, s)?;
            *(if reached > z { &mut low } else { &mut high }) = delay;
            delay = 0.5 * (low + high);
        }
        Ok(delay)
    }
}
