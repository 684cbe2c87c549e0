//! Smooth copies of set-valued friction: chosen at use, never part of a model.

mod press;
mod ramp;
mod refusal;
mod sloped;

pub(super) use press::rebounds;
pub use refusal::SmoothingError;
pub(super) use sloped::Sloped;

use std::fmt;

use crate::friction::{ContactRule, FrictionLaw};
use crate::press::PressLaw;
use crate::scalar::Scalar;
use crate::words::words;

words! {
    /// The shape by which a smoothing replaces the jump of a friction force.
    pub enum Kernel {
        /// (2/π) atan z: thesis (3.6). Its slow tail makes it the least accurate for its stiffness.
        Arctan = "arctan",
        /// tanh z.
        Tanh = "tanh",
        /// z / √(1 + z²).
        Algebraic = "algebraic",
        /// (3z − z³)/2 up to |z| = 1, then ±1.
        Cubic = "cubic",
        /// (15z − 10z³ + 3z⁵)/8 up to |z| = 1, then ±1.
        Quintic = "quintic",
        /// A bump of width ε that keeps a static peak, for one direction of sliding: thesis (4.7).
        Quartic = "quartic",
    }
}

/// A kernel and its size ε: s/m and growing towards the exact law for sign types, a speed that
/// shrinks towards it for [`Kernel::Quartic`].
///
/// ```
/// use stickslip::field::{Kernel, Smoothing};
/// let smoothing: Smoothing = "arctan:1e5".parse()?;
/// assert_eq!(smoothing, Smoothing { kernel: Kernel::Arctan, size: 1e5 });
/// # Ok::<(), stickslip::field::SmoothingError>(())
/// ```
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct Smoothing {
    /// The shape.
    pub kernel: Kernel,
    /// The size ε > 0.
    pub size: f64,
}

impl Kernel {
    /// Whether the kernel stands for a static peak in one direction instead of a change of sign.
    #[must_use]
    pub const fn is_bump(self) -> bool {
        matches!(self, Self::Quartic)
    }

    /// A usual size, as text.
    #[must_use]
    pub const fn example(self) -> &'static str {
        if self.is_bump() { "1e-2" } else { "1e5" }
    }

    fn suggest(word: &str) -> String {
        let names = Self::ALL.map(Self::name);
        crate::suggest::did_you_mean(word, names).map_or_else(
            || format!("there are {}", names.join(", ")),
            |name| format!("did you mean `{name}`?"),
        )
    }

    /// φ(z), odd, with φ(∞) = 1. Not for bumps.
    #[inline]
    pub(crate) fn sign<D: Scalar>(self, z: D) -> D {
        let beyond = z.re().abs() >= 1.0;
        match self {
            Self::Arctan => z.atan() * std::f64::consts::FRAC_2_PI,
            Self::Tanh => crate::math::tanh(z),
            Self::Algebraic => z / (z * z + 1.0).sqrt(),
            Self::Cubic | Self::Quintic if beyond => D::from(z.re().signum()),
            Self::Cubic => z * (z * z * -0.5 + 1.5),
            Self::Quintic => {
                let square = z * z;
                z * (square * (square * 0.375 - 1.25) + 1.875)
            }
            Self::Quartic => D::from(0.0),
        }
    }

    /// Values of z (or u, for a bump) at which the kernel itself is not analytic.
    pub(crate) const fn kinks(self) -> &'static [f64] {
        match self {
            Self::Arctan | Self::Tanh | Self::Algebraic => &[0.0],
            Self::Cubic | Self::Quintic => &[-1.0, 0.0, 1.0],
            Self::Quartic => &[0.0, 4.0],
        }
    }
}

impl Smoothing {
    /// Steepest slope of the force over its limit at rest, in the layer's own variable.
    #[must_use]
    pub fn steepness(&self) -> f64 {
        match self.kernel {
            Kernel::Arctan => std::f64::consts::FRAC_2_PI,
            Kernel::Tanh | Kernel::Algebraic => 1.0,
            Kernel::Cubic => 1.5,
            Kernel::Quintic => 1.875,
            Kernel::Quartic => 64.0 / 27.0,
        }
    }

