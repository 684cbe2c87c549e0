//! A third method for the tests: harmonic balance, with forces that are worked out in time. It shares no line with
//! `stickslip`, nor with the second method but Gauss's elimination.
//!
//! M. Krack, J. Gross, Harmonic Balance for Nonlinear Vibration Problems, Springer 2019.

use std::f64::consts::TAU;

use crate::reference::solved;

/// Newton's steps at most.
const STEPS: usize = 60;
/// Halvings of a step that leads away, as it may at kinks.
const HALVINGS: i32 = 12;

/// Coordinates with linear dynamics and forces that are not linear.
pub trait Balanced<const C: usize> {
    /// Dynamic stiffness at this multiple of the frequency: in phase, and a quarter ahead.
    fn stiffness(&self, order: usize) -> [[[f64; 2]; C]; C];
    /// The load at this multiple: the factors of the cosine and of the sine.
    fn load(&self, order: usize) -> [[f64; 2]; C];
    /// The other forces along a periodic motion, of which these are samples.
    fn forces(&self, motion: &[[f64; C]]) -> Vec<[f64; C]>;
}

/// A motion by its factors of the cosine and the sine of each order.
#[derive(Debug, Clone)]
pub struct Balance<const C: usize> {
    orders: Vec<usize>,
    /// Sine and cosine of each order at the samples.
    waves: Vec<Vec<(f64, f64)>>,
    pub factors: Vec<[[f64; 2]; C]>,
}

impl<const C: usize> Balance<C> {
    pub fn rest(orders: impl Iterator<Item = usize>, samples: usize) -> Self {
        let orders: Vec<usize> = orders.collect();
        let angle = |i: usize| TAU * i as f64 / samples as f64;
        let wave = |order: &usize| {
            let at = |i| (*order as f64 * angle(i)).sin_cos();
            (0..samples).map(at).collect()
        };
        Self {
            waves: orders.iter().map(wave).collect(),
            factors: vec![[[0.0; 2]; C]; orders.len()],
            orders,
        }
    }

    /// The motion at the samples.
    pub fn motion(&self) -> Vec<[f64; C]> {
        let mut motion = vec![[0.0; C]; self.waves[0].len()];
        for (wave, factors) in self.waves.iter().zip(&self.factors) {
            for (sums, (sin, cos)) in motion.iter_mut().zip(wave) {
                for (sum, [a, b]) in sums.iter_mut().zip(factors) {
                    *sum += a * cos + b * sin;
                }
            }
        }
        motion
    }

    /// The rate of a coordinate at the first sample, over the frequency.
    pub fn speed(&self, coordinate: usize) -> f64 {
        let rate =
            |(order, factors): (&usize, &[[f64; 2]; C])| *order as f64 * factors[coordinate][1];
        self.orders.iter().zip(&self.factors).map(rate).sum()
    }

    /// Newton's method with differences, from this motion; `None` where it ends elsewhere than in balance.
    pub fn solved(mut self, of: &impl Balanced<C>, tolerance: f64) -> Option<Self> {
        for _ in 0..STEPS {
            let here = self.residual(of);
            if norm(&here) < tolerance {
                return Some(self);
            }
            let step = self.step(of, &here);
            let mut shares = (0..HALVINGS).map(|halved| 0.5_f64.powi(halved));
            self = shares.find_map(|share| {
                let next = self.moved(&step, share);
                (norm(&next.residual(of)) < norm(&here)).then_some(next)
            })?;
        }
        None
    }

    fn step(&self, of: &impl Balanced<C>, here: &[f64]) -> Vec<f64> {
        let all = self.factors.as_flattened().as_flattened();
        let small = 1e-7 * all.iter().fold(1e-9_f64, |most, one| most.max(one.abs()));
        let column = |j: usize| {
            let mut unit = vec![0.0; here.len()];
            unit[j] = small;
            self.moved(&unit, 1.0).residual(of)
        };
        let columns: Vec<Vec<f64>> = (0..here.len()).map(column).collect();
        let row = |i: usize| {
            let slopes = columns.iter().map(|column| (column[i] - here[i]) / small);
            slopes.chain([-here[i]]).collect()
        };
        solved((0..here.len()).map(row).collect())
    }

    fn moved(&self, step: &[f64], share: f64) -> Self {
        let mut moved = self.clone();
        let all = moved.factors.as_flattened_mut().as_flattened_mut();
        let pairs = all.iter_mut().zip(step);
        pairs.for_each(|(factor, change)| *factor += share * change);
        moved
    }

    /// What is out of balance at each order.
    fn residual(&self, of: &impl Balanced<C>) -> Vec<f64> {
        let forces = of.forces(&self.motion());
        let mut residual = Vec::new();
        for (k, order) in self.orders.iter().enumerate() {
            let half = if *order == 0 { 1.0 } else { 2.0 } / forces.len() as f64;
            let (stiffness, load) = (of.stiffness(*order), of.load(*order));
            for i in 0..C {
                let (mut cos, mut sin) = (-load[i][0], -load[i][1]);
                for ([along, ahead], [a, b]) in stiffness[i].iter().zip(&self.factors[k]) {
                    cos += along * a + ahead * b;
                    sin += along * b - ahead * a;
                }
                for ((s, c), force) in self.waves[k].iter().zip(&forces) {
                    cos -= half * c * force[i];
                    sin -= half * s * force[i];
                }
                // A mean has no sine.
                let sin = if *order == 0 {
                    self.factors[k][i][1]
                } else {
                    sin
                };
                residual.extend([cos, sin]);
            }
        }
        residual
    }
}

fn norm(values: &[f64]) -> f64 {
    values.iter().map(|one| one * one).sum::<f64>().sqrt()
}

/// The force of a spring with a slider behind it along a periodic motion, on the second lap around it.
pub fn slider(motion: impl Iterator<Item = f64> + Clone, stiffness: f64, level: f64) -> Vec<f64> {
    let (mut force, mut before) = (0.0_f64, None);
    let mut follow = |x: f64| {
        let stretch = x - before.unwrap_or(x);
        force = (force + stiffness * stretch).clamp(-level, level);
        before = Some(x);
        force
    };
    motion.clone().for_each(|x| {
        follow(x);
    });
    motion.map(follow).collect()
}
