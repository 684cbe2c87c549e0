//! `simulate`: one motion from its start.

mod arguments;
mod document;
mod picture;
mod sheet;
mod text;

use crate::app::failure::Failure;
use crate::app::offer::App;
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
    let progress = Progress::endless(&asked.output, "following the motion");
    let motion = asked.entry.motion(case, time);
    let motion = motion.map_err(|error| asked.failed(error))?;
    let mut text = text::describe(info, case, &motion, time);
    let mut document = document::document(info, case, &motion);
    let mut sheets = vec![("trajectory", sheet(info, &motion))];
    if let Some(points) = section::points(&asked, case, section, Span::Time(time))? {
        text.push_str(&points.text);
        document = document.put("section", points.document);
        sheets.push(("section", points.sheet));
    }
    drop(progress);
    let drawn = [("trajectory", picture(info, &motion))];
    let drawn = asked.output.draw(drawn);
    let document = document.put("work", motion.work);
    let delivered = asked
        .output
        .deliver("trajectory", &text, &document, &sheets);
    delivered.and(drawn)
}
