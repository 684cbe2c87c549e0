//! How a program asks: it finds the orbit of a brake pad, follows it along the speed of the disc, and does the same with
//! the pad that slides evenly.

use stickslip::model;
use stickslip::study::{Case, StudyError, System};
use stickslip_models::friction::Tustin;

model! {
    /// A brake pad on its bracket, pressed against a turning disc.
    pub struct Pad {
        state x: m = 0.0;
        state v: m/s = 0.0;
        param mass: kg = 1.0 where mass > 0.0;
        param bracket: N/m = 100.0 where bracket > 0.0;
        param damping: N*s/m = 4.0 where damping >= 0.0;
        param disc: m/s = 0.2 where disc > 0.0;
        friction F: N = Tustin { static_level: 10.0, kinetic_level: 6.0, speed: 0.2, viscous: 0.0 } opposing v - disc;
        der(x) = v;
        der(v) = (F - bracket * x - damping * v) / mass;
    }
}

fn main() -> Result<(), StudyError> {
    let system = System::of::<Pad, _>();
    let case = Case::of(&Pad::default());
    let orbit = system.orbit(&case)?;
    println!(
        "period {:.9} s, {}",
        orbit.period,
        orbit.floquet.stability.name()
    );

    let case = case.following(Pad::disc, 0.2..0.6);
    for point in &system.branch(&case)?.special {
        println!("{} at {:.9} m/s", point.kind, point.r);
    }
    let even = system.equilibria_along(&case)?;
    for point in &even.special {
        println!("{} at {:.9} m/s", point.kind, point.r);
    }
    // Damping and the fall of the law balance where 20 exp(-5 v) = 4.
    let balance = 5.0_f64.ln() / 5.0;
    assert!((even.special[0].r - balance).abs() < 1e-9);
    Ok(())
}
