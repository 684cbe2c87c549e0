//! Brute-force diagrams: for many values of a design variable, let the motion settle and note where it
//! meets a section.
//!
//! A sweep begins each value where the one before ended, so that it stays with its attractor as long
//! as there is one: it is sequential by nature. Sweeps up and down run side by side, and values that
//! start afresh run on all cores; nothing depends on how many there are.

mod known;
mod parallel;
mod slice;
mod sweep;

pub use known::Known;
pub use parallel::{parallel, parallel_on};
pub use slice::{Motion, Slice};

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use crate::field::Work;
use crate::motion::Family;
use crate::poincare::Section;
use crate::study::error::StudyError;
use crate::study::question::{Along, Case};
use crate::study::system::System;
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
    /// How many values are not there, because it was interrupted.
    pub missing: usize,
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

/// A value of a diagram as it is found.
#[derive(Debug, Clone, Copy)]
pub struct Seen<'a> {
    /// The sweep to which it belongs.
    pub sweep: &'static str,
    /// What is seen there.
    pub slice: &'a Slice,
    /// Whether it was known before.
    pub known: bool,
    /// The share of all values that are there.
    pub share: f64,
}

/// Told of each value of a diagram, from any thread; a break ends the diagram there.
pub type Watcher<'a> = &'a (dyn Fn(Seen<'_>) -> ControlFlow<()> + Sync);

impl System {
    /// Where the motions of the case meet a section, for many values of its design variable; what is `known` from the
    /// same question is not computed again, and `watch` sees each value, from any thread.
    ///
    /// # Errors
    /// Nothing is followed, or the case cannot be asked.
    pub fn diagram(
        &self,
        case: &Case,
        diagram: &Diagram,
        known: &Known,
        watch: Watcher<'_>,
    ) -> Result<DiagramRecord, StudyError> {
        self.check(case)?;
        let along = case.along.ok_or(StudyError::NothingToFollow)?;
        let (family, start) = (self.family(case), self.start(case));
        Ok(diagram.draw(&family, along, &start, known, watch))
    }
}

impl Diagram {
    /// Draws it for a family, from `start`, where it is not `known` already.
    fn draw(
        &self,
        family: &Family,
        along: Along,
        start: &[f64],
        known: &Known,
        watch: Watcher<'_>,
    ) -> DiagramRecord {
        let values = self.spaced(along);
        let ways = self.ways(&values);
        let all = ways.iter().map(|(_, values)| values.len()).sum();
        let tell = Tell {
            watch,
            all,
            done: AtomicUsize::new(0),
            stopped: AtomicBool::new(false),
        };
        let cut = Cut {
            family,
            diagram: self,
            along,
            start,
        };
        let sweeps = match self.sweep {
            Sweep::Fresh => ways
                .iter()
                .map(|(name, values)| SweepRecord {
                    name,
                    slices: fresh(&cut, (name, values), known, &tell),
                })
                .collect(),
            _ => parallel_on(self.threads, &ways, |(name, values)| SweepRecord {
                name,
                slices: sweep::sweep(
                    &cut,
                    values,
                    |r| known.get(name, along.value(r)),
                    |slice, known| tell.of(name, slice, known),
                ),
            }),
        };
        DiagramRecord {
            along,
            diagram: *self,
            missing: all - tell.done.into_inner(),
            sweeps,
        }
    }

    /// The sweeps with their values in the order of each.
    fn ways(&self, values: &[f64]) -> Vec<(&'static str, Vec<f64>)> {
        let up = || (Sweep::Up.name(), values.to_vec());
        let down = || (Sweep::Down.name(), values.iter().rev().copied().collect());
        match self.sweep {
            Sweep::Up => vec![up()],
            Sweep::Down => vec![down()],
            Sweep::Both => vec![up(), down()],
            Sweep::Fresh => vec![(Sweep::Fresh.name(), values.to_vec())],
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

/// All values at once, each from the start.
fn fresh(
    cut: &Cut<'_>,
    (name, values): (&'static str, &[f64]),
    known: &Known,
    tell: &Tell<'_>,
) -> Vec<Slice> {
    let one = |&r: &f64| {
        if tell.stopped.load(Ordering::Relaxed) {
            return None;
        }
        let old = known.get(name, cut.along.value(r));
        let is_old = old.is_some();
        let slice = old.unwrap_or_else(|| cut.fresh(r));
        let _ = tell.of(name, &slice, is_old);
        Some(slice)
    };
    let slices = parallel_on(cut.diagram.threads, values, one);
    slices.into_iter().flatten().collect()
}

/// Tells of each value.
struct Tell<'a> {
    watch: Watcher<'a>,
    all: usize,
    done: AtomicUsize,
    stopped: AtomicBool,
}

impl Tell<'_> {
    fn of(&self, sweep: &'static str, slice: &Slice, known: bool) -> ControlFlow<()> {
        let done = self.done.fetch_add(1, Ordering::Relaxed) + 1;
        let share = done as f64 / self.all as f64;
        let verdict = (self.watch)(Seen {
            sweep,
            slice,
            known,
            share,
        });
        if verdict.is_break() {
            self.stopped.store(true, Ordering::Relaxed);
        }
        verdict
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
