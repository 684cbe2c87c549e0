//! Laws by their names: alone, or where they act in a model.

use heck::ToKebabCase;

use super::curve::Curve;
use super::drawn::drawn;
use super::exhibit::{Exhibit, Place, Wish};
use super::swing::{strike, swing};
use crate::app::document::unit;
use crate::app::failure::{Failure, refuse};
use crate::app::offer::App;
use crate::app::request;
use crate::app::values::Assignment;
use crate::app::words::{place, unknown};
use crate::model::{Friction, ModelInfo};
use crate::study::{Acting, Case, Characteristic, Dynamics, Shown, Specimen, System};

pub(super) enum Found<'a> {
    Law(&'a Shown),
    Model(&'a System),
}

/// The name of a law as a type.
fn type_name(law: &Shown) -> &'static str {
    match law {
        Shown::Static(specimen) => specimen.law().name,
        Shown::Remembering(specimen) => specimen.law().name,
        Shown::Pressing(specimen) => specimen.law().name,
    }
}

/// A law by its name as a word or as a type, or a model.
pub(super) fn find<'a>(app: &'a App, name: &str) -> Result<Found<'a>, Failure> {
    let is_named = |law: &&Shown| {
        let known = type_name(law);
        known == name || known.to_kebab_case() == name
    };
    if let Some(law) = app.laws.iter().find(is_named) {
        return Ok(Found::Law(law));
    }
    app.entry(name).map(Found::Model).map_err(|_| {
        let names = names(app);
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        Failure::usage(unknown("there is no law and no model", name, &names))
    })
}

pub(super) fn names(app: &App) -> Vec<String> {
    let laws = app.laws.iter().map(|one| type_name(one).to_kebab_case());
    laws.chain(app.names().into_iter().map(str::to_owned))
        .collect()
}

/// A law of the list at its typical values, or at those of `--set`.
pub(super) fn lone(law: &Shown, set: &[Assignment], wish: &Wish) -> Result<Exhibit, Failure> {
    match law {
        Shown::Static(specimen) => {
            let (values, built) = at_values(specimen, specimen.law().name, set)?;
            let curve = curve(wish, built.as_ref(), ["m/s", "N"])?;
            Ok(drawn(specimen.law(), None, &values, &curve))
        }
        Shown::Remembering(specimen) => {
            let (values, built) = at_values(specimen, specimen.law().name, set)?;
            swing(built.as_ref(), None, &values, wish)
        }
        Shown::Pressing(specimen) => {
            let (values, built) = at_values(specimen, specimen.law().name, set)?;
            strike(built.as_ref(), None, &values, wish, 1.0)
        }
    }
}

/// The values of a law's parameters, typical or as `--set` says, and the law there.
fn at_values<L: ?Sized>(
    specimen: &Specimen<L>,
    law: &str,
    set: &[Assignment],
) -> Result<(Vec<f64>, Box<L>), Failure> {
    let (mut values, parameters) = (specimen.values(), specimen.parameters());
    let names: Vec<&str> = parameters.iter().map(|declared| declared.name).collect();
    for one in set {
        let what = format!("`{law}` has no parameter");
        values[place(&what, &one.name, &names)?] = one.value;
    }
    let built = specimen
        .at(&values)
        .map_err(|error| Failure::usage(format!("`{law}`: {error}")))?;
    Ok((values, built))
}

/// The laws of a model's contacts, at its parameters and its start.
pub(super) fn acting(
    entry: &System,
    set: &[Assignment],
    wish: &Wish,
) -> Result<Vec<Exhibit>, Failure> {
    let info = entry.info();
    if !info.touches() && info.memories.is_empty() {
        return refuse!("`{}` has no friction", info.command);
    }
    let mut case = Case::declared(info, Dynamics::Exact);
    request::set(info, set, &mut case)?;
    let mut all = Vec::new();
    entry.laws(&case, &mut |law| all.push(exhibit(info, law, wish)));
    all.into_iter().collect()
}

/// A law where it acts.
fn exhibit(info: &ModelInfo, law: Acting<'_>, wish: &Wish) -> Result<Exhibit, Failure> {
    match law {
        Acting::Static(index, law) => {
            let contact = &info.contacts[index];
            let units = [contact.speed_unit, contact.unit].map(|of| unit(of).unwrap_or_default());
            let curve = curve(wish, law, units)?;
            let place = placed(info, contact, contact.law.name);
            Ok(drawn(contact.law, Some(place), &[], &curve))
        }
        Acting::Remembering(index, law) => {
            let memory = &info.memories[index];
            let (name, place) = placed(info, memory, memory.law.name);
            let states = memory.states.iter().map(|state| info.states[*state].name);
            let with = states.collect::<Vec<_>>().join(", ");
            let place = (name, format!("{place} with {with}"));
            swing(law, Some(place), &[], wish)
        }
        Acting::Pressing(index, law, gap) => {
            let press = &info.presses[index];
            let (name, fields, gap_of) = (press.name, press.fields, press.gap);
            let declared = format!(
                "{name} = {} {{ {fields} }} closing {gap_of}",
                press.law.name
            );
            let place = (format!("{}-{name}", info.command), declared);
            let depth = if gap == 0.0 { 1.0 } else { gap.abs() };
            strike(law, Some(place), &[], wish, depth)
        }
    }
}

/// The name of a friction where it acts, and how it is declared.
fn placed<L>(info: &ModelInfo, line: &Friction<L>, law: &str) -> Place {
    let (name, fields, speed) = (line.name, line.fields, line.speed);
    let declared = format!("{name} = {law} {{ {fields} }} opposing {speed}");
    (format!("{}-{name}", info.command), declared)
}

/// The curve of a law as wished for.
fn curve(
    wish: &Wish,
    law: &dyn Characteristic,
    units: [&'static str; 2],
) -> Result<Curve, Failure> {
    if let Some(smoothing) = wish.smoothing {
        law.accepts(smoothing)
            .map_err(|error| Failure::usage(format!("`--smooth {smoothing}`: {error}")))?;
    }
    Ok(Curve::of(law, units, wish.speed, wish.smoothing))
}
