//! What an explicit step carries along: the state alone, or the state with its tangents.

use super::Propagator;
use super::control::{combined, ratio};
use super::dop853::Weights;
use crate::field::{Field, Work};

/// States from which on entries of a Jacobian are looked at before their row is multiplied: most are zero there, while
/// the products of a small one are done in the time of the question.
const SPARSE: usize = 8;

/// A point of the space in which an explicit method steps, and a slope in it.
///
/// With tangents the method differentiates its own step: Φ and ∂φ/∂r pass through the same stages as
/// the state, and come out as the exact derivatives of the discrete step.
pub trait Carried<const N: usize>: Copy {
    /// The zero slope.
    const NOTHING: Self;

    /// Adds `factor` times `slope`, but for what no slope reads.
    fn add(&mut self, factor: f64, slope: &Self);

    /// Adds to what no slope reads what a step of this length makes of it, by its weights of the slopes: no stage looks at it.
    fn total(&mut self, _length: f64, _weights: Weights, _slopes: &[Self]) {}

    /// The state.
    fn state(&self) -> &[f64; N];

    /// The state, to be corrected by rounding errors.
    fn state_mut(&mut self) -> &mut [f64; N];

    /// Puts the slope here into `slope`, and counts it in `work`: in place, as one with tangents is large and is made a
    /// thousand times a period.
    fn slope(&self, field: &impl Field<N>, work: &mut Work, slope: &mut Self);

    /// Whether a step that adds `length` times this slope turns a tangent by more than `share` of its own, in states of
    /// these sizes; there is none to turn without tangents.
    fn turns(&self, slope: &Self, length: f64, share: f64, sizes: &[f64; N]) -> bool;

    /// Errors of the tangents over what they are, combined from orders 5 and 3 as those of states are.
    fn strays(&self, fifth: &Self, third: &Self, sizes: &[f64; N]) -> f64;

    /// Whether every number is finite.
    fn is_finite(&self) -> bool;
}

impl<const N: usize> Carried<N> for [f64; N] {
    const NOTHING: Self = [0.0; N];

    #[inline]
    fn add(&mut self, factor: f64, slope: &Self) {
        for (y, k) in self.iter_mut().zip(slope) {
            *y += factor * k;
        }
    }

    #[inline]
    fn state(&self) -> &[f64; N] {
        self
    }

    #[inline]
    fn state_mut(&mut self) -> &mut [f64; N] {
        self
    }

    #[inline]
    fn slope(&self, field: &impl Field<N>, work: &mut Work, slope: &mut Self) {
        work.evaluations += 1;
        field.with_f(self, |f| *slope = f);
    }

    #[inline]
    fn turns(&self, _slope: &Self, _length: f64, _share: f64, _sizes: &[f64; N]) -> bool {
        false
    }

    #[inline]
    fn strays(&self, _fifth: &Self, _third: &Self, _sizes: &[f64; N]) -> f64 {
        0.0
    }

    #[inline]
    fn is_finite(&self) -> bool {
        self.iter().all(|y| y.is_finite())
    }
}

/// The squares of the lengths of the columns, each entry made comparable by the size of its state.
#[inline(always)]
fn lengths<const N: usize>(
    tangent: &[[f64; N]; N],
    comparable: impl Fn(usize, f64) -> f64,
) -> [f64; N] {
    let mut lengths = [0.0; N];
    for (i, row) in tangent.iter().enumerate() {
        for (length, entry) in lengths.iter_mut().zip(row) {
            *length += comparable(i, *entry).powi(2);
        }
    }
    lengths
}

/// A state with the derivatives of the motion that led to it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motion<const N: usize> {
    /// The state y.
    pub state: [f64; N],
    /// Φ = ∂y/∂y₀, row by row.
    pub tangent: [[f64; N]; N],
    /// p = ∂y/∂r.
    pub design: [f64; N],
    /// ∫ tr J dt.
    pub trace: f64,
}

impl<const N: usize> Motion<N> {
    /// A motion that begins here: Φ = I, p = 0.
    #[must_use]
    pub fn from(state: [f64; N]) -> Self {
        let mut motion = Self {
            state,
            ..Self::NOTHING
        };
        motion.restart();
        motion
    }

    /// This motion, continued by one step whose derivatives are known; the state is set apart.
    #[must_use]
    pub fn through(&self, step: &Propagator<N>) -> Self {
        let mut motion = Self {
            state: self.state,
            trace: self.trace + step.trace,
            ..Self::NOTHING
        };
        motion.design = step.design;
        motion.add_product(&step.state, self);
        motion
    }

