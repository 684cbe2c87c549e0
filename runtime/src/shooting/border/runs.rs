//! Where a motion runs on: what it gains once around is free, and it is held along that where it meets its border.

use crate::continuation::Linearisation;
use crate::shooting::orbit::Orbit;
use crate::shooting::pin::{Pin, through};
use crate::shooting::running::{row, run};

/// What is neutral about a motion that runs on; nothing of another.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Runs {
    /// Held along each direction of any shift.
    pub(super) pins: Vec<Pin>,
    /// What the states gain once around.
    pub(super) shift: Option<Vec<f64>>,
}

impl Runs {
    /// Of an orbit; `None` where something else is neutral about it.
    pub(super) fn of(orbit: &Orbit) -> Option<Self> {
        let runs = |pin: &Pin| !pin.conserved() && orbit.shift.is_some();
        orbit.pins.iter().all(runs).then(|| Self {
            pins: orbit.pins.clone(),
            shift: orbit.shift.clone(),
        })
    }

    /// The same, held where it passes a state.
    pub(super) fn through(&self, state: &[f64]) -> Self {
        Self {
            pins: through(&self.pins, state),
            ..self.clone()
        }
    }

    /// How much a state gains once around.
    pub(super) fn gain(&self, state: usize) -> f64 {
        self.shift.as_ref().map_or(0.0, |shift| shift[state])
    }

    /// The state once around.
    pub(super) fn later(&self, state: &[f64]) -> Vec<f64> {
        let gained = |(j, y): (usize, &f64)| y + self.gain(j);
        state.iter().enumerate().map(gained).collect()
    }

    /// Takes out of the first equations, those of closing, what the motion gains besides, and holds its start there instead;
    /// the same with all that it gains.
    pub(super) fn hold<Extra>(
        &self,
        at: &mut Linearisation<Extra>,
        start: &[f64],
        magnitude: &[f64],
    ) -> Self {
        let mut all = self.clone();
        let Some(shift) = &mut all.shift else {
            return all;
        };
        run(&self.pins, (0, magnitude), at, shift);
        let (equations, unknowns) = at.jacobian.shape();
        for pin in &self.pins {
            if let Some((pivot, _)) = &pin.direction {
                let condition = pin.condition(start, magnitude, unknowns);
                condition.enter(&row(*pivot, equations), at);
            }
        }
        all
    }
}
