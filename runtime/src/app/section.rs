//! `--section`: which points of a motion are looked at.

use std::rc::Rc;

use clap::Args;

use super::answer::Answer;
use super::document::Document;
use super::failure::{Failure, refuse};
use super::request::{Request, state};
use super::spreadsheet::Columns;
use super::text::{number, short, states, time_unit, timed, unit};
use super::values::{Reading, one_of};
use super::words::{both_sides, number as numeral};
use crate::model::ModelInfo;
use crate::poincare::{Crossing, Direction, Met, Reason, Section, Silence, Surface};
use crate::study::{Case, Span};

/// Digits shown of the time in which nothing came.
const TIME: usize = 4;
/// Digits shown of a point.
const DIGITS: usize = 9;

#[derive(Debug, Clone, Args)]
pub(super) struct Cut {
    /// Points where a state has this value: `v=0.1`, `'v=0.1 down'`, `der(x)=0`; counted `up` unless `down` or `both`. Of a drive `phi`, `phi=0` is a stroboscope
    #[arg(long, value_name = "NAME=VALUE", value_parser = Reading(Written::read))]
    section: Option<Written>,
}

impl Cut {
    /// The section that is asked for, if any is.
    pub(super) fn of(&self, info: &ModelInfo) -> Result<Option<Section>, Failure> {
        let section = self.section.as_ref();
        section.map(|written| written.of(info)).transpose()
    }
}

/// A section with the name of its state.
#[derive(Debug, Clone, PartialEq)]
struct Written {
    /// Whether the rate of the state is meant.
    rate: bool,
    state: String,
    value: f64,
    direction: Direction,
}

impl Written {
    /// `v=0.1`, `v=0.1 down`, `der(x)=0`.
    fn read(option: &str, word: &str) -> Result<Self, Failure> {
        let (name, rest) = both_sides(option, word)?;
        let mut words = rest.split_whitespace();
        let value = words.next().unwrap_or_default();
        let direction = words.next().map_or(Ok(Direction::Up), direction)?;
        if let Some(more) = words.next() {
            return refuse!(
                "`{option} {word}`: `{more}` is one word too many: write a value and `up`, `down` or `both`"
            );
        }
        let value = numeral(&format!("{option} {word}"), value)?;
        let inner = name
            .strip_prefix("der(")
            .and_then(|name| name.strip_suffix(')'));
        if inner.is_some() && value != 0.0 {
            return refuse!(
                "`{option} {word}`: a rate is looked at where it vanishes: write `{name}=0`"
            );
        }
        Ok(Self {
            rate: inner.is_some(),
            state: inner.unwrap_or(name).trim().to_owned(),
            value,
            direction,
        })
    }

    fn of(&self, info: &ModelInfo) -> Result<Section, Failure> {
        let state = state(info, &self.state)?;
        if info.drive == Some(state) && (self.rate || self.direction == Direction::Down) {
            let name = &self.state;
            return refuse!(
                "`--section`: the phase `{name}` of the drive only advances: `{name}=0` looks at the motion once in each turn"
            );
        }
        Ok(Section {
            surface: if self.rate {
                Surface::Rate(state)
            } else {
                Surface::Level {
                    state,
                    value: self.value,
                }
            },
            direction: self.direction,
        })
    }
}

fn direction(word: &str) -> Result<Direction, Failure> {
    let all = [Direction::Up, Direction::Down, Direction::Both];
    one_of(all, Direction::name, "`--section` knows no direction", word)
}

/// An answer with the points where the motion of a case meets a section, if one is asked for.
pub(super) fn with_points<'a>(
    answer: Answer<'a>,
    asked: &Request<'a>,
    case: &Case,
    section: Option<Section>,
    span: Span,
) -> Result<Answer<'a>, Failure> {
    let Some(section) = section else {
        return Ok(answer);
    };
    let info = asked.info;
    let found = asked.got(asked.entry.crossings(case, section, span))?;
    let direction = |point: &Crossing| if point.rising { "up" } else { "down" }.to_owned();
    let found = Rc::new(found);
    let [told, written] = [found.clone(), found.clone()];
    let sheet = Columns::new()
        .number(timed(info, "t", "s"), |point: &Crossing| point.time)
        .numbers(states(info, ""), |point, j| point.state.get(j).copied())
        .column("direction", direction);
    Ok(answer
        .words(move || describe(info, &section, &told))
        .part("section", move || document(info, &section, &written))
        .sheet("section", move || sheet.sheet(&found.points)))
}

/// When and where, numbers as they shall be shown.
fn columns(info: &ModelInfo, shown: fn(f64) -> String) -> Columns<'static, Crossing> {
    Columns::new()
        .column(timed(info, "t", "s"), move |point: &Crossing| {
            shown(point.time)
        })
        .each(states(info, ""), move |point, j| shown(point.state[j]))
}

/// The points as a table, under a line that says where they lie.
fn describe(info: &ModelInfo, section: &Section, met: &Met) -> String {
    let count = match met.points.len() {
        0 => format!("0 points: {}", missed(info, section, met)),
        1 => "1 point".to_owned(),
        count => format!("{count} points"),
    };
    let text = format!("\n  section {}: {count}\n", section.describe(info));
    if met.points.is_empty() {
        return text;
    }
    text + &columns(info, |value| number(value, DIGITS)).text(&met.points)
}

/// Why a motion has no points on a section.
fn missed(info: &ModelInfo, section: &Section, met: &Met) -> String {
    let bounds = between(info, section, (&met.low, &met.high));
    let time = format!("for {}{}", short(met.time), time_unit(info));
    match met.against {
        0 => format!("{bounds} {time}"),
        1 => format!("{bounds} {time}, and crosses it once the other way"),
        times => format!("{bounds} {time}, and crosses it {times} times the other way"),
    }
}

/// Why no more points on a section are awaited of a motion.
pub(super) fn unmet(info: &ModelInfo, section: &Section, silence: &Silence) -> String {
    let end = match silence.reason {
        Reason::Rest => "and comes to rest".to_owned(),
        Reason::Bounded => "and keeps to these bounds".to_owned(),
        Reason::Long => format!("and after {} steps no more was awaited", silence.steps),
    };
    format!(
        "the motion does not meet the section {} any more: {} for {}{} {end}",
        section.describe(info),
        between(info, section, (&silence.low, &silence.high)),
        number(silence.time, TIME),
        time_unit(info),
    )
}

/// Where the state of a section stays.
fn between(info: &ModelInfo, section: &Section, (low, high): (&[f64], &[f64])) -> String {
    let index = section.surface.state();
    let state = info.states.get(index);
    let name = state.map_or("", |state| state.name);
    let of = unit(state.and_then(|state| state.unit));
    let side = |values: &[f64]| number(values.get(index).copied().unwrap_or(0.0), DIGITS);
    format!("{name} stays between {} and {}{of}", side(low), side(high))
}

/// The points as JSON; without any, the reason.
fn document<'a>(info: &'a ModelInfo, section: &Section, met: &Met) -> Document<'a> {
    let point = |point: &Crossing| Document::of(info, point).by_state(&["state"]);
    let none = met.points.is_empty();
    Document::new(info)
        .put("surface", section.describe(info))
        .list("points", &met.points, point)
        .maybe("reason", none.then(|| missed(info, section, met)))
}
