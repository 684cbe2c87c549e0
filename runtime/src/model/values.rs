//! Values of states in messages.

use std::fmt;
use std::ops::Deref;

use super::ModelInfo;

/// Digits of a value in a message.
const DIGITS: usize = 7;

/// The values of all states, by name where the names are known.
#[derive(Debug, Clone, PartialEq)]
pub struct Values {
    // Errors carry these, and are to stay small.
    known: Box<Known>,
    model: Option<&'static ModelInfo>,
}

#[derive(Debug, Clone, PartialEq)]
struct Known {
    values: Vec<f64>,
    /// How far each may be off; nothing where that is not known.
    errors: Vec<f64>,
}

impl Values {
    /// The states of a model.
    #[must_use]
    pub fn of(model: &'static ModelInfo, values: &[f64]) -> Self {
        Self::from(values.to_vec()).named(model)
    }

    /// The same, known to these errors: no digit below them is shown.
    #[must_use]
    pub fn within(mut self, errors: Vec<f64>) -> Self {
        self.known.errors = errors;
        self
    }

    /// The same by the names that the states have in this model.
    #[must_use]
    pub fn named(self, model: &'static ModelInfo) -> Self {
        Self {
            model: Some(model),
            ..self
        }
    }
}

impl From<Vec<f64>> for Values {
    fn from(values: Vec<f64>) -> Self {
        let errors = Vec::new();
        Self {
            known: Box::new(Known { values, errors }),
            model: None,
        }
    }
}

impl Deref for Values {
    type Target = Vec<f64>;

    fn deref(&self) -> &Vec<f64> {
        &self.known.values
    }
}

impl fmt::Display for Values {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (j, value) in self.known.values.iter().enumerate() {
            let comma = if j == 0 { "" } else { ", " };
            let error = self.known.errors.get(j).copied().unwrap_or(0.0);
            let value = known(*value, error);
            match self.model.and_then(|model| model.states.get(j)) {
                Some(state) => write!(f, "{comma}{} = {value}", state.name)?,
                None => write!(f, "{comma}{value}")?,
            }
        }
        Ok(())
    }
}

/// A number as a message shows it.
#[must_use]
pub fn brief(value: f64) -> String {
    shortened(value, DIGITS)
}

/// The digits of a number that lie above its error.
fn known(value: f64, error: f64) -> String {
    match (value.abs() / error).log10() {
        above if above < 0.0 => brief(0.0),
        above => shortened(value, above.min(DIGITS as f64 - 1.0) as usize + 1),
    }
}

fn shortened(value: f64, digits: usize) -> String {
    let rounded: f64 = format!("{value:.*e}", digits - 1).parse().unwrap_or(value);
    let plain = value == 0.0 || (1e-4..1e7).contains(&value.abs()) || !value.is_finite();
    if plain {
        format!("{rounded}")
    } else {
        format!("{rounded:e}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_short_and_plain_where_they_can_be() {
        let shown = [
            0.0,
            -0.25,
            1.0 / 3.0,
            150.0,
            1.9225325943518424e24,
            4.494e-15,
        ]
        .map(brief);
        assert_eq!(
            shown,
            ["0", "-0.25", "0.3333333", "150", "1.922533e24", "4.494e-15"]
        );
        assert_eq!(Values::from(vec![1.0, -2.0]).to_string(), "1, -2");
    }

    #[test]
    fn no_digit_below_an_error_is_shown() {
        let values = vec![-1.055_55e-10, 0.123_456_7, 0.123_456_7, 0.0, f64::INFINITY];
        let known = Values::from(values).within(vec![1e-9, 1e-4, 0.0, 0.0, 1.0]);
        assert_eq!(known.to_string(), "0, 0.1235, 0.1234567, 0, inf");
    }
}
