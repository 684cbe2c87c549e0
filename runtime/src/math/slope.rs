//! The derivative of each function of a formula, from its argument and its value; called by generated code.

use crate::scalar::Scalar;

macro_rules! slopes {
    ($($name:ident($x:ident, $value:ident) = $slope:expr;)*) => {$(
        #[doc = concat!("Derivative of [`", stringify!($name), "`](super::", stringify!($name), ").")]
        #[inline]
        pub fn $name<D: Scalar>($x: D, $value: D) -> D {
            let _ = ($x, $value);
            $slope
        }
    )*};
}

slopes! {
    abs(x, value) = super::sign(x);
    sign(x, value) = D::from(0.0);
    acos(x, value) = -complement(x).sqrt().recip();
    acosh(x, value) = ((x - 1.0) * (x + 1.0)).sqrt().recip();
    asin(x, value) = complement(x).sqrt().recip();
    asinh(x, value) = (x * x + 1.0).sqrt().recip();
    atan(x, value) = (x * x + 1.0).recip();
    atanh(x, value) = complement(x).recip();
    cos(x, value) = -x.sin();
    cosh(x, value) = x.sinh();
    exp(x, value) = value;
    ln(x, value) = x.recip();
    sin(x, value) = x.cos();
    sinh(x, value) = x.cosh();
    sqrt(x, value) = (value * 2.0).recip();
    tan(x, value) = value * value + 1.0;
    tanh(x, value) = complement(value);
}

/// 1 - x², without loss near ±1.
#[inline]
fn complement<D: Scalar>(x: D) -> D {
    (-x + 1.0) * (x + 1.0)
}

/// Derivative of [`power`](super::power) by its base.
#[inline]
pub fn power<D: Scalar>(x: D, p: f64, value: D) -> D {
    if x.re() != 0.0 {
        return value / x * p;
    }
    if p > 1.0 {
        D::from(0.0)
    } else {
        x.powf(p - 1.0) * p
    }
}

/// Derivative of [`powf`](super::powf) by its base.
#[inline]
pub fn powf_by_base<D: Scalar>(x: D, p: D, value: D) -> D {
    if x.re() == 0.0 && p.re() > 0.0 {
        return D::from(f64::from(p.re() == 1.0));
    }
    value * p / x
}

/// Derivative of [`powf`](super::powf) by its exponent.
#[inline]
pub fn powf_by_exponent<D: Scalar>(x: D, p: D, value: D) -> D {
    if x.re() == 0.0 && p.re() > 0.0 {
        return D::from(0.0);
    }
    value * x.ln()
}

#[cfg(test)]
mod tests {
    use crate::math;
    use num_dual::Dual64;

    type Function = (&'static str, fn(Dual64) -> Dual64, fn(f64, f64) -> f64);

    macro_rules! functions {
        ($($name:ident)*) => { [$((stringify!($name), math::$name, super::$name)),*] };
    }

    fn close(found: f64, expected: f64, what: &str) {
        let tolerance = 8.0 * f64::EPSILON * (expected.abs() + 1.0);
        assert!(
            (found - expected).abs() <= tolerance,
            "{what}: {found:e}, by dual numbers {expected:e}"
        );
    }

    #[test]
    fn slopes_are_those_of_dual_numbers() {
        let functions: [Function; 14] =
            functions![acos asin asinh atan atanh cos cosh exp ln sin sinh sqrt tan tanh];
        for (name, function, slope) in functions {
            for x in [0.1, 0.5, 0.9] {
                let both = function(Dual64::new(x, 1.0));
                close(slope(x, both.re), both.eps, name);
            }
        }
        let both = math::acosh(Dual64::new(1.5, 1.0));
        close(super::acosh(1.5, both.re), both.eps, "acosh");
        assert_eq!(super::tanh(30.0, math::tanh(30.0)), 0.0);
    }

    #[test]
    fn slopes_of_powers_are_those_of_dual_numbers() {
        for (x, p) in [(0.3, 1.5), (2.0, -0.5), (4.0, 0.25), (0.0, 1.5), (0.0, 3.5)] {
            let both = math::power(Dual64::new(x, 1.0), p);
            close(super::power(x, p, both.re), both.eps, "power");
        }
        for (x, p) in [(0.3, 1.5), (2.0, -0.5), (0.0, 1.0), (0.0, 1.5)] {
            let by_base = math::powf(Dual64::new(x, 1.0), Dual64::from(p));
            let by_exponent = math::powf(Dual64::from(x), Dual64::new(p, 1.0));
            let value = by_base.re;
            close(super::powf_by_base(x, p, value), by_base.eps, "base");
            close(
                super::powf_by_exponent(x, p, value),
                by_exponent.eps,
                "exponent",
            );
        }
    }
}
