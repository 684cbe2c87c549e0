//! `map`: a question asked at every node of a grid of two parameters.

mod answer;
mod asked;
mod axis;
mod picture;

use clap::Args;

use crate::app::arguments::Subject;
use crate::app::commands::attractors::Sides;
use crate::app::failure::{Failure, refuse};
use crate::app::ledger::{Ledger, Sharing};
use crate::app::offer::App;
use crate::app::question::Question;
use crate::app::request::{along, request};
use crate::app::values::{Reading, counted};
use crate::study::{Cell, Grid, Item, Rows};
use axis::Spaced;

/// Most nodes: so many are kept in memory.
const MOST: usize = 10_000_000;

/// Ask a question at every node of a grid of two parameters
#[derive(Debug, Clone, Args)]
#[command(
    after_help = "Questions: `motion`, on what the start settles, and of that `period`, `amplitude`, `amplitude:STATE`, \
                  `multiplier` or `exponent`; `equilibrium`, the largest real part of its eigenvalues; `share:CLASS` of \
                  the starts in `--box`, for instance `share:orbit`; `smoothing:KERNEL:SIZE`, the predicted error of the \
                  frequency. Each node is answered by itself: nothing is taken from a neighbour"
)]
pub(in crate::app) struct Arguments {
    #[command(flatten)]
    subject: Subject,
    /// What is asked
    #[arg(default_value = "motion")]
    question: String,
    /// The parameter across, with the number of its values [default: 50]
    #[arg(long, value_name = "NAME=A..B:N", value_parser = Reading(Spaced::read))]
    along: Option<Spaced>,
    /// The parameter upwards
    #[arg(long, value_name = "NAME=C..D:N", value_parser = Reading(Spaced::read))]
    and: Option<Spaced>,
    /// Where starts lie, for `share`
    #[arg(long = "box", value_name = "NAME=A..B,..", value_parser = Reading(Sides::read))]
    region: Option<Sides>,
    /// How many starts at each node, for `share`
    #[arg(long, value_name = "N", default_value = "200", value_parser = counted::<1, 10_000_000>())]
    starts: usize,
    #[command(flatten)]
    sharing: Sharing,
}

pub(in crate::app) fn perform(app: &App, arguments: &Arguments) -> Result<(), Failure> {
    let (Some(across), Some(up)) = (&arguments.along, &arguments.and) else {
        return refuse!("`map` needs two parameters: `--along NAME=A..B:N --and NAME=C..D:N`");
    };
    let asked = request(app, &arguments.subject, Some(&across.range), None)?;
    let (info, output) = (asked.info, &asked.output);
    let grid = Grid {
        along: [asked.along()?, along(info, "--and", &up.range)?],
        values: [across.count, up.count],
    };
    if grid.along[0].design == grid.along[1].design {
        return refuse!("`--along` and `--and` name the same parameter: a map has two");
    }
    let Some(count) = grid.count().filter(|count| *count <= MOST) else {
        return refuse!("the grid has more than {MOST} nodes");
    };
    let starts = (arguments.region.as_ref(), arguments.starts);
    let wanted = asked::read(info, &arguments.question, starts)?;
    let question = Question::new(app.version, info, &asked.case)
        .exactly("`--and`", &grid)
        .exactly("the question", &wanted);
    let rows = Rows::of(count);
    let ledger: Ledger<Cell> = Ledger::open(&asked, &arguments.sharing, "map", question, rows)?;
    let beginning = "looking for the first node";
    let kind = |item: &Item<'_, Cell>| item.found.kind.clone();
    let record = ledger.answer(&asked, beginning, &kind, |list, watch| {
        let (entry, case) = (asked.entry, &asked.case);
        entry.map_watched(case, (&grid, &wanted), list, watch)
    })?;
    if !ledger.is_shared() {
        output.deliver(&answer::answer(
            info,
            &asked.case,
            &record,
            &arguments.question,
        ))?;
    }
    ledger.close(output, record.missing)
}
