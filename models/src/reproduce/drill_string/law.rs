//! Fig. 4.3: the friction term and its smooth copies.

use stickslip::field::{Field, Kernel};
use stickslip::report::{Axis, Curve, Figure, Panel};

use super::super::ReproduceError;
use super::super::follow::field;
use super::super::words::power;
use crate::DrillString;

/// The friction term of the copy at the twist rate `omega`: what the integrator sees, at ψ = 0.
fn friction(size: f64, omega: f64) -> Result<f64, ReproduceError> {
    let model = DrillString::default();
    let field = field(&model, Kernel::Quartic, size).map_err(ReproduceError::at("figure 4.3"))?;
    Ok(field.f(&[0.0, omega])[1] + 2.0 * model.zeta * omega)
}

pub(super) fn figure_3() -> Result<Figure, ReproduceError> {
    let DrillString { eta, theta, .. } = DrillString::default();
    let mut panel = Panel::new(
        Axis::new("twist rate *ψ*′").from(-1.0, 5.0),
        Axis::new("friction term *T*_{c}").from(-4.0, 6.0),
    )
    .curve(Curve::line(
        "exact, *η* = 4",
        0,
        vec![[-1.0, 0.0], [eta, 0.0], [eta, theta], [eta, -4.0]],
    ));
    for (i, exponent) in [0, -1].into_iter().enumerate() {
        let size = 10f64.powi(exponent);
        let points = (0..=600)
            .map(|k| -1.0 + (eta + 0.3 * size + 1.0) * f64::from(k) / 600.0)
            .map(|omega| Ok([omega, friction(size, omega)?]))
            .collect::<Result<_, ReproduceError>>()?;
        panel = panel.curve(Curve::line(
            format!("*ε* = {}", power(exponent)),
            i + 1,
            points,
        ));
    }
    Ok(Figure::new(
        "4.3",
        "Friction term *T*_{c} and its smooth copies",
        "While the bit turns (*ψ*′ < *η*) the term is zero; where it sticks (*ψ*′ = *η*) the term takes any value up to \
         *θ* = 4.2. The copy climbs to the same peak at *ψ*′ = *η* − *ε* by a polynomial of fourth degree that begins \
         at *η* − 4*ε*. It stands for forward motion only.",
    )
    .panel(panel))
}
