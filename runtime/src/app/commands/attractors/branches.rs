//! The branches of motions that starts have found, in all forms.

use std::ops::ControlFlow;
use std::rc::Rc;

use crate::app::answer::Answer;
use crate::app::commands::{branch, orbit};
use crate::app::document::Document;
use crate::app::failure::Failure;
use crate::app::progress::Progress;
use crate::app::request::Request;
use crate::app::spreadsheet::Columns;
use crate::app::text::{located, number};
use crate::model::ModelInfo;
use crate::report::Panel;
use crate::study::{
    Along, AttractorsRecord, Case, Ended, Followed, FollowedRecord, Kind, OrbitRecord, Spot,
};

/// Follows the motions of a record, and shows how far it has come.
pub(super) fn follow(
    asked: &Request<'_>,
    record: &AttractorsRecord,
    threads: Option<usize>,
) -> Result<FollowedRecord, Failure> {
    let along = asked.along()?;
    let progress = Progress::along(&asked.output, "following the motions");
    let mut watch = |orbit: &OrbitRecord| match orbit.r {
        Some(r) => {
            let message = format!("{} = {}", along.name(asked.info), number(r, 6));
            progress.reach(along.share(r), message)
        }
        None => ControlFlow::Continue(()),
    };
    asked.got(
        asked
            .entry
            .followed_watched(&asked.case, record, threads, &mut watch),
    )
}

/// One line for each branch, and why motions were not followed.
pub(super) fn text(info: &ModelInfo, along: &Along, record: &FollowedRecord) -> String {
    let name = along.name(info);
    let shown = |one: &Followed, end: usize| number(one.span()[end], 6);
    let columns = Columns::new()
        .column("branch", |(count, _): &(usize, &Followed)| {
            count.to_string()
        })
        .column("motions at", |(_, one)| motions(one))
        .column(format!("least {name}"), move |(_, one)| shown(one, 0))
        .column(format!("largest {name}"), move |(_, one)| shown(one, 1))
        .column("ends", |(_, one)| ends(one))
        .column("folds", |(_, one)| folds(one));
    let rows: Vec<(usize, &Followed)> = (1..).zip(&record.branches).collect();
    let mut text = match rows.is_empty() {
        true => format!("\nno periodic motion could be followed along {name}\n"),
        false => format!("\n{}", columns.text(&rows)),
    };
    for (spot, reason) in &record.failed {
        let r = number(spot.r, 6);
        text += &format!(
            "\n  {} at {name} = {r} was not followed: {reason}\n",
            which(spot)
        );
    }
    text
}

/// Where motions of a branch were found; many values in a row are not all named.
fn motions(one: &Followed) -> String {
    let mut values: Vec<f64> = one.motions.iter().map(|spot| spot.r).collect();
    values.dedup();
    match values[..] {
        [first, .., last] if values.len() > 3 => {
            format!(
                "{} values, {}..{}",
                values.len(),
                number(first, 6),
                number(last, 6)
            )
        }
        _ => {
            let values = values.iter().map(|r| number(*r, 6));
            values.collect::<Vec<_>>().join(", ")
        }
    }
}

fn ends(one: &Followed) -> String {
    let began = one.branch.began.as_ref().map(end);
    let ended = end(&one.branch.ended);
    match began {
        _ if one.is_isola() => "none: an isola".to_owned(),
        Some(began) if began != ended => format!("{began}, {ended}"),
        _ => ended,
    }
}

fn end(ended: &Ended) -> String {
    match ended.reaches_bound() {
        true => "end of the range".to_owned(),
        false => ended.word().replace('-', " "),
    }
}

fn folds(one: &Followed) -> String {
    let folds = one
        .branch
        .special
        .iter()
        .filter(|one| one.kind == Kind::Fold);
    let folds = folds.map(|one| located(one.r, one.error));
    folds.collect::<Vec<_>>().join(", ")
}

/// What a motion is called: by its line in the table of its value.
fn which(spot: &Spot) -> String {
    let what = if spot.saddle { "saddle" } else { "motion" };
    format!("{what} {}", spot.place + 1)
}

/// The branches with the motions that lie on them, and what was not followed.
pub(super) fn documents<'a>(
    document: Document<'a>,
    info: &'a ModelInfo,
    record: &FollowedRecord,
) -> Document<'a> {
    let spot = |spot: &Spot| {
        Document::new(info).put("r", spot.r).put(
            if spot.saddle { "saddle" } else { "motion" },
            spot.place + 1,
        )
    };
    let branch = |one: &Followed| {
        Document::new(info)
            .put("isola", one.is_isola())
            .put("span", one.span())
            .list("motions", &one.motions, spot)
            .all(&branch::found(info, &one.branch))
    };
    document.list("branches", &record.branches, branch).list(
        "unfollowed",
        &record.failed,
        |(one, reason)| spot(one).put("reason", reason),
    )
}

/// The tables: `branch-1`, `branch-2`, ...
pub(super) fn sheets<'a>(
    mut answer: Answer<'a>,
    (info, case): (&'a ModelInfo, &'a Case),
    along: &Along,
    record: &'a FollowedRecord,
) -> Answer<'a> {
    let columns = Rc::new(orbit::columns(info, along, &case.harmonics));
    for (count, one) in (1..).zip(&record.branches) {
        let columns = columns.clone();
        let sheet = move || columns.sheet(&one.branch.points);
        answer = answer.sheet(format!("branch-{count}"), sheet);
    }
    answer
}

/// The largest magnitude of a state along all branches.
pub(super) fn panel(info: &ModelInfo, along: &Along, record: &FollowedRecord, j: usize) -> Panel {
    let branches = record.branches.iter().map(|one| &one.branch);
    branch::extents(info, along, (1..).zip(branches), j)
}
