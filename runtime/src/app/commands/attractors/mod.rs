//! `attractors`: all motions on which a system settles, without a seed.

mod answer;
mod branches;
mod drawn;
mod picture;
mod region;
mod saddles;

use clap::Args;

use crate::app::arguments::{Subject, Way};
use crate::app::failure::{Failure, refuse};
use crate::app::ledger::{Ledger, Sharing};
use crate::app::offer::App;
use crate::app::question::Question;
use crate::app::request::request;
use crate::app::show::Show;
use crate::app::values::{Reading, counted};
use crate::model::ModelInfo;
use crate::study::{Fate, FollowedRecord, Item, Region, Rows, Sampling};
pub(in crate::app::commands) use region::Sides;

/// Most starts in all: so many are kept in memory.
const MOST: usize = 100_000_000;

/// Find all motions on which starts in a region settle, and the share of each
#[derive(Debug, Clone, Args)]
#[command(
    after_help = "The starts fill the region evenly, and each depends on its number alone: nothing depends on threads or \
                  shares. States without a side begin at the start. The interval is Wilson's at 95 %, as if the starts \
                  were independent"
)]
pub(in crate::app) struct Arguments {
    #[command(flatten)]
    subject: Subject,
    #[command(flatten)]
    way: Way,
    /// How many values of what is followed
    #[arg(long, value_name = "N", default_value = "11", value_parser = counted::<2, 1_000_000>())]
    values: usize,
    /// Where starts lie: `x=-2..2,v=0..2`
    #[arg(long = "box", value_name = "NAME=A..B,..", value_parser = Reading(Sides::read))]
    region: Option<Sides>,
    /// How many starts at each value
    #[arg(long, value_name = "N", default_value = "1000", value_parser = counted::<1, 10_000_000>())]
    starts: usize,
    /// Shares as areas, too, by lines across a region with two sides: some four digits more
    #[arg(long)]
    areas: bool,
    /// Saddles too, on the edges between basins
    #[arg(long)]
    edges: bool,
    /// Further unstable orbits too, by Newton's method from beside what was found: there may be others
    #[arg(long)]
    further: bool,
    /// Follow the periodic motions along the parameter, too, each branch once and both ways: closed ones are isolas
    #[arg(long)]
    follow: bool,
    #[command(flatten)]
    show: Show,
    #[command(flatten)]
    sharing: Sharing,
}

pub(in crate::app) fn perform(app: &App, arguments: &Arguments) -> Result<(), Failure> {
    let Some(sides) = &arguments.region else {
        return refuse!(
            "`attractors` needs `--box NAME=A..B,..`: where starts lie, state by state"
        );
    };
    let asked = request(app, &arguments.subject, arguments.way.along.as_ref(), None)?;
    if arguments.follow && asked.case.along.is_none() {
        return refuse!("`--follow` needs `--along NAME=A..B`: what to follow the motions along");
    }
    let sampling = Sampling {
        region: sides.of(asked.info)?,
        starts: arguments.starts,
        values: asked.case.along.map_or(1, |_| arguments.values),
        areas: arguments.areas,
        edges: arguments.edges,
        further: arguments.further,
    };
    if sampling.areas && sampling.region.sides.len() != 2 {
        return refuse!("`--areas` are those of a region with two sides: `--box x=A..B,v=C..D`");
    }
    let shown = arguments.shown(asked.info, &sampling.region)?;
    let count = sampling.values.checked_mul(sampling.starts);
    let Some(count) = count.filter(|count| *count <= MOST) else {
        return refuse!("`--values` times `--starts` are more than {MOST}");
    };
    let question =
        Question::new(app.version, asked.info, &asked.case).exactly("`--box`", &sampling);
    let rows = Rows::of(count);
    let ledger: Ledger<Fate> =
        Ledger::open(&asked, &arguments.sharing, "attractors", question, rows)?;
    let (case, output) = (&asked.case, &asked.output);
    let beginning = "following the first starts";
    let followed = |_: &Item<'_, Fate>| "starts followed".to_owned();
    let record = ledger.answer(&asked, beginning, &followed, |list, watch| {
        asked.entry.attractors_watched(case, &sampling, list, watch)
    })?;
    if !ledger.is_shared() {
        let whole = arguments.follow && record.missing == 0;
        let followed = whole.then(|| branches::follow(&asked, &record, ledger.threads()));
        let followed = followed.transpose()?;
        let found = (&record, followed.as_ref());
        output.deliver(&answer::answer(asked.info, case, found, shown))?;
        if let Some(followed) = followed.filter(FollowedRecord::is_interrupted) {
            let count = followed.branches.len();
            return Err(output.interrupted(&format!("{count} branches were begun")));
        }
    }
    ledger.close(output, record.missing)
}

impl Arguments {
    /// The two states of the picture: those asked for, else the first of the region.
    fn shown(&self, info: &ModelInfo, region: &Region) -> Result<[usize; 2], Failure> {
        let sides: Vec<usize> = region.sides.iter().map(|side| side.state).collect();
        let first = sides.first().copied().unwrap_or(0);
        let usual = [first, sides.get(1).copied().unwrap_or(first)];
        match self.show.states(info)? {
            None => Ok(usual),
            Some(states) => match states.as_slice() {
                [x, y] => Ok([*x, *y]),
                _ => refuse!("`--show` names the two states of the picture: `--show x,v`"),
            },
        }
    }
}
