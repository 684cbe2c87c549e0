//! The scalar problem of one release, or of one crossing: how its speed grows with the exact law and with a smooth copy of it.

use std::ops::ControlFlow;

use num_dual::Dual64;

use crate::field::{Field, Linear, Smoothed, Smoothing, Work};
use crate::friction::{ContactRule, FrictionLaw};
use crate::integrate::explicit::{Settings, integrate};
use crate::integrate::{IntegrationError, Motion, RADAU_5, Radau, Tolerance};
use crate::model::Model;
use crate::scalar::Inline;

/// Steps of one scalar problem.
const BUDGET: u64 = 20_000;
/// Local tolerance of the scalar problems.
const TIGHT: Tolerance = Tolerance {
    relative: 1e-9,
    absolute: 1e-9,
};

/// ż = κ (A s + G (stick − F(z/κ))) with z = κ w: the unknowns are s, the time from the exact release, and z.
///
/// F is the magnitude of the force that resists sliding; w is counted in the direction of sliding.
pub(super) struct Scalar<M: Model<N>, const N: usize> {
    params: M::Params<Dual64>,
    state: [Dual64; N],
    contact: usize,
    /// Sign of w after the release.
    way: f64,
    /// A.
    acceleration: f64,
    /// G.
    compliance: f64,
    stick: f64,
    /// κ: the sharpness of the smoothing.
    sharpness: f64,
    /// The copy's law instead of the exact one.
    copy: Option<Smoothed<Dual64>>,
    kinks: &'static [f64],
}

/// One release of the exact orbit, or one crossing.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Local<const N: usize> {
    pub(super) state: [f64; N],
    pub(super) contact: usize,
    pub(super) way: f64,
    pub(super) acceleration: f64,
    pub(super) compliance: f64,
    pub(super) stick: f64,
}

impl<M: Model<N>, const N: usize> Scalar<M, N> {
    /// The problem with the exact law, in the units of `smoothing`.
    pub(super) fn exact(model: &M, at: &Local<N>, smoothing: &Smoothing) -> Self {
        let values = model.values();
        Self {
            params: Inline::from_fn(|i| Dual64::from(values.as_ref()[i])),
            state: at.state.map(Dual64::from),
            contact: at.contact,
            way: at.way,
            acceleration: at.acceleration,
            compliance: at.compliance,
            stick: at.stick,
            sharpness: smoothing.sharpness(),
            copy: None,
            kinks: &[],
        }
    }

    /// The problem with the copy's law.
    pub(super) fn copy(model: &M, at: &Local<N>, smoothing: &Smoothing) -> Self {
        Self {
            copy: Some(Smoothed {
                kernel: smoothing.kernel,
                sharpness: Dual64::from(smoothing.sharpness()),
            }),
            kinks: smoothing.kinks(),
            ..Self::exact(model, at, smoothing)
        }
    }

    /// F and its derivative by w.
    fn resistance(&self, z: f64) -> Dual64 {
        let mut asked = Asked {
            contact: self.contact,
            speed: Dual64::new(z / self.sharpness, 1.0) * self.way,
            copy: self.copy,
            force: Dual64::from(0.0),
        };
        let _ = M::rhs(&self.params, self.state, &mut asked);
        asked.force * -self.way
    }

    fn rate(&self, s: f64, force: f64) -> f64 {
        self.sharpness * (self.acceleration * s + self.compliance * (self.stick - force))
    }

    /// ż at s = 0, and its derivative by z.
    pub(super) fn speeding(&self, z: f64) -> (f64, f64) {
        let force = self.resistance(z);
        (self.rate(0.0, force.re), -self.compliance * force.eps)
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

impl<M: Model<N>, const N: usize> Field<2> for Scalar<M, N> {
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
                    self.sharpness * self.acceleration,
                    -self.compliance * force.eps,
                ],
            ],
            design: [0.0; 2],
        }
    }

    fn kinks(&self) -> usize {
        self.kinks.len()
    }

    fn kink(&self, index: usize, y: &[f64; 2]) -> f64 {
        y[1] - self.kinks[index]
    }
}

/// Asks one law for its force at a speed of one's own choice.
struct Asked {
    contact: usize,
    speed: Dual64,
    copy: Option<Smoothed<Dual64>>,
    force: Dual64,
}

impl ContactRule<Dual64> for Asked {
    fn force<L: FrictionLaw<Dual64>>(&mut self, contact: usize, law: &L, _: Dual64) -> Dual64 {
        if contact == self.contact {
            self.force = match &mut self.copy {
                Some(copy) => copy.force(contact, law, self.speed),
                None => {
                    let sign = if self.speed.re < 0.0 { -1.0 } else { 1.0 };
                    -law.slip(self.speed * sign) * sign
                }
            };
        }
        Dual64::from(0.0)
    }
}
