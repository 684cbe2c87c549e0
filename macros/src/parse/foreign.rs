//! Words with which no line begins, though people write them there, and what to write instead.

use proc_macro2::{Ident, TokenTree};
use syn::Token;
use syn::parse::ParseStream;

use super::Grammar;
use super::shape::{keywords, listed, meant, next};
use crate::syntax::word;

/// A word, the keyword that is meant by it if there is one, and what to write instead.
type Other = (&'static str, Option<&'static str>, &'static str);

const PARAM: &str = "a number that does not change is a `param`: `param g: m/s^2 = 9.81;`";
const RATE: &str = "a rate of change is written `der(x) = v;`";
const BRANCH: &str = "equations hold always: a jump of dry friction is a `friction` line, a wall or a gap is a `press` line, \
     and only `for i in 0..10 { .. }` has lines of its own";
const FOUND: &str = "when a contact switches is found from its `friction` or `press` line";

const LEFT: &str =
    "an equation has nothing but a rate on its left, and all else on its right: `der(v) = F / m;`";

const OTHERS: [Other; 33] = [
    (
        "fn",
        Some("let"),
        "a formula has a name by `let stretch = x - x_0;`, and a force that depends on a speed is a law, by `friction_law!`",
    ),
    ("const", Some("param"), PARAM),
    ("constant", Some("param"), PARAM),
    ("static", Some("param"), PARAM),
    ("parameter", Some("param"), PARAM),
    (
        "var",
        Some("state"),
        "what moves is a `state`: `state x: m = 1.0;`",
    ),
    (
        "variable",
        Some("state"),
        "what moves is a `state`: `state x: m = 1.0;`",
    ),
    (
        "force",
        Some("let"),
        "a force of friction is declared by `friction`, others stand in equations, or have a name by `let`",
    ),
    (
        "equation",
        Some("der"),
        "an equation is written `der(x) = v;`",
    ),
    ("dot", Some("der"), RATE),
    ("d", Some("der"), RATE),
    ("ddt", Some("der"), RATE),
    ("diff", Some("der"), RATE),
    ("derivative", Some("der"), RATE),
    ("if", Some("der"), BRANCH),
    ("while", Some("der"), BRANCH),
    ("loop", Some("der"), BRANCH),
    ("match", Some("der"), BRANCH),
    (
        "for",
        Some("der"),
        "a loop has its lines between braces: `for i in 0..10 { der(x[i]) = v[i]; }`",
    ),
    (
        "use",
        None,
        "constants are written with their path, as `std::f64::consts::PI`, and laws are imported above the macro",
    ),
    (
        "type",
        None,
        "every number is an `f64`, and what it measures is its unit: `state x: m = 1.0;`",
    ),
    (
        "input",
        Some("param"),
        "what acts from outside is a `param`, or a harmonic force: `cos(phi)` with the line `drive phi at omega;`",
    ),
    (
        "output",
        Some("let"),
        "all states are told of; a formula has a name by `let stretch = x - x_0;`",
    ),
    (
        "init",
        None,
        "a state begins where its own line says: `state x: m = 1.0;`",
    ),
    (
        "initial",
        None,
        "a state begins where its own line says: `state x: m = 1.0;`",
    ),
    ("event", None, FOUND),
    ("when", None, FOUND),
    ("mode", None, FOUND),
    (
        "contact",
        Some("friction"),
        "a contact rubs by a line `friction F = Law { .. } opposing v;`, and presses by `press N = Law { .. } closing gap;`",
    ),
    (
        "assert",
        None,
        "bounds stand in the line of a `param`: `param k: N/m = 1.0 where k > 0.0;`",
    ),
    (
        "mut",
        None,
        "states move and parameters are varied without it",
    ),
    (
        "return",
        None,
        "a line says what its left side is: `der(x) = v;`",
    ),
    (
        "self",
        None,
        "names of the declaration stand alone: `der(x) = v;`",
    ),
];

/// A `stop` line where none can be.
const NO_STOP: &str = "it is for the internal state of a law in `friction_law!`, as that of an elastic slider: \
     `friction F = Jenkins { .. } opposing v with z;`; a coordinate that meets a wall is pressed back by it: \
     `press N = Law { .. } closing gap;`";

const SLIP: &str = "the force while a contact slides is written `slip(s) = ...;`";
const STICK: &str = "the largest force of a contact at rest is written `stick = ...;`";
const ONE: &str = "a law is one formula for all sliding speeds `s > 0`, and one for rest: `slip(s) = ...;` and `stick = ...;`";

/// Those of laws.
const OF_LAWS: [Other; 12] = [
    ("slide", Some("slip"), SLIP),
    ("sliding", Some("slip"), SLIP),
    ("kinetic", Some("slip"), SLIP),
    ("dynamic", Some("slip"), SLIP),
    ("static", Some("stick"), STICK),
    ("rest", Some("stick"), STICK),
    ("sticking", Some("stick"), STICK),
    ("if", None, ONE),
    ("match", None, ONE),
    ("for", None, ONE),
    (
        "fn",
        None,
        "a formula has a name by `let`, and that of a speed is written `slip(s) = ...;` or `force(w) = ...;`",
    ),
    (
        "const",
        Some("param"),
        "a number that does not change is a `param`: `param limit: N;`",
    ),
];

/// Those of laws of contacts that press.
const OF_PRESSES: [Other; 3] = [
    (
        "restitution",
        Some("rebound"),
        "how fast a contact parts is written `rebound(v) = ...;`",
    ),
    (
        "if",
        None,
        "a law of presses is one formula for all depths `d > 0`: that it never pulls is seen to where it is used",
    ),
    (
        "const",
        Some("param"),
        "a number that does not change is a `param`: `param stiffness: N/m;`",
    ),
];

/// What is known of a word that begins no line of this grammar.
fn other(word: &str, grammar: Grammar) -> Option<&'static Other> {
    let others: &[Other] = match grammar {
        Grammar::Model => &OTHERS,
        Grammar::Law | Grammar::Memory => &OF_LAWS,
        Grammar::Press => &OF_PRESSES,
    };
    others.iter().find(|(other, ..)| *other == word)
}

