//! What generated code calls; nothing here is for use by hand.

use crate::friction::{FrictionLaw, LawInfo};

/// The data of the law that a function builds.
///
/// The generated code names each law in one function only, so that a misspelt law is one error.
#[must_use]
pub const fn info_of<L: FrictionLaw<f64>, const FIELDS: usize>(
    _law: fn([f64; FIELDS]) -> L,
) -> &'static LawInfo {
    L::INFO
}
