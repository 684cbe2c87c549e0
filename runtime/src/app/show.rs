//! `--show`: which quantities a picture shows.

use std::collections::BTreeSet;

use clap::Args;

use super::failure::{Failure, refuse};
use super::request::state;
use super::words::place;
use crate::model::{ModelInfo, Unit};

/// Curves of states, or of friction forces, that are few enough to be told apart.
const FEW: usize = 6;

#[derive(Debug, Clone, Args)]
pub(super) struct Show {
    /// What the pictures show, for instance `x1,x2`: of motions also friction forces and `let` lines
    #[arg(long, value_name = "NAME,..")]
    show: Option<String>,
}

/// Something that a motion has at each time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Quantity {
    pub(super) name: &'static str,
    pub(super) unit: Option<Unit>,
    pub(super) of: Kind,
    /// Which one of its kind.
    pub(super) index: usize,
}

/// What kinds of quantities there are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Kind {
    State,
    Observable,
    Force,
}

/// The states, observables and friction forces of a model, in this order.
pub(super) fn quantities(info: &ModelInfo) -> impl Iterator<Item = Quantity> {
    let kind = |of| {
        move |(index, (name, unit))| Quantity {
            name,
            unit,
            of,
            index,
        }
    };
    let states = info.states.iter().map(|one| (one.name, one.unit));
    let observables = info.observables.iter().map(|one| (one.name, one.unit));
    let states = states.enumerate().map(kind(Kind::State));
    let observables = observables.enumerate().map(kind(Kind::Observable));
    states
        .chain(observables)
        .chain(info.forces().enumerate().map(kind(Kind::Force)))
}

impl Show {
    fn names(&self) -> Option<impl Iterator<Item = &str>> {
        let names = self.show.as_ref()?;
        Some(names.split(',').map(str::trim))
    }

    /// The states that are asked for, if any are.
    pub(super) fn states(&self, info: &ModelInfo) -> Result<Option<Vec<usize>>, Failure> {
        let all = self
            .names()
            .map(|names| names.map(|name| state(info, name)));
        let all = all
            .map(Iterator::collect::<Result<Vec<usize>, _>>)
            .transpose()?;
        if let Some(twice) = all.as_deref().and_then(repeated) {
            return refuse!(
                "`--show` names `{}` more than once",
                info.states[twice].name
            );
        }
        Ok(all)
    }

    /// The quantities that are asked for; without a word all states and forces, or the outermost of many.
    pub(super) fn quantities(&self, info: &ModelInfo) -> Result<Vec<Quantity>, Failure> {
        let all: Vec<Quantity> = quantities(info).collect();
        let Some(names) = self.names() else {
            let of = |kind| all.iter().filter(move |one| one.of == kind).copied();
            return Ok([few(of(Kind::State)), few(of(Kind::Force))].concat());
        };
        let known: Vec<&str> = all.iter().map(|one| one.name).collect();
        let what = format!(
            "`{}` has no state, `let` line or friction force",
            info.command
        );
        let places = names.map(|name| place(&what, name, &known));
        let places = places.collect::<Result<Vec<usize>, _>>()?;
        if let Some(twice) = repeated(&places) {
            return refuse!("`--show` names `{}` more than once", known[twice]);
        }
        Ok(places.into_iter().map(|place| all[place]).collect())
    }
}

fn repeated(places: &[usize]) -> Option<usize> {
    let mut seen = BTreeSet::new();
    places.iter().copied().find(|place| !seen.insert(*place))
}

/// All quantities if they are few, else the first and the last of each array, as many as can be told apart.
fn few(all: impl Iterator<Item = Quantity>) -> Vec<Quantity> {
    let all: Vec<Quantity> = all.collect();
    if all.len() <= FEW {
        return all;
    }
    let runs = all.chunk_by(|a, b| family(a.name) == family(b.name));
    let mut ends: Vec<Quantity> = Vec::new();
    for run in runs {
        for one in [run.first(), run.last()].into_iter().flatten() {
            if !ends.contains(one) {
                ends.push(*one);
            }
        }
    }
    ends.truncate(FEW);
    ends
}

/// A name without its number: `x` of `x[3]` and `x4`.
pub(super) fn family(name: &str) -> &str {
    name.trim_end_matches(|end: char| end.is_ascii_digit() || "[]_".contains(end))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn named(names: &[&'static str]) -> Vec<&'static str> {
        let all = names.iter().enumerate().map(|(index, name)| Quantity {
            name,
            unit: None,
            of: Kind::State,
            index,
        });
        few(all).iter().map(|one| one.name).collect()
    }

    #[test]
    fn of_many_the_outermost_are_shown() {
        let six = ["x1", "v1", "x2", "v2", "x3", "v3"];
        assert_eq!(named(&six), six);
        let chain = [
            "x[0]", "x[1]", "x[2]", "x[3]", "v[0]", "v[1]", "v[2]", "v[3]",
        ];
        assert_eq!(named(&chain), ["x[0]", "x[3]", "v[0]", "v[3]"]);
        let pairs = ["x1", "v1", "x2", "v2", "x3", "v3", "x4", "v4"];
        assert_eq!(named(&pairs), six);
    }
}
