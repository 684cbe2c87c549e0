//! Fields that are linear but for the phase of a drive.

use std::f64::consts::{FRAC_PI_2, PI};

use super::Field;
use super::form::wave;
use super::strip::Strip;
use crate::scalar::{dot, mapped};

/// ẏ = A y + C w with w = (1, cos φ, sin φ), where φ̇ = ω is one of the states, and its derivatives by the design variable.
///
/// Without a drive ω = 0, and only the first column of C counts.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct LinearField<const N: usize> {
    /// A and C.
    own: Parts<N>,
    /// Their derivatives ∂/∂r, if there is a design variable.
    along: Option<Parts<N>>,
    /// Place of φ.
    phase: Option<usize>,
}

/// A, C and ω.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Parts<const N: usize> {
    matrix: [Strip<N>; N],
    forcing: [[f64; 3]; N],
    rate: f64,
}

/// A vector and its wave, or their derivatives of some order.
pub(crate) type Point<const N: usize> = ([f64; N], [f64; 3]);

impl<const N: usize> LinearField<N> {
    /// The parts of a field that is known to be linear; `units` are usual magnitudes of the states.
    ///
    /// `None` if they are no numbers.
    pub(crate) fn of(
        field: &impl Field<N>,
        phase: Option<usize>,
        units: &[f64; N],
        design: bool,
    ) -> Option<Self> {
        let still = field.linearise(&[0.0; N]);
        let turned = |angle| {
            let phase = phase?;
            let state = crate::scalar::filled(|i| if i == phase { angle } else { 0.0 });
            Some(field.linearise(&state))
        };
        let [quarter, half] = mapped(&[FRAC_PI_2, PI], |angle| turned(angle).unwrap_or(still));
        let at = [still, quarter, half];
        let mut matrix = at[0].jacobian;
        if let Some(phase) = phase {
            matrix.iter_mut().for_each(|row| row[phase] = 0.0);
        }
        let own = Parts::new(matrix, mapped(&at, |linear| linear.f), phase);
        let along = design.then(|| {
            let mut slopes = [[0.0; N]; N];
            for column in (0..N).filter(|&column| Some(column) != phase) {
                let mut moved = [0.0; N];
                moved[column] = units[column];
                let moved = field.linearise(&moved).design;
                for (row, slope) in slopes.iter_mut().enumerate() {
                    slope[column] = (moved[row] - at[0].design[row]) / units[column];
                }
            }
            Parts::new(slopes, mapped(&at, |linear| linear.design), phase)
        });
        let finite = own.is_finite() && along.is_none_or(|along| along.is_finite());
        finite.then_some(Self { own, along, phase })
    }

    /// A bound of how fast the motion turns, grows and decays: |A⁸|^(1/8), or ω if that is faster.
    ///
    /// The power makes it the rate of the fastest motion, whatever the units, and zero where A does nothing but shift.
    pub(crate) fn fastest(&self) -> f64 {
        let size = |matrix: &[[f64; N]; N]| {
            let sums = matrix.iter().map(|row| row.iter().map(|a| a.abs()).sum());
            sums.fold(0.0, f64::max)
        };
        let matrix = mapped(&self.own.matrix, |row| *row.entries());
        let unit = size(&matrix);
        if unit == 0.0 {
            return self.own.rate.abs();
        }
        let mut power = mapped(&matrix, |row| mapped(&row, |a| a / unit));
        for _ in 0..3 {
            power = squared(&power);
        }
        (unit * size(&power).sqrt().sqrt().sqrt()).max(self.own.rate.abs())
    }

    /// tr A.
    pub(crate) fn trace(&self) -> f64 {
        (0..N).map(|i| self.own.matrix[i].entries()[i]).sum()
    }

    /// The wave at a state.
    pub(crate) fn wave(&self, state: &[f64; N]) -> [f64; 3] {
        let (sin, cos) = self
            .phase
            .map_or((0.0, 1.0), |phase| state[phase].sin_cos());
        [1.0, cos, sin]
    }

