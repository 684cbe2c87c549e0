//! The zero problem of an orbit with a multiplier on the unit circle.

use nalgebra::{DMatrix, DVector};

use super::condition::Condition;
use super::plane::Plane;
use crate::continuation::{Linearisation, ZeroProblem};
use crate::field::Work;
use crate::field::exact::Mode;
use crate::flow::{FlowError, Want};
use crate::motion::Place;
use crate::shooting::{OrbitProblem, Shot};

/// Step of the differences that give the slopes of the condition, relative to the scales: Φ itself is
/// exact for the steps of the integrator, but not smooth below its tolerance.
const DIFFERENCE: f64 = 2e-6;

/// Unknowns are those of the orbit and p; q is the design variable. The last equation is the condition.
#[derive(Debug, Clone)]
pub struct CriticalProblem {
    /// The flows.
    pub plane: Plane,
    orbit: OrbitProblem,
    condition: Condition,
    /// Usual magnitudes of p and q.
    scales: [f64; 2],
    work: Work,
}

/// One evaluation: the motion once around, and the condition.
#[derive(Debug, Clone)]
pub struct CriticalShot {
    /// The motion.
    pub shot: Shot,
    /// The condition.
    pub test: f64,
}

impl CriticalProblem {
    /// The problem near an orbit that nearly meets the condition.
    pub fn new(plane: Plane, orbit: OrbitProblem, condition: Condition, scales: [f64; 2]) -> Self {
        Self {
            plane,
            orbit,
            condition,
            scales,
            work: Work::default(),
        }
    }

    /// Aligns the condition with the orbit of these unknowns.
    ///
    /// # Errors
    /// The motion cannot be followed.
    pub fn align(&mut self, z: &DVector<f64>, q: f64) -> Result<(), FlowError> {
        let (orbit, p) = split(z);
        self.orbit.family = self.plane.along_p(q);
        let shot = self.orbit.evaluate(&orbit, p)?.extra;
        self.align_with(&shot);
        Ok(())
    }

    /// The condition.
    #[must_use]
    pub fn condition(&self) -> &Condition {
        &self.condition
    }

    /// Work of all evaluations.
    #[must_use]
    pub fn work(&self) -> Work {
        let mut work = self.orbit.work;
        work += self.work;
        work
    }

    fn align_with(&mut self, shot: &Shot) {
        let (phi, _) = shot.monodromy();
        self.condition
            .align(&phi, &shot.velocity.f, &self.orbit.magnitude);
    }

    /// The condition at unknowns, without the derivatives of the orbit's equations.
    fn test(&mut self, z: &DVector<f64>, q: f64, modes: &[Mode]) -> Result<f64, FlowError> {
        let n = z.len() - 2;
        let flow = self.plane.at(z[n + 1], q)?;
        let place = Place {
            state: z.as_slice()[..n].to_vec(),
            modes: modes.to_vec(),
        };
        let passage = flow.advance(&place, z[n], Want::DERIVATIVES)?;
        self.work += passage.work;
        let velocity = flow.velocity(&place)?.f;
        let identity = || DMatrix::identity(n, n);
        let phi = passage.derivatives.map_or_else(identity, |d| d.state);
        Ok(self.condition.value(&phi, &velocity, &self.orbit.magnitude))
    }

    /// ∂g/∂z and ∂g/∂q, by central differences.
    fn slopes(
        &mut self,
        z: &DVector<f64>,
        q: f64,
        modes: &[Mode],
    ) -> Result<(DVector<f64>, f64), FlowError> {
        let scale = self.scale();
        let mut gradient = DVector::zeros(z.len());
        for i in 0..z.len() {
            let step = DIFFERENCE * scale[i];
            let (mut low, mut high) = (z.clone(), z.clone());
            low[i] -= step;
            high[i] += step;
            let rise = self.test(&high, q, modes)? - self.test(&low, q, modes)?;
            gradient[i] = rise / (high[i] - low[i]);
        }
        let step = DIFFERENCE * self.scales[1];
        let (low, high) = (q - step, q + step);
        let rise = self.test(z, high, modes)? - self.test(z, low, modes)?;
        Ok((gradient, rise / (high - low)))
    }
}

/// The unknowns of the orbit, and p.
pub(super) fn split(z: &DVector<f64>) -> (DVector<f64>, f64) {
    let last = z.len() - 1;
    (z.rows(0, last).into_owned(), z[last])
}

/// The unknowns of the orbit with p behind them.
pub(super) fn joined(orbit: &DVector<f64>, p: f64) -> DVector<f64> {
    orbit.push(p)
}

impl ZeroProblem for CriticalProblem {
    type Error = FlowError;
    type Extra = CriticalShot;

    fn evaluate(
        &mut self,
        z: &DVector<f64>,
        q: f64,
    ) -> Result<Linearisation<Self::Extra>, FlowError> {
        let (orbit, p) = split(z);
        self.orbit.family = self.plane.along_q(p);
        let across = self.orbit.evaluate(&orbit, q)?;
        self.orbit.family = self.plane.along_p(q);
        let closing = self.orbit.evaluate(&orbit, p)?;
        let shot = closing.extra;
        let (phi, _) = shot.monodromy();
        let test = self
            .condition
            .value(&phi, &shot.velocity.f, &self.orbit.magnitude);
        let (gradient, design) = self.slopes(z, q, &shot.start.modes)?;
        let n = z.len();
        let mut jacobian = closing.jacobian.resize(n, n, 0.0);
        jacobian
            .view_mut((0, n - 1), (n - 1, 1))
            .copy_from(&closing.design);
        jacobian.set_row(n - 1, &gradient.transpose());
        let design = across.design.push(design);
        Ok(Linearisation {
            residual: closing.residual.push(test),
            jacobian,
            design,
            extra: CriticalShot { shot, test },
        })
    }

    fn scale(&self) -> DVector<f64> {
        joined(&self.orbit.scale(), self.scales[0])
    }

    fn accept(
        &mut self,
        z: &DVector<f64>,
        q: f64,
        extra: &Self::Extra,
    ) -> Result<Option<DVector<f64>>, FlowError> {
        let (orbit, p) = split(z);
        self.orbit.family = self.plane.along_p(q);
        let moved = self.orbit.accept(&orbit, p, &extra.shot)?;
        let Some(moved) = moved else {
            self.align_with(&extra.shot);
            return Ok(None);
        };
        let z = joined(&moved, p);
        self.align(&z, q)?;
        Ok(Some(z))
    }

    /// Where along the orbit it starts means nothing; the period, p and q do.
    fn lasting(&self, tangent: &DVector<f64>) -> DVector<f64> {
        let mut lasting = tangent.clone();
        lasting.rows_mut(0, tangent.len() - 3).fill(0.0);
        lasting
    }
}
