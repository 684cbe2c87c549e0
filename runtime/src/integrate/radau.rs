//! Radau IIA: full Newton on exact stage Jacobians, kinematic rows eliminated, and the exact
//! derivative of the discrete step from one more solve with the last factorisation.

use super::collocation::Collocation;
use super::look::Look;
use super::lu::Lu;
use super::tableau::Tableau;
use super::{IntegrationError, Propagator, Tolerance};
use crate::field::{Field, Linear, Work};
use std::marker::PhantomData;

const NEWTON_ITERATIONS: usize = 9;
/// What Newton may leave undone of the tolerated error.
const NEWTON_REST: f64 = 3e-3;
/// Size of the corrections that rounding keeps alive, relative to a component.
const ROUNDING: f64 = 2.0 * f64::EPSILON;
const SAFETY: f64 = 0.85;
const SHRINK: f64 = 0.15;
const GROW: f64 = 6.0;

/// An implicit integrator under way along one motion.
#[derive(Debug)]
pub struct Radau<'f, F, const N: usize, const S: usize> {
    field: &'f F,
    tableau: &'static Tableau<S>,
    tolerance: Tolerance,
    time: f64,
    state: [f64; N],
    start: Linear<N>,
    departure: Linear<N>,
    next: f64,
    before: Option<Before<N, S>>,
    rejected: bool,
    last: Trial<N, S>,
    budget: u64,
    /// Counted work.
    pub work: Work,
}

/// What the step before leaves for the next one.
#[derive(Debug, Clone, Copy)]
struct Before<const N: usize, const S: usize> {
    step: f64,
    error: f64,
    collocation: Collocation<N, S>,
}

/// An accepted step.
#[derive(Debug, Clone, Copy)]
pub struct Accepted<const N: usize, const S: usize> {
    /// Time at its beginning.
    pub time: f64,
    /// Its length.
    pub step: f64,
    /// State at its beginning.
    pub start: [f64; N],
    /// State at its end.
    pub end: [f64; N],
    /// Increment in between.
    pub collocation: Collocation<N, S>,
}

/// The solved stages of one step.
#[derive(Debug, Clone, Copy)]
struct Trial<const N: usize, const S: usize> {
    step: f64,
    start: [f64; N],
    increments: [[f64; N]; S],
    linear: [Linear<N>; S],
    correction: [f64; N],
    lu: Lu<N, S>,
    iterations: usize,
}

/// What a step meets.
#[expect(clippy::large_enum_variant, reason = "a step allocates nothing")]
enum Kink<const N: usize, const S: usize> {
    /// No kink of the field.
    None,
    /// A kink, at which this shorter step ends.
    At(Trial<N, S>),
    /// A kink at about this fraction, to which no step leads: the step has jumped something.
    Missed(f64),
}

/// Which rows Newton solves for, and which follow from ẏᵢ = yⱼ.
struct Layout<F, const N: usize>(PhantomData<F>);

impl<F: Field<N>, const N: usize> Layout<F, N> {
    const KINEMATIC: [Option<usize>; N] = eliminable(F::KINEMATIC);
    const SOLVED: ([usize; N], usize) = remaining(Self::KINEMATIC);

    fn solved() -> &'static [usize] {
        let (rows, count) = const { &Self::SOLVED };
        &rows[..*count]
    }
}

/// Rows whose source is not itself eliminated.
const fn eliminable<const N: usize>(mut rows: [Option<usize>; N]) -> [Option<usize>; N] {
    let mut i = 0;
    while i < N {
        if let Some(source) = rows[i]
            && (source >= N || source == i || rows[source].is_some())
        {
            rows[i] = None;
        }
        i += 1;
    }
    rows
}

const fn remaining<const N: usize>(rows: [Option<usize>; N]) -> ([usize; N], usize) {
    let (mut solved, mut count, mut i) = ([0; N], 0, 0);
    while i < N {
        if rows[i].is_none() {
            solved[count] = i;
            count += 1;
        }
        i += 1;
    }
    (solved, count)
}

