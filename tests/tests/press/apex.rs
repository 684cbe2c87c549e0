//! Friction that comes to its limit where its press lets go: what it may bear vanishes with what it is to bear.

use stickslip::model;
use stickslip::study::{Case, System};
use stickslip_models::friction::Coulomb;
use stickslip_models::press::Compliant;

model! {
    /// A rod on a belt: R. I. Leine, B. Brogliato, H. Nijmeijer, European Journal of Mechanics A 21 (2002) 199, with a tip that
    /// gives way.
    struct Rod {
        state y = 0.95;
        state w = 0.0;
        state p = 0.4;
        state q = 0.0;
        param belt = -0.0641;
        press N = Compliant { stiffness: 1000.0, damping: 2.0 } closing y - cos(p);
        friction F = Coulomb { level: 2.0 * N } opposing cos(p) * q - belt;
        let b = 0.5 * sin(p);
        let lift = -20.0 * (y - 0.8) - 0.3 * w + N - 0.5 * cos(p) * q * q;
        let turn = -5.0 * (p - 0.5) - 0.2 * q + N * sin(p) + F * cos(p);
        let det = 1.2 * 0.34 - b * b;
        der(y) = w;
        der(p) = q;
        der(w) = (0.34 * lift - b * turn) / det;
        der(q) = (1.2 * turn - b * lift) / det;
    }
}

/// The speed with which it begins to slide is rounding error until the tip is off.
#[test]
fn a_slide_that_rounding_hides_is_no_chatter() {
    // Of a simulation with fixed steps.
    let simulated = 0.58296;
    for accuracy in [1e-5, 1e-7, 1e-9] {
        let mut case = Case::of(&Rod::default());
        case.accuracy = accuracy;
        let orbit = System::of::<Rod, _>().orbit(&case).unwrap();
        assert!((orbit.period - simulated).abs() < 1e-5, "{}", orbit.period);
    }
}
