//! A motion in all forms.

use super::picture::picture;
use crate::app::answer::Answer;
use crate::app::document::{Document, named};
use crate::app::interrupt;
use crate::app::output::Output;
use crate::app::request::Request;
use crate::app::show::{Kind, Quantity, quantities};
use crate::app::spreadsheet::Columns;
use crate::app::text::{heading, label, line, number, short, table, time_unit, timed, work};
use crate::model::ModelInfo;
use crate::study::{Case, Trajectory};

/// A motion that was to take this time.
pub(super) fn answer<'a>(
    asked: &'a Request<'_>,
    motion: &'a Trajectory,
    shown: &'a [Quantity],
    time: f64,
) -> Answer<'a> {
    let (info, case) = (asked.info, &asked.case);
    let answer = Answer::new(
        "trajectory",
        || describe(info, case, motion),
        move || document(info, case, motion, time),
    );
    drawn("trajectory", answer, (info, &asked.output), motion, shown)
}

/// An answer with the table and the picture of a motion, by this name.
pub(in crate::app::commands) fn drawn<'a>(
    name: &str,
    answer: Answer<'a>,
    (info, output): (&'a ModelInfo, &Output),
    motion: &'a Trajectory,
    shown: &'a [Quantity],
) -> Answer<'a> {
    let answer = answer
        .sheet(name, || {
            columns(info, motion).sheet(&(0..motion.times.len()).collect::<Vec<_>>())
        })
        .figure(name, || picture(info, motion, shown));
    if output.is_kept() && shown.len() < info.states.len() {
        let names: Vec<&str> = shown.iter().map(|one| one.name).collect();
        let names = names.join(", ");
        return answer.words(move || {
            format!("\n  the picture shows {names}: `--show` chooses, and the table has all\n")
        });
    }
    answer
}

/// The columns of a motion, a row for each number of a time.
pub(super) fn columns<'a>(info: &ModelInfo, motion: &'a Trajectory) -> Columns<'a, usize> {
    let times = Columns::new().number(timed(info, "t", "s"), |&i: &usize| {
        motion.times.get(i).copied()
    });
    quantities(info).fold(times, |columns, one| {
        let value = move |&i: &usize| value(motion, &one, i);
        columns.number(label(one.name, one.unit), value)
    })
}

/// A quantity in row number `row`.
fn value(motion: &Trajectory, one: &Quantity, row: usize) -> Option<f64> {
    let rows = match one.of {
        Kind::State => &motion.states,
        Kind::Observable => &motion.observables,
        Kind::Force => &motion.forces,
    };
    rows.get(row)?.get(one.index).copied()
}

/// Digits shown of a state.
const DIGITS: usize = 8;

fn describe(info: &ModelInfo, case: &Case, motion: &Trajectory) -> String {
    let what = format!("a motion of {}{}", short(motion.time), time_unit(info));
    let last = motion.times.len().saturating_sub(1);
    let row = |one: &Quantity, more: &[Option<&f64>]| {
        let ends = [0, last].map(|row| value(motion, one, row));
        let values = ends
            .into_iter()
            .chain(more.iter().map(|value| value.copied()));
        let shown = values.flatten().map(|value| number(value, DIGITS));
        line([label(one.name, one.unit)].into_iter().chain(shown))
    };
    let mut states = "state\tstart\tend\tmin\tmax\n".to_owned();
    let mut others = String::new();
    for one in quantities(info) {
        match one.of {
            Kind::State => {
                let sides = [&motion.min, &motion.max].map(|side| side.get(one.index));
                states += &row(&one, &sides);
            }
            Kind::Observable | Kind::Force => others += &row(&one, &[]),
        }
    }
    let others = match others.as_str() {
        "" => String::new(),
        others => table(&format!("quantity\tstart\tend\n{others}")),
    };
    let tail = format!("{} samples; {}", motion.samples, work(&motion.work));
    heading(info, case, &what) + &table(&states) + &others + &format!("\n  {tail}\n")
}

/// A motion, each quantity as one column; of one that was not followed to its end or that is thinned, this too.
fn document<'a>(info: &'a ModelInfo, case: &Case, motion: &Trajectory, time: f64) -> Document<'a> {
    let [states, observables, forces] = [Kind::State, Kind::Observable, Kind::Force].map(|kind| {
        let all = || quantities(info).filter(|one| one.of == kind);
        let column = |one: Quantity| -> Vec<f64> {
            let rows = 0..motion.times.len();
            rows.filter_map(|row| value(motion, &one, row)).collect()
        };
        named(all().map(|one| one.name), all().map(column))
    });
    let thinned = motion.every > 1;
    let ended = (motion.time < time).then_some(if interrupt::asked() {
        "interrupted"
    } else {
        "too-many-steps"
    });
    Document::case(info, case)
        .maybe("ended", ended)
        .maybe("reached", ended.map(|_| motion.time))
        .maybe("samples", thinned.then_some(motion.samples))
        .maybe("every", thinned.then_some(motion.every))
        .put("time", &motion.times)
        .put("states", states)
        .put("observables", observables)
        .put("forces", forces)
        .states("state", motion.states.last().into_iter().flatten())
        .states("max", &motion.max)
        .states("min", &motion.min)
        .units()
}
