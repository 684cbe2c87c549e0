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

    /// Time and state of each minimum of the section's state on the way, those where it ends included. Where it rests it is
    /// least from where it came to rest, not where the lap or a passage begins: between two minima lies a maximum.
    fn lows(&self) -> impl Iterator<Item = (f64, Vec<f64>)> {
        let section = self.section();
        let passages = self.passages.iter().zip(&self.begins);
        let turns = passages.flat_map(|(passage, begin)| {
            let all = passage.extrema.iter();
            let turns = all.filter(|extremum| extremum.index == section);
            turns.map(move |extremum| (begin + extremum.time, extremum))
        });
        let turns: Vec<_> = turns.collect();
        let before = |i: usize| turns[(i + turns.len() - 1) % turns.len()].1;
        let rests = |i: usize| {
            let [a, b] = [before(i), turns[i].1].map(|turn| turn.state[section]);
            turns.len() > 1 && !before(i).maximum && (a - b).abs() <= INSTANT * a.abs()
        };
        let begins = |i: &usize| self.drive.is_some() || !rests(*i);
        let lows = (0..turns.len()).filter(|i| !turns[*i].1.maximum && begins(i));
        let lows: Vec<_> = lows
            .map(|i| (turns[i].0, turns[i].1.state.clone()))
            .collect();
        lows.into_iter()
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
