//! Neutral directions: orbits beside an orbit that are orbits too, and the condition that singles one out.
//!
//! Where a combination of the states never changes, or no rate depends on where the states are along a shift, Φ − I is
//! singular at every orbit: h_z v = 0 and u h_z = 0 with v no fold's direction, since h_r lacks u, too. With a condition
//! c·x = b on the start, u c is added to h_z and u (c·x − b) to h: then h_z is regular, and as u h vanishes of itself,
//! both h = 0 and c·x = b hold where the sum does.

use nalgebra::{DMatrix, DVector};

/// A condition c·x = b on the start of an orbit in a neutral direction.
#[derive(Debug, Clone, PartialEq)]
pub struct Pin {
    /// c, its largest entry being 1 or −1, its first positive.
    pub combination: Vec<f64>,
    /// b.
    pub value: f64,
    /// Whether c·x never changes along the orbit; otherwise the orbit may be shifted along c.
    pub conserved: bool,
    /// u, over the equations.
    pub(super) left: DVector<f64>,
}

/// The same conditions, fulfilled by this state.
pub(super) fn through(pins: &[Pin], state: &[f64]) -> Vec<Pin> {
    pins.iter().map(|pin| pin.clone().through(state)).collect()
}

impl Pin {
    /// The same condition, fulfilled by this state.
    #[must_use]
    pub(super) fn through(mut self, state: &[f64]) -> Self {
        self.value = self.of(state);
        self
    }

    fn of(&self, state: &[f64]) -> f64 {
        let terms = self.combination.iter().zip(state);
        terms.map(|(c, x)| c * x).sum()
    }

    /// The usual magnitude of c·x.
    pub(super) fn unit(&self, magnitude: &[f64]) -> f64 {
        let terms = self.combination.iter().zip(magnitude);
        terms.map(|(c, size)| (c * size).abs()).sum()
    }

    /// Adds the condition to the equations of an orbit that starts at `state`.
    pub(super) fn enter(
        &self,
        state: &[f64],
        magnitude: &[f64],
        residual: &mut DVector<f64>,
        jacobian: &mut DMatrix<f64>,
    ) {
        let unit = self.unit(magnitude);
        residual.axpy((self.of(state) - self.value) / unit, &self.left, 1.0);
        for (j, c) in self.combination.iter().enumerate() {
            jacobian.column_mut(j).axpy(c / unit, &self.left, 1.0);
        }
    }
}
