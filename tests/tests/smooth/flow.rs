//! What any flow must do, whatever it is the flow of.

use stickslip::flow::{Derivatives, Flow, Passage, Place, Want};
use stickslip::model::Model;
use stickslip_tests::on_every_reference_system;
use stickslip_tests::subject::{Subject, TIGHT};

on_every_reference_system! {
    flows_compose,
    monodromy_is_the_slope_of_the_flow,
    design_derivatives_are_slopes_of_the_flow,
    volumes_shrink_by_the_trace,
    extrema_are_never_passed,
}

const DERIVATIVES: Want = Want::DERIVATIVES;

/// A time in which every subject slides, and those with friction stick and slide again.
const TIME: f64 = 9.7;

fn advance<F: Flow<N, Mode = ()>, const N: usize>(
    flow: &F,
    state: [f64; N],
    time: f64,
    want: Want,
) -> Passage<N, ()> {
    let from = Place { state, mode: () };
    flow.advance(&from, time, want)
        .expect("a motion that can be followed")
}

fn derivatives<F: Flow<N, Mode = ()>, const N: usize>(
    flow: &F,
    state: [f64; N],
    time: f64,
) -> Derivatives<N> {
    let passage = advance(flow, state, time, DERIVATIVES);
    passage
        .derivatives
        .expect("the derivatives that were wanted")
}

fn largest<const N: usize>(columns: &[[f64; N]]) -> f64 {
    columns
        .iter()
        .flatten()
        .fold(0.0, |largest, entry| entry.abs().max(largest))
}

fn distance<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    let gap: [f64; N] = std::array::from_fn(|j| a[j] - b[j]);
    largest(&[gap])
}

fn flows_compose<M: Model<N>, const N: usize>(subject: &Subject<M, N>) {
    let flow = subject.flow(TIGHT);
    let whole = advance(&flow, subject.start(), TIME, DERIVATIVES);
    let first = advance(&flow, subject.start(), 0.37 * TIME, DERIVATIVES);
    let second = advance(&flow, first.end.state, 0.63 * TIME, DERIVATIVES);
    let size = largest(&[whole.end.state]);
    let error = distance(&whole.end.state, &second.end.state) / size;
    assert!(error < 1e-8, "{error:e}");
    let (a, b) = (
        second.derivatives.unwrap().state,
        first.derivatives.unwrap().state,
    );
    let product: [[f64; N]; N] =
        std::array::from_fn(|i| std::array::from_fn(|j| (0..N).map(|k| a[i][k] * b[k][j]).sum()));
    let phi = whole.derivatives.unwrap().state;
    // A factor is only as good as its own size lets it be.
    let size = largest(&phi).max(largest(&a) * largest(&b) * 1e-2);
    for row in 0..N {
        let error = distance(&phi[row], &product[row]) / size;
        assert!(error < 1e-6, "row {row}: {error:e}");
    }
}

fn monodromy_is_the_slope_of_the_flow<M: Model<N>, const N: usize>(subject: &Subject<M, N>) {
    let flow = subject.flow(TIGHT);
    let start = subject.start();
    let phi = derivatives(&flow, start, TIME).state;
    let size = largest(&phi);
    for column in 0..N {
        let end = |by: f64| {
            let mut moved = start;
            moved[column] += by;
            advance(&flow, moved, TIME, Want::default()).end.state
        };
        let slope = central(end, 1e-5);
        let exact = std::array::from_fn(|row| phi[row][column]);
        let error = distance(&slope, &exact) / size;
        assert!(error < 2e-5, "column {column}: {error:e}");
    }
}

fn design_derivatives_are_slopes_of_the_flow<M: Model<N>, const N: usize>(subject: &Subject<M, N>) {
    for (design, value) in subject.designs() {
        let family = subject.smooth(design, TIGHT);
        let at = |r: f64| family.at(r).expect("a value within bounds");
        let exact = derivatives(&at(value), subject.start(), TIME).design;
        let end = |by: f64| {
            advance(&at(value + by), subject.start(), TIME, Want::default())
                .end
                .state
        };
        let slope = central(end, 1e-5);
        let error = distance(&slope, &exact) / largest(&[exact]).max(1e-2);
        assert!(error < 2e-5, "{design:?}: {error:e}, {exact:?}");
    }
}

/// (φ(h) − φ(−h)) / 2h.
fn central<const N: usize>(end: impl Fn(f64) -> [f64; N], step: f64) -> [f64; N] {
    let (up, down) = (end(step), end(-step));
    std::array::from_fn(|j| (up[j] - down[j]) / (2.0 * step))
}

/// Liouville: ln det Φ = ∫ tr J, over a time in which det Φ does not drown in rounding.
fn volumes_shrink_by_the_trace<M: Model<N>, const N: usize>(subject: &Subject<M, N>) {
    let flow = subject.flow(TIGHT);
    let passage = |time| derivatives(&flow, subject.start(), time);
    let mut time = TIME;
    while passage(time).determinant.log.abs() > 4.0 {
        time *= 0.7;
    }
    let Derivatives {
        state, determinant, ..
    } = passage(time);
    let trace = determinant.log;
    let determinant = nalgebra::DMatrix::from_fn(N, N, |i, j| state[i][j]).determinant();
    assert!(trace.abs() > 1e-2, "nothing was asked: {trace}");
    assert!(
        (determinant.ln() - trace).abs() < 1e-8,
        "{} {trace}",
        determinant.ln()
    );
}

/// No sample of the motion lies beyond its extrema, and the extrema lie on the motion.
fn extrema_are_never_passed<M: Model<N>, const N: usize>(subject: &Subject<M, N>) {
    let flow = subject.flow(TIGHT);
    let orbit = subject.orbit();
    let from = std::array::from_fn(|j| orbit.place.state[j]);
    let (mut low, mut high) = (from, from);
    let (mut state, samples) = (from, 4000);
    for _ in 0..samples {
        state = advance(
            &flow,
            state,
            orbit.period / f64::from(samples),
            Want::default(),
        )
        .end
        .state;
        for j in 0..N {
            low[j] = low[j].min(state[j]);
            high[j] = high[j].max(state[j]);
        }
    }
    for j in 0..N {
        let extent = high[j] - low[j];
        let (above, below) = (orbit.max[j] - high[j], low[j] - orbit.min[j]);
        for beyond in [above, below] {
            assert!(
                beyond > -1e-8 * extent,
                "state {j} passes its extremum by {:e}",
                -beyond
            );
            assert!(
                beyond < 1e-4 * extent,
                "state {j} never reaches its extremum: {beyond:e}"
            );
        }
    }
}
