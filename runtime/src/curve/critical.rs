//! The zero problem of an orbit with a multiplier on the unit circle, or of an equilibrium with an eigenvalue on the
//! imaginary axis.

use nalgebra::DVector;

use super::condition::Condition;
use super::plane::Plane;
use super::subject::Subject;
use crate::continuation::{Linearisation, ZeroProblem};
use crate::flow::FlowError;
use crate::math::ends;

/// Step of the differences that give the slopes of the condition, relative to the scales: Φ itself is
/// exact for the steps of the integrator, but not smooth below its tolerance.
const DIFFERENCE: f64 = 2e-6;

/// Unknowns are those of the orbit or equilibrium and p; q is the design variable. The last equation is the condition.
#[derive(Debug, Clone)]
pub struct CriticalProblem<S> {
    /// The flows.
    pub plane: Plane,
    /// The other equations.
    pub subject: S,
    condition: Condition,
    /// Usual magnitudes of p and q.
    scales: [f64; 2],
}

/// One evaluation: that of the orbit or equilibrium, and the condition.
#[derive(Debug, Clone)]
pub struct Critical<E> {
    /// What was found of the orbit or equilibrium.
    pub of: E,
    /// The condition.
    pub test: f64,
}

impl<S: Subject> CriticalProblem<S> {
    /// The problem near an orbit or equilibrium that nearly meets the condition.
    pub fn new(plane: Plane, subject: S, condition: Condition, scales: [f64; 2]) -> Self {
        Self {
            plane,
            subject,
            condition,
            scales,
        }
    }

    /// Aligns the condition with the orbit or equilibrium of these unknowns.
    ///
    /// # Errors
    /// It cannot be evaluated.
    pub fn align(&mut self, z: &DVector<f64>, q: f64) -> Result<(), FlowError> {
        let (z, p) = split(z);
        self.subject.steer(self.plane.along_p(q));
        let found = self.subject.evaluate(&z, p)?.extra;
        self.align_with(&found);
        Ok(())
    }

    /// The condition.
    #[must_use]
    pub fn condition(&self) -> &Condition {
        &self.condition
    }

    fn align_with(&mut self, found: &S::Extra) {
        let beside = self.subject.beside(found);
        self.condition.align(&beside, self.subject.magnitude());
    }

    /// The condition at unknowns, without the derivatives of the other equations.
    fn test(&mut self, z: &DVector<f64>, q: f64, near: &S::Extra) -> Result<f64, FlowError> {
        let (z, p) = split(z);
        self.subject.steer(self.plane.along_p(q));
        let beside = self.subject.beside_at(&z, p, near)?;
        Ok(self.condition.value(&beside, self.subject.magnitude()))
    }

    /// ∂g/∂z and ∂g/∂q, by differences from both sides of where the condition has this value.
    fn slopes(
        &mut self,
        z: &DVector<f64>,
        q: f64,
        (near, test): (&S::Extra, f64),
    ) -> Result<(DVector<f64>, f64), FlowError> {
        let scale = self.scale();
        let mut gradient = DVector::zeros(z.len());
        for i in 0..z.len() {
            let step = DIFFERENCE * scale[i];
            let (mut low, mut high) = (z.clone(), z.clone());
            low[i] -= step;
            high[i] += step;
            let beside = [&low, &high].map(|z| (z[i], self.test(z, q, near)));
            gradient[i] = slope((z[i], test), beside)?;
        }
        let step = DIFFERENCE * self.scales[1];
        let beside = [q - step, q + step].map(|q| (q, self.test(z, q, near)));
        Ok((gradient, slope((q, test), beside)?))
    }
}

/// The slope of a function between two places beside one, or from there where one of them is none.
fn slope(here: (f64, f64), beside: [(f64, Result<f64, FlowError>); 2]) -> Result<f64, FlowError> {
    let [(a, low), (b, high)] = ends(here, beside)?;
    Ok((high - low) / (b - a))
}

/// The unknowns of the orbit or equilibrium, and p.
pub(super) fn split(z: &DVector<f64>) -> (DVector<f64>, f64) {
    let last = z.len() - 1;
    (z.rows(0, last).into_owned(), z[last])
}

/// The unknowns of the orbit or equilibrium with p behind them.
pub(super) fn joined(z: &DVector<f64>, p: f64) -> DVector<f64> {
    z.push(p)
}

impl<S: Subject> ZeroProblem for CriticalProblem<S> {
    type Error = FlowError;
    type Extra = Critical<S::Extra>;

    fn evaluate(
        &mut self,
        z: &DVector<f64>,
        q: f64,
    ) -> Result<Linearisation<Self::Extra>, FlowError> {
        let (own, p) = split(z);
        self.subject.steer(self.plane.along_q(p));
        let across = self.subject.evaluate(&own, q)?;
        self.subject.steer(self.plane.along_p(q));
        let found = self.subject.evaluate(&own, p)?;
        let beside = self.subject.beside(&found.extra);
        let test = self.condition.value(&beside, self.subject.magnitude());
        let (gradient, design) = self.slopes(z, q, (&found.extra, test))?;
        let n = z.len();
        let mut jacobian = found.jacobian.resize(n, n, 0.0);
        jacobian
            .view_mut((0, n - 1), (n - 1, 1))
            .copy_from(&found.design);
        jacobian.set_row(n - 1, &gradient.transpose());
        let of = found.extra;
        Ok(Linearisation {
            residual: found.residual.push(test),
            jacobian,
            design: across.design.push(design),
            extra: Critical { of, test },
        })
    }

    fn scale(&self) -> DVector<f64> {
        joined(&self.subject.scale(), self.scales[0])
    }

    fn accept(
        &mut self,
        z: &DVector<f64>,
        q: f64,
        extra: &Self::Extra,
    ) -> Result<Option<DVector<f64>>, FlowError> {
        let (own, p) = split(z);
        self.subject.steer(self.plane.along_p(q));
        let Some(moved) = self.subject.accept(&own, p, &extra.of)? else {
            self.align_with(&extra.of);
            return Ok(None);
        };
        let z = joined(&moved, p);
        self.align(&z, q)?;
        Ok(Some(z))
    }

    /// p means the same whatever the other unknowns are.
    fn lasting(&self, tangent: &DVector<f64>) -> DVector<f64> {
        let place = tangent.len() - 2;
        let own = self.subject.lasting(&tangent.clone().remove_row(place));
        let mut lasting = own.insert_row(place, 0.0);
        lasting[place] = tangent[place];
        lasting
    }
}
