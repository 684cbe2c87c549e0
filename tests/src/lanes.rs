//! Derivatives of generated right-hand sides: through dual numbers, and as the macro has written them out.

use stickslip::field::{Design, Field, SmoothField, Smoothing};
use stickslip::friction::ContactRule;
use stickslip::model::Model;
use stickslip::scalar::{Inline, Lanes};

use crate::hand_written::Linearised;

/// By dual numbers: f, Jacobian and parameter derivatives, each parameter in turn being the design variable.
pub fn linearised<M: Model<N>, const N: usize, const P: usize>(
    model: &M,
    state: [f64; N],
    rule: impl ContactRule<M::Lanes> + ContactRule<f64> + Clone,
) -> Linearised<N, P> {
    let values = model.values();
    let lanes = std::array::from_fn(|i| M::Lanes::state(state[i], i));
    let mut jacobian = [[0.0; N]; N];
    let by_parameter = std::array::from_fn(|design| {
        let parameters = M::Params::<M::Lanes>::from_fn(|p| {
            let slope = if p == design { 1.0 } else { 0.0 };
            M::Lanes::design(values.as_ref()[p], slope)
        });
        let slopes = M::rhs(&parameters, lanes, &mut rule.clone()).map(|rate| rate.slopes());
        jacobian = slopes.map(|(by_state, _)| by_state);
        slopes.map(|(_, by_design)| by_design)
    });
    Linearised {
        f: M::rhs(&values, state, &mut rule.clone()),
        jacobian,
        by_parameter,
    }
}

/// As written out: f, Jacobian and parameter derivatives, each parameter in turn being the design variable.
///
/// # Panics
/// The smoothing does not suit the model, or f has not the bits of the right-hand side itself.
pub fn tangents<M: Model<N>, const N: usize, const P: usize>(
    model: &M,
    state: [f64; N],
    smoothing: Option<Smoothing>,
) -> Linearised<N, P> {
    let linear: [_; P] = std::array::from_fn(|design| {
        let field = SmoothField::new(model, smoothing, Design::Parameter(design));
        let field = field.expect("a suitable smoothing");
        let linear = field.linearise(&state);
        assert_eq!(
            linear.f.map(f64::to_bits),
            field.f(&state).map(f64::to_bits)
        );
        linear
    });
    Linearised {
        f: linear[0].f,
        jacobian: linear[0].jacobian,
        by_parameter: linear.map(|linear| linear.design),
    }
}
