//! A bowed string.
//!
//! The friction of rosin that falls with speed as in M. E. McIntyre, R. T. Schumacher, J. Woodhouse, On the oscillations
//! of musical instruments, J. Acoust. Soc. Am. 74 (1983) 1325; the string by its modes as in J. Antunes, M. G. Tafasca,
//! L. L. Borne, Simulation des régimes vibratoires non-linéaires d'une corde de violon, Bull. SFM (2000). Three modes of
//! a G string at 196 Hz; values chosen here.

use stickslip::model;
use stickslip_models::friction::Tustin;

model! {
    /// A bowed string in three modes.
    pub struct BowedString {
        state q[3]: m = 0.0;
        state p[3]: m/s = 0.0;
        /// Fundamental frequency.
        param omega: rad/s = 1231.5 where omega > 0.0;
        param zeta: 1 = 0.002 where zeta >= 0.0;
        /// Half of the mass of the string.
        param mass: kg = 0.0002 where mass > 0.0;
        /// Where the bow is, as part of the length.
        param beta: 1 = 0.12 where 0.0 < beta < 1.0;
        param bow: m/s = 0.1;
        param pressed: N = 1.0 where pressed >= 0.0;
        for i in 0..3 {
            let shape[i] = sin((i + 1) * std::f64::consts::PI * beta);
        }
        /// Speed of the string under the bow.
        let string = shape[0] * p[0] + shape[1] * p[1] + shape[2] * p[2];
        friction F: N = Tustin { static_level: 0.8 * pressed, kinetic_level: 0.3 * pressed, speed: 0.1, viscous: 0.0 } opposing string - bow;
        for i in 0..3 {
            der(q[i]) = p[i];
            der(p[i]) = F * shape[i] / mass - 2 * zeta * (i + 1) * omega * p[i] - powi((i + 1) * omega, 2) * q[i];
        }
    }
}

#[cfg(test)]
mod tests {
    use std::array::from_fn;
    use std::f64::consts::PI;

    use stickslip::poincare::{Direction, Section, Surface};
    use stickslip::study::Span;

    use super::BowedString;
    use crate::asked::{case, returns};
    use crate::reference::{Plant, follow};

    impl BowedString {
        fn shape(&self, mode: usize) -> f64 {
            ((mode + 1) as f64 * PI * self.beta).sin()
        }
    }

    impl Plant<6, 1> for BowedString {
        fn rate(&self, _: f64, y: &[f64; 6], &[friction]: &[f64; 1]) -> [f64; 6] {
            from_fn(|j| match j {
                0..3 => y[j + 3],
                _ => {
                    let (mode, natural) = (j - 3, (j - 2) as f64 * self.omega);
                    let pulled = friction * self.shape(mode) / self.mass;
                    pulled - 2.0 * self.zeta * natural * y[j] - natural * natural * y[mode]
                }
            })
        }
        fn speeds(&self, y: &[f64; 6]) -> [f64; 1] {
            [(0..3)
                .map(|mode| self.shape(mode) * y[mode + 3])
                .sum::<f64>()
                - self.bow]
        }
        fn stick(&self, _: usize, _: &[f64; 6]) -> f64 {
            0.8 * self.pressed
        }
        fn slip(&self, _: usize, s: f64, _: &[f64; 6]) -> f64 {
            self.pressed * (0.3 + 0.5 * (-s / 0.1).exp())
        }
    }

    #[test]
    fn its_sound_is_that_of_a_second_method() {
        let model = BowedString::default();
        let (system, case) = case(&model);
        let orbit = system.orbit(&case).unwrap();
        returns(&orbit, &model, 1e-7);
    }

    /// Upward crossings of p₀ = 0 in a fifth of a second.
    #[test]
    fn a_section_misses_no_swing() {
        let model = BowedString::default();
        let (mut state, mut crossings, step) = ([0.0; 6], 0, 5e-5);
        for _ in 0..4000 {
            let next = follow(&model, state, (0.0, step), 1e-10).state;
            crossings += usize::from(state[3] < 0.0 && next[3] >= 0.0);
            state = next;
        }
        let section = Section {
            surface: Surface::Level {
                state: 3,
                value: 0.0,
            },
            direction: Direction::Up,
        };
        let (system, case) = case(&model);
        let found = system.crossings(&case, section, Span::Time(0.2)).unwrap();
        assert_eq!(found.points.len(), crossings);
    }
}