    /// Adds `factor` times the derivatives of `motion` to these.
    #[inline(always)]
    fn add_product(&mut self, factor: &[[f64; N]; N], motion: &Self) {
        for (i, row) in factor.iter().enumerate() {
            if N < SPARSE {
                self.add_rows(i, 0, row, motion);
                continue;
            }
            let (fours, rest) = row.as_chunks::<4>();
            for (k, four) in fours.iter().enumerate() {
                match four.iter().filter(|entry| **entry != 0.0).count() {
                    0 => (),
                    1 | 2 => self.add_rows(i, 4 * k, four, motion),
                    _ => self.add_four(i, 4 * k, four, motion),
                }
            }
            self.add_rows(i, 4 * fours.len(), rest, motion);
        }
    }

    /// Adds to those of state i the derivatives of states from `first` on, so many times each.
    #[inline(always)]
    fn add_rows(&mut self, i: usize, first: usize, factors: &[f64], motion: &Self) {
        for (j, &entry) in (first..).zip(factors) {
            if N >= SPARSE && entry == 0.0 {
                continue;
            }
            self.tangent[i].add(entry, &motion.tangent[j]);
            self.design[i] += entry * motion.design[j];
        }
    }

    /// The same of four states at once: what they are added to is fetched once.
    #[inline(always)]
    fn add_four(&mut self, i: usize, first: usize, [a, b, c, d]: &[f64; 4], motion: &Self) {
        let [e, f, g, h] = crate::scalar::filled(|k: usize| &motion.tangent[first + k]);
        for (l, sum) in self.tangent[i].iter_mut().enumerate() {
            *sum += a * e[l] + b * f[l] + (c * g[l] + d * h[l]);
        }
        let [e, f, g, h] = crate::scalar::filled(|k: usize| motion.design[first + k]);
        self.design[i] += a * e + b * f + (c * g + d * h);
    }

    /// Sets Φ = I and leaves the rest.
    pub fn restart(&mut self) {
        self.tangent = crate::scalar::filled(|i| crate::scalar::filled(|j| f64::from(i == j)));
    }
}

impl<const N: usize> Carried<N> for Motion<N> {
    const NOTHING: Self = Self {
        state: [0.0; N],
        tangent: [[0.0; N]; N],
        design: [0.0; N],
        trace: 0.0,
    };

    #[inline]
    fn add(&mut self, factor: f64, slope: &Self) {
        self.state.add(factor, &slope.state);
        self.design.add(factor, &slope.design);
        for (row, k) in self.tangent.iter_mut().zip(&slope.tangent) {
            row.add(factor, k);
        }
    }

    #[inline]
    fn total(&mut self, length: f64, weights: Weights, slopes: &[Self]) {
        let traces = weights.iter().map(|&(j, weight)| weight * slopes[j].trace);
        self.trace += length * traces.fold(0.0, |sum, trace| sum + trace);
    }

    #[inline]
    fn state(&self) -> &[f64; N] {
        &self.state
    }

    #[inline]
    fn state_mut(&mut self) -> &mut [f64; N] {
        &mut self.state
    }

    /// Φ' = J Φ and p' = J p + f_r.
    #[inline]
    fn slope(&self, field: &impl Field<N>, work: &mut Work, slope: &mut Self) {
        work.linearisations += 1;
        field.with_linear(&self.state, |linear| {
            slope.state = linear.f;
            slope.design = linear.design;
            slope.trace = linear.trace();
            slope.tangent = Self::NOTHING.tangent;
            slope.add_product(&linear.jacobian, self);
        });
    }

    #[inline]
    fn turns(&self, slope: &Self, length: f64, share: f64, sizes: &[f64; N]) -> bool {
        // Of a comparison the last bit does not matter: divisions are as slow as the step's own formulas.
        let weights = sizes.map(f64::recip);
        let lengths = |tangent| lengths(tangent, |i, entry| entry * weights[i]);
        let (before, turned) = (lengths(&self.tangent), lengths(&slope.tangent));
        let (length, share) = (length * length, share * share);
        (turned.iter().zip(&before)).any(|(turned, before)| length * turned > share * before)
    }

    fn strays(&self, fifth: &Self, third: &Self, sizes: &[f64; N]) -> f64 {
        let lengths = |tangent| lengths(tangent, |i, entry| entry / sizes[i]);
        let before = lengths(&self.tangent);
        let (fifth, third) = (lengths(&fifth.tangent), lengths(&third.tangent));
        let stray = |j: usize| ratio(combined(fifth[j], third[j], 1), before[j].sqrt());
        (0..N).map(stray).fold(0.0, f64::max)
    }

    fn is_finite(&self) -> bool {
        self.state.is_finite()
            && self.design.is_finite()
            && self.trace.is_finite()
            && self.tangent.iter().all(Carried::is_finite)
    }
}
