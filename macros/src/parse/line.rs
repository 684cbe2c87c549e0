//! Each kind of line.

use proc_macro2::Ident;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Attribute, Token, Visibility, parenthesized, token};

use super::docs::{docs, name, undocumented};
use super::foreign::{no_keyword, unknown_keyword};
use super::shape::{next, shape, shaped};
use super::{Grammar, Reader, value};
use crate::arithmetic::Arithmetic;
use crate::formula::Formula;
use crate::syntax::{Line, Rule, Value, word};

impl Reader<'_> {
    /// Reads a line up to its semicolon; mistakes inside a formula do not break it.
    pub(super) fn line(&mut self, input: ParseStream) -> syn::Result<Vec<Line>> {
        let docs = docs(input)?;
        let grammar = self.place.grammar;
        self.nothing_more(input)?;
        let keyword = input.call(Ident::parse_any);
        let keyword = keyword.map_err(|_| no_keyword(input, grammar))?;
        let text = keyword.to_string();
        let Some(shape) = shape(grammar, &text) else {
            return Err(unknown_keyword(&keyword, grammar, input));
        };
        let whole = matches!(text.as_str(), "state" | "param" | "drive" | "structure");
        if grammar == Grammar::Model && whole && self.place.depth > 0 {
            let message = format!(
                "`{text}` cannot stand inside `for`: declare an array as `state x[10] = 0.0;` or `param k[10] = 1.0;` \
                 outside"
            );
            return Err(syn::Error::new(keyword.span(), message));
        }
        shaped((&text, shape), input, |input| {
            match (grammar, text.as_str()) {
                (Grammar::Model, "state") => self.values(&docs, input, false, Line::State),
                (Grammar::Model, "param") => self.values(&docs, input, true, Line::Param),
                (_, "structure") => undocumented(&docs).and_then(|()| self.structure(input)),
                (_, "load") => self.load(docs, input),
                (_, "state") => Ok(vec![Line::State(law_state(docs, input)?)]),
                (_, "param") => Ok(vec![Line::Param(law_param(docs, input)?)]),
                (_, "friction") => self.whole("friction", Line::Friction, |reader| {
                    reader.friction(docs, input)
                }),
                (_, "press") => {
                    self.whole("press", Line::Press, |reader| reader.press(docs, input))
                }
                _ => Ok(vec![self.rule(docs, keyword, input)?]),
            }
        })
    }

    /// What other declarations have before a name is told to be too much, and the line is read all the same.
    fn nothing_more(&mut self, input: ParseStream) -> syn::Result<()> {
        if input.peek(Token![pub]) {
            let word: Visibility = input.parse()?;
            self.errors.at(
                word,
                "`pub` says nothing here: all that is declared is public without it; remove it",
            );
        }
        Ok(())
    }

    /// A word, what its formula is of, and the formula.
    fn rule(&mut self, docs: Vec<Attribute>, word: Ident, input: ParseStream) -> syn::Result<Line> {
        let text = word.to_string();
        if !matches!(text.as_str(), "let" | "drive") {
            undocumented(&docs)?;
        }
        let mut rate = None;
        let (line, name, formula): (fn(Rule) -> Line, _, _) = match text.as_str() {
            "let" => {
                if let Some(word) = input.parse::<Option<Token![mut]>>()? {
                    self.errors.at(word, "`mut` says nothing here: what a `let` line names follows the states by itself; remove it");
                }
                let name = self.declared(input)?;
                no_unit(&name, input)?;
                (Line::Let, name, self.moving_side(input)?)
            }
            "drive" => (Line::Drive, name(input)?, self.at(input)?),
            "stop" => (Line::Stop, name(input)?, self.at(input)?),
            "stick" => (Line::Stick, word.clone(), self.right_side(input)?),
            "slip" => (Line::Slip, self.argument(input)?, self.right_side(input)?),
            "force" if self.place.grammar == Grammar::Press => {
                let (depth, growth) = two_names(input)?;
                rate = Some(growth);
                (Line::Force, depth, self.right_side(input)?)
            }
            "rebound" => (
                Line::Rebound,
                self.argument(input)?,
                self.right_side(input)?,
            ),
            "force" => (Line::Force, self.argument(input)?, self.moving_side(input)?),
            _ => (
                Line::Derivative,
                self.argument(input)?,
                self.moving_side(input)?,
            ),
        };
        Ok(line(Rule {
            docs,
            word,
            name,
            rate,
            formula,
        }))
    }

    /// A state or a parameter of a model, or each element of an array of them.
    fn values(
        &mut self,
        docs: &[Attribute],
        input: ParseStream,
        bounded: bool,
        line: fn(Value) -> Line,
    ) -> syn::Result<Vec<Line>> {
        let names = self.names(input)?;
        if input.peek(Token![,]) {
            return Err(input.error(
                "each state and each parameter has a line of its own, or declare an array: `x[2]`",
            ));
        }
        let unit = value::unit_if_stated(input)?;
        value::equals(input)?;
        let number = Some(value::number(input)?);
        let bounds = bounded.then(|| value::bounds_if_stated(input));
        let bounds = bounds.transpose()?.flatten();
        let single = names.len() == 1;
        let value = |name: Ident| {
            let bounds = bounds.clone().map(|bounds| match single {
                true => bounds,
                // The bounds are written for the array and hold for each element.
                false => bounds.on(&name),
            });
            line(Value {
                docs: docs.to_vec(),
                name,
                unit: unit.clone(),
                number: number.clone(),
                bounds,
            })
        };
        Ok(names.into_iter().map(value).collect())
    }

    /// The right side of a line in which, in a law, the internal state and its kinks may stand.
    fn moving_side(&mut self, input: ParseStream) -> syn::Result<Formula> {
        value::equals(input)?;
        let grammar = match self.place.grammar {
            grammar @ (Grammar::Model | Grammar::Press) => grammar,
            Grammar::Law | Grammar::Memory => Grammar::Memory,
        };
        self.formula_in(grammar, input)
    }

    /// `at formula`
    fn at(&mut self, input: ParseStream) -> syn::Result<Formula> {
        if input.parse::<Option<word::at>>()?.is_none() {
            let found = next(input).unwrap_or_default();
            return Err(input.error(format!("expected `at` before `{found}`")));
        }
        self.formula(input)
    }

    pub(super) fn right_side(&mut self, input: ParseStream) -> syn::Result<Formula> {
        value::equals(input)?;
        self.formula(input)
    }

    pub(super) fn formula(&mut self, input: ParseStream) -> syn::Result<Formula> {
        self.formula_in(self.place.grammar, input)
    }

    fn formula_in(&mut self, grammar: Grammar, input: ParseStream) -> syn::Result<Formula> {
        let mut arithmetic = Arithmetic {
            grammar,
            repeated: self.repeated,
            structures: self.structures,
            errors: self.errors,
        };
        Ok(arithmetic.read(&input.parse()?))
    }
}

