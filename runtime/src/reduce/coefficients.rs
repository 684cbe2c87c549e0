//! A matrix as it was read.

use super::place::Place;

/// A matrix as it was read.
#[derive(Debug, Clone, PartialEq)]
pub struct Coefficients {
    /// Where it came from.
    pub source: Source,
    /// Its rows; of a matrix that names them, those that it names.
    pub unknowns: usize,
    /// The places of its rows, if they are named.
    pub places: Vec<Place>,
    /// Whether rows that hold nothing may be missing, as in `DMIG`.
    pub scattered: bool,
    /// Whether both triangles are there, so that what is missing is zero.
    pub whole: bool,
    /// Row and column from 0, and the value.
    pub entries: Vec<(u32, u32, f64)>,
}

/// A file.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Source {
    /// Its name, without folders.
    pub file: String,
    /// Its bytes.
    pub size: usize,
    /// The CRC-32 of its bytes.
    pub checksum: u32,
}

impl Coefficients {
    /// Whether its rows have places.
    #[must_use]
    pub fn named(&self) -> bool {
        !self.places.is_empty()
    }
}
