//! Whatever tokens come, the macros answer with tokens: no panic, no hang.

use std::time::{Duration, Instant};

use proc_macro2::{Delimiter, Group, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::{Index, select};
use proptest::test_runner::{Config, RngSeed, TestRunner};

use super::{BELT, of_model};
use crate::expand;

/// How many inputs each of the tests makes: the same ones on every machine.
const INPUTS: u32 = 1500;

const LAW: &str = "pub struct Law { param limit: N where limit >= 0.0; param decay: s/m = 1.0; stick = limit; \
                   slip(s) = limit / (1.0 + decay * s) - powi(s, 2) * exp(-s); }";

const WORDS: [&str; 26] = [
    "state", "param", "friction", "opposing", "let", "der", "where", "struct", "pub", "x", "v",
    "s", "F", "m", "N", "stick", "slip", "powi", "exp", "D", "self", "r#fn", "Law", "default",
    "press", "closing",
];
const SIGNS: &str = "+-*/=<>;:,.^!&|#@?$%~'";
const DELIMITERS: [Delimiter; 4] = [
    Delimiter::Parenthesis,
    Delimiter::Brace,
    Delimiter::Bracket,
    Delimiter::None,
];

/// A token of which a group can still be changed.
#[derive(Debug, Clone)]
enum Token {
    Leaf(TokenTree),
    Group(Delimiter, Vec<Token>),
}

impl From<TokenTree> for Token {
    fn from(tree: TokenTree) -> Self {
        match tree {
            TokenTree::Group(group) => Self::Group(group.delimiter(), tokens(group.stream())),
            leaf => Self::Leaf(leaf),
        }
    }
}

impl From<Token> for TokenTree {
    fn from(token: Token) -> Self {
        match token {
            Token::Leaf(leaf) => leaf,
            Token::Group(around, inside) => Group::new(around, stream(inside)).into(),
        }
    }
}

fn tokens(stream: TokenStream) -> Vec<Token> {
    stream.into_iter().map(Token::from).collect()
}

fn stream(tokens: Vec<Token>) -> TokenStream {
    tokens.into_iter().map(TokenTree::from).collect()
}

fn word(word: &str) -> TokenTree {
    let ident = word.strip_prefix("r#").map_or_else(
        || Ident::new(word, Span::call_site()),
        |raw| Ident::new_raw(raw, Span::call_site()),
    );
    ident.into()
}

fn literals() -> Vec<TokenTree> {
    [
        Literal::i32_unsuffixed(3),
        Literal::f64_unsuffixed(0.0),
        Literal::f64_unsuffixed(1e308),
        Literal::u64_unsuffixed(u64::MAX),
        Literal::f32_suffixed(1.5),
        Literal::string("text"),
        Literal::character('x'),
        Literal::byte_string(b"bytes"),
        "1e999".parse().expect("a literal"),
    ]
    .map(TokenTree::from)
    .to_vec()
}

fn any_token() -> impl Strategy<Value = Token> {
    let sign = (select(SIGNS.as_bytes()), any::<bool>()).prop_map(|(sign, joint)| {
        let spacing = if joint {
            Spacing::Joint
        } else {
            Spacing::Alone
        };
        TokenTree::from(Punct::new(sign as char, spacing))
    });
    let leaf = prop_oneof![
        5 => select(&WORDS[..]).prop_map(word),
        4 => sign,
        1 => select(literals()),
    ];
    leaf.prop_map(Token::Leaf)
        .prop_recursive(4, 24, 6, |inner| {
            let group = (select(&DELIMITERS[..]), vec(inner, 0..6));
            group.prop_map(|(around, inside)| Token::Group(around, inside))
        })
}

/// What is done to the tokens of a declaration.
#[derive(Debug, Clone)]
enum Change {
    Drop,
    Double,
    Swap,
    Replace(Token),
    Insert(Token),
}

/// A change, with the list of tokens, the token and the other token that it concerns.
type Edit = (Index, [Index; 2], Change);

fn any_edit() -> impl Strategy<Value = Edit> {
    let change = prop_oneof![
        Just(Change::Drop),
        Just(Change::Double),
        Just(Change::Swap),
        any_token().prop_map(Change::Replace),
        any_token().prop_map(Change::Insert),
    ];
    (any::<Index>(), any::<[Index; 2]>(), change)
}

/// Changes one of the lists of tokens, at whatever depth it is.
fn edit(tokens: &mut Vec<Token>, (list, places, change): Edit) {
    let list = list.index(lists(tokens));
    let Some(tokens) = nth(tokens, &mut { list }) else {
        return;
    };
    if tokens.is_empty() {
        return;
    }
    let [i, j] = places.map(|place| place.index(tokens.len()));
    match change {
        Change::Drop => drop(tokens.remove(i)),
        Change::Double => tokens.insert(i, tokens[j].clone()),
        Change::Swap => tokens.swap(i, j),
        Change::Replace(token) => tokens[i] = token,
        Change::Insert(token) => tokens.insert(i, token),
    }
}

/// How many lists of tokens there are: this one, and those of its groups.
fn lists(tokens: &[Token]) -> usize {
    let inside = tokens.iter().map(|token| match token {
        Token::Group(_, inside) => lists(inside),
        Token::Leaf(_) => 0,
    });
    1 + inside.sum::<usize>()
}

/// The list of this number, counted from the outermost.
fn nth<'a>(tokens: &'a mut Vec<Token>, number: &mut usize) -> Option<&'a mut Vec<Token>> {
    if *number == 0 {
        return Some(tokens);
    }
    *number -= 1;
    tokens.iter_mut().find_map(|token| match token {
        Token::Group(_, inside) => nth(inside, number),
        Token::Leaf(_) => None,
    })
}

