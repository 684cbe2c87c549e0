//! Derivatives of smoothed fields against differences of the fields themselves.

use stickslip::field::{Field, SmoothField};
use stickslip::flow::SmoothFamily;
use stickslip::model::Model;
use stickslip_tests::on_every_reference_system;
use stickslip_tests::random::Random;
use stickslip_tests::subject::{Subject, TIGHT};

on_every_reference_system! {
    fields_have_their_slopes,
}

fn fields_have_their_slopes<M: Model<N>, const N: usize>(subject: &Subject<M, N>) {
    let mut random = Random::new(7);
    for (design, value) in subject.designs() {
        let family = subject.smooth(design, TIGHT);
        for _ in 0..50 {
            let start = subject.start();
            let state: [f64; N] = std::array::from_fn(|j| start[j] + random.real(1.0));
            let exact = field(&family, value).linearise(&state);
            let at = |r: f64| field(&family, r).f(&state);
            close(&exact.design, &central(at, value, 1e-6), "∂f/∂r");
            for column in 0..N {
                let moved = |to: f64| {
                    let mut moved = state;
                    moved[column] = to;
                    field(&family, value).f(&moved)
                };
                let by_state = std::array::from_fn(|row| exact.jacobian[row][column]);
                close(&by_state, &central(moved, state[column], 1e-6), "∂f/∂y");
            }
        }
    }
}

fn field<M: Model<N>, const N: usize>(family: &SmoothFamily<M, N>, r: f64) -> SmoothField<M, N> {
    *family.at(r).expect("a value within bounds").field()
}

fn central<const N: usize>(f: impl Fn(f64) -> [f64; N], at: f64, step: f64) -> [f64; N] {
    let (up, down) = (f(at + step), f(at - step));
    std::array::from_fn(|j| (up[j] - down[j]) / (2.0 * step))
}

fn close<const N: usize>(exact: &[f64; N], slope: &[f64; N], what: &str) {
    for j in 0..N {
        let error = (exact[j] - slope[j]).abs() / exact[j].abs().max(1.0);
        assert!(
            error < 1e-5,
            "{what} row {j}: {} against {}",
            exact[j],
            slope[j]
        );
    }
}