/// What a `let` line abbreviates has the unit that follows.
fn no_unit(name: &Ident, input: ParseStream) -> syn::Result<()> {
    if input.peek(Token![:]) && input.peek2(Token![=]) {
        return Err(input.error(format!("`:=` is written `=` here: `let {name} = ...;`")));
    }
    if input.peek(Token![:]) {
        return Err(input.error(format!(
            "a `let` line states no unit, for that of `{name}` follows from its formula: write `let {name} = ...;`"
        )));
    }
    Ok(())
}

/// `(depth, rate)`
fn two_names(input: ParseStream) -> syn::Result<(Ident, Ident)> {
    const BOTH: &str = "a press depends on the depth of the contact and its rate: write `force(d, v) = ...;`, with both names";
    if !input.peek(token::Paren) {
        return Err(input.error(BOTH));
    }
    let inside;
    parenthesized!(inside in input);
    let both = |input: ParseStream| {
        let depth = name(input)?;
        input.parse::<Token![,]>()?;
        Ok((depth, name(input)?))
    };
    let place = inside.fork();
    let found = both(&inside).map_err(|_: syn::Error| place.error(BOTH))?;
    if !inside.is_empty() {
        return Err(inside.error(BOTH));
    }
    Ok(found)
}

fn law_state(docs: Vec<Attribute>, input: ParseStream) -> syn::Result<Value> {
    law_value(docs, input, |name| {
        format!("a law's state has no start: the state of the model that carries `{name}` has one")
    })
}

fn law_param(docs: Vec<Attribute>, input: ParseStream) -> syn::Result<Value> {
    let value = law_value(docs, input, |name| {
        format!(
            "a law's parameter has no default: a model gives `{name}` its value where it names the law"
        )
    })?;
    let bounds = value::bounds_if_stated(input)?;
    Ok(Value { bounds, ..value })
}

/// A name with its unit; what a model would say next is refused.
fn law_value(
    docs: Vec<Attribute>,
    input: ParseStream,
    refusal: impl Fn(&Ident) -> String,
) -> syn::Result<Value> {
    let name = self::name(input)?;
    let unit = value::unit_if_stated(input)?;
    if input.peek(Token![=]) {
        return Err(input.error(refusal(&name)));
    }
    Ok(Value {
        docs,
        name,
        unit,
        number: None,
        bounds: None,
    })
}
