//! `laws`: friction laws, and their forces against the sliding speed.

mod curve;
mod describe;
mod document;
mod draw;
mod exhibit;
mod swing;

use clap::ArgMatches;
use serde_json::{Value, json};

use super::App;
use super::failure::Failure;
use super::options::{set, text};
use super::output::Output;
use super::words::{assignment, number as parsed, positive, unknown};
use crate::field::Smoothing;
use crate::friction::LawInfo;
use crate::study::{Case, Characteristic, Dynamics, Shown, Specimen, System};
use curve::Curve;
use exhibit::Exhibit;
use swing::swing;

pub(super) fn perform(app: &App, options: &ArgMatches) -> Result<(), Failure> {
    match text(options, "LAW") {
        Some(name) => one(app, name, options),
        None => all(app, options),
    }
}

/// The name of a law on the command line: `PoppStelter` is `popp-stelter`.
fn command(law: &str) -> String {
    let mut command = String::new();
    for (i, letter) in law.char_indices() {
        if letter.is_uppercase() && i > 0 {
            command.push('-');
        }
        command.extend(letter.to_lowercase());
    }
    command
}

/// What is drawn: a law, where it acts, and its curve.
struct Drawn {
    name: String,
    law: &'static LawInfo,
    /// Where it acts, as declared.
    place: Option<String>,
    /// Values of the law's parameters, where they are given and not computed.
    values: Vec<f64>,
    curve: Curve,
}

/// What the command line says of the drawing.
struct Wish {
    smoothing: Option<Smoothing>,
    speed: Option<f64>,
    amplitude: Option<f64>,
}

impl Wish {
    fn read(options: &ArgMatches) -> Result<Self, Failure> {
        let smoothing = text(options, "smooth").map(|word| {
            word.parse()
                .map_err(|error| Failure::usage(format!("`--smooth {word}`: {error}")))
        });
        let length = |name: &str| {
            let word = text(options, name);
            word.map(|word| positive(&format!("--{name}"), word))
                .transpose()
        };
        Ok(Self {
            smoothing: smoothing.transpose()?,
            speed: length("speed")?,
            amplitude: length("amplitude")?,
        })
    }

