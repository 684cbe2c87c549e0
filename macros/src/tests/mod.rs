//! What users are told: the list of messages for each mistake.

mod arrays;
mod bounds;
mod drive;
mod equations;
mod formulas;
mod hostile;
mod lines;
mod memory;
mod names;
mod press;
mod structure;
mod tokens;
mod units;

use proc_macro2::TokenStream;

use crate::check;
use crate::errors::Errors;
use crate::parse::{self, Grammar};

fn messages(declaration: &str, grammar: Grammar) -> Vec<String> {
    let tokens: TokenStream = declaration.parse().expect("the test is made of tokens");
    let mut errors = Errors::new();
    if let Some(written) = parse::declaration(tokens, grammar, &mut errors) {
        match grammar {
            Grammar::Model => drop(check::model(&written, &mut errors)),
            grammar => drop(check::law(&written, grammar, &mut errors)),
        }
    }
    let found = errors.finish().err().into_iter().flatten();
    found.map(|error| error.to_string()).collect()
}

/// The messages for a model with these lines.
fn of_model(lines: &str) -> Vec<String> {
    messages(&format!("pub struct M {{ {lines} }}"), Grammar::Model)
}

/// The messages for a law with these lines.
fn of_law(lines: &str) -> Vec<String> {
    messages(&format!("pub struct L {{ {lines} }}"), Grammar::Law)
}

/// The messages for a law of presses with these lines.
fn of_press(lines: &str) -> Vec<String> {
    messages(&format!("pub struct L {{ {lines} }}"), Grammar::Press)
}

/// The messages for a belt oscillator in which one piece of text is replaced by another.
fn of_belt(text: &str, replacement: &str) -> Vec<String> {
    assert!(BELT.contains(text), "the belt oscillator has no `{text}`");
    of_model(&BELT.replacen(text, replacement, 1))
}

const BELT: &str = "
    state x: m = 1.0;
    state v: m/s = 0.0;
    param mass: kg = 1.0 where mass > 0.0;
    param k: N/m = 1.0 where k > 0.0;
    param v_dr: m/s = 0.2;
    param F_s: N = 1.0 where F_s >= 0.0;
    param delta: s/m = 3.0 where delta >= 0.0;
    friction F: N = Weakening { limit: F_s, decay: delta } opposing v - v_dr;
    let stretched = k * x;
    der(x) = v;
    der(v) = (F - stretched) / mass;
";

const NONE: [&str; 0] = [];

#[test]
fn nothing_is_said_about_a_good_model() {
    assert_eq!(of_model(BELT), NONE);
}

#[test]
fn nothing_is_said_about_a_good_law() {
    let weakening = "
        param limit: N where limit >= 0.0;
        param decay: s/m where 0 <= decay <= 1e3;
        stick = limit;
        slip(s) = limit / (1.0 + decay * s);
    ";
    assert_eq!(of_law(weakening), NONE);
}

#[test]
fn several_mistakes_are_reported_at_once() {
    let lines = "
        state x = 1.0;
        state v = ;
        param k = 1.0 where k < 0.0;
        param = 3.0;
        der(x) = v;
        der(v) = -k * signum(x) * mas;
    ";
    assert_eq!(
        of_model(lines),
        [
            "expected a number such as `1.0` before `;`; the line has the form `state x: m = 1.0;`",
            "expected a name before `=`; the line has the form `param k: N/m = 1.0 where k > 0.0;`",
            "`signum` is not smooth, and no switch is declared for its jump; \
             write dry friction as `friction F = Law { .. } opposing speed;`, a wall or a gap as \
             `press N = Law { .. } closing gap;`",
            "unknown name `mas`; declare it with `state`, `param` or `let`",
            "default 1.0 of `k` breaks its own bound `k < 0.0`",
        ]
    );
}
