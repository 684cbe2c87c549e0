//! The scalar problem of one release, or of one crossing: how its speed grows with the exact law and with a smooth copy of it.

use std::ops::ControlFlow;

use num_dual::Dual64;

use super::rubbing::Rubbing;
use crate::field::{Field, Linear, Smoothing, Work};
use crate::integrate::explicit::{Settings, integrate};
use crate::integrate::{IntegrationError, Motion, RADAU_5, Radau, Tolerance};

/// Steps of one scalar problem.
const BUDGET: u64 = 20_000;
/// Local tolerance of the scalar problems.
pub(super) const TIGHT: Tolerance = Tolerance::both(1e-9);

/// ż = κ (A s + G (stick − F(z/κ))) with z = κ w: the unknowns are s, the time from the exact release, and z.
///
/// F is the magnitude of the force that resists sliding; w is counted in the direction of sliding.
#[derive(Clone, Copy)]
pub(super) struct Scalar<'a> {
    pub(super) model: &'a dyn Rubbing,
    pub(super) state: &'a [f64],
    pub(super) local: Local,
    /// Its sharpness is κ.
    pub(super) smoothing: &'a Smoothing,
    /// The copy's law instead of the exact one.
    pub(super) copied: bool,
}

/// One release of the exact orbit, or one crossing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Local {
    pub(super) contact: usize,
    /// Sign of w after it.
    pub(super) way: f64,
    /// A.
    pub(super) acceleration: f64,
    /// G.
    pub(super) compliance: f64,
    pub(super) stick: f64,
}

impl Scalar<'_> {
    /// F and its derivative by w.
    fn resistance(&self, z: f64) -> Dual64 {
        let Local { contact, way, .. } = self.local;
        let speed = Dual64::new(z / self.smoothing.sharpness(), 1.0) * way;
        let copy = self.copied.then_some(self.smoothing);
        self.model.force(self.state, contact, speed, copy) * -way
    }

    fn rate(&self, s: f64, force: f64) -> f64 {
        let at = &self.local;
        self.smoothing.sharpness() * (at.acceleration * s + at.compliance * (at.stick - force))
    }

    /// ż at s = 0, and its derivative by z.
    pub(super) fn speeding(&self, z: f64) -> (f64, f64) {
        let force = self.resistance(z);
        (self.rate(0.0, force.re), -self.local.compliance * force.eps)
    }

    /// z at s = `until`, from z at s = `from`; ends earlier where `stop` says so. Returns (s, z).
    pub(super) fn stiff(
        &self,
        from: (f64, f64),
        until: f64,
        stop: impl Fn(f64) -> bool,
    ) -> Result<(f64, f64), IntegrationError> {
        let mut radau = Radau::new(self, &RADAU_5, TIGHT, [from.0, from.1], 0.0, BUDGET)?;
        let span = until - from.0;
        while radau.time() < span && !stop(radau.state()[1]) {
            radau.step(span)?;
        }
        let [s, z] = radau.state();
        Ok((s, z))
    }

    /// z at s = `until` from z = 0 at s = `from`, with ∂z/∂z(from).
    pub(super) fn gentle(&self, from: f64, until: f64) -> Result<(f64, f64), IntegrationError> {
        let mut work = Work::default();
        let start = Motion::from([from, 0.0]);
        let settings = Settings {
            stiff_steps: u32::MAX,
            ..Settings::new(TIGHT)
        };
        let end = integrate(self, settings, start, until - from, &mut work, |_| {
            ControlFlow::Continue(())
        })?;
        Ok((end.state[1], end.tangent[1][1]))
    }
}

impl Field<2> for Scalar<'_> {
    fn f(&self, y: &[f64; 2]) -> [f64; 2] {
        [1.0, self.rate(y[0], self.resistance(y[1]).re)]
    }

    fn linearise(&self, y: &[f64; 2]) -> Linear<2> {
        let force = self.resistance(y[1]);
        Linear {
            f: [1.0, self.rate(y[0], force.re)],
            jacobian: [
                [0.0, 0.0],
                [
                    self.smoothing.sharpness() * self.local.acceleration,
                    -self.local.compliance * force.eps,
                ],
            ],
            design: [0.0; 2],
        }
    }

    fn kinks(&self) -> usize {
        if self.copied {
            self.smoothing.kernel.kinks().len()
        } else {
            0
        }
    }

    fn kink(&self, index: usize, y: &[f64; 2]) -> f64 {
        y[1] - self.smoothing.kernel.kinks()[index]
    }
}
