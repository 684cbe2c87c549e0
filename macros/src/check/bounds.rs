//! Bounds of parameters.

use crate::errors::Errors;
use crate::syntax::{Bound, Bounds, Declaration};

/// The bounds of a parameter are about that parameter, leave some value, and its default keeps them.
pub(super) fn check_bounds(written: &Declaration, errors: &mut Errors) {
    for param in written.params() {
        let Some(bounds) = &param.bounds else {
            continue;
        };
        let (name, other, described) = (&param.name, &bounds.name, describe(bounds));
        if name != other {
            errors.at(
                other,
                format!("the bounds of `{name}` are on `{other}`; write them on `{name}`"),
            );
        }
        if is_empty(bounds) {
            errors.at(
                bounds,
                format!("no value of `{name}` can keep the bound `{described}`"),
            );
        } else if let Some(default) = &param.number
            && !contains(bounds, default.value)
        {
            errors.at(
                default,
                format!("default {default} of `{name}` breaks its own bound `{described}`"),
            );
        }
    }
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
