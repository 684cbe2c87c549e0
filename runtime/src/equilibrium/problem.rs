//! The zero problem of an equilibrium: f(y, r) = 0 in one mode.

use nalgebra::{DMatrix, DVector};

use super::corner::sides;
use super::resting::{Rows, binds, held};
use super::sizes::sizes_at;
use super::unread::unread;
use super::{EquilibriumPoint, Spectrum};
use crate::continuation::{Linearisation, ZeroProblem};
use crate::field::Work;
use crate::flow::FlowError;
use crate::integrate::IntegrationError;
use crate::motion::{Family, Flow, Modes, Place, Row, Velocity, sticking};

/// Unknowns are the states; the equations are their rates, and where contacts stick or rest on a press combinations of them
/// and of what is held.
#[derive(Debug, Clone)]
pub struct EquilibriumProblem {
    /// The flows.
    pub family: Family,
    /// The modes of the contacts.
    pub modes: Modes,
    /// Evaluations so far.
    pub work: Work,
    /// States on which no rate depends, and where they are kept.
    pub(super) kept: Vec<(usize, f64)>,
    magnitude: Vec<f64>,
    rates: Vec<f64>,
    /// Of rates and of what is held, where something is: from the first evaluation.
    combinations: Option<DMatrix<f64>>,
}

impl EquilibriumProblem {
    /// The problem of an equilibrium near this place, where the design variable is r.
    #[must_use]
    pub fn new(family: Family, r: f64, near: &Place) -> Self {
        let magnitude = sizes_at(&family, r, near);
        let unread = unread(&family, r, near, &magnitude).into_iter();
        Self {
            kept: unread.map(|j| (j, near.state[j])).collect(),
            magnitude,
            family,
            modes: near.modes.clone(),
            work: Work::default(),
            rates: vec![0.0; near.state.len()],
            combinations: None,
        }
    }

    /// Usual magnitudes of the states.
    #[must_use]
    pub fn magnitude(&self) -> &[f64] {
        &self.magnitude
    }

    /// The eigenvalues at a place, where its velocity is this: without those that are zero because contacts stick. The flow,
    /// where there is one, tells the slopes on both sides of a corner.
    #[must_use]
    pub fn spectrum(
        &self,
        flow: Option<&dyn Flow>,
        place: &Place,
        velocity: &Velocity,
    ) -> Spectrum {
        match sticking(&self.modes) + self.kept.len() {
            0 => {
                let sides = flow.map(|flow| sides(flow, place, &self.magnitude));
                let sides = sides.unwrap_or_default();
                Spectrum::between(&velocity.jacobian, &sides)
            }
            lost => Spectrum::across(&velocity.jacobian, lost),
        }
    }

    /// The place of these unknowns.
    #[must_use]
    pub fn place(&self, z: &DVector<f64>) -> Place {
        Place {
            state: z.as_slice().to_vec(),
            modes: self.modes.clone(),
        }
    }

    /// Whether every rate vanishes at a place, where some follow from others: to this share of what usual states make of it.
    pub(super) fn rests(&self, velocity: &Velocity, share: f64) -> bool {
        let mut rates = velocity.f.iter().enumerate();
        self.kept.is_empty() || rates.all(|(i, rate)| rate.abs() <= share * self.rate(i))
    }

    /// What errors of the equations weigh, from the first evaluation: how much the usual states change them.
    fn weigh(&mut self, jacobian: &DMatrix<f64>) {
        for (i, rate) in self.rates.iter_mut().enumerate() {
            if *rate == 0.0 {
                let terms = self.magnitude.iter().enumerate();
                *rate = terms.map(|(j, y)| (jacobian[(i, j)] * y).abs()).sum();
            }
        }
    }

    fn rows(&self, velocity: &Velocity) -> Rows {
        let order = velocity.f.len();
        Rows {
            residual: DVector::from_fn(order, |i, _| velocity.f[i] / self.rate(i)),
            jacobian: DMatrix::from_fn(order, order, |i, j| {
                velocity.jacobian[(i, j)] / self.rate(i)
            }),
            design: DVector::from_fn(order, |i, _| velocity.design[i] / self.rate(i)),
        }
    }

    fn with_held(&self, rows: Rows, z: &DVector<f64>, r: f64) -> Result<Rows, FlowError> {
        let flow = self.family.at(r)?;
        let mut held = held(&*flow, &self.place(z))?;
        held.extend(self.kept.iter().map(|(j, value)| Row {
            value: z[*j] - value,
            slopes: (0..z.len()).map(|i| f64::from(u8::from(i == *j))).collect(),
            design: 0.0,
        }));
        Ok(rows.with(&held, &self.magnitude))
    }

    /// A number with the sign of the product of all eigenvalues, or of its negative: of those that contact leaves, where
    /// something is held.
    pub(super) fn determinant(&self, z: &DVector<f64>, r: f64, velocity: &Velocity) -> f64 {
        let Some(combinations) = &self.combinations else {
            return EquilibriumPoint::determinant_of(&velocity.jacobian);
        };
        let rows = self.with_held(self.rows(velocity), z, r);
        rows.map_or(f64::NAN, |rows| {
            rows.combined(combinations).jacobian.determinant()
        })
    }

    fn rate(&self, i: usize) -> f64 {
        if self.rates[i] > 0.0 && self.rates[i].is_finite() {
            self.rates[i]
        } else {
            1.0
        }
    }
}

fn not_finite(z: &DVector<f64>) -> FlowError {
    let state = z.as_slice().to_vec().into();
    IntegrationError::NotFinite { time: 0.0, state }.into()
}

impl ZeroProblem for EquilibriumProblem {
    type Error = FlowError;
    type Extra = Velocity;

    fn evaluate(&mut self, z: &DVector<f64>, r: f64) -> Result<Linearisation<Velocity>, FlowError> {
        let velocity = self.family.at(r)?.velocity(&self.place(z))?;
        self.work.linearisations += 1;
        self.work.newton += 1;
        self.weigh(&velocity.jacobian);
        let mut rows = self.rows(&velocity);
        if binds(&self.modes) || !self.kept.is_empty() {
            rows = self.with_held(rows, z, r)?;
            if self.combinations.is_none() {
                self.combinations = rows.combinations();
            }
            let combinations = self.combinations.as_ref().ok_or_else(|| not_finite(z))?;
            rows = rows.combined(combinations);
        }
        Ok(Linearisation {
            residual: rows.residual,
            jacobian: rows.jacobian,
            design: rows.design,
            extra: velocity,
        })
    }

    fn scale(&self) -> DVector<f64> {
        DVector::from_column_slice(&self.magnitude)
    }

    fn accept(
        &mut self,
        z: &DVector<f64>,
        r: f64,
        _velocity: &Velocity,
    ) -> Result<Option<DVector<f64>>, FlowError> {
        self.family.at(r)?.check(&self.place(z))?;
        for (magnitude, y) in self.magnitude.iter_mut().zip(z) {
            *magnitude = magnitude.max(y.abs());
        }
        Ok(None)
    }
}
