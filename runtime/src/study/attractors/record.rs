//! What is reported of the motions on which starts settle.

use nalgebra::Complex;
use serde::{Deserialize, Serialize};

use super::setting::Sampling;
use crate::bifurcation::Stability;
use crate::motion::Modes;
use crate::shooting::Shifts;
use crate::study::question::Along;
use crate::words::words;

words! {
    /// What a motion settles on.
    pub enum Class {
        /// A state of rest in which no contact sticks.
        Equilibrium = "equilibrium",
        /// A state of rest in which contacts stick, whatever a drive does: one of a set.
        Sticking = "sticking",
        /// A periodic orbit.
        Orbit = "orbit",
        /// A motion that repeats but for a shift of states on which nothing depends.
        Running = "running",
        /// A motion with several periods that have no common one.
        Torus = "torus",
        /// A motion along which errors grow.
        Chaos = "chaos",
        /// A periodic orbit beside which there are others, on none of which motions settle.
        Family = "family",
        /// A state grows beyond all bounds.
        Escape = "escape",
        /// None of these, as far as it was followed.
        Unsettled = "not settled",
        /// The motion cannot be followed.
        Failed = "failed",
    }
}

/// A motion on which starts settle.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Attractor {
    /// What it is.
    pub class: Class,
    /// A state on it; where it has none, the start.
    pub state: Vec<f64>,
    /// The modes of the contacts there.
    pub modes: Modes,
    /// The modes that it runs through, of contacts that act as declared.
    pub word: Option<String>,
    /// Its period.
    pub period: Option<f64>,
    /// What is added to the states in one period, or, where none of them turns, in a unit of time.
    pub shift: Option<Vec<f64>>,
    /// Whether any share of that changes nothing, too.
    pub slides: bool,
    /// Smallest value of each state, as far as it was seen.
    pub min: Vec<f64>,
    /// Largest value of each state.
    pub max: Vec<f64>,
    /// Where it meets its section, in the order of time.
    pub points: Vec<Vec<f64>>,
    /// The section: where this state is least, or, of a drive, begins anew.
    pub section: usize,
    /// Real and imaginary parts of its multipliers; of a state of rest, its eigenvalues.
    pub multipliers: Vec<[f64; 2]>,
    /// What they say.
    pub stability: Option<Stability>,
    /// The largest Lyapunov exponent across an irregular motion, with its standard error.
    pub exponent: Option<[f64; 2]>,
    /// Estimated relative error of period and extrema.
    pub error: Option<f64>,
    /// Why it is no more than it is.
    pub reason: Option<String>,
}

/// What becomes of a start.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum Fate {
    /// It settles on one of the motions that the first starts have found.
    Known(usize),
    /// It settles on another one, which it shows by itself.
    Other(Box<Attractor>),
}

/// A motion with the starts that settle on it.
#[derive(Debug, Clone, PartialEq)]
pub struct Found {
    /// The motion.
    pub attractor: Attractor,
    /// How many starts settle on it.
    pub count: usize,
    /// Their share.
    pub share: f64,
    /// The ends of Wilson's interval for it at 95 %, as if the starts were independent.
    pub interval: [f64; 2],
    /// The share of the region's area and its estimated error, if that was wanted.
    pub area: Option<[f64; 2]>,
}

/// An unstable motion on the edge between two basins.
#[derive(Debug, Clone, PartialEq)]
pub struct Edge {
    /// The places of the motions of both in the list of those that were found.
    pub between: [usize; 2],
    /// The motion.
    pub saddle: Attractor,
}

/// What all starts settle on at one value of a design variable.
#[derive(Debug, Clone, PartialEq)]
pub struct Survey {
    /// The value, if one is followed.
    pub r: Option<f64>,
    /// The motions: those on which most starts settle first.
    pub found: Vec<Found>,
    /// What lies on the edges between their basins, if that was wanted.
    pub edges: Vec<Edge>,
    /// Unstable orbits besides, if they were wanted.
    pub further: Vec<Attractor>,
    /// The start and the place of its motion in `found`, in the order of their numbers.
    pub starts: Vec<(Vec<f64>, usize)>,
}

