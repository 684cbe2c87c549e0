//! Local extrema of every state: located like events, not read off stored samples.

use super::steps::Steps;
use crate::flow::extrema::{FLAT, in_order};
use crate::flow::{Extremum, Peaks, strobes};
use crate::integrate::Dense;
use crate::integrate::event::Bernstein;
use crate::model::Model;
use crate::scalar::mapped;

/// Relative length of a Newton step after which the extremum is sharp.
const SHARP: f64 = 1e-9;

/// Part of its size within which a state comes near its extent: more than the dense output errs by.
const NEAR: f64 = 1e-6;

/// Follows the sign of every rate; where it changes, there is an extremum, be it smooth, a corner or a plateau.
#[derive(Debug, Clone)]
pub(super) struct Extrema<const N: usize> {
    sought: Peaks,
    /// Least and largest value of each state so far, before the last step.
    extent: [[f64; 2]; N],
    /// Last sign of the rate that was not zero; 0 as long as nothing moved.
    sign: [f64; N],
    /// Where the state came to rest, if it is at rest.
    plateau: [Option<(f64, [f64; N])>; N],
    found: Vec<Extremum<N>>,
}

impl<const N: usize> Extrema<N> {
    /// Those that are sought of a motion from this state.
    pub(super) fn new(sought: Peaks, from: &[f64; N]) -> Self {
        Self {
            sought,
            extent: mapped(from, |state| [state; 2]),
            sign: [0.0; N],
            plateau: [None; N],
            found: Vec::new(),
        }
    }

    /// Looks for extrema in the step just made.
    pub(super) fn look<M: Model<N>>(
        &mut self,
        stepper: &mut Steps<'_, '_, M, N>,
        dense: &Dense<N>,
    ) {
        for index in 0..N {
            if !self.may_show(index, dense.bounds(index)) {
                self.pass(index, dense.leaves(index));
                continue;
            }
            let path = dense.component(index);
            let slope = path.derivative().without_noise(FLAT * path.magnitude());
            let start = (stepper.time(), *stepper.from());
            let Some((first, last)) = slope.end_signs() else {
                self.plateau[index].get_or_insert(start);
                continue;
            };
            self.meet(index, first, start);
            for change in slope.sign_changes().iter() {
                if self.may_show(index, [path.value(change.theta); 2]) {
                    let (time, state) = sharpen(stepper, &slope, index, change.theta);
                    self.record(index, !change.rising, time, state);
                }
            }
            self.sign[index] = last;
            self.widen(index, stepper.end()[index]);
        }
    }

    /// Whether a value between these of a state may be one that is sought.
    fn may_show(&self, index: usize, [low, high]: [f64; 2]) -> bool {
        if self.sought == Peaks::All || self.sought == Peaks::Extent(index) {
            return true;
        }
        let [least, most] = self.extent[index];
        let near = NEAR * least.abs().max(most.abs());
        // Comparisons that fail for NaN too.
        !(low > least + near && high < most - near)
    }

    /// Notes how a state goes on after a step that showed nothing of it.
    fn pass(&mut self, index: usize, rate: f64) {
        self.plateau[index] = None;
        if rate != 0.0 {
            self.sign[index] = rate.signum();
        }
    }

    fn widen(&mut self, index: usize, value: f64) {
        let [least, most] = &mut self.extent[index];
        (*least, *most) = (least.min(value), most.max(value));
    }

    /// Notes where states jump: as if they moved on very fast.
    pub(super) fn jump(&mut self, time: f64, before: &[f64; N], after: &[f64; N]) {
        for index in 0..N {
            let way = after[index] - before[index];
            self.widen(index, after[index]);
            if way != 0.0 {
                self.meet(index, way.signum(), (time, *before));
                self.sign[index] = way.signum();
            }
        }
    }

    /// Notes where the phase of a drive begins anew in the step just made.
    pub(super) fn strobe<M: Model<N>>(
        &mut self,
        phase: Option<usize>,
        stepper: &mut Steps<'_, '_, M, N>,
    ) {
        let ends = (*stepper.from(), *stepper.end());
        let (time, length) = (stepper.time(), stepper.length());
        strobes(
            phase,
            (&ends.0, &ends.1),
            (time, length),
            &mut self.found,
            |theta| Some(stepper.step_map(theta * length)),
        );
    }

    /// All extrema in the order of time; a plateau that the passage begins or ends with is one too.
    pub(super) fn finish(mut self) -> Vec<Extremum<N>> {
        for index in 0..N {
            if let (Some((time, state)), true) = (self.plateau[index], self.sign[index] != 0.0) {
                self.record(index, self.sign[index] > 0.0, time, state);
            }
        }
        in_order(&mut self.found, |extremum| extremum.time);
        self.found
    }

    /// Compares the sign with which a step begins with that with which the motion went on before.
    fn meet(&mut self, index: usize, first: f64, start: (f64, [f64; N])) {
        let before = self.sign[index];
        let rested = self.plateau[index].take();
        let (time, state) = rested.unwrap_or(start);
        if before * first < 0.0 || (before == 0.0 && rested.is_some()) {
            self.record(index, first < 0.0, time, state);
        }
    }

    fn record(&mut self, index: usize, maximum: bool, time: f64, state: [f64; N]) {
        self.widen(index, state[index]);
        self.found.push(Extremum {
            index,
            maximum,
            time,
            state,
        });
    }
}

/// Newton's method for a vanishing rate on the step map, with the curvature of the dense output.
fn sharpen<M: Model<N>, const N: usize>(
    stepper: &mut Steps<'_, '_, M, N>,
    slope: &Bernstein,
    index: usize,
    theta: f64,
) -> (f64, [f64; N]) {
    let length = stepper.length();
    let mut at = theta;
    let mut state = stepper.step_map(at * length);
    for _ in 0..3 {
        let rate = stepper.slope_at(&state);
        let step = -rate[index] * length / slope.derivative().value(at);
        if step.abs() <= SHARP || !step.is_finite() {
            break;
        }
        let next = (at + step).clamp(0.0, 1.0);
        if next == at {
            break;
        }
        at = next;
        state = stepper.step_map(at * length);
    }
    (stepper.time() + at * length, state)
}