    /// The curve of a law as wished for.
    fn curve(&self, law: &dyn Characteristic, units: [&'static str; 2]) -> Result<Curve, Failure> {
        if let Some(smoothing) = self.smoothing {
            law.accepts(smoothing)
                .map_err(|error| Failure::usage(format!("`--smooth {smoothing}`: {error}")))?;
        }
        Ok(Curve::of(law, units, self.speed, self.smoothing))
    }
}

fn one(app: &App, name: &str, options: &ArgMatches) -> Result<(), Failure> {
    let wish = Wish::read(options)?;
    let exhibits = match find(app, name)? {
        Found::Law(law) => vec![lone(law, options, &wish)?],
        Found::Model(entry) => acting(entry, options, &wish)?,
    };
    let text = exhibits
        .iter()
        .map(|one| one.text.as_str())
        .collect::<Vec<_>>()
        .join("\n");
    deliver(name, &text, &exhibits, options)
}

fn all(app: &App, options: &ArgMatches) -> Result<(), Failure> {
    if let Some(word) = text(options, "set") {
        return Err(Failure::usage(format!(
            "`--set {word}` sets a parameter of one law or model: name it, as in `laws {}`",
            names(app).first().map_or("", String::as_str)
        )));
    }
    let wish = Wish {
        smoothing: None,
        amplitude: None,
        ..Wish::read(options)?
    };
    let mut exhibits = Vec::new();
    for law in &app.laws {
        exhibits.push(lone(law, options, &wish)?);
    }
    let listed = exhibits
        .iter()
        .map(|one| one.listing.as_str())
        .collect::<Vec<_>>();
    let hint = format!(
        "{}`laws MODEL` draws the laws that act in a model: {}\n",
        if listed.is_empty() { "" } else { "\n" },
        app.names().join(", ")
    );
    deliver("laws", &(listed.join("\n") + &hint), &exhibits, options)
}

fn deliver(
    name: &str,
    text: &str,
    exhibits: &[Exhibit],
    options: &ArgMatches,
) -> Result<(), Failure> {
    let output = Output::new(options)?;
    let drawn = output.draw(
        exhibits
            .iter()
            .map(|one| (one.name.as_str(), one.figure.clone())),
    );
    let document = match exhibits {
        [one] if name != "laws" => one.document.clone(),
        _ => {
            let documents: Vec<&Value> = exhibits.iter().map(|one| &one.document).collect();
            json!({ "laws": documents })
        }
    };
    let sheets: Vec<_> = exhibits
        .iter()
        .map(|one| (one.name.as_str(), one.sheet.clone()))
        .collect();
    output.deliver(name, text, &document, &sheets).and(drawn)
}

enum Found<'a> {
    Law(&'a Shown),
    Model(&'a System),
}

/// The name of a law as a type.
fn type_name(law: &Shown) -> &'static str {
    match law {
        Shown::Static(specimen) => specimen.law().name,
        Shown::Remembering(remembering) => remembering.specimen.law().name,
    }
}

/// A law by its name as a word or as a type, or a model.
fn find<'a>(app: &'a App, name: &str) -> Result<Found<'a>, Failure> {
    let is_named = |law: &&Shown| {
        let known = type_name(law);
        known == name || command(known) == name
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

fn names(app: &App) -> Vec<String> {
    let laws = app.laws.iter().map(|one| command(type_name(one)));
    laws.chain(app.names().into_iter().map(str::to_owned))
        .collect()
}

/// A law of the list at its typical values, or at those of `--set`.
fn lone(law: &Shown, options: &ArgMatches, wish: &Wish) -> Result<Exhibit, Failure> {
    match law {
        Shown::Static(specimen) => {
            let (values, built) = at_values(specimen, specimen.law().name, options)?;
            let drawn = Drawn {
                name: command(specimen.law().name),
                law: specimen.law(),
                place: None,
                values,
                curve: wish.curve(built.as_ref(), ["m/s", "N"])?,
            };
            Ok(drawn.exhibit())
        }
        Shown::Remembering(remembering) => {
            let name = remembering.specimen.law().name;
            let (values, built) = at_values(&remembering.specimen, name, options)?;
            swing(remembering, built.as_ref(), &values, wish)
        }
    }
}

/// The values of a law's parameters, typical or as `--set` says, and the law there.
fn at_values<L: ?Sized>(
    specimen: &Specimen<L>,
    law: &str,
    options: &ArgMatches,
) -> Result<(Vec<f64>, Box<L>), Failure> {
    let (mut values, parameters) = (specimen.values(), specimen.parameters());
    for word in options.get_many::<String>("set").into_iter().flatten() {
        let (name, value) = assignment("--set", word)?;
        let place = parameters.iter().position(|declared| declared.name == name);
        let Some(place) = place else {
            let names: Vec<&str> = parameters.iter().map(|declared| declared.name).collect();
            let what = format!("`{law}` has no parameter");
            return Err(Failure::usage(unknown(&what, name, &names)));
        };
        values[place] = parsed(&format!("--set {word}"), value)?;
    }
    let built = specimen
        .at(&values)
        .map_err(|error| Failure::usage(format!("`{law}`: {error}")))?;
    Ok((values, built))
}

/// The laws of a model's contacts, at its parameters and its start.
fn acting(entry: &System, options: &ArgMatches, wish: &Wish) -> Result<Vec<Exhibit>, Failure> {
    let info = entry.info();
    if info.contacts.is_empty() {
        return Err(Failure::usage(format!(
            "`{}` has no friction",
            info.command
        )));
    }
    let mut case = Case::declared(info, Dynamics::Exact);
    set(info, options, &mut case)?;
    let mut drawn = Vec::new();
    entry.laws(&case, &mut |index, law| {
        let contact = &info.contacts[index];
        let units =
            [contact.speed_unit, contact.unit].map(|unit| unit.map_or("", |unit| unit.text));
        drawn.push(wish.curve(law, units).map(|curve| {
            Drawn {
                name: format!("{}-{}", info.command, contact.name),
                law: contact.law,
                place: Some(format!(
                    "{} = {} {{ {} }} opposing {}",
                    contact.name, contact.law.name, contact.fields, contact.speed
                )),
                values: Vec::new(),
                curve,
            }
            .exhibit()
        }));
    });
    drawn.into_iter().collect()
}

impl Drawn {
    /// Both lines of the law, as written.
    fn formulas(&self) -> [String; 2] {
        let law = self.law;
        [
            format!("stick = {}", law.stick),
            format!("slip(s) = {}", law.slip),
        ]
    }
}
