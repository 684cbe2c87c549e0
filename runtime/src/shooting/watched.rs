//! What is watched of an orbit along its branch.

use super::orbit::Orbit;
use crate::bifurcation::{Floquet, PeriodicPoint};
use crate::continuation::Watched;
use crate::field::Work;
use crate::motion::{Modes, Segment};

impl Watched for Orbit {
    fn r(&self) -> f64 {
        self.r
    }

    fn slope(&self) -> f64 {
        self.heading.slope
    }

    fn unstable(&self) -> usize {
        self.floquet.unstable
    }

    fn marginal(&self) -> Option<usize> {
        Some(self.floquet.growths.marginal())
    }

    fn inherit(&mut self, before: &Self) {
        self.floquet.growths.inherit(&before.floquet.growths);
    }

    fn work(&mut self) -> Option<&mut Work> {
        Some(&mut self.work)
    }

    /// Whether both orbits run through the same modes in the same cyclic order.
    fn same_regime(&self, other: &Self) -> bool {
        self.has_word_of(other, 1)
    }
}

impl PeriodicPoint for Orbit {
    fn period(&self) -> f64 {
        self.period
    }

    fn floquet(&self) -> &Floquet {
        &self.floquet
    }

    fn asymmetry(&self) -> f64 {
        self.halves()
    }
}

impl Orbit {
    /// The same orbit, as if it had not left its mode between two instants.
    pub(super) fn without(&self, [from, until]: [f64; 2]) -> Self {
        let mut end = 0.0;
        let length = (until - from).rem_euclid(self.period);
        let inside = |time: f64| (time - from).rem_euclid(self.period) < length;
        let mut lasts = |segment: &&Segment| {
            end += segment.duration;
            !inside(end - 0.5 * segment.duration)
        };
        let segments = self.segments.iter().filter(|one| lasts(one));
        Self {
            segments: segments.cloned().collect(),
            ..self.clone()
        }
    }

    /// Whether its event word is that of `other`, gone around so many times.
    pub(super) fn has_word_of(&self, other: &Self, times: usize) -> bool {
        let (a, b) = (stretches(self), stretches(other));
        // A motion without events is one stretch however long it is.
        let length = if b.len() > 1 {
            times * b.len()
        } else {
            b.len()
        };
        let turned = |by: usize| (0..a.len()).all(|i| a[i].0 == b[(i + by) % b.len()].0);
        a.len() == length && (0..b.len().max(1)).any(turned)
    }
}

/// Modes and durations once around; what the start divides is one stretch.
fn stretches(orbit: &Orbit) -> Vec<(&Modes, f64)> {
    let mut stretches: Vec<(&Modes, f64)> = Vec::with_capacity(orbit.segments.len());
    for segment in &orbit.segments {
        match stretches.last_mut() {
            Some(last) if *last.0 == segment.modes => last.1 += segment.duration,
            _ => stretches.push((&segment.modes, segment.duration)),
        }
    }
    if let [first, .., last] = stretches.as_mut_slice()
        && first.0 == last.0
    {
        first.1 += last.1;
        stretches.pop();
    }
    stretches
}
