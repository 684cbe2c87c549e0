//! What swings between two bounds along a motion, so that where it could be as well is told by the middle: an internal
//! state of a law between its stops, or the force of a contact that sticks all along, over the most that it can bear.

use super::instant::Instant;
use super::pin::Swing;
use super::shot::Shot;
use crate::field::exact::Mode;
use crate::flow::{FlowError, Want};
use crate::motion::{Flow, Modes, Passage, Place, Row, Segment};

/// A state this near to its stop, relatively, is on it.
const ON: f64 = 1e-13;
/// Steps of Newton's method by which it is told when a force turns.
const SHARPENED: usize = 4;
/// Part of a stretch within which it is known then: what is left of its value is the square of that.
const SHARP: f64 = 1e-6;
/// Part of a period before an event that is not beyond it.
const SLIGHTLY: f64 = 1e-10;
/// How far away a turn is at most, over the way to a place beside it: next to the end of an orbit that may be on the other side.
const ASIDE: f64 = 2.0;
/// Panels of a quadrature over a period, at whose nodes forces are looked at.
const PANELS: f64 = 24.0;

/// Where what swings turns.
#[derive(Debug, Clone)]
pub(super) struct Turn {
    /// The segment of the motion.
    pub(super) segment: usize,
    /// The time since that began.
    pub(super) time: f64,
    /// Its value there.
    pub(super) value: f64,
    /// The modes there, where forces are asked for.
    modes: Option<Modes>,
    /// Its second derivative in time, where the turn is known roughly.
    bend: Option<f64>,
    /// What happens there, if it turns as contacts switch.
    pub(super) instant: Option<Instant>,
}

impl Swing {
    /// Whether it reaches neither bound on a motion.
    pub(super) fn is_free(self, flow: &dyn Flow, shot: &Shot) -> bool {
        match self {
            Self::State(state) => met(flow, shot, state) == [false; 2],
            Self::Force(contact) => sticks(&shot.stretches(), contact),
        }
    }

    /// Where it is greatest, and where least.
    ///
    /// # Errors
    /// The motion cannot be followed, or its forces are not determined.
    pub(super) fn turns(self, flow: &dyn Flow, shot: &Shot) -> Result<[Turn; 2], FlowError> {
        match self {
            Self::State(state) => Ok([1.0, -1.0].map(|sign| farthest(shot, state, sign))),
            Self::Force(contact) => peaks(flow, &shot.start, shot.period, contact),
        }
    }

    /// Its value at a state near a turn, and its slopes.
    ///
    /// # Errors
    /// The forces are not determined there.
    pub(super) fn row(self, flow: &dyn Flow, state: &[f64], turn: &Turn) -> Result<Row, FlowError> {
        let contact = match self {
            Self::State(j) => {
                let mut slopes = vec![0.0; state.len()];
                slopes[j] = 1.0;
                return Ok(Row {
                    value: state[j],
                    slopes,
                    design: 0.0,
                });
            }
            Self::Force(contact) => contact,
        };
        let (mut load, rate) = load(
            flow,
            &Place::known(flow, state, turn.modes.as_ref())?,
            contact,
        )?;
        // What the turn is beyond the time at which it was taken.
        load.value -= turn.bend.map_or(0.0, |bend| 0.5 * rate * rate / bend);
        Ok(load)
    }
}

/// Which stops of a state a motion meets: the lower one, and the upper one.
pub(super) fn met(flow: &dyn Flow, shot: &Shot, state: usize) -> [bool; 2] {
    let (low, high) = shot.extent();
    let stop = flow.stop(state) * (1.0 - ON);
    [-low[state] >= stop, high[state] >= stop]
}

/// Whether a contact sticks all along.
pub(super) fn sticks(segments: &[Segment], contact: usize) -> bool {
    segments
        .iter()
        .all(|segment| segment.modes[contact] == Mode::Stick)
}

