//! What draws no start in: on the edges between basins, and besides.

use super::drawn::drawn;
use crate::app::text::{brief, followed, line, number, table, timed};
use crate::model::ModelInfo;
use crate::study::AttractorsRecord;

/// A line for each, with the numbers of the lines of the motions between whose basins it lies; nothing where none was sought.
pub(super) fn text(info: &ModelInfo, record: &AttractorsRecord) -> String {
    if !(record.sampling.edges || record.sampling.further) {
        return String::new();
    }
    let along = record.along.map(|along| followed(info, &along));
    let period = timed(info, "period", "s");
    let columns = ["between", "saddle", "word", &period, "unstable by"].map(str::to_owned);
    let states = info.states.iter().map(|state| state.name.to_owned());
    let mut lines = line(along.into_iter().chain(columns).chain(states));
    let mut none = true;
    for survey in &record.surveys {
        for (between, saddle) in survey.saddles() {
            none = false;
            let between = between.map(|[a, b]| format!("{}, {}", a + 1, b + 1));
            let period = saddle.period.map(|period| number(period, 9));
            let columns = [
                between.unwrap_or_default(),
                saddle.class.to_string(),
                brief(saddle.word.as_deref().unwrap_or_default()),
                period.unwrap_or_default(),
                drawn(saddle),
            ];
            let state = saddle.state.iter().map(|y| number(*y, 9));
            let r = survey.r.map(|r| number(r, 6));
            lines += &line(r.into_iter().chain(columns).chain(state));
        }
    }
    match none {
        true => "\n  no saddle was found\n".to_owned(),
        false => format!("\n{}", table(&lines)),
    }
}
