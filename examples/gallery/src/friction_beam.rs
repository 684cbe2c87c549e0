//! A beam that rubs at one place, by its modes.
//!
//! Example 02 of NLstep (Krack and co-workers, Stuttgart): a steel cantilever of eight beam elements, 2 m long, 0.1 m high and
//! 0.3 m wide, with set-valued friction at its fourth node and a harmonic force at its tip. Five modes and the residual
//! flexibility of both points; the matrices of `structures/` are those of Euler's and Bernoulli's beam in mm, t and s, damped by
//! 5 % of the lowest mode with the contact held, and `stickslip reduce` has made `structures/beam.structure` of them.

use stickslip::model;
use stickslip_models::friction::Coulomb;

model! {
    /// A cantilever with dry friction at a node: example 02 of NLstep.
    pub struct FrictionBeam {
        structure beam = "structures/beam.structure";
        /// Force at which the contact slides.
        param limit: N = 1500.0 where limit > 0.0;
        /// Amplitude of the force at the tip.
        param push: N = 200.0;
        param omega: rad/s = 180.0 where omega > 0.0;
        drive phi at omega;
        friction F: N = Coulomb { level: limit } opposing der(beam.contact);
        load beam.contact = F;
        load beam.tip = push * cos(phi);
    }
}

#[cfg(test)]
mod tests {

    use std::f64::consts::TAU;

    use super::FrictionBeam;
    use crate::asked::{case, close};
    use crate::balance::{Balance, Balanced, slider};
    use crate::reference::solved;

    /// Rows of the displacements of the fourth and the ninth node.
    const CONTACT: usize = 4;
    const TIP: usize = 14;
    /// Elements, and unknowns.
    const ELEMENTS: usize = 8;
    const UNKNOWNS: usize = 2 * ELEMENTS;

    type Matrix = [[f64; UNKNOWNS]; UNKNOWNS];

    /// Stiffness and mass of the beam in mm, t and s, by Hermite's polynomials.
    fn matrices() -> [Matrix; 2] {
        let (length, height, modulus, density) = (2e3 / ELEMENTS as f64, 100.0, 185e3, 7.83e-9);
        let section = 3.0 * height * height;
        let bending = modulus * section * height * height / 12.0 / length.powi(3);
        let weight = density * section * length / 420.0;
        let l = length;
        let stiffness = [
            [12.0, 6.0 * l, -12.0, 6.0 * l],
            [6.0 * l, 4.0 * l * l, -6.0 * l, 2.0 * l * l],
            [-12.0, -6.0 * l, 12.0, -6.0 * l],
            [6.0 * l, 2.0 * l * l, -6.0 * l, 4.0 * l * l],
        ];
        let mass = [
            [156.0, 22.0 * l, 54.0, -13.0 * l],
            [22.0 * l, 4.0 * l * l, 13.0 * l, -3.0 * l * l],
            [54.0, 13.0 * l, 156.0, -22.0 * l],
            [-13.0 * l, -3.0 * l * l, -22.0 * l, 4.0 * l * l],
        ];
        [(stiffness, bending), (mass, weight)].map(|(element, factor)| {
            let mut all = [[0.0; UNKNOWNS]; UNKNOWNS];
            for first in 0..ELEMENTS {
                for (i, row) in element.iter().enumerate() {
                    for (j, entry) in row.iter().enumerate() {
                        // The two unknowns of the clamp are none.
                        let places = [i, j].map(|at| (2 * first + at).checked_sub(2));
                        if let [Some(i), Some(j)] = places {
                            all[i][j] += factor * entry;
                        }
                    }
                }
            }
            all
        })
    }

    /// 2 × 5 % of the lowest frequency with the contact held, which Rayleigh's quotient gives: damping over mass.
    const DAMPING: f64 = 24.897320476952537;

