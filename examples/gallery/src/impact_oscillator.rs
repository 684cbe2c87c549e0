//! An oscillator that is driven against a wall.
//!
//! S. W. Shaw, P. J. Holmes, A periodically forced piecewise linear oscillator, J. Sound and Vibration 90 (1983) 129. With
//! the parameters of the demo `impact` of COCO (Dankowicz and Schilder 2013) orbits with one impact are a quadratic in the
//! speed of departure. Away from resonance they begin at the grazing of the free motion, with a multiplier that comes from
//! −∞, and gain stability in a flip.

use stickslip::model;
use stickslip_models::press::Rigid;

model! {
    /// A driven oscillator beside a wall: Shaw and Holmes 1983.
    pub struct ImpactOscillator {
        state x = 0.0;
        state v = 0.0;
        /// Amplitude of the force.
        param load = 0.1;
        param omega = 0.9 where omega > 0.0;
        param c = 0.1 where c >= 0.0;
        param k = 1.0 where k > 0.0;
        /// Where the wall stands.
        param wall = 1.0;
        /// Coefficient of restitution.
        param e = 0.8 where 0.0 <= e <= 1.0;
        drive phi at omega;
        press R = Rigid { restitution: e } closing wall - x;
        der(x) = v;
        der(v) = load * cos(phi) - k * x - c * v - R;
    }
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;

    use stickslip::continuation::Kind;

    use super::ImpactOscillator;
    use crate::asked::{along, case, close};

    /// The grazing is that of the linear response; where orbits with one impact have the multiplier −1 is an equation that is
    /// linear in the speed of departure (tests/tests/press/graze.rs).
    #[test]
    fn impacts_begin_at_the_grazing_and_are_stable_from_the_flip_on() {
        let (system, case) = case(&ImpactOscillator::default());
        let case = along(&case, ImpactOscillator::load, 0.1, 0.7);
        let branch = system.branch(&case, &mut |_| ControlFlow::Continue(()));
        let branch = branch.unwrap();
        let found: Vec<_> = branch.special.iter().map(|one| (one.kind, one.r)).collect();
        let [(Kind::Grazing, grazing), (Kind::Flip, flip)] = found[..] else {
            panic!("{found:?}, {}", branch.ended.reason)
        };
        close(grazing, 0.19_f64.hypot(0.09), 1e-9, "grazing");
        close(flip, 0.5707287665132044, 1e-9, "flip");
    }
}
