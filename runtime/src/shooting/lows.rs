//! Where an orbit meets its section: where the first state that does not run on is least, or where the phase of a drive begins.

use std::f64::consts::TAU;

use super::shot::{INSTANT, Shot};

/// The state whose minima are the section: the first that does not run on; with a drive, its phase.
pub(super) fn section(drive: Option<usize>, shift: Option<&[f64]>) -> usize {
    let closes = |shift: &[f64]| shift.iter().position(|gain| *gain == 0.0);
    drive.or_else(|| shift.and_then(closes)).unwrap_or(0)
}

impl Shot {
    fn section(&self) -> usize {
        section(self.drive, self.shift.as_deref())
    }

    /// The minima as they would be if nothing ran on: those of one lap are those of the next.
    pub(super) fn points(&self) -> Vec<Vec<f64>> {
        let still = |(time, mut state): (f64, Vec<f64>)| {
            let run = self.shift.iter().flatten().zip(&mut state);
            run.for_each(|(gain, y)| *y -= gain * time / self.period);
            state
        };
        self.minima().map(still).collect()
    }

    /// Time and state of each minimum of the section's state in [0, T), the start included once if it is one; with a drive,
    /// of each beginning of its phase.
    pub(crate) fn minima(&self) -> impl Iterator<Item = (f64, Vec<f64>)> + '_ {
        // What turns slowly may begin further from where it turns than an instant.
        let off = self.off_section();
        let near = (INSTANT * self.period).max(2.0 * off.unwrap_or(0.0));
        let all = self.lows();
        let inside = all.filter(move |(time, _)| *time > near && *time < self.period - near);
        let start = off.map(|_| (0.0, self.start.state.clone()));
        start.into_iter().chain(inside)
    }

    /// Time and state of each minimum of the section's state on the way, those where it ends included.
    fn lows(&self) -> impl Iterator<Item = (f64, Vec<f64>)> + '_ {
        let section = self.section();
        let passages = self.passages.iter().zip(&self.begins);
        passages.flat_map(move |(passage, begin)| {
            let all = passage.extrema.iter();
            let minima = all.filter(move |e| e.index == section && !e.maximum);
            minima.map(move |e| (begin + e.time, e.state.clone()))
        })
    }

    /// Whether the section's state is least at the start; with a drive, whether its phase begins there.
    pub(super) fn starts_on_section(&self) -> bool {
        self.off_section().is_some()
    }

    /// How far in time a start on the section is from where its state turns; `None` if it is not on it.
    fn off_section(&self) -> Option<f64> {
        if let Some(phase) = self.drive {
            let turns = self.start.state[phase] / TAU;
            return ((turns - turns.round()).abs() <= INSTANT).then_some(0.0);
        }
        let section = self.section();
        let terms = self
            .velocity
            .jacobian
            .row(section)
            .transpose()
            .component_mul(&self.velocity.f);
        let (bend, size) = terms.iter().fold((0.0, 0.0), |(sum, size), term| {
            (sum + term, size + term.abs())
        });
        let rate = self.velocity.f[section].abs();
        let on = rate <= INSTANT * self.period * size && bend > 0.0;
        // At an impact it turns without coming to rest.
        let turns = || {
            self.lows()
                .any(|(time, _)| self.is_start(time))
                .then_some(0.0)
        };
        on.then_some(rate / bend).or_else(turns)
    }
}
