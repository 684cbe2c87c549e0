//! The equations of a periodic orbit, (2.3), and their derivatives.

use std::f64::consts::TAU;

use nalgebra::{DMatrix, DVector};

use super::lows::section;
use super::problem::OrbitProblem;
use super::shot::Shot;
use crate::continuation::Linearisation;
use crate::flow::{FlowError, Peaks, Want};
use crate::motion::{Flow, spelt};

impl OrbitProblem {
    /// The equations and their derivatives, without what is held in neutral directions.
    ///
    /// # Errors
    /// The motion cannot be followed.
    pub(super) fn once_around(
        &mut self,
        flow: &dyn Flow,
        z: &DVector<f64>,
    ) -> Result<Linearisation<Shot>, FlowError> {
        let (m, n, order) = (self.modes.len(), z.len(), self.order());
        let period = z[n - 1];
        if !(period > 0.0 && period.is_finite()) {
            return Err(FlowError::BadTime { time: period });
        }
        self.keeps_shift(flow)?;
        let mut h = DVector::zeros(n);
        let mut h_z = DMatrix::zeros(n, n);
        let mut h_r = DVector::zeros(n);
        let mut passages = Vec::with_capacity(m);
        let want = self.wanted();
        for i in 0..m {
            let passage = flow.advance(&self.start(z, i), period * self.shares[i], want)?;
            self.work += passage.work;
            // A start that is held on a surface hides a motion that does not come back to it.
            if passage.end.modes != self.modes[(i + 1) % m] {
                return Err(FlowError::OtherMode {
                    found: spelt(&passage.end.modes),
                    wanted: spelt(&self.modes[(i + 1) % m]),
                });
            }
            let next = (i + 1) % m * order;
            if let Some(derivatives) = &passage.derivatives {
                for row in 0..order {
                    let (at, unit) = (i * order + row, self.magnitude[row]);
                    let mut gap = passage.end.state[row] - z[next + row];
                    if i + 1 == m {
                        if flow.phase() == Some(row) {
                            // Once around, the phase has turned a whole number of times, and at least once.
                            gap -= TAU * (gap / TAU).round().max(1.0);
                        }
                        gap -= self.shift.as_ref().map_or(0.0, |shift| shift[row]);
                    }
                    h[at] = gap / unit;
                    h_r[at] = derivatives.design[row] / unit;
                    h_z[(at, n - 1)] = derivatives.time[row] * self.shares[i] / unit;
                    for column in 0..order {
                        h_z[(at, i * order + column)] += derivatives.state[(row, column)] / unit;
                    }
                    h_z[(at, next + row)] -= 1.0 / unit;
                }
            }
            passages.push(passage);
        }
        let start = self.start(z, 0);
        let velocity = flow.velocity(&start)?;
        let (value, gradient, design) = self.phase.equation(&start.state, &velocity);
        let unit: f64 = (0..order)
            .map(|j| (gradient[j] * self.magnitude[j]).abs())
            .sum();
        let unit = if unit > 0.0 { unit } else { 1.0 };
        h[n - 1] = value / unit;
        h_r[n - 1] = design / unit;
        for (column, slope) in gradient.iter().enumerate() {
            h_z[(n - 1, column)] = slope / unit;
        }
        let closure = h.rows(0, n - 1).norm();
        self.work.newton += 1;
        Ok(Linearisation {
            residual: h,
            jacobian: h_z,
            design: h_r,
            extra: Shot {
                passages,
                start,
                velocity,
                period,
                begins: self.begins(period),
                drive: flow.phase(),
                closure,
                pins: Vec::new(),
                shift: self.shift.clone(),
            },
        })
    }

    /// What passages shall report: of states other than the section's, their extent alone.
    fn wanted(&self) -> Want {
        let section = section(self.family.phase(), self.shift.as_deref());
        Want {
            extrema: match self.want.extrema {
                Peaks::All => Peaks::Extent(section),
                other => other,
            },
            ..self.want
        }
    }

    /// When each segment begins.
    fn begins(&self, period: f64) -> Vec<f64> {
        let mut passed = 0.0;
        let begin = |share: &f64| {
            let begin = passed * period;
            passed += share;
            begin
        };
        self.shares.iter().map(begin).collect()
    }
}