/// All macros on the same tokens: something must come out, be it errors, and be it soon.
fn answered(tokens: &TokenStream) {
    let clock = Instant::now();
    let all = [expand::model as fn(_) -> _, expand::law, expand::press_law];
    let out = all.map(|expand| expand(tokens.clone()));
    let time = clock.elapsed();
    assert!(time < Duration::from_secs(5), "{time:?} for {tokens}");
    // What is no declaration of the one kind or the other is at least told so.
    assert!(
        out.iter().any(|out| !out.is_empty()),
        "silence about {tokens}"
    );
}

/// Tries many inputs, and of one that fails the simplest that does.
fn for_many<S: Strategy>(inputs: &S, judge: impl Fn(S::Value)) {
    let config = Config {
        cases: INPUTS,
        rng_seed: RngSeed::Fixed(20),
        failure_persistence: None,
        ..Config::default()
    };
    let outcome = TestRunner::new(config).run(inputs, |input| {
        judge(input);
        Ok(())
    });
    outcome.unwrap_or_else(|failure| panic!("{failure}"));
}

#[test]
fn random_tokens() {
    for_many(&vec(any_token(), 0..40), |body| {
        let body = stream(body);
        answered(&body);
        let whole: TokenStream = "pub struct M".parse().expect("tokens");
        let whole = whole
            .into_iter()
            .chain([Group::new(Delimiter::Brace, body).into()]);
        answered(&whole.collect());
    });
}

#[test]
fn mutated_declarations() {
    let model = format!("pub struct M {{ {BELT} }}");
    let declarations =
        [model.as_str(), &model, LAW].map(|text| tokens(text.parse().expect("tokens")));
    let inputs = (select(declarations.to_vec()), vec(any_edit(), 1..25));
    for_many(&inputs, |(mut tokens, edits)| {
        for one in edits {
            edit(&mut tokens, one);
        }
        answered(&stream(tokens));
    });
}

/// What the compiler runs a macro on.
const STACK: usize = 8 << 20;

#[test]
fn formulas_without_end() {
    let compiler = std::thread::Builder::new().stack_size(STACK);
    compiler.spawn(without_end).unwrap().join().unwrap();
}

/// The message for a formula without end: `--------x`, `((((x))))`, `x + x + x`.
fn without_end() {
    let lines = |formula: &str| format!("state x = 1.0; der(x) = {formula};");
    let deep = |depth: usize| format!("{}x{}", "(".repeat(depth), ")".repeat(depth));
    let long = |terms: usize| vec!["x"; terms].join(" + ");
    for fine in [deep(50), long(900), format!("{}x", "-".repeat(900))] {
        assert_eq!(of_model(&lines(&fine)), [""; 0], "{fine}");
    }
    for (formula, what) in [
        (deep(500), "nested deeper than 60"),
        (long(100_000), "longer than 2000"),
        (format!("{}x", "-".repeat(100_000)), "longer than 2000"),
    ] {
        let messages = of_model(&lines(&formula));
        assert!(
            messages[0].contains(what) && messages[0].contains("`let`"),
            "{messages:?}"
        );
    }
    let keywords = "state ".repeat(100_000);
    assert!(!of_model(&keywords).is_empty());
}
