//! Extrema of the states along smooth motions: found by the signs of f, polished on the step map.

use super::{Extremum, strobes};
use crate::field::Linear;
use crate::integrate::Look;
use crate::integrate::event::Bernstein;

const ITERATIONS: usize = 12;
/// Relative change over a step below which a state is at rest.
pub(crate) const FLAT: f64 = 1e-13;

/// Follows the sign of every rate from step to step.
pub(crate) struct Turning<const N: usize> {
    /// Last sign of the rate that was not zero; 0 as long as nothing moved.
    sign: [f64; N],
    /// Where the state came to rest, if it rests.
    resting: [Option<(f64, [f64; N])>; N],
    found: Vec<Extremum<N>>,
    /// Those of the last step, so that steps allocate nothing.
    looks: Vec<Look<N>>,
}

/// The inside of a step.
pub(crate) trait Inside<const N: usize> {
    /// When it begins, and how long it is.
    fn span(&self) -> (f64, f64);

    /// The polynomial of one state, as it is known without further work.
    fn path(&self, index: usize) -> Bernstein;

    /// State and field at a fraction of the step, by the step map.
    fn probe(&mut self, theta: f64) -> Option<([f64; N], Linear<N>)>;

    /// A look there.
    fn look(&mut self, theta: f64) -> Option<Look<N>> {
        let (state, linear) = self.probe(theta)?;
        Some(Look {
            theta,
            state,
            linear,
        })
    }
}

impl<const N: usize> Turning<N> {
    pub(crate) const fn new() -> Self {
        Self {
            sign: [0.0; N],
            resting: [None; N],
            found: Vec::new(),
            looks: Vec::new(),
        }
    }

    /// Finds the extrema of every state inside a step, which is looked at here at least, its beginning first.
    pub(crate) fn step(
        &mut self,
        looks: &mut dyn Iterator<Item = Look<N>>,
        step: &mut dyn Inside<N>,
    ) {
        let mut seen = std::mem::take(&mut self.looks);
        seen.clear();
        seen.extend(looks);
        for index in 0..N {
            let mut all = hidden(index, &seen, step);
            if all.is_empty() {
                self.follow(index, &seen, step);
            } else {
                all.extend_from_slice(&seen);
                in_order(&mut all, |look| look.theta);
                self.follow(index, &all, step);
            }
        }
        self.looks = seen;
    }

    /// Notes where the phase of a drive begins anew in a step between these ends.
    pub(crate) fn strobes(
        &mut self,
        phase: Option<usize>,
        (from, to): (&[f64; N], &[f64; N]),
        step: &mut dyn Inside<N>,
    ) {
        let span = step.span();
        strobes(phase, (from, to), span, &mut self.found, |theta| {
            step.probe(theta).map(|(state, _)| state)
        });
    }

    /// All extrema in the order of time; a rest with which the motion ends is one, too.
    pub(crate) fn finish(mut self) -> Vec<Extremum<N>> {
        for index in 0..N {
            if let (Some(rest), true) = (self.resting[index], self.sign[index] != 0.0) {
                self.record(index, self.sign[index] > 0.0, rest);
            }
        }
        in_order(&mut self.found, |extremum| extremum.time);
        self.found
    }

    fn follow(&mut self, index: usize, looks: &[Look<N>], step: &mut dyn Inside<N>) {
        let (time, length) = step.span();
        let (mut last, mut still) = (None::<&Look<N>>, None::<&Look<N>>);
        for look in looks {
            let sign = look.sign(index);
            if sign == 0.0 {
                still = Some(look);
                continue;
            }
            let old = self.sign[index];
            let rest = self.resting[index].take();
            if old * sign < 0.0 || (old == 0.0 && rest.is_some()) {
                let place = match (rest, last) {
                    (Some(rest), _) => rest,
                    (None, Some(before)) => {
                        let (theta, state) = polish(index, before, look, length, step);
                        (time + theta * length, state)
                    }
                    // A corner between two steps, or an extremum just there.
                    (None, None) => {
                        let at = still.unwrap_or(look);
                        (time + at.theta * length, at.state)
                    }
                };
                self.record(index, sign < 0.0, place);
            }
            self.sign[index] = sign;
            last = Some(look);
        }
        if let (None, Some(first)) = (last, looks.first()) {
            self.resting[index].get_or_insert((time, first.state));
        }
    }

    fn record(&mut self, index: usize, maximum: bool, (time, state): (f64, [f64; N])) {
        self.found.push(Extremum {
            index,
            maximum,
            time,
            state,
        });
    }
}

/// Looks between those that have the same sign on both sides of a pair of extrema.
fn hidden<const N: usize>(
    index: usize,
    looks: &[Look<N>],
    step: &mut dyn Inside<N>,
) -> Vec<Look<N>> {
    let path = step.path(index);
    let noise = FLAT * path.magnitude();
    if path.most_turns(noise) < 2 {
        return Vec::new();
    }
    let slope = path.derivative().without_noise(noise);
    let (changes, mut before) = (slope.sign_changes(), None);
    let mut more = Vec::new();
    for change in changes.iter() {
        let after = change.theta;
        let seen = |from: f64| looks.iter().any(|l| from < l.theta && l.theta < after);
        if let Some(from) = before.replace(after).filter(|from| !seen(*from)) {
            more.extend(step.look(0.5 * (from + after)));
        }
    }
    more
}

/// Puts a list in the order of a number. It is short, or nearly in order: a sort for any would be compiled for each order N.
pub(crate) fn in_order<T>(list: &mut [T], number: fn(&T) -> f64) {
    for next in 1..list.len() {
        let own = number(&list[next]);
        let mut first = next;
        while first > 0 && number(&list[first - 1]).total_cmp(&own).is_gt() {
            first -= 1;
        }
        list[first..=next].rotate_right(1);
    }
}

/// Safeguarded Newton for fⱼ = 0 between two looks of opposite sign.
fn polish<const N: usize>(
    j: usize,
    low: &Look<N>,
    high: &Look<N>,
    length: f64,
    step: &mut dyn Inside<N>,
) -> (f64, [f64; N]) {
    let (mut a, mut b) = ((low.theta, low.linear.f[j]), (high.theta, high.linear.f[j]));
    let mut theta = a.0 - a.1 * (b.0 - a.0) / (b.1 - a.1);
    let mut best = (theta, low.state);
    for _ in 0..ITERATIONS {
        let Some((state, linear)) = step.probe(theta) else {
            break;
        };
        best = (theta, state);
        let slope = linear.f[j];
        if slope * a.1 > 0.0 {
            a = (theta, slope)
        } else {
            b = (theta, slope)
        }
        let bend: f64 = (0..N).map(|k| linear.jacobian[j][k] * linear.f[k]).sum();
        let newton = -slope / (bend * length);
        // The value is stationary here: what a further move would change.
        if !(0.5 * slope * newton * length).is_normal()
            || (0.5 * slope * newton * length).abs() <= 1e-15 * state[j].abs()
        {
            break;
        }
        let inside = (a.0.min(b.0), a.0.max(b.0));
        theta += newton;
        if !(theta > inside.0 && theta < inside.1) {
            theta = 0.5 * (inside.0 + inside.1);
        }
    }
    best
}
