//! The diagram of a case, value by value.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use super::known::Known;
use super::record::{DiagramRecord, Seen, SweepRecord, Watcher};
use super::setting::{Diagram, Sweep};
use super::slice::{Cut, Slice};
use super::sweep;
use crate::motion::Family;
use crate::study::error::StudyError;
use crate::study::question::{Along, Case};
use crate::study::system::System;
use crate::study::work::parallel_on;

impl System {
    /// Where the motions of the case meet a section, for many values of its design variable; what is `known` from the
    /// same question is not computed again, and `watch` sees each value, from any thread.
    ///
    /// # Errors
    /// Nothing is followed, or the case cannot be asked.
    pub fn diagram_watched(
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
        let values = along.spaced(self.values);
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
