//! Parameters by name.

use stickslip::field::Design;
use stickslip::study::{Along, Entry};

/// Place of the parameter of this name.
///
/// # Panics
/// The model has none.
#[must_use]
pub fn place(model: &dyn Entry, name: &str) -> usize {
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
pub fn range(model: &dyn Entry, name: &str, from: f64, to: f64) -> Along {
    let design = Design::Parameter(place(model, name));
    Along { design, from, to }
}
