//! How a line begins and ends, and what to say where it does not.

use proc_macro2::{Ident, TokenStream};
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser};
use syn::{Attribute, Token, parenthesized, token};

use super::Grammar;
use crate::suggest::nearest;
use crate::syntax::{Broken, Line};

/// How a line that begins with `word` is written; `None` if none does.
pub(super) fn shape(grammar: Grammar, word: &str) -> Option<&'static str> {
    let lines = lines(grammar).iter();
    let mut shapes = lines.filter(|(known, _)| *known == word);
    shapes.next().map(|(_, shape)| *shape)
}

/// The words that begin a line, each with an example.
fn lines(grammar: Grammar) -> &'static [(&'static str, &'static str)] {
    match grammar {
        Grammar::Model => &[
            ("state", "state x: m = 1.0;"),
            ("param", "param k: N/m = 1.0 where k > 0.0;"),
            ("let", LET),
            (
                "friction",
                "friction F: N = Law { field: value } opposing v - v_belt;",
            ),
            (
                "press",
                "press N: N = Law { field: value } closing y - y_wall;",
            ),
            ("drive", "drive phi at omega;"),
            (
                "structure",
                "structure beam = \"beam.structure\" keeping 12;",
            ),
            ("load", "load beam.tip = force * cos(phi);"),
            ("der", DER),
        ],
        Grammar::Law | Grammar::Memory => &[
            ("param", "param limit: N where limit >= 0.0;"),
            ("let", LET),
            ("stick", "stick = limit;"),
            ("slip", "slip(s) = limit / (1.0 + decay * s);"),
            ("state", "state z: m;"),
            ("der", DER),
            ("stop", "stop z at limit;"),
            ("force", "force(w) = stiffness * z;"),
        ],
        Grammar::Press => &[
            ("param", "param stiffness: N/m where stiffness > 0.0;"),
            ("let", LET),
            ("force", "force(d, v) = stiffness * d + damping * v;"),
            ("rebound", "rebound(v) = restitution * v;"),
        ],
    }
}

const LET: &str = "let stretch = x - x_0;";
const DER: &str = "der(x) = v;";

/// The words that begin a line.
fn keywords(grammar: Grammar) -> impl Iterator<Item = &'static str> + Clone {
    lines(grammar).iter().map(|(word, _)| *word)
}

/// Reads with `read` up to the semicolon; a syntax error shows how such a line is written.
pub(super) fn shaped(
    shape: &str,
    input: ParseStream,
    read: impl FnOnce(ParseStream) -> syn::Result<Vec<Line>>,
) -> syn::Result<Vec<Line>> {
    let outcome = read(input).and_then(|line| ended(input).map(|()| line));
    outcome.map_err(|error| with_shape(error, "the line", shape))
}

/// An error of the parser with how the whole is written.
pub(super) fn with_shape(error: syn::Error, whole: &str, shape: &str) -> syn::Error {
    let message = error.to_string();
    if message.starts_with("expected") || message.starts_with("unexpected") {
        let message = format!("{message}; {whole} has the form `{shape}`");
        syn::Error::new(error.span(), message)
    } else {
        error
    }
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
    let mut all = keywords(Grammar::Model).chain(keywords(Grammar::Law));
    all.any(|keyword| word == keyword).then_some(word)
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
    let exact = keywords(grammar).find(|keyword| *keyword == word);
    exact.or_else(|| nearest(&word, keywords(grammar)))
}

pub(super) fn no_keyword(input: ParseStream, grammar: Grammar) -> syn::Error {
    input.error(format!("a line begins with {}", listed(grammar)))
}

/// Words with which people begin lines, and what to write instead.
const OTHERS: [(&str, &str); 7] = [
    ("pub", "states and parameters are public without it"),
    (
        "fn",
        "a formula has a name by `let stretch = x - x_0;`, and a force that depends on a speed is a law, by `friction_law!`",
    ),
    (
        "const",
        "a number that does not change is a `param`: `param g: m/s^2 = 9.81;`",
    ),
    (
        "constant",
        "a number that does not change is a `param`: `param g: m/s^2 = 9.81;`",
    ),
    ("var", "what moves is a `state`: `state x: m = 1.0;`"),
    (
        "force",
        "a force of friction is declared by `friction`, others stand in equations, or have a name by `let`",
    ),
    ("equation", "an equation is written `der(x) = v;`"),
];

/// A `stop` line where none can be.
const NO_STOP: &str = "it is for the internal state of a law in `friction_law!`, as that of an elastic slider: \
     `friction F = Jenkins { .. } opposing v with z;`; a coordinate that meets a wall is pressed back by it: \
     `press N = Law { .. } closing gap;`";

pub(super) fn unknown_keyword(written: &Ident, grammar: Grammar, input: ParseStream) -> syn::Error {
    let word = written.to_string();
    let advice = if word == "stop" && grammar == Grammar::Model {
        NO_STOP.to_owned()
    } else if let Some(near) = meant(written, grammar) {
        format!("did you mean `{near}`?")
    } else if let Some((_, advice)) = OTHERS.iter().find(|(other, _)| *other == word) {
        (*advice).to_owned()
    } else if let Some(home) = home(&word, grammar) {
        format!("it belongs to `{home}`")
    } else if word.starts_with('d') && input.peek(Token![/]) {
        "a rate of change is written `der(x) = v;`".to_owned()
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

/// The macro of which this word begins a line, if it is another one.
fn home(word: &str, grammar: Grammar) -> Option<&'static str> {
    let homes = [
        (Grammar::Model, "model!"),
        (Grammar::Law, "friction_law!"),
        (Grammar::Press, "press_law!"),
    ];
    let mut others = homes
        .into_iter()
        .filter(|(other, _)| keywords(*other).any(|keyword| keyword == word));
    let own = keywords(grammar).any(|keyword| keyword == word);
    others.next().filter(|_| !own).map(|(_, home)| home)
}

fn listed(grammar: Grammar) -> String {
    let quoted = keywords(grammar).map(|word| format!("`{word}`"));
    let quoted: Vec<String> = quoted.collect();
    let (last, first) = quoted.split_last().expect("a grammar has keywords");
    format!("{} or {last}", first.join(", "))
}
