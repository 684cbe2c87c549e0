//! Units of measurement.

/// A unit: its text, and its exponents of m, kg, s, A, K, mol, cd.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Unit {
    /// As written, for instance `N/m`; `1` for a dimensionless quantity.
    pub text: &'static str,
    /// Exponents of the SI base units m, kg, s, A, K, mol, cd, in twelfths: 12 is the first power, 6 a square root.
    pub dimension: [i16; 7],
}
