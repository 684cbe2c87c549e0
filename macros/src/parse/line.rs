//! Each kind of line.

use proc_macro2::{Ident, TokenStream, TokenTree};
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Attribute, Path, Token, braced, parenthesized};

use super::{Grammar, value};
use crate::arithmetic;
use crate::errors::Errors;
use crate::suggest::nearest;
use crate::syntax::{
    Derivative, Field, Formula, Friction, Let, Line, Param, Slip, State, Stick, word,
};

const STATE: &str = "state x: m = 1.0;";
const PARAM: &str = "param k: N/m = 1.0 where k > 0.0;";
const LAW_PARAM: &str = "param limit: N where limit >= 0.0;";
const LET: &str = "let stretch = x - x_0;";
const FRICTION: &str = "friction F: N = Law { field: value } opposing v - v_belt;";
const DER: &str = "der(x) = v;";
const STICK: &str = "stick = limit;";
const SLIP: &str = "slip(s) = limit / (1.0 + decay * s);";

/// The words that begin a line.
fn keywords(grammar: Grammar) -> &'static [&'static str] {
    match grammar {
        Grammar::Model => &["state", "param", "let", "friction", "der"],
        Grammar::Law => &["param", "stick", "slip"],
    }
}

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
            (Grammar::Model, "state") => shaped(STATE, input, |input| state(docs, input)),
            (Grammar::Model, "param") => shaped(PARAM, input, |input| param(docs, input)),
            (Grammar::Law, "param") => shaped(LAW_PARAM, input, |input| law_param(docs, input)),
            (Grammar::Model, "let") => shaped(LET, input, |input| self.quantity(docs, input)),
            (Grammar::Model, "friction") => {
                shaped(FRICTION, input, |input| self.friction(docs, input))
            }
            (Grammar::Model, "der") => shaped(DER, input, |input| self.derivative(&docs, input)),
            (Grammar::Law, "stick") => {
                shaped(STICK, input, |input| self.stick(&docs, &keyword, input))
            }
            (Grammar::Law, "slip") => {
                shaped(SLIP, input, |input| self.slip(&docs, &keyword, input))
            }
            _ => Err(unknown_keyword(&keyword, self.grammar, input)),
        }
    }

    fn quantity(&mut self, docs: Vec<Attribute>, input: ParseStream) -> syn::Result<Line> {
        let name = input.call(Ident::parse_any)?;
        let formula = self.right_side(input)?;
        Ok(Line::Let(Let {
            docs,
            name,
            formula,
        }))
    }

    fn friction(&mut self, docs: Vec<Attribute>, input: ParseStream) -> syn::Result<Line> {
        let name = input.call(Ident::parse_any)?;
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
    let name = input.call(Ident::parse_any)?;
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
    let name = input.call(Ident::parse_any)?;
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
    let name = input.call(Ident::parse_any)?;
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

/// `(name)`
fn argument(input: ParseStream) -> syn::Result<Ident> {
    let inside;
    parenthesized!(inside in input);
    let name = inside.call(Ident::parse_any)?;
    if inside.is_empty() {
        Ok(name)
    } else {
        Err(inside.error("expected one name between the parentheses"))
    }
}

/// Reads with `read` up to the semicolon; a syntax error shows how such a line is written.
fn shaped(
    shape: &str,
    input: ParseStream,
    read: impl FnOnce(ParseStream) -> syn::Result<Line>,
) -> syn::Result<Line> {
    let outcome = read(input).and_then(|line| ended(input).map(|()| line));
    outcome.map_err(|error| {
        let message = error.to_string();
        if message.starts_with("expected") || message.starts_with("unexpected") {
            syn::Error::new(
                error.span(),
                format!("{message}; the line has the form `{shape}`"),
            )
        } else {
            error
        }
    })
}

/// A line ends with a semicolon; where it is missing, the next line may begin.
fn ended(input: ParseStream) -> syn::Result<()> {
    let rest: TokenStream = input.fork().parse()?;
    if input.peek(Token![;]) || keyword_of(&rest).is_some() {
        return Ok(());
    }
    Err(input.error("expected `;` here"))
}

/// The word with which another line begins in these tokens, if one does.
pub(super) fn keyword_of(tokens: &TokenStream) -> Option<Ident> {
    let starts = tokens
        .clone()
        .into_iter()
        .next()
        .is_some_and(|first| match first {
            TokenTree::Ident(_) => true,
            TokenTree::Punct(mark) => mark.as_char() == '#',
            _ => false,
        });
    let all = [Grammar::Model, Grammar::Law].map(keywords).concat();
    words(tokens)
        .next()
        .filter(|word| starts && all.contains(&word.to_string().as_str()))
}

/// The identifiers of a line without its doc comments; those in parentheses too.
pub(super) fn words(tokens: &TokenStream) -> impl Iterator<Item = Ident> + use<> {
    let mut found = Vec::new();
    let mut previous = ' ';
    for token in tokens.clone() {
        match token {
            TokenTree::Ident(word) => found.push(word),
            TokenTree::Group(group) if previous != '#' => found.extend(words(&group.stream())),
            TokenTree::Punct(mark) => {
                previous = mark.as_char();
                continue;
            }
            _ => {}
        }
        previous = ' ';
    }
    found.into_iter()
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

fn no_keyword(input: ParseStream, grammar: Grammar) -> syn::Error {
    input.error(format!("a line begins with {}", listed(grammar)))
}

fn unknown_keyword(written: &Ident, grammar: Grammar, input: ParseStream) -> syn::Error {
    let word = written.to_string();
    let advice = if let Some(near) = nearest(&word, keywords(grammar).iter().copied()) {
        format!("did you mean `{near}`?")
    } else if grammar == Grammar::Model && input.peek(Token![=]) {
        format!(
            "write `der({word}) = ...;` for an equation, `let {word} = ...;` for an abbreviation"
        )
    } else {
        format!("a line begins with {}", listed(grammar))
    };
    syn::Error::new(
        written.span(),
        format!("`{word}` does not begin a line; {advice}"),
    )
}

fn listed(grammar: Grammar) -> String {
    let quoted: Vec<String> = keywords(grammar)
        .iter()
        .map(|word| format!("`{word}`"))
        .collect();
    let (last, first) = quoted.split_last().expect("a grammar has keywords");
    format!("{} or {last}", first.join(", "))
}
