//! `trade`: what smoothing costs, and what it gets wrong.

mod arguments;
mod document;
mod sheet;
mod text;

use crate::app::failure::{Failure, refuse};
use crate::app::interrupt;
use crate::app::offer::App;
use crate::app::progress::Progress;
use crate::app::request::request;
use crate::app::spreadsheet::Spreadsheet;
use crate::field::{Design, Kernel};
use crate::study::TradeRecord;
use crate::study::trade::{Finding, Point, Precision};
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
    let mut errors = output.journal("trade", sheet::head(info));
    let mut precisions = output.journal("work-precision", sheet::precision_head());
    let mut watch = |end: usize, finding: Finding<'_>| {
        match finding {
            Finding::Copy(kernel, point) => errors.add([sheet::row((end, kernel, point))]),
            Finding::Precision(one) => precisions.add(sheet::precision_rows((end, one))),
        }
        interrupt::verdict()
    };
    let record = asked.entry.trade(case, &scope, &mut watch);
    let record = record.map_err(|error| asked.failed(error))?;
    drop(progress);
    let errors = copies(&record).map(sheet::row);
    let precisions = precision(&record).flat_map(sheet::precision_rows);
    let sheets = [
        ("trade", Spreadsheet::new(sheet::head(info), errors)),
        (
            "work-precision",
            Spreadsheet::new(sheet::precision_head(), precisions),
        ),
    ];
    let text = text::describe(info, case, &record, scope.accuracy);
    output.deliver("trade", &text, &document::document(info, &record), &sheets)?;
    if record.is_interrupted() {
        let count = copies(&record).count();
        return Err(output.interrupted(&format!("{count} copies were measured")));
    }
    Ok(())
}

/// All copies with the numbers of their ends.
fn copies(record: &TradeRecord) -> impl Iterator<Item = (usize, Kernel, &Point)> {
    let ends = record.ends.iter().enumerate();
    let curves = ends.flat_map(|(end, at)| at.trade.curves.iter().map(move |curve| (end, curve)));
    curves.flat_map(|(end, curve)| {
        let points = curve.points.iter();
        points.map(move |point| (end, curve.kernel, point))
    })
}

/// All work-precision curves with the numbers of their ends.
fn precision(record: &TradeRecord) -> impl Iterator<Item = (usize, &Precision)> {
    let ends = record.ends.iter().enumerate();
    ends.flat_map(|(end, at)| at.trade.precision.iter().map(move |one| (end, one)))
}
