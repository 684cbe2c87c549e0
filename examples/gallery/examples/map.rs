//! Where a brake pad squeals: 20 × 20 speeds of the disc and dampings, on all cores; model included.

use stickslip::study::{Case, OrbitError, StudyError, System, parallel};
use stickslip_models::friction::Tustin;

stickslip::model! {
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

fn main() {
    let system = System::of::<Pad, _>();
    let cells: Vec<[f64; 2]> = (0..400)
        .map(|cell| [f64::from(19 - cell / 20), f64::from(cell % 20 + 1)])
        .collect();
    let map = parallel(&cells, |[damping, disc]| {
        let case = Case::of(&Pad {
            damping: 0.5 * damping,
            disc: 0.05 * disc,
            ..Pad::default()
        });
        match system.orbit(&case) {
            Ok(_) => '#',
            Err(StudyError::Orbit(OrbitError::Equilibrium { .. })) => '.',
            Err(_) => '?',
        }
    });
    map.chunks(20)
        .for_each(|row| println!("{}", row.iter().collect::<String>()));
}
