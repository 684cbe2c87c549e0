
/// The right-hand side and its derivatives.
pub fn evaluated(state: [f64; 2]) -> ([f64; 2], stickslip::model::Linear<2>) {
    use stickslip::field::{Design, Field, SmoothField};
    let smoothing = "arctan:1e3".parse().ok();
    let field = SmoothField::new(&Belt::default(), smoothing, Design::Parameter(2)).expect("within bounds");
    (field.f(&state), field.linearise(&state))
}
