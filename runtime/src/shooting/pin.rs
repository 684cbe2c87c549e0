//! Neutral directions: orbits beside an orbit that are orbits too, and the condition that singles one out.
//!
//! Where a combination of the states never changes, or no rate depends on where the states are along a shift, Φ − I is
//! singular at every orbit: h_z v = 0 and u h_z = 0 with v no fold's direction, since h_r lacks u, too. With a condition
//! c·x = b on the start, u c is added to h_z and u (c·x − b) to h: then h_z is regular, and as u h vanishes of itself,
//! both h = 0 and c·x = b hold where the sum does.

use nalgebra::{DVector, RowDVector};

use super::echelon::Free;
use crate::continuation::Linearisation;

/// A condition c·x = b on the start of an orbit in a neutral direction.
#[derive(Debug, Clone, PartialEq)]
pub struct Pin {
    /// c, its largest entry being 1 or −1, its first positive.
    pub combination: Vec<f64>,
    /// b.
    pub value: f64,
    /// What c·x is where the orbit is told to begin, wherever shooting begins.
    pub(super) told: f64,
    /// Where c·x changes along the orbit, the direction in which that may be shifted.
    pub(super) direction: Option<Free>,
    /// Whether c·x moves with a drive, and gains the same in a period wherever it begins.
    pub(super) driven: bool,
    /// What swings about the middle of its bounds instead. It meets both at once where it begins to meet any, so that the
    /// orbits go on as those that do.
    pub(super) centred: Option<Swing>,
    /// u, over the equations.
    pub(super) left: DVector<f64>,
}

/// What swings between two bounds.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Swing {
    /// The internal state of a law, of this index, between its stops.
    State(usize),
    /// The force of the contact of this index, which sticks all along, over the most that it can bear.
    Force(usize),
}

/// The same conditions, fulfilled by this state, where orbits are told to begin.
pub(super) fn told(pins: &[Pin], state: &[f64]) -> Vec<Pin> {
    pins.iter().map(|pin| pin.clone().told(state)).collect()
}

/// The same conditions, fulfilled by this state.
pub(crate) fn through(pins: &[Pin], state: &[f64]) -> Vec<Pin> {
    pins.iter().map(|pin| pin.clone().through(state)).collect()
}

impl Pin {
    /// Whether c·x never changes along the orbit but with a drive; otherwise that may be shifted.
    #[must_use]
    pub fn conserved(&self) -> bool {
        self.direction.is_none()
    }

    /// Whether c·x never changes along the orbit at all.
    pub(crate) fn never_changes(&self) -> bool {
        self.conserved() && !self.driven
    }

    /// The direction in which the orbit may be shifted at will, if c·x changes along it.
    pub(crate) fn along(&self) -> Option<&[f64]> {
        let (_, direction) = self.direction.as_ref()?;
        Some(direction)
    }

    /// Whether an internal state of a law is what is held.
    pub(super) fn holds_state(&self) -> bool {
        matches!(self.centred, Some(Swing::State(_)))
    }

    /// The same condition, fulfilled by this state, where orbits are told to begin.
    #[must_use]
    pub(super) fn told(self, state: &[f64]) -> Self {
        Self {
            told: self.of(state),
            ..self.through(state)
        }
    }

    /// The same condition, fulfilled by this state.
    #[must_use]
    pub(super) fn through(mut self, state: &[f64]) -> Self {
        self.value = self.of(state);
        self
    }

    /// c·x.
    pub(crate) fn of(&self, state: &[f64]) -> f64 {
        let terms = self.combination.iter().zip(state);
        terms.map(|(c, x)| c * x).sum()
    }

    /// Shifts a state to where c·x is this, if that may be shifted.
    pub(super) fn slide(&self, state: &mut [f64], to: f64) {
        if let Some((_, direction)) = &self.direction {
            let along = (to - self.of(state)) / self.of(direction);
            state
                .iter_mut()
                .zip(direction)
                .for_each(|(y, d)| *y += along * d);
        }
    }

    /// The usual magnitude of c·x.
    pub(super) fn unit(&self, magnitude: &[f64]) -> f64 {
        let terms = self.combination.iter().zip(magnitude);
        terms.map(|(c, size)| (c * size).abs()).sum()
    }

    /// c·x − b over its usual magnitude, for a motion of this many unknowns that begins here.
    pub(super) fn condition(&self, state: &[f64], magnitude: &[f64], unknowns: usize) -> Condition {
        let mut gradient = RowDVector::zeros(unknowns);
        for (slope, c) in gradient.iter_mut().zip(&self.combination) {
            *slope = *c;
        }
        let condition = Condition {
            value: self.of(state) - self.value,
            gradient,
            design: 0.0,
        };
        condition.over(self.unit(magnitude))
    }
}

/// What has to vanish besides the equations of an orbit, with its derivatives by the unknowns and by r.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Condition {
    pub(super) value: f64,
    pub(super) gradient: RowDVector<f64>,
    pub(super) design: f64,
}

impl Condition {
    pub(super) fn over(self, unit: f64) -> Self {
        Self {
            value: self.value / unit,
            gradient: self.gradient / unit,
            design: self.design / unit,
        }
    }

    /// Adds it to the equations of an orbit as far as u says.
    pub(super) fn enter<Extra>(&self, left: &DVector<f64>, at: &mut Linearisation<Extra>) {
        at.residual.axpy(self.value, left, 1.0);
        at.design.axpy(self.design, left, 1.0);
        at.jacobian += left * &self.gradient;
    }
}
