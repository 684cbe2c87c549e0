//! What is watched of an orbit along its branch.

use super::orbit::Orbit;
use crate::bifurcation::{Floquet, Kind, PeriodicPoint};
use crate::continuation::{Chance, Watched};
use crate::field::Work;
use crate::flow::EventKind;
use crate::motion::{Modes, Segment};

/// A stretch this many times shorter than the errors of an orbit tell may as well be none; the most that is left out, of a
/// period.
const BRIEF: f64 = 10.0;
const BRIEFEST: f64 = 1e-6;

impl Watched for Orbit {
    fn r(&self) -> f64 {
        self.r
    }

    fn r_scale(&self) -> f64 {
        self.heading.r_scale
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

    fn growing_beside(&self, kind: Kind) -> Option<usize> {
        self.floquet.growing_beside(kind)
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

    fn seems_in_regime_of(&self, other: &Self) -> bool {
        self.same_regime(other) || turns_into(&self.lasting(), &other.lasting(), 1)
    }

    fn exchanged(&self, other: &Self) -> Option<f64> {
        let (a, b) = (stretches(self), stretches(other));
        if a.len() + 1 == b.len() {
            return gap(&a, &b).map(|_| 0.0);
        }
        let alone = |by: usize| {
            let mut unlike = (0..a.len()).filter(|i| !a[*i].is_like(&b[(i + by) % b.len()]));
            let first = unlike.next().filter(|_| unlike.next().is_none())?;
            Some(a[first].duration)
        };
        let same = a.len() == b.len();
        same.then(|| (0..b.len()).find_map(alone)).flatten()
    }

    fn besides(&self, other: &Self) -> Option<f64> {
        let (a, b) = (stretches(other), stretches(self));
        let one = a.len() + 1 == b.len();
        one.then(|| gap(&a, &b).map(|i| b[i].duration)).flatten()
    }

    fn margins(&self, as_in: &Self) -> Vec<(Chance, f64)> {
        let own = stretches(self);
        let theirs = stretches(as_in);
        let alike = own.len() == theirs.len();
        let Some(by) = alike.then(|| turned(&theirs, &own)).flatten() else {
            return Vec::new();
        };
        let number = |i: usize| (i + own.len() - by) % own.len();
        // One that is all of the orbit does not vanish.
        let lasts = own.iter().enumerate().filter(|_| own.len() > 1);
        let mut margins: Vec<(Chance, f64)> = lasts
            .map(|(i, stretch)| (Chance::Stretch(number(i)), stretch.duration))
            .collect();
        for event in &self.events {
            match event.kind {
                EventKind::Nearest { margin } => nearer(&mut margins, event.contact, margin),
                EventKind::Landing { margin, .. } | EventKind::Crossing { margin, .. } => {
                    let ended = ended_at(&own, event.time, self.period);
                    margins.extend(ended.map(|i| (Chance::Outcome(number(i)), margin)));
                }
                _ => {}
            }
        }
        margins
    }

    fn lasts(&self) -> f64 {
        self.period
    }
}

/// Keeps the least margin of a contact.
fn nearer(margins: &mut Vec<(Chance, f64)>, contact: usize, margin: f64) {
    let of = Chance::Event(contact);
    match margins.iter_mut().find(|one| one.0 == of) {
        Some(one) => one.1 = one.1.min(margin),
        None => margins.push((of, margin)),
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
        let mut lasts = |segment: &Segment| {
            end += segment.duration;
            !inside(end - 0.5 * segment.duration)
        };
        let mut segments: Vec<Segment> = Vec::new();
        let mut without = false;
        for segment in &self.segments {
            let stays = lasts(segment);
            if stays {
                // An impact that ends what is left out did not happen either.
                let impact = segment.impact.filter(|_| !without);
                segments.push(Segment {
                    impact,
                    ..segment.clone()
                });
            }
            without = !stays;
        }
        Self {
            segments,
            ..self.clone()
        }
    }

    /// Whether its event word is that of `other`, gone around so many times.
    pub(super) fn has_word_of(&self, other: &Self, times: usize) -> bool {
        let (a, b) = (stretches(self), stretches(other));
        turns_into(&a, &b, times)
    }

    /// The stretches once around that last longer than the error of their ends: those of contacts that move alike are left in
    /// an order that rounding chooses.
    fn lasting(&self) -> Vec<Stretch<'_>> {
        let error = BRIEF * self.error_estimate / self.floquet.pull();
        let brief = error.min(BRIEFEST) * self.period;
        let mut stretches = stretches(self);
        stretches.retain(|one| one.impact.is_some() || one.duration > brief);
        stretches
    }
}

/// Whether `a` is `b` gone around so many times, from wherever it begins.
fn turns_into(a: &[Stretch<'_>], b: &[Stretch<'_>], times: usize) -> bool {
    // A motion without events is one stretch however long it is.
    let length = if b.len() > 1 || b.iter().any(|one| one.impact.is_some()) {
        times * b.len()
    } else {
        b.len()
    };
    a.len() == length && (a.is_empty() || turned(a, b).is_some())
}

/// From which stretch of `b` on those of `a` are, gone around as often as need be.
fn turned(a: &[Stretch<'_>], b: &[Stretch<'_>]) -> Option<usize> {
    let alike = |by: &usize| (0..a.len()).all(|i| a[i].is_like(&b[(i + by) % b.len()]));
    (0..b.len()).find(alike)
}

/// The stretch that ends next to a time.
fn ended_at(stretches: &[Stretch<'_>], time: f64, period: f64) -> Option<usize> {
    let off = |stretch: &Stretch<'_>| {
        let turns = (stretch.end - time) / period;
        (turns - turns.round()).abs()
    };
    let offs = stretches.iter().map(off).enumerate();
    offs.min_by(|a, b| a.1.total_cmp(&b.1)).map(|(i, _)| i)
}

/// A stretch of an orbit between two events.
struct Stretch<'a> {
    modes: &'a Modes,
    /// The contact whose impact began it, if one did.
    impact: Option<usize>,
    duration: f64,
    /// When it ends.
    end: f64,
}

impl Stretch<'_> {
    /// Whether it begins alike and passes in the same modes.
    fn is_like(&self, other: &Self) -> bool {
        (self.modes, self.impact) == (other.modes, other.impact)
    }
}

/// The stretch of `b` between two events but for which those of `a` are those of `b`.
fn gap(a: &[Stretch<'_>], b: &[Stretch<'_>]) -> Option<usize> {
    let without = |gap: usize, by: usize| {
        (1..b.len()).all(|i| b[(gap + i) % b.len()].is_like(&a[(by + i) % a.len()]))
    };
    (0..b.len()).find(|gap| (0..a.len()).any(|by| without(*gap, by)))
}

/// The stretches once around; what the start divides is one.
fn stretches(orbit: &Orbit) -> Vec<Stretch<'_>> {
    let mut stretches: Vec<Stretch<'_>> = Vec::with_capacity(orbit.segments.len());
    let mut end = 0.0;
    for segment in &orbit.segments {
        end += segment.duration;
        match stretches.last_mut() {
            Some(last) if *last.modes == segment.modes && segment.impact.is_none() => {
                last.duration += segment.duration;
                last.end = end;
            }
            _ => stretches.push(Stretch {
                modes: &segment.modes,
                impact: segment.impact,
                duration: segment.duration,
                end,
            }),
        }
    }
    if let [first, .., last] = stretches.as_mut_slice()
        && first.modes == last.modes
        && first.impact.is_none()
    {
        (first.impact, first.duration) = (last.impact, first.duration + last.duration);
        stretches.pop();
    }
    stretches
}