impl<'f, F: Field<N>, const N: usize, const S: usize> Radau<'f, F, N, S> {
    /// Sets out from `state`; `step` is a first step to try, or 0 to have one chosen.
    ///
    /// # Errors
    /// The field is not finite at `state`.
    pub fn new(
        field: &'f F,
        tableau: &'static Tableau<S>,
        tolerance: Tolerance,
        state: [f64; N],
        step: f64,
        budget: u64,
    ) -> Result<Self, IntegrationError> {
        let start = field.linearise(&state);
        if !start.f.iter().all(|component| component.is_finite()) {
            return Err(IntegrationError::NotFinite {
                time: 0.0,
                state: state.to_vec(),
            });
        }
        let next = if step > 0.0 {
            step
        } else {
            first_step(&start, &field.scale(&state, &tolerance), S)
        };
        Ok(Self {
            field,
            tableau,
            tolerance,
            time: 0.0,
            state,
            start,
            departure: start,
            next,
            before: None,
            rejected: false,
            last: Trial::blank(state, start),
            budget,
            work: Work {
                linearisations: 1,
                ..Work::default()
            },
        })
    }

    /// Time from the beginning.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.time
    }

    /// State reached.
    #[must_use]
    pub fn state(&self) -> [f64; N] {
        self.state
    }

    /// The field where the motion has arrived.
    #[must_use]
    pub fn linear(&self) -> &Linear<N> {
        &self.start
    }

    /// The step size that would be tried next.
    #[must_use]
    pub fn next_step(&self) -> f64 {
        self.next
    }

    /// Makes one step that ends at `end` at the latest, and on a kink of the field if it meets one.
    ///
    /// # Errors
    /// See [`IntegrationError`].
    pub fn step(&mut self, end: f64) -> Result<Accepted<N, S>, IntegrationError> {
        loop {
            let rest = end - self.time;
            let mut step = fitting(self.next, rest);
            if self.work.steps + self.work.rejected >= self.budget {
                return Err(
                    self.stuck(|steps, time, state| IntegrationError::TooManySteps {
                        steps,
                        time,
                        state,
                    }),
                );
            }
            if step <= 4.0 * f64::EPSILON * self.time.abs().max(f64::MIN_POSITIVE) {
                return Err(IntegrationError::StepTooSmall {
                    time: self.time,
                    step,
                    state: self.state.to_vec(),
                });
            }
            let guess = self.predict(step);
            let Some(mut trial) = self.solve(step, guess) else {
                self.reject(0.3 * step);
                continue;
            };
            let error = self.error(&trial);
            if !(error <= 1.0) {
                self.reject(
                    step * (SAFETY * error.powf(-1.0 / (S as f64 + 1.0))).clamp(SHRINK, 0.9),
                );
                continue;
            }
            if self.field.leaps(&trial.start, &trial.end()) {
                self.reject(0.3 * step);
                continue;
            }
            let mut collocation = Collocation::new(self.tableau, &trial.increments);
            match self.stop_at_kink(&trial, &collocation) {
                Kink::None => {}
                Kink::At(shorter) => {
                    trial = shorter;
                    step = trial.step;
                    collocation = Collocation::new(self.tableau, &trial.increments);
                }
                Kink::Missed(theta) => {
                    self.reject(step * (0.7 * theta).clamp(0.01, 0.7));
                    continue;
                }
            }
            return Ok(self.accept(trial, collocation, error, step, end));
        }
    }

    fn stuck(
        &self,
        error: impl FnOnce(u64, f64, Vec<f64>) -> IntegrationError,
    ) -> IntegrationError {
        error(self.work.steps, self.time, self.state.to_vec())
    }

    fn reject(&mut self, shorter: f64) {
        self.work.rejected += 1;
        self.rejected = true;
        self.next = if shorter.is_finite() {
            shorter
        } else {
            0.1 * self.next
        };
    }

    fn accept(
        &mut self,
        trial: Trial<N, S>,
        collocation: Collocation<N, S>,
        error: f64,
        step: f64,
        end: f64,
    ) -> Accepted<N, S> {
        let accepted = Accepted {
            time: self.time,
            step,
            start: self.state,
            end: trial.end(),
            collocation,
        };
        let grown = self.grow(error, step, trial.iterations);
        self.next = if step < self.next && trial.step == step {
            self.next.max(grown.min(GROW * step))
        } else {
            grown
        };
        self.before = Some(Before {
            step,
            error: error.max(1e-2),
            collocation,
        });
        self.rejected = false;
        self.work.steps += 1;
        self.time = if self.time + step >= end - 4.0 * f64::EPSILON * end.abs() {
            end
        } else {
            self.time + step
        };
        self.state = accepted.end;
        self.departure = self.start;
        self.start = trial.arrival();
        self.last = trial;
        accepted
    }

    /// Gustafsson's predictive controller, as in Hairer & Wanner II, section IV.8.
    fn grow(&self, error: f64, step: f64, iterations: usize) -> f64 {
        let order = S as f64 + 1.0;
        let effort = SAFETY * (2 * NEWTON_ITERATIONS + 1) as f64
            / (2 * NEWTON_ITERATIONS + iterations) as f64;
        let error = error.max(1e-9);
        let mut factor = effort * error.powf(-1.0 / order);
        if let Some(before) = &self.before {
            let trend = step / before.step * (before.error / (error * error)).powf(1.0 / order);
            factor = factor.min(effort * trend);
        }
        step * factor.clamp(SHRINK, if self.rejected { 1.0 } else { GROW })
    }

    /// The polynomial of the step before, continued.
    fn predict(&self, step: f64) -> [[f64; N]; S] {
        let nodes = &self.tableau.nodes;
        match &self.before {
            Some(before) => {
                let ratio = step / before.step;
                let end = before.collocation.at(1.0);
                std::array::from_fn(|i| {
                    let value = before.collocation.at(1.0 + nodes[i] * ratio);
                    std::array::from_fn(|j| value[j] - end[j])
                })
            }
            None => std::array::from_fn(|i| self.start.f.map(|slope| step * nodes[i] * slope)),
        }
    }

    /// Newton on the stage system; `None` if it does not converge.
    fn solve(&mut self, step: f64, guess: [[f64; N]; S]) -> Option<Trial<N, S>> {
        let mut trial = Trial::blank(self.state, self.start);
        trial.step = step;
        trial.increments = guess;
        self.follow_kinematics(&mut trial);
        let scale = self.scale(&trial.end());
        let mut before = f64::INFINITY;
        for iteration in 1..=NEWTON_ITERATIONS {
            for i in 0..S {
                trial.linear[i] = self
                    .field
                    .linearise(&add(&trial.start, &trial.increments[i]));
            }
            self.work.linearisations += S as u64;
            self.work.factorisations += 1;
            if !self.assemble(&mut trial) {
                return None;
            }
            let size = self.correct(&mut trial, &scale);
            if !size.is_finite() || (iteration > 2 && size > 2.0 * before) {
                return None;
            }
            let rate = if before.is_finite() {
                (size / before).min(1.0)
            } else {
                1.0
            };
            trial.iterations = iteration;
            if size * rate <= NEWTON_REST || size <= 1e-2 * NEWTON_REST {
                return Some(trial);
            }
            before = size;
        }
        None
    }

    /// What errors are measured against at `y`, never below what its digits resolve.
    fn scale(&self, y: &[f64; N]) -> [f64; N] {
        let scale = self.field.scale(y, &self.tolerance);
        std::array::from_fn(|j| scale[j].max(ROUNDING / NEWTON_REST * y[j].abs()))
    }

    /// I − h A∘J with the kinematic rows eliminated; false if it is singular.
    fn assemble(&self, trial: &mut Trial<N, S>) -> bool {
        let (solved, h, a) = (Layout::<F, N>::solved(), trial.step, &self.tableau.matrix);
        let width = solved.len();
        trial.lu = Lu::zero(S * width);
        for i in 0..S {
            for (d, &row) in solved.iter().enumerate() {
                let out = trial.lu.row(i * width + d);
                for j in 0..S {
                    let slopes = &trial.linear[j].jacobian[row];
                    for (c, &column) in solved.iter().enumerate() {
                        out[j * width + c] -= h * a[i][j] * slopes[column];
                    }
                    for (eliminated, source) in kinematic::<F, N>() {
                        let weight = h * h * a[i][j] * slopes[eliminated];
                        if weight != 0.0 {
                            let c = position(solved, source);
                            for k in 0..S {
                                out[k * width + c] -= weight * a[j][k];
                            }
                        }
                    }
                }
                out[i * width + d] += 1.0;
            }
        }
        trial.lu.factorise()
    }

    /// One Newton correction; returns its size relative to what is tolerated.
    fn correct(&self, trial: &mut Trial<N, S>, scale: &[f64; N]) -> f64 {
        let (solved, h, a) = (Layout::<F, N>::solved(), trial.step, &self.tableau.matrix);
        let width = solved.len();
        let mut right = [[0.0; N]; S];
        let flat = right.as_flattened_mut();
        for i in 0..S {
            for (d, &row) in solved.iter().enumerate() {
                let sum: f64 = (0..S).map(|j| a[i][j] * trial.linear[j].f[row]).sum();
                flat[i * width + d] = h * sum - trial.increments[i][row];
            }
        }
        trial.lu.solve(flat);
        let mut largest = 0.0_f64;
        for i in 0..S {
            for (d, &row) in solved.iter().enumerate() {
                let correction = flat[i * width + d];
                trial.increments[i][row] += correction;
                let beyond = correction.abs() / scale[row];
                // `max` would hide a NaN.
                largest = if beyond > largest || beyond.is_nan() {
                    beyond
                } else {
                    largest
                };
            }
        }
        let old = trial.increments[S - 1];
        self.follow_kinematics(trial);
        let new = trial.increments[S - 1];
        trial.correction = std::array::from_fn(|j| new[j] - old[j]);
        for (d, &row) in solved.iter().enumerate() {
            trial.correction[row] = flat[(S - 1) * width + d];
        }
        largest
    }

    /// Stage increments of the eliminated rows: h A (y₀ⱼ + Zⱼ).
    fn follow_kinematics(&self, trial: &mut Trial<N, S>) {
        for (eliminated, source) in kinematic::<F, N>() {
            for i in 0..S {
                let row = &self.tableau.matrix[i];
                let sum: f64 = (0..S)
                    .map(|j| row[j] * (trial.start[source] + trial.increments[j][source]))
                    .sum();
                trial.increments[i][eliminated] = trial.step * sum;
            }
        }
    }

    /// Estimated local error relative to what is tolerated.
    fn error(&mut self, trial: &Trial<N, S>) -> f64 {
        let end = trial.end();
        let scale = self.scale(&end);
        let (start, arrival) = (self.start, trial.linear[S - 1]);
        let estimate = self.filtered(trial, &start.f, &start.jacobian);
        let size = |error: &[f64; N]| {
            (0..N).fold(0.0_f64, |largest, j| {
                let relative = error[j].abs() / scale[j];
                if relative > largest || relative.is_nan() {
                    relative
                } else {
                    largest
                }
            })
        };
        // A stiff start damps the estimate even of a step that jumps out of its layer; the end then is not stiff.
        let unstiff = size(&self.filtered(trial, &start.f, &arrival.jacobian));
        let first = size(&estimate).max(unstiff);
        if first <= 1.0 || !(self.rejected || self.before.is_none()) {
            return first;
        }
        self.work.evaluations += 1;
        let slope = self.field.f(&add(&self.state, &estimate));
        size(&self.filtered(trial, &slope, &start.jacobian))
            .max(unstiff)
            .min(first)
    }

    /// (I − γhJ)⁻¹ (γ h f + Σ eᵢ Zᵢ).
    fn filtered(
        &self,
        trial: &Trial<N, S>,
        slope: &[f64; N],
        jacobian: &[[f64; N]; N],
    ) -> [f64; N] {
        let (solved, shift) = (Layout::<F, N>::solved(), trial.step * self.tableau.gamma);
        let mut error: [f64; N] = std::array::from_fn(|j| {
            let stages: f64 = (0..S)
                .map(|i| self.tableau.error[i] * trial.increments[i][j])
                .sum();
            shift * slope[j] + stages
        });
        let mut lu = Lu::<N, 1>::zero(solved.len());
        let mut right = [0.0; N];
        for (d, &row) in solved.iter().enumerate() {
            let slopes = &jacobian[row];
            right[d] = error[row];
            let out = lu.row(d);
            for (c, &column) in solved.iter().enumerate() {
                out[c] = f64::from(c == d) - shift * slopes[column];
            }
            for (eliminated, source) in kinematic::<F, N>() {
                out[position(solved, source)] -= shift * shift * slopes[eliminated];
                right[d] += shift * slopes[eliminated] * error[eliminated];
            }
        }
        if !lu.factorise() {
            return [f64::NAN; N];
        }
        lu.solve(&mut right);
        for (d, &row) in solved.iter().enumerate() {
            error[row] = right[d];
        }
        for (eliminated, source) in kinematic::<F, N>() {
            error[eliminated] += shift * error[source];
        }
        error
    }

    /// Looks for the first kink of the field inside a step.
    fn stop_at_kink(&mut self, trial: &Trial<N, S>, collocation: &Collocation<N, S>) -> Kink<N, S> {
        let (start, end) = (trial.start, trial.end());
        let mut first: Option<(f64, usize)> = None;
        for index in 0..self.field.kinks() {
            let (a, b) = (self.field.kink(index, &start), self.field.kink(index, &end));
            if a.abs() > KINK_REACHED && a * b < 0.0 {
                let theta = bisect(
                    |theta| self.field.kink(index, &add(&start, &collocation.at(theta))),
                    a,
                );
                if first.is_none_or(|(earliest, _)| theta < earliest) {
                    first = Some((theta, index));
                }
            }
        }
        let Some((theta, index)) = first else {
            return Kink::None;
        };
        match self.locate_kink(trial, collocation, theta, index) {
            Some(shorter) => Kink::At(shorter),
            None => Kink::Missed(theta),
        }
    }

    /// The step to kink number `index`, which the polynomial sees at `theta`.
    fn locate_kink(
        &mut self,
        trial: &Trial<N, S>,
        collocation: &Collocation<N, S>,
        theta: f64,
        index: usize,
    ) -> Option<Trial<N, S>> {
        let along = |theta: f64| add(&trial.start, &collocation.at(theta));
        let mut shorter = self.solve_within(trial, collocation, theta)?;
        // One secant step on the step map; the polynomial supplies the slope.
        let value = self.field.kink(index, &shorter.end());
        let nearby = self.field.kink(index, &along(theta * (1.0 - 1e-4)));
        let slope = (self.field.kink(index, &along(theta)) - nearby) / (1e-4 * theta);
        let better = theta - value / slope;
        if value.abs() > KINK_REACHED && better > 0.0 && better < 1.0 {
            shorter = self.solve_within(trial, collocation, better)?;
        }
        // The stage equations have other solutions that leave a layer at once; they fail here.
        let reached = self.field.kink(index, &shorter.end()).abs() <= KINK_MISSED;
        (reached && self.error(&shorter) <= 1.0).then_some(shorter)
    }

    /// The step map from the same start over the fraction `theta` of a solved step.
    fn solve_within(
        &mut self,
        trial: &Trial<N, S>,
        collocation: &Collocation<N, S>,
        theta: f64,
    ) -> Option<Trial<N, S>> {
        let guess = self.tableau.nodes.map(|node| collocation.at(theta * node));
        self.solve(theta * trial.step, guess)
    }

    /// State and field at the fraction `theta` of the last accepted step, by the step map itself.
    #[must_use]
    pub fn probe(
        &mut self,
        accepted: &Accepted<N, S>,
        theta: f64,
    ) -> Option<([f64; N], Linear<N>)> {
        let arrived = (self.state, self.start);
        (self.state, self.start) = (accepted.start, self.departure);
        let last = self.last;
        let trial = self
            .solve_within(&last, &accepted.collocation, theta)
            .filter(|trial| self.error(trial) <= 1.0);
        (self.state, self.start) = arrived;
        trial.map(|trial| (trial.end(), trial.arrival()))
    }

    /// The stages of the last accepted step, its beginning first: where the sign of a slope can be read off.
    pub(crate) fn looks(
        &self,
        accepted: &Accepted<N, S>,
    ) -> impl Iterator<Item = Look<N>> + Clone + use<'f, F, N, S> {
        let beginning = Look {
            theta: 0.0,
            state: accepted.start,
            linear: self.departure,
        };
        let (nodes, start) = (self.tableau.nodes, accepted.start);
        let (increments, linear) = (self.last.increments, self.last.linear);
        let stages = (0..S).map(move |i| Look {
            theta: nodes[i],
            state: add(&start, &increments[i]),
            linear: linear[i],
        });
        std::iter::once(beginning).chain(stages)
    }

    /// The exact derivative of the last accepted step with respect to its start, the design variable and its length.
    #[must_use]
    pub fn propagator(&self) -> Propagator<N> {
        let mut propagator = Propagator::IDENTITY;
        for column in 0..N {
            let mut direction = [0.0; N];
            direction[column] = 1.0;
            let end = self.transport(&direction, 0.0, 0.0);
            for row in 0..N {
                propagator.state[row][column] = end[row];
            }
        }
        propagator.design = self.transport(&[0.0; N], 1.0, 0.0);
        propagator.time = self.transport(&[0.0; N], 0.0, 1.0);
        let quadrature = &self.tableau.matrix[S - 1];
        propagator.trace = self.last.step
            * (0..S)
                .map(|i| quadrature[i] * self.last.linear[i].trace())
                .sum::<f64>();
        propagator
    }

    /// ∫ J dt over the last accepted step.
    #[must_use]
    pub fn growth(&self) -> [[f64; N]; N] {
        let weights = &self.tableau.matrix[S - 1];
        let entry = |row: usize, column: usize| -> f64 {
            (0..S)
                .map(|i| weights[i] * self.last.linear[i].jacobian[row][column])
                .sum()
        };
        std::array::from_fn(|row| std::array::from_fn(|column| self.last.step * entry(row, column)))
    }

    /// Differentiates the stage equations along (δy₀, δr, δh) and returns δy₁.
    fn transport(&self, start: &[f64; N], design: f64, length: f64) -> [f64; N] {
        let (trial, solved, a) = (&self.last, Layout::<F, N>::solved(), &self.tableau.matrix);
        let (h, width, nodes) = (trial.step, solved.len(), &self.tableau.nodes);
        // Stage velocities of the eliminated rows' sources, for the part that is known beforehand.
        let known: [[f64; N]; S] = std::array::from_fn(|j| {
            let mut stage = *start;
            for (eliminated, source) in kinematic::<F, N>() {
                stage[eliminated] += h * nodes[j] * start[source];
                stage[eliminated] += length * trial.increments[j][eliminated] / h;
            }
            stage
        });
        let slope: [[f64; N]; S] = std::array::from_fn(|j| {
            let linear = &trial.linear[j];
            std::array::from_fn(|row| {
                dot(&linear.jacobian[row], &known[j]) + linear.design[row] * design
            })
        });
        let mut right = [[0.0; N]; S];
        let flat = right.as_flattened_mut();
        for i in 0..S {
            for (d, &row) in solved.iter().enumerate() {
                let sum: f64 = (0..S).map(|j| a[i][j] * slope[j][row]).sum();
                flat[i * width + d] = h * sum + length * trial.increments[i][row] / h;
            }
        }
        trial.lu.solve(flat);
        let mut end = known[S - 1];
        for (d, &row) in solved.iter().enumerate() {
            end[row] = start[row] + flat[(S - 1) * width + d];
        }
        for (eliminated, source) in kinematic::<F, N>() {
            let c = position(solved, source);
            end[eliminated] += h
                * (0..S)
                    .map(|j| a[S - 1][j] * flat[j * width + c])
                    .sum::<f64>();
        }
        end
    }
}

