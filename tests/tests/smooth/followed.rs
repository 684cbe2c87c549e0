//! Motions of models with internal states, followed.

use stickslip::field::{Design, SmoothField};
use stickslip::flow::{Flow, Passage, Peaks, SmoothFlow, Want};
use stickslip::integrate::Tolerance;
use stickslip::model::Model;

/// The flow of a model without contacts to smooth.
pub(super) fn flow<M: Model<N>, const N: usize>(
    model: &M,
    design: Design,
    accuracy: f64,
) -> SmoothFlow<M, N> {
    let field = SmoothField::new(model, None, design).expect("no friction to smooth");
    SmoothFlow::new(field, Tolerance::for_accuracy(accuracy))
}

/// A motion with all that is known of it.
pub(super) fn followed<M: Model<N>, const N: usize>(
    model: &M,
    state: [f64; N],
    time: f64,
    accuracy: f64,
) -> Passage<N, ()> {
    designed(model, Design::None, state, time, accuracy)
}

/// The same with its derivatives with respect to `design`.
pub(super) fn designed<M: Model<N>, const N: usize>(
    model: &M,
    design: Design,
    state: [f64; N],
    time: f64,
    accuracy: f64,
) -> Passage<N, ()> {
    let flow = flow(model, design, accuracy);
    let want = Want {
        path: true,
        derivatives: true,
        extrema: Peaks::All,
        ..Want::default()
    };
    let from = flow.place(state).expect("a place");
    flow.advance(&from, time, want).expect("a motion")
}

/// The start that a model declares.
pub(super) fn declared<M: Model<N>, const N: usize>() -> [f64; N] {
    std::array::from_fn(|i| M::INFO.states[i].start)
}

/// That a number is the expected one.
#[track_caller]
pub(super) fn close(found: f64, expected: f64, tolerance: f64, what: &str) {
    assert!(
        (found - expected).abs() <= tolerance,
        "{what}: {found} instead of {expected}"
    );
}
