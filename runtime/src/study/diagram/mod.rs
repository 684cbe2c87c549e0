//! Brute-force diagrams: for many values of a design variable, let the motion settle and note where it
//! meets a section.
//!
//! A sweep begins each value where the one before ended, so that it stays with its attractor as long
//! as there is one: it is sequential by nature. Sweeps up and down run side by side, and values that
//! start afresh run on all cores; nothing depends on how many there are.

mod slice;
mod sweep;

pub use slice::{Motion, Slice};

use std::sync::atomic::{AtomicUsize, Ordering};

use super::case::Along;
use super::parallel::parallel_on;
use crate::field::Work;
use crate::flow::Family;
use crate::poincare::Section;
use slice::Cut;

/// What is to be drawn.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Diagram {
    /// Where points are taken.
    pub section: Section,
    /// How the values follow each other.
    pub sweep: Sweep,
    /// How many values, evenly spaced, both ends among them.
    pub values: usize,
    /// Crossings of the section that are left out while the motion settles.
    pub settle: usize,
    /// Crossings that are noted.
    pub points: usize,
    /// Laps over which the largest Lyapunov exponent is averaged, if it is wanted.
    pub lyapunov: Option<usize>,
    /// Number of threads; all cores if nothing is said.
    pub threads: Option<usize>,
}

/// How the values of a diagram follow each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sweep {
    /// From the smallest to the largest, each from the end of the one before.
    Up,
    /// From the largest to the smallest, each from the end of the one before.
    Down,
    /// Up, and down: where they differ, there are two attractors.
    Both,
    /// Each value from the start of the case.
    Fresh,
}

/// A diagram as it is reported, whatever model it belongs to.
#[derive(Debug, Clone, PartialEq)]
pub struct DiagramRecord {
    /// The design variable and its range.
    pub along: Along,
    /// What was asked for.
    pub diagram: Diagram,
    /// One or two sweeps.
    pub sweeps: Vec<SweepRecord>,
}

/// One sweep over all values.
#[derive(Debug, Clone, PartialEq)]
pub struct SweepRecord {
    /// `up`, `down` or `fresh`.
    pub name: &'static str,
    /// The values in the order of the sweep.
    pub slices: Vec<Slice>,
}

impl Sweep {
    /// All there are.
    pub const ALL: [Self; 4] = [Self::Up, Self::Down, Self::Both, Self::Fresh];

    /// Its word on the command line.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Up => "up",
            Self::Down => "down",
            Self::Both => "both",
            Self::Fresh => "fresh",
        }
    }
}

impl Diagram {
    /// Draws it for a family, from `start`.
    pub(super) fn draw<F: Family<N> + Clone + Sync, const N: usize>(
        &self,
        family: &F,
        along: Along,
        start: [f64; N],
        watch: &(dyn Fn(f64) + Sync),
    ) -> DiagramRecord {
        let values = self.spaced(along);
        let done = AtomicUsize::new(0);
        let all = values.len() * if self.sweep == Sweep::Both { 2 } else { 1 };
        let count = || {
            let done = done.fetch_add(1, Ordering::Relaxed) + 1;
            watch(done as f64 / all as f64);
        };
        let cut = Cut {
            family,
            diagram: self,
            along,
            start,
        };
        let backwards: Vec<f64> = values.iter().rev().copied().collect();
        let up = ("up", values.as_slice());
        let down = ("down", backwards.as_slice());
        let ways = match self.sweep {
            Sweep::Up => vec![up],
            Sweep::Down => vec![down],
            Sweep::Both => vec![up, down],
            Sweep::Fresh => Vec::new(),
        };
        let mut sweeps = parallel_on(self.threads, &ways, |(name, values)| SweepRecord {
            name,
            slices: sweep::sweep(&cut, values, &count),
        });
        if self.sweep == Sweep::Fresh {
            sweeps.push(SweepRecord {
                name: "fresh",
                slices: parallel_on(self.threads, &values, |&r| {
                    let slice = cut.fresh(r);
                    count();
                    slice
                }),
            });
        }
        DiagramRecord {
            along,
            diagram: *self,
            sweeps,
        }
    }

    /// The values as a family counts them, smallest first.
    fn spaced(&self, along: Along) -> Vec<f64> {
        let (from, to) = along.span();
        let (low, high) = (from.min(to), from.max(to));
        let last = self.values.max(2) - 1;
        let value = |k: usize| match k {
            0 => low,
            k if k == last => high,
            k => low + (high - low) * k as f64 / last as f64,
        };
        (0..=last).map(value).collect()
    }
}

impl DiagramRecord {
    /// Work of all values.
    #[must_use]
    pub fn work(&self) -> Work {
        let slices = self.sweeps.iter().flat_map(|sweep| &sweep.slices);
        slices.fold(Work::default(), |mut all, slice| {
            all += slice.work;
            all
        })
    }
}
