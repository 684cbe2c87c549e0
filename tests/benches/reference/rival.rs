//! The same flows by the `diffsol` crate: BDF with forward sensitivities, the closest that a library offers.

use diffsol::error::DiffsolError;
use diffsol::{DenseMatrix, NalgebraLU, NalgebraMat, OdeBuilder, SensitivitiesOdeSolverMethod};
use stickslip::field::Field;
use stickslip::model::Model;

use crate::round::{Round, Sensitivities};

/// Once around by BDF.
pub(crate) fn bdf<M: Model<N>, const N: usize>(
    round: &Round<M, N>,
    tolerance: f64,
) -> Option<Sensitivities<N>> {
    go(round, tolerance).ok()
}

/// Φ and ∂φ/∂r: the start and the design variable are the parameters.
fn go<M: Model<N>, const N: usize>(
    round: &Round<M, N>,
    tolerance: f64,
) -> Result<Sensitivities<N>, DiffsolError> {
    let field = round.field();
    let state = |x: &[f64]| std::array::from_fn::<f64, N, _>(|j| x[j]);
    let problem = OdeBuilder::<NalgebraMat<f64>>::new()
        .rtol(tolerance)
        .atol([tolerance])
        .sens_rtol(tolerance)
        .sens_atol([tolerance])
        .p(round.start.into_iter().chain([round.r]))
        .rhs_sens_implicit(
            |x, _, _, y| y.copy_from_slice(&field.f(&state(x))),
            |x, _, _, v, y| {
                let linear = field.linearise(&state(x));
                for (row, y) in linear.jacobian.iter().zip(y) {
                    *y = row.iter().zip(v).map(|(slope, v)| slope * v).sum();
                }
            },
            |x, _, _, v, y| {
                let linear = field.linearise(&state(x));
                for (slope, y) in linear.design.iter().zip(y) {
                    *y = slope * v[N];
                }
            },
        )
        .init_sens(
            |p, _, y| y.copy_from_slice(&p[..N]),
            |_, _, v, y| y.copy_from_slice(&v[..N]),
            N,
        )
        .build()?;
    let mut solver = problem.bdf_sens::<NalgebraLU<f64>>()?;
    let (_, columns, _) = solver.solve_dense_sensitivities(&[round.period])?;
    let entry = |row: usize, column: usize| columns[column].get_index(row, 0);
    Ok((
        std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j))),
        std::array::from_fn(|i| entry(i, N)),
    ))
}
