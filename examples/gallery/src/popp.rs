//! A friction oscillator that is excited by itself and from outside.
//!
//! K. Popp, P. Stelter, Stick-slip vibrations and chaos, Phil. Trans. R. Soc. Lond. A 332 (1990) 89; parameters after
//! M. Oestreich, N. Hinrichs, K. Popp, Bifurcation and stability analysis for a non-smooth friction oscillator, Archive
//! of Applied Mechanics 66 (1996) 301, as known here: μ(s) = 0.3/(1 + 1.42 s) + 0.1 + 0.01 s², F_N = 10, u₀ = 0.5.

use stickslip::model;
use stickslip_models::friction::PoppStelter;

model! {
    /// Self- and externally excited friction oscillator: Popp and Stelter 1990.
    pub struct PoppOscillator {
        state x: m = 0.0;
        state v: m/s = 0.0;
        param m: kg = 1.0 where m > 0.0;
        param k: N/m = 1.0 where k > 0.0;
        param belt: m/s = 1.0;
        /// Amplitude of the base that carries the spring.
        param u0: m = 0.5;
        param Omega: rad/s = 0.6 where Omega > 0.0;
        param normal: N = 10.0 where normal >= 0.0;
        drive phi at Omega;
        friction F: N = PoppStelter { static_level: 0.4 * normal, kinetic_level: 0.1 * normal, decay: 1.42, growth: 0.01 * normal } opposing v - belt;
        der(x) = v;
        der(v) = (F - k * (x - u0 * cos(phi))) / m;
    }
}

#[cfg(test)]
mod tests {
    use super::PoppOscillator;
    use crate::asked::{case, returns};
    use crate::reference::Plant;

    impl Plant<2, 1> for PoppOscillator {
        fn rate(&self, t: f64, &[x, v]: &[f64; 2], &[friction]: &[f64; 1]) -> [f64; 2] {
            let base = self.u0 * (self.Omega * t).cos();
            [v, (friction - self.k * (x - base)) / self.m]
        }
        fn speeds(&self, &[_, v]: &[f64; 2]) -> [f64; 1] {
            [v - self.belt]
        }
        fn stick(&self, _: usize, _: &[f64; 2]) -> f64 {
            0.4 * self.normal
        }
        fn slip(&self, _: usize, s: f64, _: &[f64; 2]) -> f64 {
            (0.3 / (1.0 + 1.42 * s) + 0.1 + 0.01 * s * s) * self.normal
        }
    }

    #[test]
    fn stick_slip_locked_to_the_base_is_that_of_a_second_method() {
        let model = PoppOscillator {
            Omega: 1.0,
            u0: 5.0,
            ..PoppOscillator::default()
        };
        let (system, case) = case(&model);
        let orbit = system.orbit(&case).unwrap();
        returns(&orbit, &model, 1e-8);
    }
}
