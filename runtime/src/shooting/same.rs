//! Whether two orbits are one.

use super::orbit::Orbit;
use crate::continuation::Watched;
use crate::motion::apart;

/// Two orbits at one r are one if they differ by this share of their extents at most.
pub(crate) const SAME_ORBIT: f64 = 1e-5;
/// An orbit lies between two others if it is no farther from either than this many times their own distance.
const BETWEEN: f64 = 1.1;
/// Odd numbers of laps in which an orbit may go around a shorter one.
const ODD: [usize; 3] = [3, 5, 7];

impl Orbit {
    /// Whether both run through the same points of the default section, in the same order, to this
    /// tolerance relative to the extents: at the same r, they are one orbit then, whatever point of it
    /// they begin with and however often they go around.
    #[must_use]
    pub fn coincides(&self, other: &Self, tolerance: f64) -> bool {
        let (a, b) = (self.section.len(), other.section.len());
        if a == 0 || b == 0 {
            return false;
        }
        let rate = self.period / a as f64 * (b as f64 / other.period);
        let same_at = |turn: usize| {
            (0..a.max(b)).all(|i| {
                let (p, q) = (&self.section[i % a], &other.section[(i + turn) % b]);
                self.distance(p, q) <= tolerance
            })
        };
        (rate - 1.0).abs() <= tolerance && (0..b).any(same_at)
    }

    /// How much the second half differs from the first: see [`crate::bifurcation::Watched::asymmetry`].
    pub(super) fn halves(&self) -> f64 {
        self.laps(2)
    }

    /// Whether it goes around a shorter orbit several times, to this tolerance relative to the extents.
    pub(super) fn repeats(&self, tolerance: f64) -> bool {
        self.halves() <= tolerance || self.repeats_oddly(tolerance)
    }

    /// Whether it does so an odd number of times: no flip leads there.
    pub(super) fn repeats_oddly(&self, tolerance: f64) -> bool {
        ODD.into_iter().any(|times| self.laps(times) <= tolerance)
    }

    /// How much one of so many laps differs from the next; infinite if its points cannot be parted like that.
    fn laps(&self, times: usize) -> f64 {
        let count = self.section.len();
        let parted = count > 0 && count.is_multiple_of(times);
        if !parted || (self.shift.is_some() && !self.switches_alike(times)) {
            return f64::INFINITY;
        }
        let next = self.section.iter().cycle().skip(count / times);
        let pairs = self.section.iter().zip(next);
        pairs.map(|(p, q)| self.distance(p, q)).fold(0.0, f64::max)
    }

    /// Whether contacts switch alike in so many laps: where an angle has turned in part, a lap may be one in which they slide
    /// the other way, and nothing else tells.
    fn switches_alike(&self, times: usize) -> bool {
        let switches = self.events.iter().filter(|event| event.switches());
        let modes: Vec<_> = switches.map(|event| (event.contact, event.mode)).collect();
        let next = modes.iter().cycle().skip(modes.len() / times);
        modes.len().is_multiple_of(times) && modes.iter().zip(next).all(|(a, b)| a == b)
    }

    /// How far another orbit is, by its extents and its period, relative to themselves.
    pub(super) fn apart(&self, other: &Self) -> f64 {
        let magnitude = self.magnitude();
        let period = (other.period / self.period - 1.0).abs();
        let [a, b] = [self, other].map(Self::extents);
        let ends = a.iter().zip(&b);
        let ends = ends.map(|(a, b)| apart(a, b, &magnitude));
        ends.fold(period, f64::max)
    }

    /// Whether it lies between two others on a path that turns here by less than a right angle, by their extents.
    pub(super) fn parts(&self, [from, to]: [&Self; 2]) -> bool {
        let magnitude = self.magnitude();
        let here = self.extents();
        let [from, to] = [from, to].map(Self::extents);
        let along = |end: usize| {
            let ways = from[end].iter().zip(&here[end]).zip(&to[end]);
            let scaled = ways.zip(&magnitude);
            scaled.map(|(((from, here), to), unit)| (here - from) / unit * ((to - here) / unit))
        };
        along(0).chain(along(1)).sum::<f64>() > 0.0
    }

    /// Least and largest values of the states; of one that runs on, what it gains once around.
    fn extents(&self) -> [Vec<f64>; 2] {
        let mut ends = [self.min.clone(), self.max.clone()];
        let gains = self.shift.iter().flatten().enumerate();
        for (j, gain) in gains.filter(|(_, gain)| **gain != 0.0) {
            (ends[0][j], ends[1][j]) = (0.0, *gain);
        }
        ends
    }

    /// The same, r relative to itself beside them.
    pub(super) fn away(&self, other: &Self) -> f64 {
        let r = (other.r - self.r).abs() / self.r_size().max(f64::MIN_POSITIVE);
        self.apart(other).max(r)
    }

    /// Whether it lies between two neighbours on its branch, as far as these errors tell.
    pub(super) fn is_between(&self, ends: [&Self; 2], errors: f64) -> bool {
        let whole = ends[0].away(ends[1]);
        let [a, b] = ends.map(|end| self.away(end));
        a.max(b) <= (BETWEEN * whole).max(errors)
    }

    /// How far apart two points are, but for where the motion runs on.
    fn distance(&self, p: &[f64], q: &[f64]) -> f64 {
        let q = self.slid(q.to_vec(), p);
        apart(p, &q, &self.magnitude())
    }

    /// A state shifted to where it is beside a point, along what runs on at will.
    pub(super) fn slid(&self, mut state: Vec<f64>, point: &[f64]) -> Vec<f64> {
        for pin in self.pins.iter().filter(|_| self.shift.is_some()) {
            pin.slide(&mut state, pin.of(point));
        }
        state
    }
}