/// The keyword that is meant by a word of others.
pub(super) fn meant_by(word: &str, grammar: Grammar) -> Option<&'static str> {
    other(word, grammar).and_then(|(_, keyword, _)| *keyword)
}

/// Whether whoever writes this word goes on with a block of lines, of which nothing is read.
pub(super) fn has_block(word: &Ident) -> bool {
    ["if", "while", "loop", "match", "for"]
        .iter()
        .any(|other| word == other)
}

/// Whether such a block ends what begins with this token.
pub(super) fn begins_block(token: &TokenTree) -> bool {
    matches!(token, TokenTree::Ident(word) if word == "fn" || has_block(word))
}

pub(super) fn no_keyword(input: ParseStream, grammar: Grammar) -> syn::Error {
    let begins = format!("a line begins with {}", listed(grammar));
    match next(input) {
        Some(number) if number.starts_with(|first: char| first.is_ascii_digit()) => {
            input.error(format!("`{number}` does not begin a line; {LEFT}"))
        }
        Some(word) => input.error(format!("`{word}` does not begin a line; {begins}")),
        None => input.error(begins),
    }
}

pub(super) fn unknown_keyword(written: &Ident, grammar: Grammar, input: ParseStream) -> syn::Error {
    let word = written.to_string();
    syn::Error::new(
        written.span(),
        format!(
            "`{word}` does not begin a line; {}",
            advice(&word, written, grammar, input)
        ),
    )
}

fn advice(word: &str, written: &Ident, grammar: Grammar, input: ParseStream) -> String {
    if word == "stop" && grammar == Grammar::Model {
        return NO_STOP.to_owned();
    }
    let rate = word.starts_with('d') && input.peek(Token![/]);
    if rate {
        return RATE.to_owned();
    }
    let elsewhere = || home(word, grammar).map(|home| format!("it belongs to `{home}`"));
    other(word, grammar)
        .map(|(.., advice)| (*advice).to_owned())
        .or_else(elsewhere)
        .or_else(|| meant(written, grammar).map(|near| format!("did you mean `{near}`?")))
        .unwrap_or_else(|| by_what_follows(word, grammar, input))
}

/// What is meant by a name with which no line begins is told by what stands after it.
fn by_what_follows(word: &str, grammar: Grammar, input: ParseStream) -> String {
    let model = grammar == Grammar::Model;
    if model && input.peek(Token![:]) {
        return format!(
            "write `let {word} = ...;` for an abbreviation, `state {word}: m = 0.0;` for what moves, \
             `param {word}: m = 1.0;` for what does not"
        );
    }
    let product = input.peek(Token![*]) || input.peek(Token![+]) || input.peek(Token![-]);
    if model && product {
        return LEFT.to_owned();
    }
    if model && input.peek(Token![=]) && !input.peek(Token![==]) {
        if input.peek2(word::der) {
            return LEFT.to_owned();
        }
        return format!(
            "write `der({word}) = ...;` for an equation, `let {word} = ...;` for an abbreviation"
        );
    }
    format!("a line begins with {}", listed(grammar))
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
