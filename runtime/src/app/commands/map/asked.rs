//! The question of a map, as it is written.

use crate::app::commands::attractors::Sides;
use crate::app::failure::{Failure, refuse};
use crate::app::request::state;
use crate::app::words::unknown;
use crate::field::Smoothing;
use crate::model::ModelInfo;
use crate::study::{Asked, Class, Quantity};

/// The words that begin a question, beside those of quantities.
const WORDS: [&str; 4] = ["motion", "equilibrium", "share", "smoothing"];

/// `motion`, `amplitude:x`, `share:orbit`, `smoothing:arctan:1e5`.
pub(super) fn read(
    info: &ModelInfo,
    question: &str,
    starts: (Option<&Sides>, usize),
) -> Result<Asked, Failure> {
    let (word, rest) = match question.split_once(':') {
        Some((word, rest)) => (word, Some(rest)),
        None => (question, None),
    };
    let quantity = Quantity::ALL
        .into_iter()
        .find(|quantity| quantity.name() == word);
    if starts.0.is_some() && word != "share" {
        return refuse!("`--box` says where starts lie, and `{question}` has only one: `--start`");
    }
    match (word, quantity, rest) {
        ("motion", _, None) => Ok(Asked::Motion),
        ("equilibrium", _, None) => Ok(Asked::Equilibrium),
        (_, Some(Quantity::Amplitude), Some(name)) => {
            Ok(Asked::Quantity(Quantity::Amplitude, state(info, name)?))
        }
        (_, Some(quantity), None) => Ok(Asked::Quantity(quantity, 0)),
        ("share", _, Some(class)) => share(info, starts, class),
        ("share", _, None) => refuse!("`share` of what? For instance `share:orbit`"),
        ("smoothing", _, Some(copy)) => smoothing(question, copy),
        ("smoothing", _, None) => {
            refuse!("`smoothing` by which copy? For instance `smoothing:arctan:1e5`")
        }
        (word, _, Some(_)) if quantity.is_some() || WORDS.contains(&word) => {
            refuse!("`{word}` has nothing after it: `{question}` is one word too long")
        }
        _ => {
            let names = Quantity::ALL.map(Quantity::name);
            let all: Vec<&str> = WORDS.iter().chain(&names).copied().collect();
            Err(Failure::usage(unknown(
                "a map cannot be asked for",
                word,
                &all,
            )))
        }
    }
}

fn share(
    info: &ModelInfo,
    (sides, starts): (Option<&Sides>, usize),
    class: &str,
) -> Result<Asked, Failure> {
    let Some(sides) = sides else {
        return refuse!(
            "`share:{class}` needs `--box NAME=A..B,..`: where starts lie, state by state"
        );
    };
    let names: Vec<&str> = Class::ALL.iter().map(|class| class.name()).collect();
    let Some(class) = Class::ALL.into_iter().find(|one| one.name() == class) else {
        return Err(Failure::usage(unknown(
            "there is no class of motions",
            class,
            &names,
        )));
    };
    Ok(Asked::Share(class, sides.of(info)?, starts))
}

fn smoothing(question: &str, copy: &str) -> Result<Asked, Failure> {
    match copy.parse::<Smoothing>() {
        Ok(smoothing) => Ok(Asked::Smoothing(smoothing)),
        Err(error) => refuse!("`{question}`: {error}"),
    }
}
