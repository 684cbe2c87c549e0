//! What stands beside errors, so that one mistake is one message: the same names, and nothing in them.

use std::collections::HashSet;

use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, format_ident, quote};

use super::{law as laws, model as models};
use crate::check::{self, is_field};
use crate::formula::{Formula, Kind, Number};
use crate::parse::Grammar;
use crate::repeated::Repeated;
use crate::structure::Structures;
use crate::syntax::{Declaration, Line, Rule, Value};

/// A model in which nothing moves; it names the laws of the one that is written.
pub(super) fn model(written: &Declaration) -> TokenStream {
    let mut least = least(written, &["param", "state", "let", "drive"]);
    if least.states().next().is_none() {
        least.lines.extend(at_rest(&format_ident!("__nothing")));
    }
    let model = check::unasked_model(&least);
    let tokens = model.map(|model| models::tokens(&model, written));
    quote!(#tokens)
}

/// A law without force.
pub(super) fn law(written: &Declaration, grammar: Grammar) -> TokenStream {
    let mut least = least(written, &["param", "state"]);
    let speed = zero(&format_ident!("__speed"));
    if grammar == Grammar::Press {
        let rate = Some(format_ident!("__rate"));
        least.lines.push(Line::Force(Rule { rate, ..speed }));
    } else if written.has_memory() {
        least.lines.push(Line::Force(speed));
    } else {
        least.lines.push(Line::Stick(zero(&written.header.name)));
        least.lines.push(Line::Slip(speed));
    }
    let tokens = check::unasked_law(&least).map(|law| laws::tokens(&law));
    quote!(#tokens)
}

/// What lines of these kinds declare, broken or not, each name once and at zero.
fn least(written: &Declaration, keywords: &[&'static str]) -> Declaration {
    let mut seen = HashSet::new();
    let mut lines = Vec::new();
    for keyword in keywords {
        for name in written.named(keyword) {
            if !is_field(name) || !seen.insert(name.to_token_stream().to_string()) {
                continue;
            }
            match *keyword {
                "param" => lines.push(Line::Param(value(name))),
                "state" => lines.extend(at_rest(name)),
                "let" => lines.push(Line::Let(zero(name))),
                _ => lines.push(Line::Drive(zero(name))),
            }
        }
    }
    Declaration {
        header: written.header.clone(),
        lines,
        repeated: Repeated::default(),
        structures: Structures::default(),
    }
}

/// A state that stays where it is.
fn at_rest(name: &Ident) -> [Line; 2] {
    [Line::State(value(name)), Line::Derivative(zero(name))]
}

fn value(name: &Ident) -> Value {
    Value {
        docs: Vec::new(),
        name: name.clone(),
        unit: None,
        number: Some(nothing()),
        bounds: None,
    }
}

fn zero(name: &Ident) -> Rule {
    Rule {
        docs: Vec::new(),
        word: name.clone(),
        name: name.clone(),
        rate: None,
        formula: Formula {
            kind: Kind::Number(nothing()),
            source: nothing().source,
        },
    }
}

fn nothing() -> Number {
    Number {
        value: 0.0,
        source: quote!(0.0),
    }
}
