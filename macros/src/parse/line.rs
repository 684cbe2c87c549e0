//! Each kind of line.

use proc_macro2::Ident;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Attribute, Path, Token, braced};

use super::docs::{docs, name, undocumented};
use super::shape::{self, no_keyword, shaped, unknown_keyword};
use super::{Grammar, value};
use crate::arithmetic;
use crate::errors::Errors;
use crate::formula::Formula;
use crate::repeated::Repeated;
use crate::syntax::{
    Derivative, Drive, Field, Force, Friction, Let, Line, Param, Slip, State, Stick, Stop, word,
};

/// Reads lines of one grammar; mistakes inside a formula do not break its line.
pub(super) struct Reader<'a> {
    pub(super) grammar: Grammar,
    /// Whether the line stands inside `for`.
    pub(super) inside: bool,
    pub(super) repeated: &'a mut Repeated,
    pub(super) errors: &'a mut Errors,
}

impl Reader<'_> {
    /// Reads a line up to its semicolon.
    pub(super) fn line(&mut self, input: ParseStream) -> syn::Result<Vec<Line>> {
        let docs = docs(input)?;
        let keyword = input
            .call(Ident::parse_any)
            .map_err(|_| no_keyword(input, self.grammar))?;
        match (self.grammar, keyword.to_string().as_str()) {
            (Grammar::Model, word @ ("state" | "param" | "drive")) if self.inside => {
                Err(syn::Error::new(
                    keyword.span(),
                    format!(
                        "`{word}` cannot stand inside `for`: declare an array as `state x[10] = 0.0;` or `param k[10] = 1.0;` \
                     outside"
                    ),
                ))
            }
            (Grammar::Model, "state") => {
                shaped(shape::STATE, input, |input| self.states(&docs, input))
            }
            (Grammar::Model, "param") => {
                shaped(shape::PARAM, input, |input| self.params(&docs, input))
            }
            (Grammar::Law, "param") => {
                shaped(shape::LAW_PARAM, input, |input| one(law_param(docs, input)))
            }
            (_, "let") => shaped(shape::LET, input, |input| one(self.quantity(docs, input))),
            (Grammar::Law, "state") => {
                shaped(shape::LAW_STATE, input, |input| one(law_state(docs, input)))
            }
            (Grammar::Model, "friction") => shaped(shape::FRICTION, input, |input| {
                one(self.friction(docs, input))
            }),
            (Grammar::Model, "drive") => {
                shaped(shape::DRIVE, input, |input| one(self.drive(docs, input)))
            }
            (_, "der") => shaped(
                shape::DER,
                input,
                |input| one(self.derivative(&docs, input)),
            ),
            (Grammar::Law, "force") => shaped(shape::FORCE, input, |input| {
                one(self.force(&docs, &keyword, input))
            }),
            (Grammar::Law, "stop") => {
                shaped(shape::STOP, input, |input| one(self.stop(&docs, input)))
            }
            (Grammar::Law, "stick") => shaped(shape::STICK, input, |input| {
                one(self.stick(&docs, &keyword, input))
            }),
            (Grammar::Law, "slip") => shaped(shape::SLIP, input, |input| {
                one(self.slip(&docs, &keyword, input))
            }),
            _ => Err(unknown_keyword(&keyword, self.grammar, input)),
        }
    }

    fn quantity(&mut self, docs: Vec<Attribute>, input: ParseStream) -> syn::Result<Line> {
        let name = self.declared(input)?;
        let formula = self.moving_side(input)?;
        Ok(Line::Let(Let {
            docs,
            name,
            formula,
        }))
    }

    fn friction(&mut self, docs: Vec<Attribute>, input: ParseStream) -> syn::Result<Line> {
        let name = self.declared(input)?;
        let unit = value::unit_if_stated(input)?;
        input.parse::<Token![=]>()?;
        let law = input.call(Path::parse_mod_style)?;
        let fields = self.fields(input)?;
        input.parse::<word::opposing>()?;
        let speed = self.formula(input)?;
        let memory = self.memory_if_stated(input)?;
        Ok(Line::Friction(Friction {
            docs,
            name,
            unit,
            law,
            fields,
            speed,
            memory,
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

    fn drive(&mut self, docs: Vec<Attribute>, input: ParseStream) -> syn::Result<Line> {
        let name = self::name(input)?;
        input.parse::<word::at>()?;
        let rate = self.formula(input)?;
        Ok(Line::Drive(Drive { docs, name, rate }))
    }

    fn derivative(&mut self, docs: &[Attribute], input: ParseStream) -> syn::Result<Line> {
        undocumented(docs)?;
        let state = self.argument(input)?;
        let formula = self.moving_side(input)?;
        Ok(Line::Derivative(Derivative { state, formula }))
    }

    fn stick(&mut self, docs: &[Attribute], word: &Ident, input: ParseStream) -> syn::Result<Line> {
        undocumented(docs)?;
        let (word, formula) = (word.clone(), self.right_side(input)?);
        Ok(Line::Stick(Stick { word, formula }))
    }

    fn slip(&mut self, docs: &[Attribute], word: &Ident, input: ParseStream) -> syn::Result<Line> {
        undocumented(docs)?;
        let speed = self.argument(input)?;
        let (word, formula) = (word.clone(), self.right_side(input)?);
        Ok(Line::Slip(Slip {
            word,
            speed,
            formula,
        }))
    }

    fn force(&mut self, docs: &[Attribute], word: &Ident, input: ParseStream) -> syn::Result<Line> {
        undocumented(docs)?;
        let speed = self.argument(input)?;
        let (word, formula) = (word.clone(), self.moving_side(input)?);
        Ok(Line::Force(Force {
            word,
            speed,
            formula,
        }))
    }

    fn stop(&mut self, docs: &[Attribute], input: ParseStream) -> syn::Result<Line> {
        undocumented(docs)?;
        let state = name(input)?;
        input.parse::<word::at>()?;
        let bound = self.formula(input)?;
        Ok(Line::Stop(Stop { state, bound }))
    }

    /// The right side of a line in which, in a law, the internal state and its kinks may stand.
    fn moving_side(&mut self, input: ParseStream) -> syn::Result<Formula> {
        let grammar = match self.grammar {
            Grammar::Model => Grammar::Model,
            Grammar::Law | Grammar::Memory => Grammar::Memory,
        };
        Reader {
            grammar,
            inside: self.inside,
            repeated: self.repeated,
            errors: self.errors,
        }
        .right_side(input)
    }

    /// A state, or each element of an array of them.
    fn states(&mut self, docs: &[Attribute], input: ParseStream) -> syn::Result<Vec<Line>> {
        let names = self.names(input)?;
        let unit = value::unit_if_stated(input)?;
        input.parse::<Token![=]>()?;
        let start = Some(value::number(input)?);
        let state = |name| {
            Line::State(State {
                docs: docs.to_vec(),
                name,
                unit: unit.clone(),
                start: start.clone(),
            })
        };
        Ok(names.into_iter().map(state).collect())
    }

    /// A parameter, or each element of an array of them.
    fn params(&mut self, docs: &[Attribute], input: ParseStream) -> syn::Result<Vec<Line>> {
        let names = self.names(input)?;
        let unit = value::unit_if_stated(input)?;
        input.parse::<Token![=]>()?;
        let default = Some(value::number(input)?);
        let bounds = value::bounds_if_stated(input)?;
        let single = names.len() == 1;
        let param = |name: Ident| {
            let bounds = bounds.clone().map(|bounds| match single {
                true => bounds,
                // The bounds are written for the array and hold for each element.
                false => bounds.on(&name),
            });
            Line::Param(Param {
                docs: docs.to_vec(),
                name,
                unit: unit.clone(),
                default: default.clone(),
                bounds,
            })
        };
        Ok(names.into_iter().map(param).collect())
    }

    fn right_side(&mut self, input: ParseStream) -> syn::Result<Formula> {
        input.parse::<Token![=]>()?;
        self.formula(input)
    }

    fn formula(&mut self, input: ParseStream) -> syn::Result<Formula> {
        Ok(arithmetic::formula(
            &input.parse()?,
            self.grammar,
            self.repeated,
            self.errors,
        ))
    }
}

fn one(line: syn::Result<Line>) -> syn::Result<Vec<Line>> {
    Ok(vec![line?])
}

fn law_state(docs: Vec<Attribute>, input: ParseStream) -> syn::Result<Line> {
    let name = self::name(input)?;
    let unit = value::unit_if_stated(input)?;
    if input.peek(Token![=]) {
        return Err(input.error(format!(
            "a law's state has no start: the state of the model that carries `{name}` has one"
        )));
    }
    Ok(Line::State(State {
        docs,
        name,
        unit,
        start: None,
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
