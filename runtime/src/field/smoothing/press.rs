//! Smooth copies of contacts that press and let go.
//!
//! With s the sharpness of a copy, a penetration d becomes the ramp P(d) of width 1/s and its rate Ṗ, and the law of a
//! compliant press acts on these; where it would pull, the ramp once more takes its force, over the width of the force at
//! rate zero at the depth P′/s. A press that does not give way becomes a spring of the stiffness s (a unit of force presses
//! it in by 1/s) that gives back the share e² of the energy that it took: s P (1 + ρ φ(√s ḋ)) with ρ = (1 − e²)/(1 + e²),
//! which keeps Newton's restitution whatever mass meets it, and at whatever speed beyond 1/√s.

use super::{Kernel, Sloped, Smoothed, SmoothingError};
use crate::press::{GapSlopes, PressLaw};
use crate::scalar::Scalar;

/// How far a restitution may change with the speed of approach, to be called one.
const CHANGES: f64 = 1e-12;

/// ρ of a restitution.
#[inline]
fn loss<D: Scalar>(restitution: D) -> D {
    let square = restitution * restitution;
    (-square + 1.0) / (square + 1.0)
}

impl<D: Scalar> Smoothed<D> {
    /// The force of a copy at a gap and its rate: it pushes, ever less as the gap opens.
    #[inline]
    pub(super) fn pressing<L: PressLaw<D>>(&self, law: &L, gap: D, rate: D) -> D {
        let (kernel, sharpness) = (self.kernel.of_presses(), self.sharpness);
        let place = -gap * sharpness;
        let ramp = kernel.ramp(place);
        if ramp.re() == 0.0 {
            return D::from(0.0);
        }
        if L::INFO.is_rigid() {
            let lost = loss(law.rebound(D::from(1.0)));
            return ramp * (lost * kernel.sign(-rate * sharpness.sqrt()) + 1.0);
        }
        let rise = kernel.rise(place);
        let force = law.force(ramp / sharpness, -rate * rise);
        let width = law.force(rise / sharpness, D::from(0.0));
        kernel.never_pulling(force, width)
    }
}

impl Sloped {
    /// The same with its derivatives.
    #[inline]
    pub(super) fn pressing<L: PressLaw<f64>>(
        &self,
        law: &L,
        along: &L,
        gap: f64,
        rate: f64,
    ) -> GapSlopes {
        let kernel = self.kernel.of_presses();
        let place = -gap * self.sharpness;
        if kernel.ramp(place) == 0.0 {
            return GapSlopes::default();
        }
        let plain = Smoothed {
            kernel,
            sharpness: self.sharpness,
        };
        let slopes = if L::INFO.is_rigid() {
            self.rebounding(kernel, law, along, gap, rate)
        } else {
            self.giving_way(kernel, law, along, gap, rate)
        };
        GapSlopes {
            force: plain.pressing(law, gap, rate),
            ..slopes
        }
    }

    fn rebounding<L: PressLaw<f64>>(
        &self,
        kernel: Kernel,
        law: &L,
        along: &L,
        gap: f64,
        rate: f64,
    ) -> GapSlopes {
        let (sharpness, root) = (self.sharpness, self.sharpness.sqrt());
        let place = -gap * sharpness;
        let (ramp, rise) = (kernel.ramp(place), kernel.rise(place));
        let (sign, turn) = kernel.sign_and_rate(-rate * root);
        let [restitution, moved] = law.rebound_along(along, 1.0);
        let (lost, square) = (loss(restitution), restitution * restitution + 1.0);
        let (by_place, by_turn) = (rise * (1.0 + lost * sign), ramp * lost * turn);
        GapSlopes {
            force: 0.0,
            by_gap: -sharpness * by_place,
            by_rate: -root * by_turn,
            along: -4.0 * restitution / (square * square) * moved * ramp * sign,
            by_design: -self.seed * (gap * by_place + 0.5 * rate / root * by_turn),
        }
    }

    fn giving_way<L: PressLaw<f64>>(
        &self,
        kernel: Kernel,
        law: &L,
        along: &L,
        gap: f64,
        rate: f64,
    ) -> GapSlopes {
        let sharpness = self.sharpness;
        let place = -gap * sharpness;
        let (ramp, rise) = (kernel.ramp(place), kernel.rise(place));
        let (_, turn) = kernel.sign_and_rate(place);
        let bend = 0.5 * turn;
        let spring = law.slopes(along, ramp / sharpness, -rate * rise);
        let wide = law.slopes(along, rise / sharpness, 0.0);
        let [by_force, by_width] = kernel.never_pulling_slopes(spring.force, wide.force);
        // The place z = −s·gap moves the depth by z' rise/s, its rate by −rate z' bend and the width's depth by z' bend/s.
        let by_place = by_force
            * (spring.by_depth * rise / sharpness - spring.by_rate * rate * bend)
            + by_width * wide.by_depth * bend / sharpness;
        let shrinks = by_force * spring.by_depth * ramp + by_width * wide.by_depth * rise;
        GapSlopes {
            force: 0.0,
            by_gap: -sharpness * by_place,
            by_rate: -by_force * spring.by_rate * rise,
            along: by_force * spring.along + by_width * wide.along,
            by_design: -self.seed * (gap * by_place + shrinks / (sharpness * sharpness)),
        }
    }
}

/// Whether a copy stands for the law of a press: its restitution must be one number.
///
/// # Errors
/// It changes with the speed of approach, which a force does not know, or makes energy.
pub(in crate::field) fn rebounds<L: PressLaw<f64>>(
    law: &L,
    press: &'static str,
) -> Result<(), SmoothingError> {
    if !L::INFO.is_rigid() {
        return Ok(());
    }
    let restitution = |speed: f64| law.rebound(speed) / speed;
    let unit = restitution(1.0);
    let changes = |speed: f64| (restitution(speed) - unit).abs() > CHANGES;
    if unit >= 0.0 && ![1e-3, 0.3, 7.0, 1e3].into_iter().any(changes) {
        return Ok(());
    }
    Err(SmoothingError::Rebound {
        press,
        slow: restitution(1e-3),
        fast: restitution(1e3),
    })
}

#[cfg(test)]
mod tests;