    /// Factors of the wave so much later as factors of the wave now, and their derivatives by the design variable.
    pub(crate) fn turned(&self, later: &[f64; 3], time: f64) -> ([f64; 3], [f64; 3]) {
        let (sin, cos) = (self.own.rate * time).sin_cos();
        let (a, b) = (
            later[1] * cos + later[2] * sin,
            later[2] * cos - later[1] * sin,
        );
        let slope = self.along.as_ref().map_or(0.0, |along| along.rate * time);
        ([later[0], a, b], [0.0, slope * b, -slope * a])
    }

    /// Place of the phase, and the derivative of the wave by it.
    pub(crate) fn turn(&self, wave: &[f64; 3]) -> Option<(usize, [f64; 3])> {
        self.phase.map(|phase| (phase, [0.0, -wave[2], wave[1]]))
    }

    /// ω.
    pub(crate) fn rate(&self) -> f64 {
        self.own.rate
    }

    /// Whether there is a drive.
    pub(crate) fn is_driven(&self) -> bool {
        self.phase.is_some()
    }

    /// Whether there is a design variable.
    pub(crate) fn is_designed(&self) -> bool {
        self.along.is_some()
    }

    /// Whether A depends on it.
    pub(crate) fn bends(&self) -> bool {
        let bends = |along: &Parts<N>| {
            along
                .matrix
                .iter()
                .flat_map(Strip::entries)
                .any(|a| *a != 0.0)
        };
        self.along.as_ref().is_some_and(bends)
    }

    /// f at a state.
    pub(crate) fn f(&self, state: &[f64; N]) -> [f64; N] {
        self.own.along(1.0, &(*state, self.wave(state))).0
    }

    /// The magnitude of the terms of f: what its rounding errors are measured against.
    pub(crate) fn terms(&self, (state, wave): &Point<N>) -> [f64; N] {
        crate::scalar::filled(|i| {
            let own = self.own.matrix[i].iter().map(|(j, a)| a * state[j]);
            let forced = self.own.forcing[i].iter().zip(wave);
            let terms = own.chain(forced.map(|(c, w)| c * w));
            terms.map(f64::abs).sum()
        })
    }

    /// The derivative of a point by the time, times a factor.
    #[inline]
    pub(crate) fn next(&self, factor: f64, point: &Point<N>) -> Point<N> {
        self.own.along(factor, point)
    }

    /// The same of the derivative of a point by the design variable.
    #[inline]
    pub(crate) fn next_design(&self, factor: f64, design: &Point<N>, point: &Point<N>) -> Point<N> {
        let mut next = self.own.along(factor, design);
        if let Some(along) = &self.along {
            let more = along.along(factor, point);
            for (sum, term) in next.0.iter_mut().zip(more.0) {
                *sum += term;
            }
            for (sum, term) in next.1.iter_mut().zip(more.1) {
                *sum += term;
            }
        }
        next
    }
}

impl<const N: usize> Parts<N> {
    /// From the values at the angles 0, π/2 and π of the phase.
    fn new(matrix: [[f64; N]; N], at: [[f64; N]; 3], phase: Option<usize>) -> Self {
        let waves = |i: usize| wave(mapped(&at, |f| f[i]), phase.is_some());
        Self {
            matrix: matrix.map(Strip::of_matrix),
            forcing: crate::scalar::filled(waves),
            rate: phase.map_or(0.0, |phase| at[0][phase]),
        }
    }

    fn is_finite(&self) -> bool {
        let numbers = self.matrix.iter().flat_map(Strip::entries);
        let numbers = numbers.chain(self.forcing.iter().flatten());
        numbers.chain([&self.rate]).all(|number| number.is_finite())
    }

    #[inline(always)]
    fn along(&self, factor: f64, (state, wave): &Point<N>) -> Point<N> {
        let mut rates = [0.0; N];
        for ((rate, row), forcing) in rates.iter_mut().zip(&self.matrix).zip(&self.forcing) {
            *rate = factor * (dot(forcing, wave) + row.dot(state));
        }
        let turn = factor * self.rate;
        (rates, [0.0, -turn * wave[2], turn * wave[1]])
    }
}

fn squared<const N: usize>(matrix: &[[f64; N]; N]) -> [[f64; N]; N] {
    mapped(matrix, |row| {
        let mut sum = [0.0; N];
        for (a, other) in row.iter().zip(matrix).filter(|(a, _)| **a != 0.0) {
            for (s, b) in sum.iter_mut().zip(other) {
                *s += a * b;
            }
        }
        sum
    })
}
