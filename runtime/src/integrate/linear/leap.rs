//! How the end of a motion depends on its beginning: of many steps on end found by doubling the map of one.

use super::series::add;
use crate::field::{LinearField, Point, Strip};
use crate::integrate::Propagator;
use crate::scalar::{dot, filled, mapped};

/// The map of a motion of one length: y₁ = y₀ + R y₀ + S w₀, with w₀ the wave of the drive where it begins.
///
/// R is exp(A h) − I: what moves little keeps its digits in it, however often it is doubled.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Leap<const N: usize> {
    pub(super) length: f64,
    pub(super) own: Map<N>,
    /// ∂R/∂r and ∂S/∂r, if there is a design variable.
    pub(super) along: Option<Map<N>>,
}

/// R and S, or their derivatives, row by row.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Map<const N: usize> {
    pub(super) states: [Strip<N>; N],
    pub(super) waves: [[f64; 3]; N],
}

impl<const N: usize> Leap<N> {
    /// Twice as long.
    pub(super) fn doubled(&self, field: &LinearField<N>) -> Self {
        let turned = |map: &Map<N>| map.turned(|wave| field.turned(wave, self.length).0);
        let own = self
            .own
            .times(&self.own)
            .plus(&self.own)
            .plus(&turned(&self.own));
        let along = self.along.as_ref().map(|along| {
            let turning = Map {
                states: [Strip::ZERO; N],
                waves: filled(|i| field.turned(&self.own.waves[i], self.length).1),
            };
            let (before, after) = (along.times(&self.own), self.own.times(along));
            let both = before.plus(&after).plus(along).plus(&turned(along));
            both.plus(&turning)
        });
        Self {
            length: 2.0 * self.length,
            own,
            along,
        }
    }

    /// The state at the end.
    pub(super) fn end(&self, start: &Point<N>) -> [f64; N] {
        let rise = self.own.of(start);
        filled(|i| start.0[i] + rise[i])
    }

    /// How the end depends on the beginning and on the design variable.
    pub(super) fn propagator(&self, field: &LinearField<N>, start: &Point<N>) -> Propagator<N> {
        let mut state = mapped(&self.own.states, |row| *row.entries());
        if let Some((phase, turn)) = field.turn(&start.1) {
            for (row, waves) in state.iter_mut().zip(&self.own.waves) {
                row[phase] += dot(waves, &turn);
            }
        }
        for (i, row) in state.iter_mut().enumerate() {
            row[i] += 1.0;
        }
        let along = self.along.as_ref();
        Propagator {
            state,
            design: along.map_or([0.0; N], |along| along.of(start)),
            time: [0.0; N],
            trace: field.trace() * self.length,
        }
    }
}

impl<const N: usize> Map<N> {
    pub(super) const NOTHING: Self = Self {
        states: [Strip::ZERO; N],
        waves: [[0.0; 3]; N],
    };

    /// What it adds to a point.
    fn of(&self, (state, wave): &Point<N>) -> [f64; N] {
        filled(|i| self.states[i].dot(state) + dot(&self.waves[i], wave))
    }

    /// This after another one.
    fn times(&self, other: &Self) -> Self {
        let mut product = Self::NOTHING;
        for (i, row) in self.states.iter().enumerate() {
            for (j, factor) in row.iter().filter(|(_, factor)| *factor != 0.0) {
                other.states[j].add_to_strip(&mut product.states[i], factor);
                add(&mut product.waves[i], factor, &other.waves[j]);
            }
        }
        product
    }

    fn plus(mut self, other: &Self) -> Self {
        self.add(1.0, other);
        self
    }

    /// Adds so many times another one.
    pub(super) fn add(&mut self, factor: f64, other: &Self) {
        for i in 0..N {
            other.states[i].add_to_strip(&mut self.states[i], factor);
            add(&mut self.waves[i], factor, &other.waves[i]);
        }
    }

    /// The same of a wave that has gone on.
    fn turned(&self, turned: impl Fn(&[f64; 3]) -> [f64; 3]) -> Self {
        Self {
            states: self.states,
            waves: filled(|i| turned(&self.waves[i])),
        }
    }
}
