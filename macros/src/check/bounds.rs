//! Bounds: on their own parameter, not empty, and kept by the default.

use crate::errors::Errors;
use crate::syntax::{Bound, Bounds, Declaration, Value};

/// The bounds of a parameter are about that parameter.
pub(super) fn check_bound_names(written: &Declaration, errors: &mut Errors) {
    for (param, bounds) in bounded(written) {
        let (own, other) = (&param.name, &bounds.name);
        if own != other {
            errors.at(
                other,
                format!("the bounds of `{own}` are on `{other}`; write them on `{own}`"),
            );
        }
    }
}

/// Some value is left between the bounds.
pub(super) fn check_bounds_not_empty(written: &Declaration, errors: &mut Errors) {
    for (param, bounds) in bounded(written) {
        if is_empty(bounds) {
            let (name, described) = (&param.name, describe(bounds));
            errors.at(
                bounds,
                format!("no value of `{name}` can keep the bound `{described}`"),
            );
        }
    }
}

/// The default keeps its own bounds.
pub(super) fn check_defaults_in_bounds(written: &Declaration, errors: &mut Errors) {
    for (param, bounds) in bounded(written) {
        let Some(default) = &param.number else {
            continue;
        };
        if !is_empty(bounds) && !contains(bounds, default.value) {
            let (name, described) = (&param.name, describe(bounds));
            errors.at(
                default,
                format!("default {default} of `{name}` breaks its own bound `{described}`"),
            );
        }
    }
}

fn bounded(written: &Declaration) -> impl Iterator<Item = (&Value, &Bounds)> {
    written
        .params()
        .filter_map(|param| Some((param, param.bounds.as_ref()?)))
}

fn is_empty(bounds: &Bounds) -> bool {
    let (Some(lower), Some(upper)) = (&bounds.lower, &bounds.upper) else {
        return false;
    };
    let (low, high) = (lower.number.value, upper.number.value);
    low > high || (low == high && !(lower.inclusive && upper.inclusive))
}

fn contains(bounds: &Bounds, value: f64) -> bool {
    let above = |b: &Bound| value > b.number.value || (b.inclusive && value == b.number.value);
    let below = |b: &Bound| value < b.number.value || (b.inclusive && value == b.number.value);
    bounds.lower.as_ref().is_none_or(above) && bounds.upper.as_ref().is_none_or(below)
}

/// The bounds as a reader writes them: `0.0 <= zeta < 1.0`.
pub(crate) fn describe(bounds: &Bounds) -> String {
    let sign = |bound: &Bound| if bound.inclusive { "=" } else { "" };
    let name = &bounds.name;
    match (&bounds.lower, &bounds.upper) {
        (None, None) => String::new(),
        (Some(l), None) => format!("{name} >{} {}", sign(l), l.number),
        (None, Some(u)) => format!("{name} <{} {}", sign(u), u.number),
        (Some(l), Some(u)) => {
            format!("{} <{} {name} <{} {}", l.number, sign(l), sign(u), u.number)
        }
    }
}
