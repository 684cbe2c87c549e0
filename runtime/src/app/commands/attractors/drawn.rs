//! How strongly a motion draws others in.

use crate::app::text::number;
use crate::study::{Attractor, Class};

/// Digits shown of what only shows that.
const SHOWN: usize = 4;

/// How strongly a motion draws others in: its largest multiplier, the real part of an eigenvalue, or its exponent.
pub(super) fn drawn(found: &Attractor) -> String {
    if let Some([exponent, error]) = found.exponent {
        return format!(
            "exponent {} ± {}",
            number(exponent, SHOWN),
            number(error, 2)
        );
    }
    match (found.class, found.multipliers.first()) {
        (Class::Orbit | Class::Running, Some([re, im])) if found.period.is_some() => {
            format!("|μ| = {}", number(re.hypot(*im), SHOWN))
        }
        (Class::Equilibrium | Class::Sticking | Class::Running, Some([re, _])) => {
            format!("Re = {}", number(*re, SHOWN))
        }
        _ => String::new(),
    }
}
