//! A model in other units: time and states scaled, nothing else said.

use stickslip::friction::{ContactRule, SlopeRule};
use stickslip::model::{Model, ModelInfo, Rates};
use stickslip::scalar::Scalar;

/// How much faster [`Transformed`] runs than its original.
pub const PACE: f64 = 3.0;

/// How much larger state number `index` of [`Transformed`] is.
#[must_use]
pub fn stretch(index: usize) -> f64 {
    [0.7, 5.0, 1.3, 0.4][index % 4]
}

/// The original `M` with f → [`PACE`] f and y → S y: no row of it is kinematic any more.
#[derive(Debug, Clone, Copy, Default)]
pub struct Transformed<M>(pub M);

impl<M: Model<N>, const N: usize> Model<N> for Transformed<M> {
    type Params<D: Scalar> = M::Params<D>;
    type PerContact<T: Copy + Send + Sync> = M::PerContact<T>;
    type Observables = M::Observables;
    type Lanes = M::Lanes;

    const INFO: &'static ModelInfo = M::INFO;
    const KINEMATIC: [Option<usize>; N] = [None; N];
    const SPARSITY: [[bool; N]; N] = M::SPARSITY;

    fn values(&self) -> M::Params<f64> {
        self.0.values()
    }

    fn from_values(values: M::Params<f64>) -> Self {
        Self(M::from_values(values))
    }

    fn rhs<D: Scalar>(
        params: &M::Params<D>,
        state: [D; N],
        contacts: &mut impl ContactRule<D>,
    ) -> [D; N] {
        let original = std::array::from_fn(|j| state[j] * (1.0 / stretch(j)));
        let rates = M::rhs(params, original, contacts);
        std::array::from_fn(|j| rates[j] * (PACE * stretch(j)))
    }

    fn entries(
        params: &M::Params<f64>,
        seeds: &M::Params<f64>,
        state: [f64; N],
        contacts: &mut impl SlopeRule,
        mut entry: impl FnMut(usize, usize, f64),
    ) -> Rates<N> {
        let original = std::array::from_fn(|j| state[j] * (1.0 / stretch(j)));
        let pace = |i: usize| PACE * stretch(i);
        let entry =
            |i: usize, j: usize, slope: f64| entry(i, j, slope * (1.0 / stretch(j)) * pace(i));
        let rates = M::entries(params, seeds, original, contacts, entry);
        Rates {
            f: std::array::from_fn(|i| rates.f[i] * pace(i)),
            design: std::array::from_fn(|i| rates.design[i] * pace(i)),
        }
    }

    fn observables(
        params: &M::Params<f64>,
        state: [f64; N],
        contacts: &mut impl ContactRule<f64>,
    ) -> M::Observables {
        let original = std::array::from_fn(|j| state[j] / stretch(j));
        M::observables(params, original, contacts)
    }
}
