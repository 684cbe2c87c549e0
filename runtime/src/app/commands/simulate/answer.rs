//! A motion in all forms.

use super::picture::{Line, lines, picture};
use crate::app::answer::Answer;
use crate::app::document::{Document, named};
use crate::app::spreadsheet::{Columns, Spreadsheet};
use crate::app::text::{heading, label, line, number, short, table, time_unit, timed, work};
use crate::model::ModelInfo;
use crate::study::{Case, Trajectory};

/// A motion of this time.
pub(super) fn answer(
    info: &ModelInfo,
    case: &Case,
    motion: &Trajectory,
    time: f64,
) -> Answer<'static> {
    let (text, document) = (
        describe(info, case, motion, time),
        document(info, case, motion),
    );
    let answer = Answer::new("trajectory", text, document);
    drawn("trajectory", answer, info, motion)
}

/// An answer with the table and the picture of a motion, by this name.
pub(in crate::app::commands) fn drawn<'a>(
    name: &str,
    answer: Answer<'a>,
    info: &ModelInfo,
    motion: &Trajectory,
) -> Answer<'a> {
    answer
        .sheet(name, sheet(info, motion))
        .figure(name, picture(info, motion))
}

/// One row for each time.
fn sheet(info: &ModelInfo, motion: &Trajectory) -> Spreadsheet {
    let all = lines(info, motion);
    let lines: Vec<&Line> = all.iter().flatten().collect();
    let heads = lines.iter().map(|line| label(line.name, line.unit));
    let columns = Columns::new()
        .number(timed(info, "t", "s"), |&i: &usize| Some(motion.times[i]))
        .numbers(heads, |&i, j| lines[j].values.get(i).copied());
    columns.sheet(&(0..motion.times.len()).collect::<Vec<_>>())
}

/// Digits shown of a state.
const DIGITS: usize = 8;

fn describe(info: &ModelInfo, case: &Case, motion: &Trajectory, time: f64) -> String {
    let what = format!("a motion of {}{}", short(time), time_unit(info));
    let [states, observables, forces] = lines(info, motion);
    let row = |line: &Line, more: &[Option<&f64>]| {
        let values = [line.values.first(), line.values.last()];
        let values = values.iter().chain(more).flatten();
        let shown = values.map(|&&value| number(value, DIGITS));
        self::line([label(line.name, line.unit)].into_iter().chain(shown))
    };
    let mut text = "state\tstart\tend\tmin\tmax\n".to_owned();
    for (j, line) in states.iter().enumerate() {
        text += &row(line, &[motion.min.get(j), motion.max.get(j)]);
    }
    let others: String = observables
        .iter()
        .chain(&forces)
        .map(|line| row(line, &[]))
        .collect();
    let states = table(&text);
    let others = match others.as_str() {
        "" => String::new(),
        others => table(&format!("quantity\tstart\tend\n{others}")),
    };
    let (samples, work) = (motion.times.len(), work(&motion.work));
    heading(info, case, &what) + &format!("{states}{others}\n  {samples} samples; {work}\n")
}

/// A motion, each quantity as one column.
fn document<'a>(info: &'a ModelInfo, case: &Case, motion: &Trajectory) -> Document<'a> {
    let [states, observables, forces] = lines(info, motion).map(|lines| {
        let names = lines.iter().map(|line| line.name);
        named(names, lines.iter().map(|line| &line.values))
    });
    Document::case(info, case)
        .put("time", &motion.times)
        .put("states", states)
        .put("observables", observables)
        .put("forces", forces)
        .states("state", motion.states.last().into_iter().flatten())
        .states("max", &motion.max)
        .states("min", &motion.min)
        .units()
}