impl Survey {
    /// What draws no start in, each with the motions between whose basins it lies if it was found there.
    pub fn saddles(&self) -> impl Iterator<Item = (Option<[usize; 2]>, &Attractor)> {
        let edges = self.edges.iter();
        let edges = edges.map(|edge| (Some(edge.between), &edge.saddle));
        edges.chain(self.further.iter().map(|one| (None, one)))
    }
}

/// All motions, without a seed.
#[derive(Debug, Clone, PartialEq)]
pub struct AttractorsRecord {
    /// Where the starts lie, and how many there are.
    pub sampling: Sampling,
    /// What is followed, if anything is.
    pub along: Option<Along>,
    /// One survey for each value.
    pub surveys: Vec<Survey>,
    /// How many starts have no answer yet, because it was interrupted.
    pub missing: usize,
}

impl Attractor {
    /// What it is in a few words: its class, and its word if it has one.
    #[must_use]
    pub fn name(&self) -> String {
        match &self.word {
            Some(word) => format!("{} {word}", self.class),
            None => self.class.to_string(),
        }
    }

    /// A motion of which no more is known than what it is, and why.
    pub(super) fn bare(class: Class, state: &[f64], reason: Option<String>) -> Self {
        Self {
            class,
            state: state.to_vec(),
            modes: Modes::new(),
            word: None,
            period: None,
            shift: None,
            slides: false,
            min: state.to_vec(),
            max: state.to_vec(),
            points: Vec::new(),
            section: 0,
            multipliers: Vec::new(),
            stability: None,
            exponent: None,
            error: None,
            reason,
        }
    }

    /// The same, angles within one turn of where they are nothing.
    pub(super) fn turned(mut self, shifts: &Shifts) -> Self {
        let turns = shifts.turns(&self.state);
        let told = [&mut self.state, &mut self.min, &mut self.max];
        for state in told.into_iter().chain(&mut self.points) {
            for (y, by) in state.iter_mut().zip(&turns) {
                *y -= by;
            }
        }
        self
    }

    /// The same, judged by its multipliers or eigenvalues.
    pub(super) fn judged(mut self, values: &[Complex<f64>], stability: Stability) -> Self {
        self.multipliers = values.iter().map(|value| [value.re, value.im]).collect();
        self.stability = Some(stability);
        self
    }
}

impl Found {
    /// A motion on which `count` of `all` starts settle.
    pub(super) fn new(attractor: Attractor, count: usize, all: usize) -> Self {
        Self {
            attractor,
            count,
            share: count as f64 / all.max(1) as f64,
            interval: wilson(count, all),
            area: None,
        }
    }
}

/// Wilson's score interval at 95 % (Wilson 1927).
fn wilson(count: usize, all: usize) -> [f64; 2] {
    const QUANTILE: f64 = 1.959_963_984_540_054;
    if all == 0 {
        return [0.0, 1.0];
    }
    let (n, share) = (all as f64, count as f64 / all as f64);
    let square = QUANTILE * QUANTILE / n;
    let centre = (share + 0.5 * square) / (1.0 + square);
    let half = QUANTILE / (1.0 + square) * (share * (1.0 - share) / n + 0.25 * square / n).sqrt();
    [(centre - half).max(0.0), (centre + half).min(1.0)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_interval_is_that_of_wilson() {
        // Newcombe 1998, Statistics in Medicine 17, 857, table I: 81/263, 15/148 and 0/20.
        for (count, all, low, high) in [
            (81, 263, 0.2553, 0.3662),
            (15, 148, 0.0624, 0.1605),
            (0, 20, 0.0, 0.1611),
        ] {
            let [l, h] = wilson(count, all);
            assert!((l - low).abs() < 5e-5 && (h - high).abs() < 5e-5, "{l} {h}");
        }
    }
}
