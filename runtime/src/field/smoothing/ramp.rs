//! The ramp whose slope follows a kernel: it rounds the kink of a force that sets in where a gap closes.

use super::Kernel;
use crate::scalar::Scalar;

/// Beyond this many widths a force is what it is, or none.
const FAR: f64 = 1e8;

impl Kernel {
    /// The kernel by which a copy rounds its presses: a bump has no ramp, and that of `arctan` would not end.
    pub(super) const fn of_presses(self) -> Self {
        match self {
            Self::Quartic => Self::Quintic,
            Self::Arctan => Self::Algebraic,
            other => other,
        }
    }

    /// (z + ∫φ)/2: nothing far below zero, z far above. For the kernels of presses.
    #[inline]
    pub(super) fn ramp<D: Scalar>(self, z: D) -> D {
        match self {
            Self::Cubic | Self::Quintic if z.re() <= -1.0 => D::from(0.0),
            Self::Cubic | Self::Quintic if z.re() >= 1.0 => z,
            Self::Cubic => {
                let t = z + 1.0;
                t * t * t * (-t + 4.0) * 0.0625
            }
            Self::Quintic | Self::Quartic => {
                let t = z + 1.0;
                let square = t * t;
                square * square * (square - t * 6.0 + 10.0) * 0.03125
            }
            Self::Tanh if z.re() < 0.0 => (z * 2.0).exp().ln_1p() * 0.5,
            Self::Tanh => z + (z * -2.0).exp().ln_1p() * 0.5,
            Self::Arctan | Self::Algebraic => {
                let root = (z * z + 1.0).sqrt();
                if z.re() < 0.0 {
                    (root - z).recip() * 0.5
                } else {
                    (root + z) * 0.5
                }
            }
        }
    }

    /// The slope (1 + φ)/2 of the ramp, to all digits where it is small.
    #[inline]
    pub(super) fn rise<D: Scalar>(self, z: D) -> D {
        match self {
            Self::Cubic | Self::Quintic if z.re() <= -1.0 => D::from(0.0),
            Self::Cubic | Self::Quintic if z.re() >= 1.0 => D::from(1.0),
            Self::Cubic => {
                let t = z + 1.0;
                t * t * (-t + 3.0) * 0.25
            }
            Self::Quintic | Self::Quartic => {
                let t = z + 1.0;
                t * t * t * (t * t * 3.0 - t * 15.0 + 20.0) * 0.0625
            }
            Self::Tanh if z.re() < 0.0 => {
                let small = (z * 2.0).exp();
                small / (small + 1.0)
            }
            Self::Tanh => ((z * -2.0).exp() + 1.0).recip(),
            Self::Arctan | Self::Algebraic => {
                let root = (z * z + 1.0).sqrt();
                if z.re() < 0.0 {
                    (root * (root - z)).recip() * 0.5
                } else {
                    (z / root + 1.0) * 0.5
                }
            }
        }
    }

    /// A force that never pulls: its ramp over a width in which it is still rounded.
    #[inline]
    pub(super) fn never_pulling<D: Scalar>(self, force: D, width: D) -> D {
        if (force.re() / width.re()).abs() <= FAR {
            self.ramp(force / width) * width
        } else if force.re() <= 0.0 {
            D::from(0.0)
        } else {
            force
        }
    }

    /// Derivatives of [`Kernel::never_pulling`] by the force, and by the width.
    #[inline]
    pub(super) fn never_pulling_slopes(self, force: f64, width: f64) -> [f64; 2] {
        let place = force / width;
        if place.abs() <= FAR {
            let rise = self.rise(place);
            [rise, self.ramp(place) - place * rise]
        } else {
            [f64::from(u8::from(force > 0.0)), 0.0]
        }
    }
}

#[cfg(test)]
mod tests {
    use num_dual::Dual64;

    use super::*;

    const ROUNDING: [Kernel; 4] = [
        Kernel::Tanh,
        Kernel::Algebraic,
        Kernel::Cubic,
        Kernel::Quintic,
    ];

    #[test]
    fn a_ramp_rises_as_its_kernel_says() {
        for kernel in ROUNDING {
            assert_eq!(kernel, kernel.of_presses());
            for i in -300..=300 {
                let z = f64::from(i) * 0.0137 + 1e-3;
                let (ramp, rise) = (kernel.ramp(Dual64::from(z).derivative()), kernel.rise(z));
                assert!((ramp.eps - rise).abs() < 1e-14, "{kernel} {z}");
                let half = 0.5 * (1.0 + kernel.sign(z));
                assert!((rise - half).abs() < 1e-14, "{kernel} {z}");
                assert!(ramp.re >= z.max(0.0) - 1e-15 && rise >= 0.0, "{kernel} {z}");
            }
            assert!((kernel.ramp(1e6_f64) - 1e6).abs() < 1e-6, "{kernel}");
            assert!(kernel.ramp(-1e6_f64) < 1e-6, "{kernel}");
            for far in [-1e150, -1e3, 1e3, 1e150] {
                let ramp = kernel.ramp(Dual64::from(far).derivative());
                assert!(ramp.re.is_finite() && ramp.eps.is_finite(), "{kernel}");
            }
        }
    }

    #[test]
    fn a_width_of_nothing_leaves_the_force() {
        for kernel in ROUNDING {
            for (force, kept) in [(2.0, 2.0), (-2.0, 0.0), (0.0, 0.0)] {
                assert_eq!(kernel.never_pulling(force, 0.0), kept);
            }
        }
    }
}
