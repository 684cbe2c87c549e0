//! A second method for the tests: an event-driven integration by Dormand and Prince's pair, which shares no line with
//! `stickslip`. Friction forces of sticking contacts are solved for, switches are found by bisection of a whole step.

use std::array::from_fn;

/// A system written by hand: `N` states, `C` contacts.
pub trait Plant<const N: usize, const C: usize> {
    /// Rates of the states at a time, under these friction forces.
    fn rate(&self, t: f64, y: &[f64; N], friction: &[f64; C]) -> [f64; N];
    /// Relative speeds of the contacts, affine in the states.
    fn speeds(&self, y: &[f64; N]) -> [f64; C];
    /// Largest force of a contact at rest.
    fn stick(&self, contact: usize, y: &[f64; N]) -> f64;
    /// Force of a contact at this magnitude of its speed.
    fn slip(&self, contact: usize, speed: f64, y: &[f64; N]) -> f64;
    /// The force of a contact at rest, where a spring in series with it gives that force.
    fn elastic(&self, _contact: usize, _y: &[f64; N]) -> Option<f64> {
        None
    }
    /// The rates while these contacts slide, where a spring in series with them rests then.
    fn sliding(&self, rate: [f64; N], _contacts: [bool; C]) -> [f64; N] {
        rate
    }
}

/// Where a motion came to.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion<const N: usize> {
    pub state: [f64; N],
    pub min: [f64; N],
    pub max: [f64; N],
    /// What the contacts did, one letter for each stretch of the motion: `s`, `+` or `-` for each contact.
    pub word: Vec<String>,
}

/// What a contact does: 0 sticks, ±1 slides forwards or backwards.
type Modes<const C: usize> = [i8; C];

struct Run<'a, P, const N: usize, const C: usize> {
    plant: &'a P,
    tolerance: f64,
    modes: Modes<C>,
}

/// Follows a motion from `from` to `to` with local errors of this size relative to the states' magnitudes so far.
pub fn follow<const N: usize, const C: usize>(
    plant: &impl Plant<N, C>,
    start: [f64; N],
    (from, to): (f64, f64),
    tolerance: f64,
) -> Motion<N> {
    let mut run = Run {
        plant,
        tolerance,
        modes: [0; C],
    };
    run.begin(from, &start);
    let mut motion = Motion {
        state: start,
        min: start,
        max: start,
        word: vec![spelt(&run.modes)],
    };
    let longest = (to - from) / 400.0;
    let (mut t, mut h) = (from, 1e-4 * longest);
    while to - t > 1e-14 * (to - from) {
        let full = h.min(longest).min(to - t);
        let scale = from_fn(|j| motion.max[j].abs().max(motion.min[j].abs()));
        let (next, error) = run.step(t, &motion.state, full, &scale);
        let growth = (0.9 * error.powf(-0.2)).clamp(0.2, 4.0);
        h = full * growth;
        if error > 1.0 {
            continue;
        }
        let (taken, next) = match run.switching(t + full, &next) {
            None => (full, next),
            Some(_) => run.bisected(t, &motion.state, full, &scale),
        };
        motion.widen(&run, t, taken, &next);
        t += taken;
        motion.state = next;
        if let Some(contact) = run.switching(t, &motion.state) {
            run.switch(t, &motion.state, contact);
            motion.word.push(spelt(&run.modes));
            h = 1e-3 * longest;
        }
    }
    motion
}

fn spelt<const C: usize>(modes: &Modes<C>) -> String {
    let letter = |mode: &i8| ["-", "s", "+"][(mode + 1) as usize];
    modes.iter().map(letter).collect()
}

