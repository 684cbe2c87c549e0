//! The same flows by the `diffsol` crate: BDF with forward sensitivities, the closest that a library offers.

use std::time::Duration;

use diffsol::error::DiffsolError;
use diffsol::{DenseMatrix, NalgebraLU, NalgebraMat, OdeBuilder, SensitivitiesOdeSolverMethod};
use stickslip::field::{Design, Field, SmoothField};
use stickslip::model::Model;

use crate::flows::{PHI, Round, errors, loosest};

type Sensitivities<const N: usize> = ([[f64; N]; N], [f64; N]);

pub(crate) fn row<M: Model<N>, const N: usize>(round: &Round<M, N>, ours: f64) {
    let truth = round.truth();
    let error = |tolerance: f64| {
        let (state, design) = go(round, tolerance).ok()?;
        Some(errors(&state, &design, &truth))
    };
    let Some(tolerance) = loosest(|tolerance| error(tolerance).map(|error| error.0)) else {
        println!("{:<18}does not reach an error of {PHI:e}", "  diffsol");
        return;
    };
    let (phi, by_r) = error(tolerance).unwrap_or((f64::NAN, f64::NAN));
    let seconds = super::clock::best(Duration::from_secs(1), || {
        let _ = std::hint::black_box(go(round, std::hint::black_box(tolerance)));
    });
    println!(
        "{:<18}{tolerance:>10.1e}{:>10.1}{:>33}{phi:>10.1e}{by_r:>10.1e}   {:.1} times ours (10 is wanted)",
        "  diffsol",
        seconds * 1e6,
        "",
        seconds / ours,
    );
}

/// Φ and ∂φ/∂r: the start and the design variable are the parameters.
fn go<M: Model<N>, const N: usize>(
    round: &Round<M, N>,
    tolerance: f64,
) -> Result<Sensitivities<N>, DiffsolError> {
    let smoothing = "arctan:1e5".parse().ok();
    let design = Design::Parameter(round.design);
    let field = SmoothField::new(&round.model_at_r(), smoothing, design).expect("a smoothing");
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
