//! The zero problem of an orbit with a multiplier on the unit circle.

use nalgebra::DVector;

use super::condition::Condition;
use super::plane::Plane;
use crate::continuation::{Linearisation, ZeroProblem};
use crate::field::Work;
use crate::flow::{Flow, FlowError, Place, Steered, Want};
use crate::shooting::{OrbitProblem, Shot};

type Mode<F, const N: usize> = <<F as crate::flow::Family<N>>::Flow as Flow<N>>::Mode;

/// Step of the differences that give the slopes of the condition, relative to the scales: Φ itself is
/// exact for the steps of the integrator, but not smooth below its tolerance.
const DIFFERENCE: f64 = 2e-6;

/// Unknowns are those of the orbit and p; q is the design variable. The last equation is the condition.
#[derive(Debug, Clone)]
pub struct CriticalProblem<F: Steered<N>, const N: usize> {
    /// The flows.
    pub plane: Plane<F>,
    orbit: OrbitProblem<F, N>,
    condition: Condition,
    /// Usual magnitudes of p and q.
    scales: [f64; 2],
    work: Work,
}

/// One evaluation: the motion once around, and the condition.
#[derive(Debug, Clone)]
pub struct CriticalShot<const N: usize, Mode> {
    /// The motion.
    pub shot: Shot<N, Mode>,
    /// The condition.
    pub test: f64,
}

impl<F: Steered<N>, const N: usize> CriticalProblem<F, N> {
    /// The problem near an orbit that nearly meets the condition.
    pub fn new(
        plane: Plane<F>,
        orbit: OrbitProblem<F, N>,
        condition: Condition,
        scales: [f64; 2],
    ) -> Self {
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

    fn align_with(&mut self, shot: &Shot<N, Mode<F, N>>) {
        let (phi, _) = shot.monodromy();
        self.condition
            .align(&phi, &shot.velocity.f, &self.orbit.magnitude);
    }

    /// The condition at unknowns, without the derivatives of the orbit's equations.
    fn test(&mut self, z: &DVector<f64>, q: f64, mode: Mode<F, N>) -> Result<f64, FlowError> {
        let flow = self.plane.at(z[N + 1], q)?;
        let place = Place {
            state: std::array::from_fn(|j| z[j]),
            mode,
        };
        let want = Want {
            derivatives: true,
            ..Want::default()
        };
        let passage = flow.advance(&place, z[N], want)?;
        self.work += passage.work;
        let velocity = flow.velocity(&place)?.f;
        let identity = std::array::from_fn(|i| std::array::from_fn(|j| f64::from(i == j)));
        let phi = passage.derivatives.map_or(identity, |d| d.state);
        Ok(self.condition.value(&phi, &velocity, &self.orbit.magnitude))
    }

    /// ∂g/∂z and ∂g/∂q, by central differences.
    fn slopes(
        &mut self,
        z: &DVector<f64>,
        q: f64,
        mode: Mode<F, N>,
    ) -> Result<(DVector<f64>, f64), FlowError> {
        let scale = self.scale();
        let mut gradient = DVector::zeros(z.len());
        for i in 0..z.len() {
            let step = DIFFERENCE * scale[i];
            let (mut low, mut high) = (z.clone(), z.clone());
            low[i] -= step;
            high[i] += step;
            let rise = self.test(&high, q, mode)? - self.test(&low, q, mode)?;
            gradient[i] = rise / (high[i] - low[i]);
        }
        let step = DIFFERENCE * self.scales[1];
        let (low, high) = (q - step, q + step);
        let rise = self.test(z, high, mode)? - self.test(z, low, mode)?;
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

impl<F: Steered<N>, const N: usize> ZeroProblem for CriticalProblem<F, N> {
    type Error = FlowError;
    type Extra = CriticalShot<N, Mode<F, N>>;

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
        let mode = shot.start.mode;
        let (phi, _) = shot.monodromy();
        let test = self
            .condition
            .value(&phi, &shot.velocity.f, &self.orbit.magnitude);
        let (gradient, design) = self.slopes(z, q, mode)?;
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
        lasting.rows_mut(0, N).fill(0.0);
        lasting
    }
}
