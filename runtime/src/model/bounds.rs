//! What values a parameter may have.

/// An interval for a parameter, each end open, closed or absent.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Bounds {
    /// Lower end.
    pub lower: Option<Bound>,
    /// Upper end.
    pub upper: Option<Bound>,
}

/// One end of an interval.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bound {
    /// Where the interval ends.
    pub value: f64,
    /// Whether the end belongs to it.
    pub inclusive: bool,
}

impl Bounds {
    /// No bound at all.
    pub const NONE: Self = Self {
        lower: None,
        upper: None,
    };

    /// Whether `value` is finite and inside.
    #[must_use]
    pub fn contain(&self, value: f64) -> bool {
        let above = |b: Bound| value > b.value || (b.inclusive && value == b.value);
        let below = |b: Bound| value < b.value || (b.inclusive && value == b.value);
        value.is_finite() && self.lower.is_none_or(above) && self.upper.is_none_or(below)
    }

    /// Checks a value of the parameter `name`.
    pub(crate) fn check(&self, name: &'static str, value: f64) -> Result<(), ParameterError> {
        if !value.is_finite() {
            return Err(ParameterError::NotFinite { name, value });
        }
        if !within_reach(value) {
            return Err(ParameterError::OutOfReach { name, value });
        }
        if !self.contain(value) {
            let bound = self.describe(name);
            return Err(ParameterError::OutOfBounds { name, value, bound });
        }
        Ok(())
    }

    /// The bounds as a user writes them, for instance `0 <= zeta < 1`; empty if there are none.
    #[must_use]
    pub fn describe(&self, name: &str) -> String {
        let sign = |inclusive| if inclusive { "=" } else { "" };
        match (self.lower, self.upper) {
            (None, None) => String::new(),
            (Some(l), None) => format!("{name} >{} {}", sign(l.inclusive), l.value),
            (None, Some(u)) => format!("{name} <{} {}", sign(u.inclusive), u.value),
            (Some(l), Some(u)) => {
                let (a, b) = (sign(l.inclusive), sign(u.inclusive));
                format!("{} <{a} {name} <{b} {}", l.value, u.value)
            }
        }
    }
}

/// A value that a parameter must not have.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum ParameterError {
    /// Not a number, or infinite.
    #[error("{name} = {value} is not a finite number")]
    NotFinite {
        /// The parameter.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// So large or so small that its square is no number.
    #[error("{name} = {value:e} is out of reach: magnitudes lie between 1e-100 and 1e100")]
    OutOfReach {
        /// The parameter.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// Outside the declared bounds.
    #[error("{name} = {value} breaks its declared bound {bound}")]
    OutOfBounds {
        /// The parameter.
        name: &'static str,
        /// Its value.
        value: f64,
        /// The bounds as written.
        bound: String,
    },
}

/// Whether a number is zero, or such that its square and a few more factors are numbers too.
#[must_use]
pub fn within_reach(value: f64) -> bool {
    value == 0.0 || (1e-100..=1e100).contains(&value.abs())
}
