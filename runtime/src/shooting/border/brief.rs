//! What is brief beside a border: all that happens until the modes are as they were.

use super::around::Around;
use super::candidate::{Border, Condition};
use super::change::Change;
use crate::field::exact::Mode;
use crate::flow::{EventKind, FlowError};
use crate::motion::{Event, Flow, Modes};

impl<'a> Around<'a> {
    /// How far away in time the border is, told to it, and the rate of what vanishes there: that of a gap that comes from
    /// outside, or else of one that has just come from inside.
    pub(super) fn approached(
        &self,
        flow: &dyn Flow,
        border: &mut Border,
        event: &Event,
    ) -> Result<Option<f64>, FlowError> {
        let rate = self.approach(flow, border, event)?;
        if rate.is_some() || border.condition != Condition::Touch {
            return Ok(rate);
        }
        let Some(modes) = self.inside(event) else {
            return Ok(None);
        };
        border.modes = modes.map(Clone::clone);
        self.approach(flow, border, event)
    }

    /// The modes around a gap that closes after it has been open, as if it had not: of a press that has let go before.
    pub(super) fn inside(&self, event: &Event) -> Option<[&'a Modes; 2]> {
        let [_, after] = self.around(event)?;
        let open = self.stretch(event)?;
        let segments = &self.orbit.segments;
        let before = &segments[(open + segments.len() - 1) % segments.len()].modes;
        let parted = before.get(event.contact) == Some(&Mode::Parted);
        (parted && event.kind == EventKind::Closing).then_some([before, after])
    }

    /// When what belongs to a border begins and ends, if it lasts: all of these, or the time for which a gap is open.
    pub(super) fn span(&self, own: &[usize], inside: bool) -> Option<[f64; 2]> {
        let event = |i: &usize| &self.orbit.events[*i];
        match own {
            [first, .., last] => Some([event(first).time, self.over(event(last))]),
            [closing] if inside => {
                let (closing, count) = (event(closing), self.ends.len());
                let open = self.stretch(closing)?;
                Some([self.ends[(open + count - 1) % count], closing.time])
            }
            _ => None,
        }
    }

    /// What belongs to an impact, to a gap that closes, or to a reaction that vanishes: all until the modes are as they were.
    /// An impact may knock loose what sticks; after a flight others follow until the gap is closed again. A press that only lets
    /// go for a moment does not open its gap.
    pub(super) fn restored(&self, index: usize, before: Modes) -> Option<Change> {
        let first = &self.orbit.events[index];
        let mut own = vec![index];
        let mut last = index;
        while own.len() <= self.switches.len() {
            let [ended, after] = self.around(&self.orbit.events[last])?;
            if opened(after) == opened(&before) {
                let opens = first.mode == Mode::Parted && ended[first.contact] == Mode::Open;
                return (!opens).then(|| Change::at_once([before.clone(), before], own));
            }
            last = self.next(last)?;
            own.push(last);
        }
        None
    }

    /// When what an event begins is over: the gap of a press that lets go opens later, which is no event.
    pub(super) fn over(&self, event: &Event) -> f64 {
        let segments = &self.orbit.segments;
        let stretches = self.stretch(event).into_iter().flat_map(|i| {
            let turned = (1..segments.len()).map(move |by| (i + by) % segments.len());
            turned.take_while(|i| segments[*i].modes.get(event.contact) == Some(&Mode::Parted))
        });
        stretches.last().map_or(event.time, |i| self.ends[i])
    }
}

/// The same modes, the gaps open of which the presses have let go.
fn opened(modes: &Modes) -> Modes {
    let open = |mode: &Mode| match mode {
        Mode::Parted => Mode::Open,
        other => *other,
    };
    modes.iter().map(open).collect()
}
