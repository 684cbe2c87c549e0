//! `simulate`: one motion from its start.

mod arguments;
mod document;
mod picture;
mod sheet;
mod text;

use crate::app::App;
use crate::app::failure::Failure;
use crate::app::progress::Progress;
use crate::app::request::request;
use crate::app::section;
use crate::study::Span;
pub(in crate::app) use arguments::Arguments;
pub(in crate::app) use picture::picture;
pub(in crate::app) use sheet::sheet;

pub(in crate::app) fn perform(app: &App, arguments: &Arguments) -> Result<(), Failure> {
    let asked = request(app, &arguments.subject, None, None)?;
    let (info, case, time) = (asked.info, &asked.case, arguments.time);
    let section = arguments.cut.of(info)?;
    let failed = |error| asked.failed(error);
    let progress = Progress::endless(&asked.output, "following the motion");
    let motion = asked.entry.motion(case, time).map_err(failed)?;
    let mut text = text::describe(info, case, &motion, time);
    let mut sheets = vec![("trajectory", sheet(info, &motion))];
    let mut points = None;
    if let Some(section) = section {
        let found = asked.entry.crossings(case, section, Span::Time(time));
        let found = found.map_err(failed)?;
        text.push_str(&section::describe(info, &section, &found));
        sheets.push(("section", section::sheet(info, &found)));
        points = Some(section::document(info, &section, &found));
    }
    drop(progress);
    let drawn = [("trajectory", picture(info, &motion))];
    let drawn = asked.output.draw(drawn);
    let document = document::document(info, case, &motion)
        .maybe("section", points)
        .put("work", motion.work);
    let delivered = asked
        .output
        .deliver("trajectory", &text, &document, &sheets);
    delivered.and(drawn)
}