    /// Displacements at the contact under unit forces there and at the tip, in phase and a quarter ahead.
    fn receptances([stiffness, mass]: &[Matrix; 2], frequency: f64) -> [[f64; 2]; 2] {
        let row = |i: usize| {
            let (i, ahead) = (i % UNKNOWNS, i >= UNKNOWNS);
            let along = |j: usize| stiffness[i][j] - frequency * frequency * mass[i][j];
            let across = |j: usize| frequency * DAMPING * mass[i][j];
            let load = f64::from(u8::from(i == CONTACT && !ahead));
            let halves = |j: usize| match (ahead, j >= UNKNOWNS) {
                (false, false) | (true, true) => along(j % UNKNOWNS),
                (false, true) => across(j % UNKNOWNS),
                (true, false) => -across(j % UNKNOWNS),
            };
            (0..2 * UNKNOWNS).map(halves).chain([load]).collect()
        };
        let moved = solved((0..2 * UNKNOWNS).map(row).collect());
        [CONTACT, TIP].map(|at| [moved[at], moved[at + UNKNOWNS]])
    }

    /// The whole beam with Coulomb's friction: the coordinate is what the contact would be displaced without what a
    /// spring, the flexibility, gives way. Any flexibility is one and the same problem.
    struct Whole {
        receptances: Vec<[[f64; 2]; 2]>,
        flexibility: f64,
        limit: f64,
        push: f64,
    }

    /// Over a + b in quadrature as the factors of the cosine and the sine.
    fn over([a, b]: [f64; 2], [c, d]: [f64; 2]) -> [f64; 2] {
        let size = c * c + d * d;
        [(a * c + b * d) / size, (b * c - a * d) / size]
    }

    impl Whole {
        fn of(model: &FrictionBeam, highest: usize) -> Self {
            let matrices = matrices();
            let at = |order: usize| receptances(&matrices, order as f64 * model.omega);
            Self {
                receptances: (0..=highest).map(at).collect(),
                flexibility: FLEXIBILITY,
                limit: model.limit,
                push: model.push,
            }
        }
    }

    /// About what the contact gives way by the modes beyond the fifth, in mm/N.
    const FLEXIBILITY: f64 = 3.5e-8;

    impl Balanced<1> for Whole {
        fn stiffness(&self, order: usize) -> [[[f64; 2]; 1]; 1] {
            let [[along, across], _] = self.receptances[order];
            [[over([1.0, 0.0], [along - self.flexibility, across])].map(|[a, b]| [a, -b])]
        }
        fn load(&self, order: usize) -> [[f64; 2]; 1] {
            let [[along, across], tip] = self.receptances[order];
            let share = over(tip, [along - self.flexibility, across]);
            [if order == 1 {
                share.map(|part| self.push * part)
            } else {
                [0.0; 2]
            }]
        }
        fn forces(&self, motion: &[[f64; 1]]) -> Vec<[f64; 1]> {
            let places = motion.iter().map(|[place]| *place);
            let forces = slider(places, 1.0 / self.flexibility, self.limit);
            forces.into_iter().map(|force| [-force]).collect()
        }
    }

    /// The first harmonics of the contact, balanced: what the coordinate is, and what the spring gives way.
    fn balanced(whole: &Whole, motion: &Balance<1>) -> Vec<[f64; 2]> {
        let samples = motion.motion();
        let forces = whole.forces(&samples);
        let pairs = samples.iter().zip(&forces);
        let places: Vec<f64> = pairs
            .map(|([place], [force])| place + whole.flexibility * force)
            .collect();
        let half = 2.0 / places.len() as f64;
        let part = |order: f64| {
            let waves = places.iter().enumerate().map(|(i, place)| {
                let (sin, cos) = (order * TAU * i as f64 / places.len() as f64).sin_cos();
                [half * place * cos, half * place * sin]
            });
            waves.fold([0.0; 2], |[a, b], [c, d]| [a + c, b + d])
        };
        [1.0, 3.0, 5.0].map(part).to_vec()
    }