/// The place in which a state is greatest, or least.
fn farthest(shot: &Shot, state: usize, sign: f64) -> Turn {
    let turn = |segment, time, value| Turn {
        segment,
        time,
        value,
        modes: None,
        bend: None,
        instant: None,
    };
    let passages = shot.passages.iter().enumerate();
    let turns = passages.flat_map(|(segment, passage)| {
        let turns = passage.extrema.iter().filter(|turn| turn.index == state);
        turns.map(move |found| turn(segment, found.time, found.state[state]))
    });
    let start = turn(0, 0.0, shot.start.state[state]);
    let further = |most: Turn, turn: Turn| match sign * (turn.value - most.value) > 0.0 {
        true => turn,
        false => most,
    };
    turns.fold(start, further)
}

/// Where in a period from a place on the force of a contact is greatest over the most that it can bear, and where least.
///
/// # Errors
/// The motion cannot be followed, or its forces are not determined.
pub(super) fn peaks(
    flow: &dyn Flow,
    start: &Place,
    period: f64,
    contact: usize,
) -> Result<[Turn; 2], FlowError> {
    let want = Want {
        panel: period / PANELS,
        ..Want::default()
    };
    let passage = flow.advance(start, period, want)?;
    let mut begin = 0.0;
    let mut most: [Option<Turn>; 2] = [None, None];
    for stretch in &passage.segments {
        let (modes, end) = (&stretch.modes, begin + stretch.duration);
        let mut looked = Vec::new();
        for (time, state) in looks(&passage, start, [begin, end]) {
            let at = Place::known(flow, state, Some(modes))?;
            let (load, rate) = load(flow, &at, contact)?;
            looked.push([time, load.value, rate]);
        }
        for (sign, most) in [1.0, -1.0].into_iter().zip(&mut most) {
            let around = (passage.segments.len() == 1).then_some(period);
            let turn = top(&looked, sign, modes, around);
            let mut turn = sharpened(flow, contact, turn, (start, [begin, end]))?;
            if turn.bend.is_none() {
                turn.instant = Instant::of(&passage, turn.time);
                turn.time -= turn.instant.as_ref().map_or(0.0, |_| SLIGHTLY * period);
            }
            let further = |old: &Turn| sign * (turn.value - old.value) > 0.0;
            if most.as_ref().is_none_or(further) {
                *most = Some(turn);
            }
        }
        begin = end;
    }
    let none = || Turn {
        segment: 0,
        time: 0.0,
        value: 0.0,
        modes: Some(start.modes.clone()),
        bend: None,
        instant: None,
    };
    Ok(most.map(|turn| turn.unwrap_or_else(none)))
}

/// Where a motion comes by in a stretch of it, and at both its ends: followed anew from there, rounding would tell whether what
/// has just happened happens again.
fn looks<'a>(
    passage: &'a Passage,
    start: &'a Place,
    [begin, end]: [f64; 2],
) -> Vec<(f64, &'a [f64])> {
    let first = [(0.0, &start.state), (passage.time, &passage.end.state)];
    let events = passage.events.iter().map(|one| (one.time, &one.state));
    let nodes = passage.nodes.iter().map(|one| (one.time, &one.state));
    let all = first.into_iter().chain(events).chain(nodes);
    let inside = all.filter(|(time, _)| (begin..=end).contains(time));
    let mut looks: Vec<(f64, &[f64])> = inside.map(|(time, state)| (time, &state[..])).collect();
    looks.sort_by(|a, b| a.0.total_cmp(&b.0));
    looks
}

/// What a contact that sticks all along could bear besides, over the most that it can; `None` where it slides, or forces are
/// not determined.
pub(super) fn spare_force(
    flow: &dyn Flow,
    start: &Place,
    stretches: &[Segment],
    contact: usize,
) -> Option<f64> {
    if !sticks(stretches, contact) {
        return None;
    }
    let period = stretches.iter().map(|stretch| stretch.duration).sum();
    let turns = peaks(flow, start, period, contact).ok()?;
    let part = |turn: &Turn| {
        let there = flow.advance(start, turn.time, Want::default()).ok()?.end;
        let row = Swing::Force(contact).row(flow, &there.state, turn).ok()?;
        Some(row.value.abs())
    };
    Some(1.0 - part(&turns[0])?.max(part(&turns[1])?))
}

