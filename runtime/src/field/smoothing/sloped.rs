//! The smoothed friction force with its derivatives, written out.

use super::{Kernel, bump_of};
use crate::friction::{ForceSlopes, FrictionLaw, LawSlopes, SlopeRule};
use crate::press::{GapSlopes, PressLaw};

/// [`Smoothed`](super::Smoothed) with derivatives, among them that along its own size.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Sloped {
    pub(crate) kernel: Kernel,
    /// z = sharpness · w.
    pub(crate) sharpness: f64,
    /// Derivative of the sharpness with respect to the design variable.
    pub(crate) seed: f64,
}

impl SlopeRule for Sloped {
    #[inline]
    fn force<L: FrictionLaw<f64>>(
        &mut self,
        _contact: usize,
        law: &L,
        along: &L,
        speed: f64,
    ) -> ForceSlopes {
        let law = law.slopes(along, speed.abs());
        let by_speed = law.slip_by_speed * 1.0_f64.copysign(speed);
        let z = speed * self.sharpness;
        if self.kernel.is_bump() {
            return self.bump(&law, by_speed, z, speed);
        }
        let (sign, rate) = self.kernel.sign_and_rate(z);
        let steep = -law.slip * rate;
        ForceSlopes {
            force: -law.slip * sign,
            by_speed: steep * self.sharpness - by_speed * sign,
            along: -law.slip_along * sign,
            by_design: steep * speed * self.seed,
        }
    }

    #[inline]
    fn press<L: PressLaw<f64>>(
        &mut self,
        _contact: usize,
        law: &L,
        along: &L,
        gap: f64,
        rate: f64,
    ) -> GapSlopes {
        self.pressing(law, along, gap, rate)
    }
}

impl Sloped {
    #[inline]
    fn bump(&self, law: &LawSlopes<f64>, by_speed: f64, u: f64, speed: f64) -> ForceSlopes {
        if u >= 4.0 {
            return ForceSlopes {
                force: -law.slip,
                by_speed: -by_speed,
                along: -law.slip_along,
                by_design: 0.0,
            };
        }
        let rest = -u + 4.0;
        let shape = u * (rest * rest * rest) * (1.0 / 27.0);
        let rate = (4.0 - 4.0 * u) * (rest * rest) * (1.0 / 27.0);
        let steep = -(law.stick - law.slip) * rate;
        ForceSlopes {
            force: -bump_of(law.stick, law.slip, u),
            by_speed: steep * self.sharpness - by_speed * (1.0 - shape),
            along: -law.slip_along - (law.stick_along - law.slip_along) * shape,
            by_design: steep * speed * self.seed,
        }
    }
}

impl Kernel {
    /// φ(z) and φ'(z). Not for bumps.
    #[inline]
    pub(super) fn sign_and_rate(self, z: f64) -> (f64, f64) {
        let square = z * z;
        let within = |rate: f64| if z.abs() < 1.0 { rate } else { 0.0 };
        match self {
            Self::Arctan => {
                let rate = std::f64::consts::FRAC_2_PI / (1.0 + square);
                (Self::Arctan.sign(z), rate)
            }
            Self::Tanh => {
                let sign = Self::Tanh.sign(z);
                (sign, (1.0 - sign) * (1.0 + sign))
            }
            Self::Algebraic => {
                let root = (square + 1.0).sqrt();
                (Self::Algebraic.sign(z), 1.0 / (root * root * root))
            }
            Self::Cubic => (Self::Cubic.sign(z), within(1.5 - 1.5 * square)),
            Self::Quintic => {
                let complement = 1.0 - square;
                let rate = within(1.875 * complement * complement);
                (Self::Quintic.sign(z), rate)
            }
            Self::Quartic => (0.0, 0.0),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examples::Weakening;
    use crate::field::smoothing::Smoothed;
    use crate::friction::ContactRule;
    use num_dual::Dual64;

    const SHARPNESS: f64 = 40.0;
    const FIELDS: [f64; 3] = [1.3, 1.1, 3.0];
    const MOVES: [f64; 3] = [0.2, -0.7, 0.4];

    /// The force by dual numbers that move the speed, the fields of the law, or the sharpness.
    fn by_dual(kernel: Kernel, speed: f64, moves: [f64; 3]) -> Dual64 {
        let [by_speed, by_law, by_sharpness] = moves;
        let [peak, limit, decay] =
            crate::scalar::filled(|i| Dual64::new(FIELDS[i], by_law * MOVES[i]));
        let law = Weakening { peak, limit, decay };
        let mut rule = Smoothed {
            kernel,
            sharpness: Dual64::new(SHARPNESS, by_sharpness),
        };
        rule.force(0, &law, Dual64::new(speed, by_speed))
    }

    fn law([peak, limit, decay]: [f64; 3]) -> Weakening<f64> {
        Weakening { peak, limit, decay }
    }

    fn assert_slopes(kernel: Kernel, speed: f64) {
        let sharpness = SHARPNESS;
        let mut rule = Sloped {
            kernel,
            sharpness,
            seed: 0.7,
        };
        let found = rule.force(0, &law(FIELDS), &law(MOVES), speed);
        let plain = Smoothed { kernel, sharpness }.force(0, &law(FIELDS), speed);
        assert_eq!(found.force.to_bits(), plain.to_bits(), "{kernel} {speed}");
        let directions = [
            (found.by_speed, [1.0, 0.0, 0.0]),
            (found.along, [0.0, 1.0, 0.0]),
            (found.by_design, [0.0, 0.0, 0.7]),
        ];
        for (slope, moves) in directions {
            let expected = by_dual(kernel, speed, moves).eps;
            let tolerance = 32.0 * f64::EPSILON * (expected.abs() + SHARPNESS);
            assert!(
                (slope - expected).abs() < tolerance,
                "{kernel} {speed} {moves:?}: {slope:e} {expected:e}"
            );
        }
    }

    #[test]
    fn slopes_are_those_of_dual_numbers() {
        for kernel in Kernel::ALL {
            for i in -60..60 {
                assert_slopes(kernel, f64::from(i) * 0.0031 + 1e-5);
            }
            // At rest the sign is that of the zero.
            assert_slopes(kernel, 0.0);
            assert_slopes(kernel, -0.0);
        }
    }

    #[test]
    fn nothing_overflows_far_away() {
        for kernel in Kernel::ALL {
            let mut rule = Sloped {
                kernel,
                sharpness: 1e200,
                seed: 1.0,
            };
            let found = rule.force(0, &law(FIELDS), &law(MOVES), 2.0);
            assert!(found.by_speed.is_finite(), "{kernel}");
            assert!(found.by_design.is_finite(), "{kernel}");
        }
    }
}