impl<P: Plant<N, C>, const N: usize, const C: usize> Run<'_, P, N, C> {
    /// Contacts without speed stick if they can.
    fn begin(&mut self, t: f64, y: &[f64; N]) {
        let speeds = self.plant.speeds(y);
        self.modes = from_fn(|i| match self.plant.elastic(i, y) {
            None if speeds[i].abs() > 1e-13 => speeds[i].signum() as i8,
            _ => 0,
        });
        while let Some(contact) = self.switching(t, y) {
            self.switch(t, y, contact);
        }
    }

    /// The friction forces: of sticking contacts those that keep their speeds.
    fn friction(&self, t: f64, y: &[f64; N]) -> [f64; C] {
        let speeds = self.plant.speeds(y);
        let mut forces = from_fn(|i| match self.modes[i] {
            0 => self.plant.elastic(i, y).unwrap_or(0.0),
            mode => -f64::from(mode) * self.plant.slip(i, speeds[i].abs(), y),
        });
        let rigid = |&i: &usize| self.modes[i] == 0 && self.plant.elastic(i, y).is_none();
        let held: Vec<usize> = (0..C).filter(rigid).collect();
        let free = self.drift(t, y, &forces);
        let mut table: Vec<Vec<f64>> = held.iter().map(|&i| vec![-free[i]]).collect();
        for &j in &held {
            let mut pushed = forces;
            pushed[j] += 1.0;
            let drift = self.drift(t, y, &pushed);
            for (row, &i) in table.iter_mut().zip(&held) {
                row.insert(row.len() - 1, drift[i] - free[i]);
            }
        }
        for (&j, force) in held.iter().zip(solved(table)) {
            forces[j] = force;
        }
        forces
    }

    /// Rates of the relative speeds.
    fn drift(&self, t: f64, y: &[f64; N], friction: &[f64; C]) -> [f64; C] {
        let rate = self.plant.speeds(&self.plant.rate(t, y, friction));
        let zero = self.plant.speeds(&[0.0; N]);
        from_fn(|i| rate[i] - zero[i])
    }

    fn rate(&self, t: f64, y: &[f64; N]) -> [f64; N] {
        let rate = self.plant.rate(t, y, &self.friction(t, y));
        self.plant.sliding(rate, self.modes.map(|mode| mode != 0))
    }

    /// One step with its error over the tolerance.
    fn step(&self, t: f64, y: &[f64; N], h: f64, scale: &[f64; N]) -> ([f64; N], f64) {
        const A: [&[f64]; 6] = [
            &[1.0 / 5.0],
            &[3.0 / 40.0, 9.0 / 40.0],
            &[44.0 / 45.0, -56.0 / 15.0, 32.0 / 9.0],
            &[
                19372.0 / 6561.0,
                -25360.0 / 2187.0,
                64448.0 / 6561.0,
                -212.0 / 729.0,
            ],
            &[
                9017.0 / 3168.0,
                -355.0 / 33.0,
                46732.0 / 5247.0,
                49.0 / 176.0,
                -5103.0 / 18656.0,
            ],
            &[
                35.0 / 384.0,
                0.0,
                500.0 / 1113.0,
                125.0 / 192.0,
                -2187.0 / 6784.0,
                11.0 / 84.0,
            ],
        ];
        const C: [f64; 6] = [0.2, 0.3, 0.8, 8.0 / 9.0, 1.0, 1.0];
        const E: [f64; 7] = [
            71.0 / 57600.0,
            0.0,
            -71.0 / 16695.0,
            71.0 / 1920.0,
            -17253.0 / 339200.0,
            22.0 / 525.0,
            -1.0 / 40.0,
        ];
        let mut k = vec![self.rate(t, y)];
        let mut next = *y;
        for (row, c) in A.iter().zip(C) {
            next = from_fn(|j| y[j] + h * row.iter().zip(&k).map(|(a, k)| a * k[j]).sum::<f64>());
            k.push(self.rate(t + c * h, &next));
        }
        let off = |j: usize| h * E.iter().zip(&k).map(|(e, k)| e * k[j]).sum::<f64>();
        let size = |j: usize| self.tolerance * scale[j].max(next[j].abs()).max(1e-9);
        let error = (0..N)
            .map(|j| (off(j) / size(j)).abs())
            .fold(1e-9, f64::max);
        (next, error)
    }

    /// A contact that cannot go on as it does.
    fn switching(&self, t: f64, y: &[f64; N]) -> Option<usize> {
        let (speeds, forces) = (self.plant.speeds(y), self.friction(t, y));
        (0..C).find(|&i| match self.modes[i] {
            0 => forces[i].abs() > self.plant.stick(i, y) * (1.0 + 1e-13),
            mode => f64::from(mode) * speeds[i] < 0.0,
        })
    }

    /// The first part of a step up to just behind the first switch in it.
    fn bisected(&self, t: f64, y: &[f64; N], full: f64, scale: &[f64; N]) -> (f64, [f64; N]) {
        let (mut low, mut high) = (0.0, full);
        for _ in 0..60 {
            let middle = 0.5 * (low + high);
            let there = self.step(t, y, middle, scale).0;
            match self.switching(t + middle, &there) {
                Some(_) => high = middle,
                None => low = middle,
            }
        }
        (high, self.step(t, y, high, scale).0)
    }

    /// What the contact does next: a torn one slides against its force, one that came to rest sticks if it can.
    fn switch(&mut self, t: f64, y: &[f64; N], contact: usize) {
        let before = std::mem::replace(&mut self.modes[contact], 0);
        let force = self.friction(t, y)[contact];
        let limit = self.plant.stick(contact, y) * (1.0 + 1e-12);
        let torn = before == 0 || force.abs() > limit;
        self.modes[contact] = if torn { -force.signum() as i8 } else { 0 };
    }
}

impl<const N: usize> Motion<N> {
    /// Takes in the extrema of a step, by cubic interpolation.
    fn widen<P: Plant<N, C>, const C: usize>(
        &mut self,
        run: &Run<'_, P, N, C>,
        t: f64,
        h: f64,
        next: &[f64; N],
    ) {
        let (before, after) = (run.rate(t, &self.state), run.rate(t + h, next));
        for j in 0..N {
            let (a, b) = (self.state[j], next[j]);
            let (p, q) = (h * before[j], h * after[j]);
            let (c3, c2) = (p + q - 2.0 * (b - a), 3.0 * (b - a) - 2.0 * p - q);
            let root = (c2 * c2 - 3.0 * c3 * p).max(0.0).sqrt();
            let flat = [p / (-c2 - root), p / (-c2 + root)];
            let inside = flat.into_iter().filter(|s| (0.0..=1.0).contains(s));
            let values = inside.map(|s| a + s * (p + s * (c2 + s * c3)));
            for value in values.chain([b]) {
                self.min[j] = self.min[j].min(value);
                self.max[j] = self.max[j].max(value);
            }
        }
    }
}

/// Gauss's elimination of a table with its right-hand side as the last column.
pub fn solved(mut table: Vec<Vec<f64>>) -> Vec<f64> {
    let n = table.len();
    for i in 0..n {
        let pivot = (i..n).max_by(|&a, &b| table[a][i].abs().total_cmp(&table[b][i].abs()));
        table.swap(i, pivot.unwrap_or(i));
        let head = table[i].clone();
        for (r, row) in table.iter_mut().enumerate() {
            if r != i {
                let factor = row[i] / head[i];
                row.iter_mut()
                    .zip(&head)
                    .for_each(|(x, p)| *x -= factor * p);
            }
        }
    }
    (0..n).map(|i| table[i][n] / table[i][i]).collect()
}
