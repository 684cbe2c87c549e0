//! Functions of enclosures: by the chain rule.

use num_dual::DualNum;
use num_traits::Inv;

use super::Enclosure;
use crate::math::interval::Interval;

/// 1 / √x.
fn inverse_root(x: Interval) -> Interval {
    Interval::ONE / x.sqrt()
}

/// 1 − x².
fn complement(x: Interval) -> Interval {
    (Interval::ONE - x) * (Interval::ONE + x)
}

/// x² + 1, or x² − 1.
fn square_and(x: Interval, one: Interval) -> Interval {
    x.powi(2) + one
}

macro_rules! functions {
    ($($name:ident($x:ident, $value:ident) = $slope:expr;)*) => {$(
        fn $name(&self) -> Self {
            let $x = self.value;
            let $value = $x.$name();
            let slope = { let _ = $value; $slope };
            self.chained($value, slope)
        }
    )*};
}

impl<const N: usize> DualNum for Enclosure<N> {
    type Primitive = f64;
    const NDERIV: usize = 1;
    type InnerDual = Self;

    functions! {
        sqrt(x, value) = Interval::ONE / (value + value);
        cbrt(x, value) = Interval::ONE / (Interval::from(3.0) * value.powi(2));
        exp(x, value) = value;
        exp_m1(x, value) = x.exp();
        ln(x, value) = Interval::ONE / x;
        ln_1p(x, value) = Interval::ONE / (Interval::ONE + x);
        sin(x, value) = x.cos();
        cos(x, value) = -x.sin();
        tan(x, value) = square_and(value, Interval::ONE);
        atan(x, value) = Interval::ONE / square_and(x, Interval::ONE);
        asin(x, value) = inverse_root(complement(x));
        acos(x, value) = -inverse_root(complement(x));
        sinh(x, value) = x.cosh();
        cosh(x, value) = x.sinh();
        tanh(x, value) = complement(value).clamped(0.0, 1.0);
        asinh(x, value) = inverse_root(square_and(x, Interval::ONE));
        acosh(x, value) = inverse_root(square_and(x, -Interval::ONE));
        atanh(x, value) = Interval::ONE / complement(x);
    }

    fn from_re(re: Self) -> Self {
        re
    }

    fn scale(self, factor: &Self) -> Self {
        self * factor
    }

    fn recip(&self) -> Self {
        self.inv()
    }

    fn powi(&self, n: i32) -> Self {
        let slope = match n.checked_sub(1) {
            Some(less) => Interval::from(f64::from(n)) * self.value.powi(less),
            None => Interval::ENTIRE,
        };
        self.chained(self.value.powi(n), slope)
    }

    fn powf(&self, n: f64) -> Self {
        let value = self.value.powf(n);
        self.chained(value, Interval::from(n) * value / self.value)
    }

    fn exp2(&self) -> Self {
        (*self * Self::from(2.0).ln()).exp()
    }

    fn log(&self, base: f64) -> Self {
        self.ln() / Self::from(base).ln()
    }

    fn log2(&self) -> Self {
        self.log(2.0)
    }

    fn log10(&self) -> Self {
        self.log(10.0)
    }

    fn sin_cos(&self) -> (Self, Self) {
        (self.sin(), self.cos())
    }

    /// Nothing is known of it: no formula has it.
    fn atan2(&self, _: Self) -> Self {
        self.unknown()
    }

    /// Nothing is known of it: no formula has it.
    fn sph_j0(&self) -> Self {
        self.unknown()
    }

    /// Nothing is known of it: no formula has it.
    fn sph_j1(&self) -> Self {
        self.unknown()
    }

    /// Nothing is known of it: no formula has it.
    fn sph_j2(&self) -> Self {
        self.unknown()
    }
}
