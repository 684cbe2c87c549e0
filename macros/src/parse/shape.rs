//! How a line begins and ends, and what to say where it does not.

use proc_macro2::{Ident, TokenStream};
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser};
use syn::{Attribute, Token, parenthesized, token};

use super::Grammar;
use crate::suggest::nearest;
use crate::syntax::{Broken, Line};

pub(super) const STATE: &str = "state x: m = 1.0;";
pub(super) const PARAM: &str = "param k: N/m = 1.0 where k > 0.0;";
pub(super) const LAW_PARAM: &str = "param limit: N where limit >= 0.0;";
pub(super) const LET: &str = "let stretch = x - x_0;";
pub(super) const FRICTION: &str = "friction F: N = Law { field: value } opposing v - v_belt;";
pub(super) const DER: &str = "der(x) = v;";
pub(super) const STICK: &str = "stick = limit;";
pub(super) const SLIP: &str = "slip(s) = limit / (1.0 + decay * s);";
pub(super) const DRIVE: &str = "drive phi at omega;";
pub(super) const LAW_STATE: &str = "state z: m;";
pub(super) const FORCE: &str = "force(w) = stiffness * z;";
pub(super) const STOP: &str = "stop z at limit;";

/// The words that begin a line.
fn keywords(grammar: Grammar) -> &'static [&'static str] {
    match grammar {
        Grammar::Model => &["state", "param", "let", "friction", "drive", "der"],
        Grammar::Law | Grammar::Memory => &[
            "param", "let", "stick", "slip", "state", "der", "stop", "force",
        ],
    }
}

/// Reads with `read` up to the semicolon; a syntax error shows how such a line is written.
pub(super) fn shaped(
    shape: &str,
    input: ParseStream,
    read: impl FnOnce(ParseStream) -> syn::Result<Vec<Line>>,
) -> syn::Result<Vec<Line>> {
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
    let next = rest.into_iter().next().map(|token| token.to_string());
    let next = next.unwrap_or_default();
    Err(input.error(format!(
        "expected `;` before `{next}`, or `*` if a product is meant"
    )))
}

/// The word with which another line begins in these tokens, if one does.
pub(super) fn keyword_of(tokens: &TokenStream) -> Option<Ident> {
    let reader = |input: ParseStream| {
        let word = first_word(input)?;
        input.parse::<TokenStream>()?;
        Ok(word)
    };
    let word = reader.parse2(tokens.clone()).ok()?;
    let all = [Grammar::Model, Grammar::Law].map(keywords).concat();
    all.contains(&word.to_string().as_str()).then_some(word)
}

fn first_word(input: ParseStream) -> syn::Result<Ident> {
    input.call(Attribute::parse_outer)?;
    input.call(Ident::parse_any)
}

/// What a line that cannot be read was meant to declare.
pub(super) fn broken(tokens: &TokenStream, grammar: Grammar) -> Broken {
    let reader = |input: ParseStream| {
        let first = first_word(input)?;
        let keyword = meant(&first, grammar);
        let name = if keyword.is_none() && input.peek(Token![=]) {
            Some(first)
        } else {
            second_word(input).ok()
        };
        input.parse::<TokenStream>()?;
        Ok(Broken { keyword, name })
    };
    reader.parse2(tokens.clone()).unwrap_or_default()
}

fn second_word(input: ParseStream) -> syn::Result<Ident> {
    if input.peek(token::Paren) {
        let inside;
        parenthesized!(inside in input);
        let word = inside.call(Ident::parse_any);
        inside.parse::<TokenStream>()?;
        return word;
    }
    input.call(Ident::parse_any)
}

/// The keyword that is written, or that the written word is near to.
fn meant(word: &Ident, grammar: Grammar) -> Option<&'static str> {
    let word = word.to_string();
    let known = keywords(grammar).iter().copied();
    let exact = known.clone().find(|keyword| *keyword == word);
    exact.or_else(|| nearest(&word, known))
}

pub(super) fn no_keyword(input: ParseStream, grammar: Grammar) -> syn::Error {
    input.error(format!("a line begins with {}", listed(grammar)))
}

/// A `stop` line where none can be.
const NO_STOP: &str = "it is for the internal state of a law in `friction_law!`; a coordinate that meets a wall has no line \
     of its own yet: a spring that presses smoothly, `k * (d + sqrt(powi(d, 2) + powi(e, 2))) / 2` at the depth d, comes \
     near it for a small length e";

pub(super) fn unknown_keyword(written: &Ident, grammar: Grammar, input: ParseStream) -> syn::Error {
    let word = written.to_string();
    let advice = if word == "stop" && grammar == Grammar::Model {
        NO_STOP.to_owned()
    } else if let Some(near) = meant(written, grammar) {
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
