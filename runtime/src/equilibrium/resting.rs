//! Equations of what rests on a wall that does not give way: rates that its reaction keeps at zero say nothing, the gap does.

use nalgebra::{DMatrix, DVector};

use crate::field::exact::Mode;
use crate::flow::FlowError;
use crate::linear::svd;
use crate::motion::{Flow, Modes, Place, Row};

/// Whether something rests on a press.
pub(super) fn rests(modes: &Modes) -> bool {
    modes.contains(&Mode::Rest)
}

/// The gaps of the presses at rest, which are closed.
pub(super) fn closed_gaps(flow: &dyn Flow, at: &Place) -> Result<Vec<Row>, FlowError> {
    let rests = |(i, mode): (usize, &Mode)| (*mode == Mode::Rest).then_some(i);
    let resting: Vec<usize> = at.modes.iter().enumerate().filter_map(rests).collect();
    if resting.is_empty() {
        return Ok(Vec::new());
    }
    let mut open = at.clone();
    for press in &resting {
        open.modes[*press] = Mode::Open;
    }
    let all = flow.contacts(&open)?.all;
    Ok(resting
        .iter()
        .map(|press| all[*press].speed.clone())
        .collect())
}

/// Rates and gaps with their derivatives, each row in its own measure.
#[derive(Debug, Clone)]
pub(super) struct Rows {
    pub(super) residual: DVector<f64>,
    pub(super) jacobian: DMatrix<f64>,
    pub(super) design: DVector<f64>,
}

impl Rows {
    /// The same with one row more for each gap, divided by how much the usual states change it.
    pub(super) fn with(self, gaps: &[Row], magnitude: &[f64]) -> Self {
        let order = self.residual.len();
        let sizes: Vec<f64> = gaps.iter().map(|gap| measure(gap, magnitude)).collect();
        let gap = |i: usize| i.checked_sub(order).map(|i| (&gaps[i], sizes[i]));
        let count = order + gaps.len();
        Self {
            residual: DVector::from_fn(count, |i, _| {
                gap(i).map_or_else(|| self.residual[i], |(gap, size)| gap.value / size)
            }),
            jacobian: DMatrix::from_fn(count, order, |i, j| {
                gap(i).map_or_else(|| self.jacobian[(i, j)], |(gap, size)| gap.slopes[j] / size)
            }),
            design: DVector::from_fn(count, |i, _| {
                gap(i).map_or_else(|| self.design[i], |(gap, size)| gap.design / size)
            }),
        }
    }

    /// As many combinations as there are states, in which these rows differ most; `None` if they cannot be told apart.
    ///
    /// A reaction holds the second derivative of its gap at zero everywhere, so that where all combinations vanish, all rows
    /// do.
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

fn measure(gap: &Row, magnitude: &[f64]) -> f64 {
    let terms = gap.slopes.iter().zip(magnitude);
    let size: f64 = terms.map(|(slope, y)| (slope * y).abs()).sum();
    if size > 0.0 && size.is_finite() {
        size
    } else {
        1.0
    }
}
