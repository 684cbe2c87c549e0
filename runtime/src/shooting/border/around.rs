//! The events of an orbit once around, and which of them belong to a border.

use super::candidate::{Border, Condition};
use super::change::Change;
use crate::field::exact::Mode;
use crate::flow::{EventKind, FlowError};
use crate::motion::{Event, Flow, Modes};
use crate::shooting::Orbit;
use crate::shooting::symmetry::Symmetry;

/// Share of the period along which the rate of a guard is compared with itself.
const AHEAD: f64 = 1e-5;
/// Distance in time, as a share of the period, beyond which an orbit is not near a border.
const NEAR: f64 = 0.25;
/// Share of the period within which two events are one instant.
const INSTANT: f64 = 1e-9;
/// Drop of the force at release, as a share of its limit at rest, that is rounding error.
const FLAT: f64 = 1e-9;

/// The borders near to which an orbit is, the nearest first; none of a smooth system.
///
/// # Errors
/// The forces are not determined at an event.
pub fn borders(flow: &dyn Flow, orbit: &Orbit) -> Result<Vec<Border>, FlowError> {
    // Without events there is no border, and no image of one to be looked for.
    if orbit.events.is_empty() {
        return Ok(Vec::new());
    }
    let around = Around::of(flow, orbit);
    let mut found = Vec::new();
    for event in 0..orbit.events.len() {
        for condition in [Condition::Touch, Condition::Edge] {
            found.extend(around.border(flow, event, condition)?);
        }
    }
    found.sort_by(|a: &Border, b| a.away.total_cmp(&b.away));
    Ok(found)
}

/// An orbit once around.
pub(super) struct Around<'a> {
    pub(super) orbit: &'a Orbit,
    /// The symmetry that it has after half a period.
    pub(super) symmetry: Option<Symmetry>,
    /// When each stretch ends.
    pub(super) ends: Vec<f64>,
    /// The events at which modes change, in the order of time.
    pub(super) switches: Vec<usize>,
}

impl<'a> Around<'a> {
    fn of(flow: &dyn Flow, orbit: &'a Orbit) -> Self {
        let mut end = 0.0;
        let mut sum = |duration: f64| {
            end += duration;
            end
        };
        let ends = orbit.segments.iter().map(|one| sum(one.duration)).collect();
        let all = 0..orbit.events.len();
        let switches = all.filter(|i| orbit.events[*i].kind.is_switch());
        Self {
            orbit,
            symmetry: orbit.mirrored(flow).filter(|_| orbit.shift.is_none()),
            ends,
            switches: switches.collect(),
        }
    }

    /// The border of this condition at an event, if that is near to one.
    fn border(
        &self,
        flow: &dyn Flow,
        index: usize,
        condition: Condition,
    ) -> Result<Option<Border>, FlowError> {
        let event = &self.orbit.events[index];
        let Some([before, after]) = self.around(event) else {
            return Ok(None);
        };
        let contact = event.contact;
        let drops = flow.loosening(&event.state, contact) > FLAT;
        let mut border = Border::new(event, condition, [before, after].map(Clone::clone));
        border.drops = drops;
        border.by_hold = border.lets_go(flow, event)?;
        let Some(rate) = self.approached(flow, &mut border, event)? else {
            return Ok(None);
        };
        let inside = border.is_from_inside();
        let change = match condition {
            Condition::Touch if inside => Some(Change::at_once(border.modes.clone(), vec![index])),
            Condition::Touch => self.touched(index, [before, after], drops),
            Condition::Edge => self.crossed(index, [before, after], (rate, drops)),
        };
        let Some(change) = change.filter(|_| border.away <= NEAR) else {
            return Ok(None);
        };
        if condition == Condition::Edge {
            border.happens = matches!(event.kind, EventKind::Landing { .. });
        }
        let Change {
            modes,
            own,
            at_once,
        } = change;
        border.mirror = self.mirror(index, &own[..at_once], inside);
        let images: Vec<usize> = match border.mirror {
            Some(_) => own.iter().filter_map(|i| self.image(*i)).collect(),
            None => Vec::new(),
        };
        let brief = [&own, &images].map(|part| self.span(part, inside));
        border.brief.extend(brief.into_iter().flatten());
        let images = images.iter().take(at_once);
        let held: Vec<usize> = own[..at_once].iter().chain(images).copied().collect();
        border.modes = modes;
        (border.held, border.calm) = self.held(event, &held, border.turn());
        Ok(Some(border))
    }

    /// How far away in time the border is, told to it, and the rate of what vanishes there.
    pub(super) fn approach(
        &self,
        flow: &dyn Flow,
        border: &mut Border,
        event: &Event,
    ) -> Result<Option<f64>, FlowError> {
        let period = self.orbit.period;
        let switches = match event.kind {
            EventKind::Nearest { .. } => false,
            _ if event.rate < 0.0 => true,
            _ => return Ok(None),
        };
        let coming = border.coming(&event.state);
        if border.condition == Condition::Edge {
            let lands = matches!(
                event.kind,
                EventKind::Landing { .. } | EventKind::Crossing { .. }
            );
            if !lands {
                return Ok(None);
            }
            let held = flow.touch(&border.stuck(&event.state), border.contact)?;
            return Ok(held.map(|[value, rate]| {
                border.away = (value / rate).abs() / period;
                rate
            }));
        }
        let Some([value, rate]) = border.touch(flow, &coming)? else {
            return Ok(None);
        };
        let field = flow.velocity(&coming)?.f;
        let mut ahead = coming;
        for (x, f) in ahead.state.iter_mut().zip(field.iter()) {
            *x += AHEAD * period * f;
        }
        let later = border.touch(flow, &ahead)?;
        let bend = later.map_or(f64::NAN, |[_, later]| (later - rate) / (AHEAD * period));
        border.away = if switches {
            rate.abs() / bend
        } else {
            // Events are those of the last motion, one correction away from the orbit.
            (2.0 * value.abs() / bend).sqrt()
        } / period;
        Ok((bend > 0.0).then_some(rate))
    }

