//! Arrays: indices within them, and counters that are nothing else.

use std::collections::{HashMap, HashSet};

use proc_macro2::Ident;
use syn::ext::IdentExt;

use super::names::Names;
use crate::errors::Errors;
use crate::repeated::Element;
use crate::suggest::nearest;
use crate::syntax::Declaration;

/// Every element that is used is one of a declared array.
pub(super) fn check_indices(written: &Declaration, names: &Names, errors: &mut Errors) {
    let arrays = arrays(written);
    for element in missing(written) {
        let (array, index) = (&element.array, element.index);
        let message = match arrays.get(&array.unraw().to_string()) {
            Some(indices) => format!(
                "`{array}[{index}]` is out of range: `{array}` has the elements {}",
                listed(indices)
            ),
            None => unknown(array, names, &arrays),
        };
        errors.at(array, message);
    }
}

fn unknown(array: &Ident, names: &Names, arrays: &HashMap<String, Vec<i64>>) -> String {
    if let Some(noun) = names.noun_of(array) {
        return format!("`{array}` is one {noun}, not an array: write it without an index");
    }
    let known = arrays.keys().map(String::as_str);
    match nearest(&array.unraw().to_string(), known) {
        Some(near) => format!("unknown array `{array}`; did you mean `{near}`?"),
        None => format!(
            "unknown array `{array}`; declare it with `state {array}[10] = 0.0;` or `param {array}[10] = 1.0;`"
        ),
    }
}

/// Elements that are used and not declared.
pub(super) fn missing(written: &Declaration) -> impl Iterator<Item = &Element> {
    let elements = &written.repeated.elements;
    let declared: HashSet<&Ident> = elements
        .iter()
        .filter(|element| element.declares)
        .map(|element| &element.name)
        .collect();
    let used = elements.iter().filter(|element| !element.declares);
    used.filter(move |element| !declared.contains(&element.name))
}

/// The indices of each array.
pub(super) fn arrays(written: &Declaration) -> HashMap<String, Vec<i64>> {
    let mut arrays: HashMap<String, Vec<i64>> = HashMap::new();
    let elements = written.repeated.elements.iter();
    for element in elements.filter(|element| element.declares) {
        let indices = arrays.entry(element.array.unraw().to_string()).or_default();
        indices.push(element.index);
    }
    for indices in arrays.values_mut() {
        indices.sort_unstable();
    }
    arrays
}

fn listed(indices: &[i64]) -> String {
    match indices {
        [only] => only.to_string(),
        [first, .., last] if last - first + 1 == indices.len() as i64 => {
            format!("{first} to {last}")
        }
        _ => {
            let all: Vec<String> = indices.iter().map(ToString::to_string).collect();
            all.join(", ")
        }
    }
}

/// What counts in `for` has no other meaning.
pub(super) fn check_counters(written: &Declaration, names: &Names, errors: &mut Errors) {
    for counter in &written.repeated.counters {
        if let Some(noun) = names.noun_of(counter) {
            errors.at(
                counter,
                format!("`{counter}` counts in this `for` and is a {noun} too; rename one"),
            );
        }
    }
}
