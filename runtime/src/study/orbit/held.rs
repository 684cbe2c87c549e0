//! What singles out an orbit beside which there are others, in the names of its model.

use crate::model::ModelInfo;
use crate::shooting::Pin;

/// A condition on the start of an orbit that singles it out among its neighbours.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "app", derive(serde::Serialize))]
pub struct Held {
    /// A combination of the states, in their names.
    pub combination: String,
    /// Its value where the orbit begins.
    pub value: f64,
    /// Whether it never changes along the orbit; otherwise the orbit may be shifted along it, or moves with a drive.
    pub conserved: bool,
}

impl Held {
    /// The condition on an orbit that begins at this state, in the names of the model.
    pub(in crate::study) fn new(pin: &Pin, state: &[f64], info: &ModelInfo) -> Self {
        let entries = pin.combination.iter().zip(info.states);
        let terms = entries.filter(|(c, _)| **c != 0.0);
        let mut combination = String::new();
        for (c, state) in terms {
            let sign = match (combination.is_empty(), *c < 0.0) {
                (true, false) => "",
                (true, true) => "-",
                (false, false) => " + ",
                (false, true) => " - ",
            };
            let size = match c.abs() {
                size if (size - 1.0).abs() < 1e-6 => String::new(),
                size => format!("{} ", to_six_digits(size)),
            };
            combination += &format!("{sign}{size}{}", state.name);
        }
        Self {
            combination,
            value: pin.of(state),
            conserved: pin.never_changes(),
        }
    }
}

/// A positive coefficient without the rounding errors of the combination, however small it is.
fn to_six_digits(size: f64) -> f64 {
    format!("{size:.5e}").parse().unwrap_or(size)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn small_coefficients_keep_their_digits() {
        assert_eq!(to_six_digits(1.000_000_04e-8), 1e-8);
        assert_eq!(to_six_digits(0.333_333_333), 0.333_333);
    }
}
