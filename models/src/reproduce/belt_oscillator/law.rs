//! Fig. 3.5: the friction law and its smooth copies.

use stickslip::field::{Field, Kernel};
use stickslip::friction::FrictionLaw;
use stickslip::report::{Axis, Curve, Figure, Panel};

use super::super::ReproduceError;
use super::super::follow::field;
use super::super::words::power;
use crate::BeltOscillator;
use crate::friction::Weakening;

/// The force of the copy at sliding speed w: what the integrator sees, at x = 0 and m = 1.
fn force(size: f64, w: f64) -> Result<f64, ReproduceError> {
    let model = BeltOscillator::default();
    let field = field(&model, Kernel::Arctan, size).map_err(ReproduceError::at("figure 3.5"))?;
    Ok(field.f(&[0.0, model.v_dr + w])[1])
}

/// Sliding speeds up to `most` either way, dense where the copies are steep.
fn speeds(most: f64) -> impl Iterator<Item = f64> {
    (-300..=300).map(move |i| {
        let share = f64::from(i) / 300.0;
        most * share * share.abs() * share.abs()
    })
}

pub(super) fn figure_5() -> Result<Figure, ReproduceError> {
    Ok(Figure::new(
        "3.5",
        "Friction force *F* and its smooth copies",
        "Left: friction pushes against the direction of sliding, and weakens with speed; at rest it takes any value \
         between −1 N and 1 N. Right: the same near rest. The larger *ε*, the closer the copy; but its peak is always \
         lower than the limit at rest, and its slope there, −(2/π) *ε* *F*_{s}, is what makes the equations stiff.",
    )
    .columns(2)
    .panel(forces(1.0)?)
    .panel(forces(0.05)?))
}

fn forces(most: f64) -> Result<Panel, ReproduceError> {
    let law = Weakening {
        limit: 1.0,
        decay: 3.0,
    };
    let exact = speeds(most)
        .filter(|w| *w != 0.0)
        .map(|w| [w, -w.signum() * law.slip(w.abs())])
        .collect();
    let axes = Panel::new(
        Axis::new("sliding speed *v*_{rel} (m/s)").from(-most, most),
        Axis::new("friction force *F* (N)").from(-1.2, 1.2),
    );
    let mut panel = axes.curve(Curve::line("exact", 0, exact));
    for (i, exponent) in [2, 3, 4].into_iter().enumerate() {
        let points = speeds(most)
            .map(|w| Ok([w, force(10f64.powi(exponent), w)?]))
            .collect::<Result<_, ReproduceError>>()?;
        panel = panel.curve(Curve::line(
            format!("*ε* = {} s/m", power(exponent)),
            i + 1,
            points,
        ));
    }
    Ok(panel)
}