    /// Five modes of the beam against all sixteen unknowns and 25 odd harmonics, in mm: with twice as many
    /// harmonics the balance moves by 0.9 %, and the modes are off by 0.4 %; the limit is 1.5 %.
    #[test]
    fn the_response_is_that_of_a_harmonic_balance_of_the_whole_beam() {
        let mut motion = Balance::rest((1..50).step_by(2), 2048);
        // From where Newton's method finds it from rest.
        for omega in [255.0, 250.0, 245.0, 240.0, 235.0, 230.0, 225.0, 220.0] {
            let model = FrictionBeam {
                omega,
                ..FrictionBeam::default()
            };
            let whole = Whole::of(&model, 50);
            motion = motion.solved(&whole, 1e-7).expect("a balance");
            if omega % 20.0 != 0.0 {
                continue;
            }
            let (system, mut case) = case(&model);
            case.harmonics = vec![1, 3, 5];
            let orbit = system.orbit(&case).unwrap();
            assert_eq!(orbit.floquet.stability.name(), "stable");
            let known = balanced(&whole, &motion);
            let size = known[0][0].hypot(known[0][1]);
            let modes = system.info().structures[0].modes;
            let found = orbit.harmonics.as_ref().unwrap();
            for (found, known) in found.iter().zip(known) {
                let mut sums = [0.0; 2];
                for (k, mode) in modes.iter().enumerate() {
                    let (sin, cos) = found.phase[2 * k].sin_cos();
                    let amplitude = 1e3 * mode.shape[0] * found.amplitude[2 * k];
                    sums = [sums[0] + amplitude * cos, sums[1] - amplitude * sin];
                }
                let off = (sums[0] - known[0]).hypot(sums[1] - known[1]);
                close(off, 0.0, 1.5e-2 * size, "harmonic of the contact");
            }
        }
    }

    /// What the contact has to bear where it holds.
    fn bears(model: &FrictionBeam, omega: f64) -> f64 {
        let [contact, tip] = receptances(&matrices(), omega);
        let share = over(tip, contact);
        model.push * share[0].hypot(share[1])
    }

    /// While the contact holds, the response of the tip is that of the whole beam with its fourth node held; where friction
    /// can bear no more is a closed form, too.
    #[test]
    fn the_contact_holds_while_friction_can_bear_it() {
        for (omega, holds) in [(380.0, true), (318.0, true), (316.0, false)] {
            let model = FrictionBeam {
                omega,
                ..FrictionBeam::default()
            };
            let bears = bears(&model, omega);
            assert_eq!(bears < model.limit, holds, "{omega}: {bears}");
            let (system, case) = case(&model);
            let orbit = system.orbit(&case).unwrap();
            let stuck = orbit.word.as_deref() == Some("stick(F)");
            assert_eq!(stuck, holds, "{omega}: {:?}", orbit.word);
        }
    }

    /// From where the contact holds, a response goes on to where it slides: at first for moments, which shake the higher modes.
    #[test]
    fn a_response_goes_on_where_the_contact_lets_go() {
        let model = FrictionBeam {
            omega: 330.0,
            ..FrictionBeam::default()
        };
        let (mut holds, mut slides) = (330.0, 310.0);
        while holds - slides > 1e-9 {
            let middle = f64::midpoint(holds, slides);
            match bears(&model, middle) < model.limit {
                true => holds = middle,
                false => slides = middle,
            }
        }
        let (system, case) = case(&model);
        let branch = system.branch(&case.following(FrictionBeam::omega, 330.0..316.0));
        let branch = branch.unwrap();
        assert_eq!(branch.ended.word(), "reached-end");
        let found = branch.special.first().expect("where it lets go");
        close(found.r, holds, 0.1, "where it lets go");
        let model = FrictionBeam {
            omega: 316.0,
            ..model
        };
        let (system, case) = self::case(&model);
        let (last, settled) = (&branch.points.last().unwrap(), system.orbit(&case).unwrap());
        for (found, known) in last.max_abs.iter().zip(&settled.max_abs).take(14) {
            close(*found, *known, 1e-6 * known, "size");
        }
    }
}
