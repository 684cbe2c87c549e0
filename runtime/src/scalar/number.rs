//! What every number that carries derivatives has, once it has operators with its own kind and with plain numbers.

/// Operators with a reference and in place, sums and products, and what comes of plain numbers.
macro_rules! number {
    ($number:ident) => {
        $crate::scalar::number::number! { $number:
            Add add AddAssign add_assign,
            Sub sub SubAssign sub_assign,
            Mul mul MulAssign mul_assign,
            Div div DivAssign div_assign,
            Rem rem RemAssign rem_assign,
        }
    };
    ($number:ident: $($operator:ident $method:ident $assign:ident $assigned:ident,)*) => {
        $(
            impl<const N: usize> std::ops::$operator<&Self> for $number<N> {
                type Output = Self;
                fn $method(self, other: &Self) -> Self {
                    std::ops::$operator::$method(self, *other)
                }
            }

            impl<const N: usize> std::ops::$assign for $number<N> {
                fn $assigned(&mut self, other: Self) {
                    *self = std::ops::$operator::$method(*self, other);
                }
            }

            impl<const N: usize> std::ops::$assign<f64> for $number<N> {
                fn $assigned(&mut self, other: f64) {
                    *self = std::ops::$operator::$method(*self, other);
                }
            }
        )*

        impl<const N: usize> std::iter::Sum for $number<N> {
            fn sum<I: Iterator<Item = Self>>(terms: I) -> Self {
                terms.fold(Self::from(0.0), std::ops::Add::add)
            }
        }

        impl<const N: usize> std::iter::Product for $number<N> {
            fn product<I: Iterator<Item = Self>>(factors: I) -> Self {
                factors.fold(Self::from(1.0), std::ops::Mul::mul)
            }
        }

        impl<const N: usize> num_traits::Zero for $number<N> {
            fn zero() -> Self {
                Self::from(0.0)
            }

            fn is_zero(&self) -> bool {
                *self == Self::from(0.0)
            }
        }

        impl<const N: usize> num_traits::One for $number<N> {
            fn one() -> Self {
                Self::from(1.0)
            }
        }

        impl<const N: usize> num_traits::Num for $number<N> {
            type FromStrRadixErr = num_traits::ParseFloatError;

            fn from_str_radix(text: &str, radix: u32) -> Result<Self, Self::FromStrRadixErr> {
                f64::from_str_radix(text, radix).map(Self::from)
            }
        }

        impl<const N: usize> num_traits::FromPrimitive for $number<N> {
            fn from_i64(value: i64) -> Option<Self> {
                f64::from_i64(value).map(Self::from)
            }

            fn from_u64(value: u64) -> Option<Self> {
                f64::from_u64(value).map(Self::from)
            }

            fn from_f64(value: f64) -> Option<Self> {
                Some(Self::from(value))
            }
        }

        impl<const N: usize> num_dual::Mappable<Self> for $number<N> {
            type Output<O> = O;

            fn map_dual<M: Fn(Self) -> O, O>(self, map: M) -> O {
                map(self)
            }
        }
    };
}

pub(crate) use number;