    /// What belongs to a touch: where nothing drops, what happens between falling and rising again is brief.
    fn touched(&self, index: usize, around: [&Modes; 2], drops: bool) -> Option<Change> {
        let event = &self.orbit.events[index];
        let [before, after] = around.map(Clone::clone);
        if !event.kind.is_switch() {
            let turned = self.turned(event);
            return turned.or_else(|| Some(Change::at_once([before, after], Vec::new())));
        }
        if matches!(event.kind, EventKind::Impact { .. }) {
            let turns = Change::turning([&before, &after], index);
            return turns.or_else(|| self.restored(index, before));
        }
        let own = before.get(event.contact);
        if drops {
            let touches =
                own == Some(&Mode::Stick) || after.get(event.contact) == Some(&Mode::Stick);
            return touches.then(|| Change::at_once([before, after], vec![index]));
        }
        if own.is_some_and(|mode| mode.is_of_press()) {
            return self.restored(index, before);
        }
        let next = self.next(index)?;
        let back = self.around(&self.orbit.events[next])?[1];
        let modes = [before.clone(), before];
        (back == &modes[0]).then(|| Change::at_once(modes, vec![index, next]))
    }

    /// What belongs to a gap that comes nearest to closing just where contacts turn.
    fn turned(&self, event: &Event) -> Option<Change> {
        let near = INSTANT * self.orbit.period;
        let here = |i: &&usize| (self.orbit.events[**i].time - event.time).abs() <= near;
        let switch = *self.switches.iter().find(here)?;
        let modes = self.around(&self.orbit.events[switch])?;
        let presses = modes[0].get(event.contact)?.is_of_press();
        let turning = Change::turning(modes, switch);
        turning.filter(|_| presses)
    }

    /// What belongs to an arrival at the edge of where a contact can stick: on its way out, a stick before it goes on is
    /// brief; on its way in, a slip before it sticks, where nothing drops.
    fn crossed(
        &self,
        index: usize,
        around: [&Modes; 2],
        (rate, drops): (f64, bool),
    ) -> Option<Change> {
        let event = &self.orbit.events[index];
        let [before, after] = around.map(Clone::clone);
        let landed = matches!(event.kind, EventKind::Landing { .. });
        if landed == (rate > 0.0) {
            return Some(Change::at_once([before, after], vec![index]));
        }
        let next = self.next(index)?;
        let last = self.around(&self.orbit.events[next])?[1].clone();
        let contact = event.contact;
        let other =
            self.orbit.events[next].contact == contact && last.get(contact) != before.get(contact);
        let (after, at_once) = if drops && !landed {
            (after, 1)
        } else {
            (last, 2)
        };
        other.then(|| Change {
            modes: [before, after],
            own: vec![index, next],
            at_once,
        })
    }

    /// The switch after this one.
    pub(super) fn next(&self, index: usize) -> Option<usize> {
        let place = self.switches.iter().position(|one| *one == index)?;
        let next = self.switches[(place + 1) % self.switches.len()];
        (next != index).then_some(next)
    }

    /// The modes before and after an event.
    pub(super) fn around(&self, event: &Event) -> Option<[&'a Modes; 2]> {
        let segments = &self.orbit.segments;
        let modes = |i: usize| &segments[i % segments.len()].modes;
        let i = self.stretch(event)?;
        let after = i + usize::from(event.kind.is_switch());
        Some([modes(i), modes(after)])
    }

    /// The stretch that an event ends, or in which it lies.
    pub(super) fn stretch(&self, event: &Event) -> Option<usize> {
        let near = INSTANT * self.orbit.period;
        let mut ends = self.ends.iter().map(|end| end - event.time).enumerate();
        if !event.kind.is_switch() {
            return ends.find(|(_, off)| *off > -near).map(|(i, _)| i);
        }
        // A stretch may be shorter than that.
        let nearest = ends.min_by(|(_, a), (_, b)| a.abs().total_cmp(&b.abs()));
        nearest.filter(|(_, off)| off.abs() <= near).map(|(i, _)| i)
    }

    /// Shares of the period, from the event on and up to this one, between which others happen: half of the way to the next
    /// and from the last; and the middle of the longest stretch without any.
    fn held(&self, event: &Event, own: &[usize], turn: f64) -> ([f64; 2], f64) {
        let period = self.orbit.period;
        let others = self.switches.iter().filter(|other| !own.contains(other));
        let ahead =
            |i: &usize| (self.orbit.events[*i].time - event.time).rem_euclid(period) / period;
        let others = others.map(ahead).filter(|time| *time < turn);
        let mut times: Vec<f64> = others.chain([0.0, turn]).collect();
        times.sort_by(f64::total_cmp);
        let middle = |gap: &[f64]| 0.5 * (gap[0] + gap[1]);
        let length = |gap: &&[f64]| gap[1] - gap[0];
        let longest = times
            .windows(2)
            .max_by(|a, b| length(a).total_cmp(&length(b)));
        let ends = [&times[..2], &times[times.len() - 2..]].map(middle);
        (ends, longest.map_or(0.5 * turn, middle))
    }
}
