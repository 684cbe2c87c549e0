//! `trade`: what smoothing costs, and what it gets wrong.

mod arguments;
mod document;
mod sheet;
mod text;

use crate::app::App;
use crate::app::failure::Failure;
use crate::app::interrupt;
use crate::app::progress::Progress;
use crate::app::request::{Request, request};
use crate::app::spreadsheet::Spreadsheet;
use crate::field::{Design, Kernel};
use crate::study::TradeRecord;
use crate::study::trade::{Finding, Point, Precision};
pub(in crate::app) use arguments::Arguments;

pub(in crate::app) fn perform(app: &App, arguments: &Arguments) -> Result<(), Failure> {
    arguments.resume.refuse()?;
    let Request {
        entry,
        info,
        case,
        output,
    } = request(
        app,
        &arguments.subject,
        arguments.along.as_ref(),
        arguments.guess.period,
    )?;
    let scope = arguments.scope(&case);
    if case.along.map(|along| along.design) == Some(Design::Smoothing) {
        let message = "`trade` goes through the sizes by itself: `--along` takes a parameter";
        return Err(Failure::usage(message));
    }
    let progress = Progress::endless(&output, "measuring what smoothing costs");
    let heads = [sheet::head(info), sheet::precision_head()];
    let [trade, precise] = heads.clone();
    let mut errors = output.journal("trade", trade);
    let mut precisions = output.journal("work-precision", precise);
    let mut watch = |end: usize, finding: Finding<'_>| {
        match finding {
            Finding::Copy(kernel, point) => errors.add([sheet::row((end, kernel, point))]),
            Finding::Precision(one) => precisions.add(sheet::precision_rows((end, one))),
        }
        interrupt::verdict()
    };
    let record = entry
        .trade(&case, &scope, &mut watch)
        .map_err(|error| Failure::of(&error, info))?;
    drop(progress);
    let [trade, precise] = heads;
    let precisions = precision(&record).flat_map(sheet::precision_rows);
    let sheets = [
        (
            "trade",
            Spreadsheet::new(trade, copies(&record).map(sheet::row)),
        ),
        ("work-precision", Spreadsheet::new(precise, precisions)),
    ];
    let text = text::describe(info, &case, &record, scope.accuracy);
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
