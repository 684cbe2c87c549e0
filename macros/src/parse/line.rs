//! Each kind of line.

use proc_macro2::Ident;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Attribute, Path, Token, braced, parenthesized};

use super::shape::{self, no_keyword, shaped, unknown_keyword};
use super::{Grammar, value};
use crate::arithmetic;
use crate::errors::Errors;
use crate::formula::Formula;
use crate::syntax::{Derivative, Field, Friction, Let, Line, Param, Slip, State, Stick, word};

/// Reads lines of one grammar; mistakes inside a formula do not break its line.
pub(super) struct Reader<'a> {
    pub(super) grammar: Grammar,
    pub(super) errors: &'a mut Errors,
}

impl Reader<'_> {
    /// Reads a line up to its semicolon.
    pub(super) fn line(&mut self, input: ParseStream) -> syn::Result<Line> {
        let docs = docs(input)?;
        let keyword = input
            .call(Ident::parse_any)
            .map_err(|_| no_keyword(input, self.grammar))?;
        match (self.grammar, keyword.to_string().as_str()) {
            (Grammar::Model, "state") => shaped(shape::STATE, input, |input| state(docs, input)),
            (Grammar::Model, "param") => shaped(shape::PARAM, input, |input| param(docs, input)),
            (Grammar::Law, "param") => {
                shaped(shape::LAW_PARAM, input, |input| law_param(docs, input))
            }
            (Grammar::Model, "let") => {
                shaped(shape::LET, input, |input| self.quantity(docs, input))
            }
            (Grammar::Model, "friction") => {
                shaped(shape::FRICTION, input, |input| self.friction(docs, input))
            }
            (Grammar::Model, "der") => {
                shaped(shape::DER, input, |input| self.derivative(&docs, input))
            }
            (Grammar::Law, "stick") => shaped(shape::STICK, input, |input| {
                self.stick(&docs, &keyword, input)
            }),
            (Grammar::Law, "slip") => shaped(shape::SLIP, input, |input| {
                self.slip(&docs, &keyword, input)
            }),
            _ => Err(unknown_keyword(&keyword, self.grammar, input)),
        }
    }

    fn quantity(&mut self, docs: Vec<Attribute>, input: ParseStream) -> syn::Result<Line> {
        let name = self::name(input)?;
        let formula = self.right_side(input)?;
        Ok(Line::Let(Let {
            docs,
            name,
            formula,
        }))
    }

    fn friction(&mut self, docs: Vec<Attribute>, input: ParseStream) -> syn::Result<Line> {
        let name = self::name(input)?;
        let unit = value::unit_if_stated(input)?;
        input.parse::<Token![=]>()?;
        let law = input.call(Path::parse_mod_style)?;
        let fields = self.fields(input)?;
        input.parse::<word::opposing>()?;
        let speed = self.formula(input)?;
        Ok(Line::Friction(Friction {
            docs,
            name,
            unit,
            law,
            fields,
            speed,
        }))
    }

    fn fields(&mut self, input: ParseStream) -> syn::Result<Vec<Field>> {
        let body;
        braced!(body in input);
        let mut fields = Vec::new();
        while !body.is_empty() {
            fields.push(self.field(&body)?);
            if !body.is_empty() {
                body.parse::<Token![,]>()?;
            }
        }
        Ok(fields)
    }

    /// `name: formula`, or `name` alone where both are called the same.
    fn field(&mut self, input: ParseStream) -> syn::Result<Field> {
        let name: Ident = input.parse()?;
        let formula = if input.parse::<Option<Token![:]>>()?.is_some() {
            self.formula(input)?
        } else {
            Formula::name(&name)
        };
        Ok(Field { name, formula })
    }

    fn derivative(&mut self, docs: &[Attribute], input: ParseStream) -> syn::Result<Line> {
        undocumented(docs)?;
        let state = argument(input)?;
        let formula = self.right_side(input)?;
        Ok(Line::Derivative(Derivative { state, formula }))
    }

    fn stick(&mut self, docs: &[Attribute], word: &Ident, input: ParseStream) -> syn::Result<Line> {
        undocumented(docs)?;
        let (word, formula) = (word.clone(), self.right_side(input)?);
        Ok(Line::Stick(Stick { word, formula }))
    }

    fn slip(&mut self, docs: &[Attribute], word: &Ident, input: ParseStream) -> syn::Result<Line> {
        undocumented(docs)?;
        let speed = argument(input)?;
        let (word, formula) = (word.clone(), self.right_side(input)?);
        Ok(Line::Slip(Slip {
            word,
            speed,
            formula,
        }))
    }

    fn right_side(&mut self, input: ParseStream) -> syn::Result<Formula> {
        input.parse::<Token![=]>()?;
        self.formula(input)
    }

    fn formula(&mut self, input: ParseStream) -> syn::Result<Formula> {
        Ok(arithmetic::formula(
            &input.parse()?,
            self.grammar,
            self.errors,
        ))
    }
}

fn state(docs: Vec<Attribute>, input: ParseStream) -> syn::Result<Line> {
    let name = self::name(input)?;
    let unit = value::unit_if_stated(input)?;
    input.parse::<Token![=]>()?;
    let start = value::number(input)?;
    Ok(Line::State(State {
        docs,
        name,
        unit,
        start,
    }))
}

fn param(docs: Vec<Attribute>, input: ParseStream) -> syn::Result<Line> {
    let name = self::name(input)?;
    let unit = value::unit_if_stated(input)?;
    input.parse::<Token![=]>()?;
    let default = Some(value::number(input)?);
    let bounds = value::bounds_if_stated(input)?;
    Ok(Line::Param(Param {
        docs,
        name,
        unit,
        default,
        bounds,
    }))
}

fn law_param(docs: Vec<Attribute>, input: ParseStream) -> syn::Result<Line> {
    let name = self::name(input)?;
    let unit = value::unit_if_stated(input)?;
    if input.peek(Token![=]) {
        return Err(input.error(format!(
            "a law's parameter has no default: a model gives `{name}` its value where it names the law"
        )));
    }
    let bounds = value::bounds_if_stated(input)?;
    Ok(Line::Param(Param {
        docs,
        name,
        unit,
        default: None,
        bounds,
    }))
}

fn name(input: ParseStream) -> syn::Result<Ident> {
    let found = input.call(Ident::parse_any);
    found.map_err(|error| syn::Error::new(error.span(), "expected a name"))
}

/// `(name)`
fn argument(input: ParseStream) -> syn::Result<Ident> {
    let inside;
    parenthesized!(inside in input);
    let name = name(&inside)?;
    if inside.is_empty() {
        Ok(name)
    } else {
        Err(inside.error("expected one name between the parentheses"))
    }
}

/// Doc comments; no other attribute has a meaning here.
pub(super) fn docs(input: ParseStream) -> syn::Result<Vec<Attribute>> {
    let attributes = input.call(Attribute::parse_outer)?;
    match attributes
        .iter()
        .find(|attribute| !attribute.path().is_ident("doc"))
    {
        None => Ok(attributes),
        Some(other) => Err(syn::Error::new_spanned(
            other,
            "only doc comments (`///`) may stand here",
        )),
    }
}

fn undocumented(docs: &[Attribute]) -> syn::Result<()> {
    match docs.first() {
        None => Ok(()),
        Some(doc) => Err(syn::Error::new_spanned(
            doc,
            "a doc comment describes what a line declares, and this line declares nothing: use `//`",
        )),
    }
}