    /// 1/width of the friction layer: z = sharpness · w.
    #[must_use]
    pub fn sharpness(&self) -> f64 {
        if self.kernel.is_bump() {
            1.0 / self.size
        } else {
            self.size
        }
    }
}

impl fmt::Display for Smoothing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let plain = format!("{}", self.size);
        let short = format!("{:e}", self.size);
        write!(
            f,
            "{}:{}",
            self.kernel,
            if plain.len() <= short.len() {
                plain
            } else {
                short
            }
        )
    }
}

impl std::str::FromStr for Smoothing {
    type Err = SmoothingError;

    fn from_str(text: &str) -> Result<Self, SmoothingError> {
        let (word, size) = text.split_once(':').unwrap_or((text, ""));
        let kernel = Kernel::ALL
            .into_iter()
            .find(|kernel| kernel.name() == word)
            .ok_or_else(|| SmoothingError::UnknownKernel {
                word: word.to_owned(),
            })?;
        size.parse()
            .ok()
            .filter(|size: &f64| *size > 0.0 && crate::model::within_reach(*size))
            .map(|size| Self { kernel, size })
            .ok_or_else(|| SmoothingError::BadSize {
                kernel,
                word: size.to_owned(),
            })
    }
}

/// Gives each contact the force of its smoothed law.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Smoothed<D> {
    pub(crate) kernel: Kernel,
    /// z = sharpness · w.
    pub(crate) sharpness: D,
}

impl<D: Scalar> ContactRule<D> for Smoothed<D> {
    #[inline]
    fn force<L: FrictionLaw<D>>(&mut self, _contact: usize, law: &L, speed: D) -> D {
        let z = speed * self.sharpness;
        if self.kernel.is_bump() {
            return -bump(law, z, speed);
        }
        -law.slip(speed.abs()) * self.kernel.sign(z)
    }

    #[inline]
    fn press<L: PressLaw<D>>(&mut self, _contact: usize, law: &L, gap: D, rate: D) -> D {
        self.pressing(law, gap, rate)
    }
}

#[inline]
fn bump<D: Scalar, L: FrictionLaw<D>>(law: &L, u: D, speed: D) -> D {
    let slip = law.slip(speed.abs());
    if u.re() >= 4.0 {
        return slip;
    }
    bump_of(law.stick(), slip, u)
}

/// The bump of a static peak: slip + (stick − slip) u (4 − u)³/27, for u ≤ 4; slip beyond.
#[inline]
pub(super) fn bump_of<D: Scalar>(stick: D, slip: D, u: D) -> D {
    let rest = -u + 4.0;
    slip + (stick - slip) * u * (rest * rest * rest) * (1.0 / 27.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn kernels_are_odd_and_saturate() {
        for kernel in Kernel::ALL.into_iter().filter(|kernel| !kernel.is_bump()) {
            assert_eq!(kernel.sign(0.7), -kernel.sign(-0.7));
            assert!((kernel.sign(1e9_f64) - 1.0).abs() < 1e-8, "{kernel}");
        }
    }

    #[test]
    fn text_and_back() {
        for text in ["arctan:1e5", "quartic:0.01", "tanh:250"] {
            assert_eq!(text.parse::<Smoothing>().unwrap().to_string(), text);
        }
    }

    #[test]
    fn messages_name_the_word_and_the_way_out() {
        let message = |text: &str| text.parse::<Smoothing>().unwrap_err().to_string();
        assert!(message("arctn:1e5").contains("did you mean `arctan`?"));
        assert!(message("arctan:-1").contains("above 0, and `-1` is not"));
        assert!(message("arctan:nan").contains("`nan`"));
        assert!(message("quartic").contains("`quartic:1e-2`"));
    }
}
