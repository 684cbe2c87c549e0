//! Parameters by name.

use stickslip::field::Design;
use stickslip::study::{Along, System};

/// Place of the parameter of this name.
///
/// # Panics
/// The model has none.
#[must_use]
pub fn place(model: &System, name: &str) -> usize {
    let mut parameters = model.info().parameters.iter();
    parameters
        .position(|parameter| parameter.name == name)
        .expect("a parameter of the model")
}

/// The parameter of this name, to be followed from one value to another.
///
/// # Panics
/// The model has none.
#[must_use]
pub fn range(model: &System, name: &str, from: f64, to: f64) -> Along {
    let design = Design::Parameter(place(model, name));
    Along { design, from, to }
}
