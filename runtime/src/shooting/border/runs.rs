//! What is neutral about an orbit on its border: what a motion gains that runs on is free, and it is held along that where it
//! meets the border; what never changes, as where a contact sticks all along, is held in the equations that it leaves open.

use nalgebra::DVector;

use crate::continuation::Linearisation;
use crate::shooting::orbit::Orbit;
use crate::shooting::pin::{Pin, through};
use crate::shooting::running::{row, run};

/// What is held closes of itself up to this share of the equations.
const OF_ITSELF: f64 = 1e-6;

/// What is neutral about an orbit.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Runs {
    /// Held along each direction of any shift, or what never changes.
    pub(super) pins: Vec<Pin>,
    /// What the states gain once around.
    pub(super) shift: Option<Vec<f64>>,
}

impl Runs {
    /// Of an orbit; `None` where it may be shifted, and closes all the same.
    pub(super) fn of(orbit: &Orbit) -> Option<Self> {
        let told = |pin: &Pin| pin.conserved() || orbit.shift.is_some();
        orbit.pins.iter().all(told).then(|| Self {
            pins: orbit.pins.clone(),
            shift: orbit.shift.clone(),
        })
    }

    /// Whether something of it never changes.
    pub(super) fn conserves(&self) -> bool {
        self.pins.iter().any(Pin::conserved)
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

    /// Takes out of the first equations, those of closing, what the motion gains besides, and holds its start there instead, and
    /// in those that never change; the same with all that it gains.
    pub(super) fn hold<Extra>(
        &self,
        at: &mut Linearisation<Extra>,
        start: &[f64],
        magnitude: &[f64],
    ) -> Self {
        let mut all = self.clone();
        if let Some(shift) = &mut all.shift {
            run(&self.pins, (0, magnitude), at, shift);
        }
        let (equations, unknowns) = at.jacobian.shape();
        for pin in &self.pins {
            let left = match &pin.direction {
                Some((pivot, _)) => Some(row(*pivot, equations)),
                None => left_open(pin, at, magnitude),
            };
            if let Some(left) = left {
                let condition = pin.condition(start, magnitude, unknowns);
                condition.enter(&left, at);
            }
        }
        all
    }
}

/// Over the equations, what they leave open as c·x never changes; `None` where they do not, as those of half an orbit to its
/// mirror image.
fn left_open<Extra>(
    pin: &Pin,
    at: &Linearisation<Extra>,
    magnitude: &[f64],
) -> Option<DVector<f64>> {
    let (equations, order) = (at.jacobian.nrows(), magnitude.len());
    let entry = |i: usize| match i < order {
        true => pin.combination[i] * magnitude[i],
        false => 0.0,
    };
    let left = DVector::from_fn(equations, |i, _| entry(i)).try_normalize(0.0)?;
    let mut slopes = at.jacobian.columns(0, order).into_owned();
    for (mut slope, unit) in slopes.column_iter_mut().zip(magnitude) {
        slope *= *unit;
    }
    (left.tr_mul(&slopes).norm() <= OF_ITSELF * slopes.norm()).then_some(left)
}
