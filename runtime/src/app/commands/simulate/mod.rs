//! `simulate`: one motion from its start.

mod arguments;
mod document;
mod picture;
mod sheet;
mod text;

use crate::app::App;
use crate::app::failure::Failure;
use crate::app::progress::Progress;
use crate::app::request::{Request, request};
use crate::app::section;
use crate::study::Span;
pub(in crate::app) use arguments::Arguments;
pub(in crate::app) use picture::picture;
pub(in crate::app) use sheet::sheet;

pub(in crate::app) fn perform(app: &App, arguments: &Arguments) -> Result<(), Failure> {
    let Request {
        entry,
        info,
        case,
        output,
    } = request(app, &arguments.subject, None, None)?;
    let time = arguments.time;
    let section = arguments.cut.of(info)?;
    let failed = |error| Failure::of(&error, info);
    let progress = Progress::endless(&output, "following the motion");
    let motion = entry.motion(&case, time).map_err(failed)?;
    let mut sheets = vec![("trajectory", sheet(info, &motion))];
    let mut text = text::describe(info, &case, &motion, time);
    let mut points = None;
    if let Some(section) = section {
        let found = entry
            .crossings(&case, section, Span::Time(time))
            .map_err(failed)?;
        text.push_str(&section::describe(info, &section, &found));
        sheets.push(("section", section::sheet(info, &found)));
        points = Some(section::document(info, &section, &found));
    }
    drop(progress);
    let drawn = output.draw([("trajectory", picture(info, &motion))]);
    let document = document::document(info, &case, &motion)
        .maybe("section", points)
        .put("work", motion.work);
    output
        .deliver("trajectory", &text, &document, &sheets)
        .and(drawn)
}
