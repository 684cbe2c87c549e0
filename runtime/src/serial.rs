//! How values of records are written where serde has no way of its own.

use nalgebra::Complex;
use serde::{Serialize, Serializer};

/// Complex numbers as pairs.
pub(crate) fn pairs<S: Serializer>(
    values: &[Complex<f64>],
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.collect_seq(values.iter().map(|value| [value.re, value.im]))
}

/// A number, or nothing where it is infinite.
pub(crate) fn finite<S: Serializer>(value: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    value.is_finite().then_some(value).serialize(serializer)
}
