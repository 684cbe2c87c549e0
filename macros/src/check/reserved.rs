//! Names that are taken.

use proc_macro2::Ident;

use super::names::Names;
use crate::errors::Errors;
use crate::syntax::Declaration;

/// The words of the language itself.
const WORDS: [&str; 7] = [
    "der", "friction", "opposing", "param", "slip", "state", "stick",
];

/// What every model has by these names.
const MODEL_ITEMS: [&str; 13] = [
    "INFO",
    "KINEMATIC",
    "SPARSITY",
    "clone",
    "default",
    "entries",
    "eq",
    "fmt",
    "from_values",
    "linearise",
    "observables",
    "rhs",
    "values",
];

/// A name must not shadow what the generated code or the language calls by it.
pub(super) fn check_reserved(written: &Declaration, names: &Names, errors: &mut Errors) {
    for (name, _) in &names.declared {
        if let Some(reason) = reserved(name, names.in_model) {
            errors.at(
                name,
                format!("`{name}` cannot be a name here: {reason}; choose another"),
            );
        }
    }
    let types = written
        .frictions()
        .filter_map(|friction| friction.law.get_ident());
    for name in types
        .chain([&written.header.name])
        .filter(|name| *name == "D")
    {
        errors.at(name, "`D` cannot be the name of a type here: formulas use it for their numbers; choose another");
    }
}

fn reserved(name: &Ident, in_model: bool) -> Option<&'static str> {
    let text = name.to_string();
    if in_model && MODEL_ITEMS.contains(&text.as_str()) {
        Some("every model has an item of this name")
    } else if in_model && text == "smooth" {
        Some("it stands for the size of the smoothing")
    } else if WORDS.contains(&text.as_str()) {
        Some("it is a word of this language")
    } else if !is_field(name) {
        Some("it is a word of Rust")
    } else if text.starts_with("__") {
        Some("two leading underscores mark the names of generated code")
    } else {
        None
    }
}

/// Whether Rust accepts this as the name of a field.
pub(crate) fn is_field(name: &Ident) -> bool {
    name != "gen" && syn::parse2::<Ident>(quote::quote!(#name)).is_ok()
}
