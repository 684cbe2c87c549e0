//! Where starts lie.

use crate::math::Spread;

/// A side of a region of starts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Side {
    /// The state.
    pub state: usize,
    /// Its least value.
    pub low: f64,
    /// Its largest.
    pub high: f64,
}

/// A box of starts; states without a side begin as the case does.
#[derive(Debug, Clone, PartialEq)]
pub struct Region {
    /// Its sides, each of another state.
    pub sides: Vec<Side>,
}

/// From where motions are followed.
#[derive(Debug, Clone, PartialEq)]
pub struct Sampling {
    /// Where starts lie.
    pub region: Region,
    /// How many starts at each value of what is followed.
    pub starts: usize,
    /// How many values.
    pub values: usize,
    /// Whether shares are areas, too: of a region with two sides.
    pub areas: bool,
    /// Whether saddles are sought on the edges between basins.
    pub edges: bool,
    /// Whether unstable orbits are sought that lie on no edge, too.
    pub further: bool,
}

impl Sampling {
    /// So many starts in a region, at one value of what is followed.
    #[must_use]
    pub const fn of(region: Region, starts: usize) -> Self {
        Self {
            region,
            starts,
            values: 1,
            areas: false,
            edges: false,
            further: false,
        }
    }
}

impl Region {
    /// The start at these shares of its sides.
    pub(super) fn at(&self, shares: impl Iterator<Item = f64>, others: &[f64]) -> Vec<f64> {
        let mut start = others.to_vec();
        for (side, share) in self.sides.iter().zip(shares) {
            if let Some(place) = start.get_mut(side.state) {
                *place = side.low + share * (side.high - side.low);
            }
        }
        start
    }

    /// Start number `k`: all fill the region evenly, and each depends on nothing but its number.
    #[must_use]
    pub fn start(&self, k: usize, others: &[f64]) -> Vec<f64> {
        self.at(Spread::new(self.sides.len()).point(k), others)
    }

    /// How large the states are in it, beside those of a start.
    pub(super) fn magnitude(&self, others: &[f64]) -> Vec<f64> {
        let mut size: Vec<f64> = others.iter().map(|y| y.abs()).collect();
        for side in &self.sides {
            if let Some(size) = size.get_mut(side.state) {
                *size = side.low.abs().max(side.high.abs());
            }
        }
        let largest = size.iter().fold(0.0_f64, |most, size| most.max(*size));
        let other = if largest > 0.0 { largest } else { 1.0 };
        let known = |size: f64| if size > 1e-3 * other { size } else { other };
        size.into_iter().map(known).collect()
    }
}
