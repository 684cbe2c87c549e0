//! What happens to branches where a curve of their folds stands still in the other variable.
//!
//! There h(z, a) = 0, the branch along a at a fixed b, has two directions in the kernel of its derivatives instead of one. By
//! Lyapunov and Schmidt it looks like the zeros of the quadratic form wᵀ D²h of these two, w being the left null vector, plus
//! a multiple of b: an ellipse that shrinks to a point, or the two hyperbolas beside two lines that cross
//! (Golubitsky & Schaeffer 1985, chapter IV).

use nalgebra::{DMatrix, DVector};

use super::plane::Plane;
use crate::continuation::{Kind, ZeroProblem};
use crate::flow::FlowError;
use crate::linear::svd;
use crate::motion::Family;

/// Step of the differences of exact derivatives, in units of the scales; the second time twice as long.
const STEP: f64 = 1e-4;
/// Largest relative difference of the two determinants that leaves no doubt of the sign.
const DOUBT: f64 = 0.1;

/// The two variables of a curve, by which its points are unfolded.
#[derive(Debug, Clone)]
pub(super) struct Unfolding {
    /// The flows.
    pub(super) plane: Plane,
    /// Usual magnitudes of p and q.
    pub(super) scales: [f64; 2],
}

impl Unfolding {
    /// What becomes of branches along the one variable where the curve stands still in the other, at this p and q; `None`
    /// where their second derivatives leave that open. `problem` has the equations of a branch there, and their unknowns.
    pub(super) fn kind<P: ZeroProblem<Error = FlowError>>(
        &self,
        [p, q]: [f64; 2],
        still: usize,
        problem: impl Fn(Family, f64) -> Result<(P, DVector<f64>), FlowError>,
    ) -> Option<Kind> {
        let (family, a) = match still {
            0 => (self.plane.along_q(p), q),
            _ => (self.plane.along_p(q), p),
        };
        let (problem, z) = problem(family, a).ok()?;
        let scale = problem.scale().push(self.scales[1 - still]);
        let at = z.push(a);
        let branch = Branch { problem, at, scale };
        let [short, long] = branch.determinants().ok().flatten()?;
        let sure = (long - short).abs() <= DOUBT * short.abs() && short != 0.0;
        sure.then_some(if short > 0.0 {
            Kind::IsolaCentre
        } else {
            Kind::Exchange
        })
    }
}

/// The equations of a branch near a point of it.
struct Branch<P> {
    problem: P,
    /// The unknowns, the variable last.
    at: DVector<f64>,
    scale: DVector<f64>,
}

impl<P: ZeroProblem<Error = FlowError>> Branch<P> {
    /// The determinant of the quadratic form, from differences over a step and over twice that.
    fn determinants(mut self) -> Result<Option<[f64; 2]>, FlowError> {
        let slopes = self.slopes(&DVector::zeros(self.at.len()))?;
        let Some((left, kernel)) = null(slopes) else {
            return Ok(None);
        };
        let short = self.determinant(&left, &kernel, STEP)?;
        let long = self.determinant(&left, &kernel, 2.0 * STEP)?;
        Ok(Some([short, long]))
    }

    /// [h_z h_a] so far from the point, both in units of the scales.
    fn slopes(&mut self, off: &DVector<f64>) -> Result<DMatrix<f64>, FlowError> {
        let at = &self.at + off.component_mul(&self.scale);
        let last = at.len() - 1;
        let h = self
            .problem
            .evaluate(&at.rows(0, last).into_owned(), at[last])?;
        let mut slopes = h.jacobian.insert_column(last, 0.0);
        slopes.set_column(last, &h.design);
        for (mut column, scale) in slopes.column_iter_mut().zip(&self.scale) {
            column *= *scale;
        }
        Ok(slopes)
    }

    /// The determinant of wᵀ D²h on a kernel.
    fn determinant(
        &mut self,
        left: &DVector<f64>,
        kernel: &[DVector<f64>; 2],
        step: f64,
    ) -> Result<f64, FlowError> {
        let mut form = [[0.0; 2]; 2];
        for (row, along) in form.iter_mut().zip(kernel) {
            let rise = self.slopes(&(along * step))? - self.slopes(&(along * -step))?;
            let rise = rise.tr_mul(left) / (2.0 * step);
            *row = [0, 1].map(|j| rise.dot(&kernel[j]));
        }
        let mixed = 0.5 * (form[0][1] + form[1][0]);
        Ok(form[0][0] * form[1][1] - mixed * mixed)
    }
}

/// The left null vector of a matrix with one column more than rows, and two directions that span its kernel: those of its
/// least singular values.
fn null(matrix: DMatrix<f64>) -> Option<(DVector<f64>, [DVector<f64>; 2])> {
    let n = matrix.nrows();
    let all = svd(matrix.insert_row(n, 0.0))?;
    let (values, u, v) = (all.singular_values, all.u?, all.v_t?);
    let mut order: Vec<usize> = (0..=n).collect();
    order.sort_by(|a, b| values[*a].total_cmp(&values[*b]));
    let [first, second, ..] = order[..] else {
        return None;
    };
    // What belongs to the row of zeros has no part in the others.
    let left = [first, second].map(|i| u.view((0, i), (n, 1)).column(0).into_owned());
    let left = left
        .into_iter()
        .max_by(|a, b| a.norm().total_cmp(&b.norm()))?;
    Some((left, [first, second].map(|i| v.row(i).transpose())))
}