/// A kink function this small means that the kink is reached; this large, that it was missed.
const KINK_REACHED: f64 = 1e-7;
const KINK_MISSED: f64 = 1e-4;

impl<const N: usize, const S: usize> Trial<N, S> {
    fn blank(start: [f64; N], linear: Linear<N>) -> Self {
        Self {
            step: 0.0,
            start,
            increments: [[0.0; N]; S],
            linear: [linear; S],
            correction: [0.0; N],
            lu: Lu::zero(0),
            iterations: 0,
        }
    }

    fn end(&self) -> [f64; N] {
        add(&self.start, &self.increments[S - 1])
    }

    /// The field at the end: that of the last iterate, moved by the last correction.
    fn arrival(&self) -> Linear<N> {
        let mut linear = self.linear[S - 1];
        for i in 0..N {
            linear.f[i] += dot(&linear.jacobian[i], &self.correction);
        }
        linear
    }
}

/// The step to try where `rest` is left: never one that would leave a splinter.
fn fitting(step: f64, rest: f64) -> f64 {
    if step >= rest {
        rest
    } else if 2.0 * step > rest {
        0.5 * rest
    } else {
        step
    }
}

/// Pairs (eliminated row, the state it equals).
fn kinematic<F: Field<N>, const N: usize>() -> impl Iterator<Item = (usize, usize)> {
    let rows = const { &Layout::<F, N>::KINEMATIC };
    rows.iter()
        .enumerate()
        .filter_map(|(row, source)| source.map(|source| (row, source)))
}

fn position(solved: &[usize], state: usize) -> usize {
    solved.iter().position(|&row| row == state).unwrap_or(0)
}

/// Where along [0, 1] a function that starts at `from` ≠ 0 and ends with the other sign vanishes.
fn bisect(value: impl Fn(f64) -> f64, from: f64) -> f64 {
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..40 {
        let middle = 0.5 * (low + high);
        if value(middle) * from > 0.0 {
            low = middle
        } else {
            high = middle
        }
    }
    0.5 * (low + high)
}

/// A step small enough for the first error test to be meaningful.
fn first_step<const N: usize>(linear: &Linear<N>, scale: &[f64; N], stages: usize) -> f64 {
    let rate = (0..N).fold(1e-300_f64, |rate, j| rate.max(linear.f[j].abs() / scale[j]));
    (rate.recip().powf(1.0 / stages as f64) * 1e-1).clamp(1e-14, 1.0)
}

fn add<const N: usize>(a: &[f64; N], b: &[f64; N]) -> [f64; N] {
    std::array::from_fn(|j| a[j] + b[j])
}

fn dot<const N: usize>(a: &[f64; N], b: &[f64; N]) -> f64 {
    (0..N).map(|j| a[j] * b[j]).sum()
}
