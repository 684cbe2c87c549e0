//! Equations of what contacts hold: rates that a force keeps at zero say nothing where it sticks or rests on a wall that does
//! not give way; its speed does, and the gap.

use nalgebra::{DMatrix, DVector};

use crate::field::exact::Mode;
use crate::flow::FlowError;
use crate::linear::svd;
use crate::motion::{Flow, Modes, Place, Row};

/// Whether a contact sticks, or something rests on a press.
pub(super) fn binds(modes: &Modes) -> bool {
    modes.iter().any(|mode| mode.binds())
}

/// What is zero because contacts hold it: the speeds of those that stick, and the gaps of the presses at rest.
pub(super) fn held(flow: &dyn Flow, at: &Place) -> Result<Vec<Row>, FlowError> {
    let speeds = |place: &Place, of: Mode| -> Result<Vec<Row>, FlowError> {
        if !at.modes.contains(&of) {
            return Ok(Vec::new());
        }
        let all = at.modes.iter().zip(flow.contacts(place)?.all);
        let held = all.filter(|(mode, _)| **mode == of);
        Ok(held.map(|(_, contact)| contact.speed).collect())
    };
    // The gap of a press at rest is that which it has while it is open.
    let mut open = at.clone();
    for mode in open.modes.iter_mut().filter(|mode| **mode == Mode::Rest) {
        *mode = Mode::Open;
    }
    let mut held = speeds(at, Mode::Stick)?;
    held.extend(speeds(&open, Mode::Rest)?);
    Ok(held)
}

/// Rates, speeds and gaps with their derivatives, each row in its own measure.
#[derive(Debug, Clone)]
pub(super) struct Rows {
    pub(super) residual: DVector<f64>,
    pub(super) jacobian: DMatrix<f64>,
    pub(super) design: DVector<f64>,
}

impl Rows {
    /// The same with one row more for each of these, divided by how much the usual states change it.
    pub(super) fn with(self, held: &[Row], magnitude: &[f64]) -> Self {
        let order = self.residual.len();
        let sizes: Vec<f64> = held.iter().map(|row| measure(row, magnitude)).collect();
        let more = |i: usize| i.checked_sub(order).map(|i| (&held[i], sizes[i]));
        let count = order + held.len();
        Self {
            residual: DVector::from_fn(count, |i, _| {
                more(i).map_or_else(|| self.residual[i], |(row, size)| row.value / size)
            }),
            jacobian: DMatrix::from_fn(count, order, |i, j| {
                more(i).map_or_else(|| self.jacobian[(i, j)], |(row, size)| row.slopes[j] / size)
            }),
            design: DVector::from_fn(count, |i, _| {
                more(i).map_or_else(|| self.design[i], |(row, size)| row.design / size)
            }),
        }
    }

    /// As many combinations as there are states, in which these rows differ most; `None` if they cannot be told apart.
    ///
    /// A reaction holds the second derivative of its gap at zero everywhere, friction at rest the rate of its speed, so that
    /// where all combinations vanish, all rows do.
    pub(super) fn combinations(&self) -> Option<DMatrix<f64>> {
        Some(svd(self.jacobian.clone())?.u?.transpose())
    }

    /// These combinations of the rows.
    pub(super) fn combined(&self, by: &DMatrix<f64>) -> Self {
        Self {
            residual: by * &self.residual,
            jacobian: by * &self.jacobian,
            design: by * &self.design,
        }
    }
}

fn measure(row: &Row, magnitude: &[f64]) -> f64 {
    let terms = row.slopes.iter().zip(magnitude);
    let size: f64 = terms.map(|(slope, y)| (slope * y).abs()).sum();
    if size > 0.0 && size.is_finite() {
        size
    } else {
        1.0
    }
}