/// The turn next to the greatest, or least, of these times, values and rates, which go all around an orbit of this period or are
/// those of one stretch of it: beyond the end of that there is none. Of a force that keeps still, rounding tells a turn anywhere.
fn top(looked: &[[f64; 3]], sign: f64, modes: &Modes, around: Option<f64>) -> Turn {
    let heights = looked.iter().map(|[_, value, _]| sign * value).enumerate();
    let (i, _) = heights
        .max_by(|a, b| a.1.total_cmp(&b.1))
        .unwrap_or_default();
    let [time, value, rate] = looked.get(i).copied().unwrap_or_default();
    let mut sides = [i.checked_sub(1), Some(i + 1)].map(|side| looked.get(side?));
    if sign * rate > 0.0 {
        sides.reverse();
    }
    let next = sides[0].or(sides[1].filter(|_| around.is_some()));
    let bend = next.map(|next| (next[2] - rate) / (next[0] - time));
    let beside = next.map_or(0.0, |next| (next[0] - time).abs());
    let bend = bend.filter(|bend| sign * bend < 0.0 && (rate / bend).abs() <= ASIDE * beside);
    let off = bend.map_or(0.0, |bend| -rate / bend);
    let turned = time + off;
    Turn {
        segment: 0,
        time: around.map_or(turned, |period| turned.rem_euclid(period)),
        value: value + 0.5 * off * rate,
        modes: Some(modes.clone()),
        bend,
        instant: None,
    }
}

/// A turn where the rate vanishes, by Newton's method with secants, in this stretch of the motion from a start: taken from the
/// nodes of a quadrature alone, it would jump with those from one orbit to the next.
fn sharpened(
    flow: &dyn Flow,
    contact: usize,
    mut turn: Turn,
    (start, [begin, end]): (&Place, [f64; 2]),
) -> Result<Turn, FlowError> {
    let mut before: Option<[f64; 2]> = None;
    for _ in 0..SHARPENED {
        let Some(bend) = turn.bend else { break };
        if !(begin..=end).contains(&turn.time) {
            break;
        }
        let there = flow.advance(start, turn.time, Want::default())?.end;
        let place = Place::known(flow, &there.state, turn.modes.as_ref())?;
        let (load, rate) = load(flow, &place, contact)?;
        let secant = before.map(|[time, other]| (rate - other) / (turn.time - time));
        let bend = secant.filter(|secant| secant * bend > 0.0).unwrap_or(bend);
        let off = -rate / bend;
        let next = (turn.time + off).clamp(begin, end);
        turn.value = load.value + 0.5 * off * rate;
        turn.bend = Some(bend);
        if (next - turn.time).abs() <= SHARP * (end - begin) {
            break;
        }
        before = Some([turn.time, rate]);
        turn.time = next;
    }
    Ok(turn)
}

/// What part of the most that it can bear a contact holds at a place, and its rate.
fn load(flow: &dyn Flow, at: &Place, contact: usize) -> Result<(Row, f64), FlowError> {
    let contacts = flow.contacts(at)?;
    let (force, stick) = (&contacts.all[contact].force, &contacts.all[contact].stick);
    let most = stick.value;
    let value = force.value / most;
    if !value.is_finite() {
        return Err(FlowError::LetsGo);
    }
    let slope = |force: f64, stick: f64| (force - value * stick) / most;
    let slopes = force.slopes.iter().zip(&stick.slopes);
    let slopes: Vec<f64> = slopes.map(|(f, s)| slope(*f, *s)).collect();
    let rate = slopes.iter().zip(&contacts.f).map(|(s, f)| s * f).sum();
    let design = slope(force.design, stick.design);
    let row = Row {
        value,
        slopes,
        design,
    };
    Ok((row, rate))
}
