//! How a line begins and ends, and what to say where it does not.

use proc_macro2::{Ident, Spacing, TokenStream, TokenTree};
use syn::ext::IdentExt;
use syn::parse::{ParseStream, Parser};
use syn::{Attribute, Token, parenthesized, token};

use super::Grammar;
use super::foreign::{has_block, meant_by};
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
pub(super) fn keywords(grammar: Grammar) -> impl Iterator<Item = &'static str> + Clone {
    lines(grammar).iter().map(|(word, _)| *word)
}

/// Reads with `read` up to the semicolon; a syntax error shows how such a line is written.
pub(super) fn shaped(
    (word, shape): (&str, &str),
    input: ParseStream,
    read: impl FnOnce(ParseStream) -> syn::Result<Vec<Line>>,
) -> syn::Result<Vec<Line>> {
    let outcome = read(input).and_then(|line| ended(word, input).map(|()| line));
    outcome.map_err(|error| with_shape(with_next(error, input), "the line", shape))
}

/// An error of the parser with what it met, if it met that where it stands.
fn with_next(error: syn::Error, input: ParseStream) -> syn::Error {
    let message = error.to_string();
    let told = message.contains(" before ") || message.contains(": ");
    let here = format!("{:?}", input.span()) == format!("{:?}", error.span());
    match next(input).filter(|_| here && !told && message.starts_with("expected")) {
        Some(found) => syn::Error::new(error.span(), format!("{message} before `{found}`")),
        None => error,
    }
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

/// A line ends with a semicolon; where it is missing, or a comma stands for it, the next line may begin.
fn ended(word: &str, input: ParseStream) -> syn::Result<()> {
    if input.peek(Token![;]) || parted(input) {
        return Ok(());
    }
    let next = next(input).unwrap_or_default();
    Err(input.error(match next.as_str() {
        "," => "`,` parts nothing here: a line has one name and one formula, and ends with `;`".to_owned(),
        "where" => format!("`where` bounds a `param`, and a `{word}` line has no bounds: remove them"),
        "if" | "in" | "<" | ">" | "<=" | ">=" => {
            format!("bounds follow `where`, not `{next}`: write `where 0.0 < k < 1.0`")
        }
        "and" | "or" | "&&" | "||" => {
            format!("`{next}` joins no bounds: write both ends of an interval as `0.0 <= k < 1.0`")
        }
        "[" => "`[` has no place here: arrays are states and parameters of models, and have their number of elements where \
                they are declared"
            .to_owned(),
        "+" | "-" | "*" | "/" => format!(
            "`{next}` calculates where a number stands: a start and a default are one number, such as `0.5`, and formulas \
             have a line of their own by `let`"
        ),
        _ => format!("expected `;` before `{next}`, or `*` if a product is meant"),
    }))
}

/// Whether the next line begins here, or does so after a comma; or nothing comes after that.
fn parted(input: ParseStream) -> bool {
    let rest = input.fork();
    let comma = rest.parse::<Option<Token![,]>>();
    let comma = comma.is_ok_and(|comma| comma.is_some());
    let last = comma && (rest.is_empty() || rest.peek(Token![;]));
    rest.parse::<TokenStream>()
        .is_ok_and(|rest| last || keyword_of(&rest).is_some())
}

/// Whether a comma stands where a line should end with a semicolon.
pub(super) fn ends_with_comma(input: ParseStream) -> bool {
    input.peek(Token![,]) && parted(input)
}

/// The line that begins after a comma in these tokens, if one does.
pub(super) fn after_comma(line: TokenStream) -> Option<TokenStream> {
    let mut rest = line.into_iter();
    loop {
        if matches!(rest.next()?, TokenTree::Punct(mark) if mark.as_char() == ',') {
            let next: TokenStream = rest.clone().collect();
            if keyword_of(&next).is_some() {
                return Some(next);
            }
        }
    }
}

/// What stands next as it is written; signs that touch are one.
pub(super) fn next(input: ParseStream) -> Option<String> {
    let mut rest = input.fork().parse::<TokenStream>().ok()?.into_iter();
    let mut text = String::new();
    loop {
        let punct = match (rest.next(), text.is_empty()) {
            (Some(TokenTree::Punct(punct)), _) => punct,
            (Some(TokenTree::Group(group)), true) => {
                return group.to_string().chars().next().map(String::from);
            }
            (Some(token), true) => return Some(token.to_string()),
            _ => return (!text.is_empty()).then_some(text),
        };
        text.push(punct.as_char());
        let ends = matches!(punct.as_char(), ';' | ',') || punct.spacing() == Spacing::Alone;
        if ends {
            return Some(text);
        }
    }
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
    let equation = || Broken {
        keyword: Some("der"),
        name: None,
    };
    let reader = |input: ParseStream| {
        let first = first_word(input)?;
        let keyword = meant(&first, grammar);
        let model = grammar == Grammar::Model;
        let rate = model && keyword.is_none() && (input.peek(Token![/]) || holds_rate(tokens));
        let (named, block) = (
            input.peek(Token![=]) || input.peek(Token![:]),
            has_block(&first),
        );
        let name = match keyword {
            None if named => Some(first),
            _ => second_word(input).ok(),
        };
        input.parse::<TokenStream>()?;
        Ok(if rate || (model && block) {
            equation()
        } else {
            Broken { keyword, name }
        })
    };
    let read = reader.parse2(tokens.clone());
    read.unwrap_or_else(|_| {
        if holds_rate(tokens) {
            equation()
        } else {
            Broken::default()
        }
    })
}

/// Whether a rate stands somewhere in a line.
fn holds_rate(tokens: &TokenStream) -> bool {
    let rate = |token| matches!(token, TokenTree::Ident(word) if word == "der");
    tokens.clone().into_iter().any(rate)
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
pub(super) fn meant(word: &Ident, grammar: Grammar) -> Option<&'static str> {
    let word = word.to_string();
    let exact = keywords(grammar).find(|keyword| *keyword == word);
    let other = || meant_by(&word, grammar);
    exact
        .or_else(other)
        .or_else(|| nearest(&word, keywords(grammar)))
}

/// The words that begin a line, as a message lists them.
pub(super) fn listed(grammar: Grammar) -> String {
    let quoted = keywords(grammar).map(|word| format!("`{word}`"));
    let quoted: Vec<String> = quoted.collect();
    let (last, first) = quoted.split_last().expect("a grammar has keywords");
    format!("{} or {last}", first.join(", "))
}
