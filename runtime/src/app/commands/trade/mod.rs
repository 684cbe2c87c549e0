//! `trade`: what smoothing costs, and what it gets wrong.

mod arguments;
mod document;
mod sheet;
mod text;

use crate::app::answer::Answer;
use crate::app::failure::{Failure, refuse};
use crate::app::interrupt;
use crate::app::offer::App;
use crate::app::progress::Progress;
use crate::app::request::request;
use crate::field::{Design, Kernel};
use crate::study::trade::Finding;
pub(in crate::app) use arguments::Arguments;

pub(in crate::app) fn perform(app: &App, arguments: &Arguments) -> Result<(), Failure> {
    arguments.resume.refuse()?;
    let range = arguments.along.as_ref();
    let asked = request(app, &arguments.subject, range, arguments.guess.period)?;
    let (info, case, output) = (asked.info, &asked.case, &asked.output);
    let scope = arguments.scope(case);
    if case.along.map(|along| along.design) == Some(Design::Smoothing) {
        return refuse!("`trade` goes through the sizes by itself: `--along` takes a parameter");
    }
    let progress = Progress::endless(output, "measuring what smoothing costs");
    let mut errors = output.journal("trade", sheet::copies(info, 0, Kernel::Arctan).head());
    let mut precisions = output.journal("work-precision", sheet::precision_head());
    let mut watch = |end: usize, finding: Finding<'_>| {
        match finding {
            Finding::Copy(kernel, point) => {
                errors.add([sheet::copies(info, end, kernel).row(point)])
            }
            Finding::Precision(one) => precisions.add(sheet::precision_rows(end, one)),
        }
        interrupt::verdict()
    };
    let record = asked.entry.trade(case, &scope, &mut watch);
    let record = record.map_err(|error| asked.failed(error))?;
    drop(progress);
    let [errors, precisions] = sheet::sheets(info, &record);
    let text = text::describe(info, case, &record, scope.accuracy);
    let answer = Answer::new("trade", text, document::document(info, &record));
    let answer = answer
        .sheet("trade", errors)
        .sheet("work-precision", precisions);
    output.deliver(answer)?;
    if record.is_interrupted() {
        let curves = record.ends.iter().flat_map(|end| &end.trade.curves);
        let count: usize = curves.map(|curve| curve.points.len()).sum();
        return Err(output.interrupted(&format!("{count} copies were measured")));
    }
    Ok(())
}
