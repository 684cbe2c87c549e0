//! Whatever tokens come, the macros answer with tokens: no panic, no hang.

use std::time::{Duration, Instant};

use proc_macro2::{Delimiter, Group, Ident, Literal, Punct, Spacing, Span, TokenStream, TokenTree};

use super::{BELT, of_model};
use crate::expand;

/// How many inputs each of the tests makes: the same ones on every machine.
const INPUTS: usize = 4000;

const LAW: &str = "pub struct Law { param limit: N where limit >= 0.0; param decay: s/m = 1.0; stick = limit; \
                   slip(s) = limit / (1.0 + decay * s) - powi(s, 2) * exp(-s); }";

/// SplitMix64.
struct Dice(u64);

impl Dice {
    fn below(&mut self, limit: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        (z ^ (z >> 31)) as usize % limit.max(1)
    }

    fn token(&mut self, depth: usize) -> TokenTree {
        const WORDS: [&str; 24] = [
            "state", "param", "friction", "opposing", "let", "der", "where", "struct", "pub", "x",
            "v", "s", "F", "m", "N", "stick", "slip", "powi", "exp", "D", "self", "r#fn", "Law",
            "default",
        ];
        const SIGNS: &str = "+-*/=<>;:,.^!&|#@?$%~'";
        match self.below(10) {
            0..=3 => {
                let word = WORDS[self.below(WORDS.len())];
                let ident = word.strip_prefix("r#").map_or_else(
                    || Ident::new(word, Span::call_site()),
                    |raw| Ident::new_raw(raw, Span::call_site()),
                );
                ident.into()
            }
            4..=6 => {
                let sign = SIGNS.as_bytes()[self.below(SIGNS.len())] as char;
                let spacing = if self.below(2) == 0 {
                    Spacing::Alone
                } else {
                    Spacing::Joint
                };
                Punct::new(sign, spacing).into()
            }
            7 => self.literal(),
            _ if depth > 3 => self.literal(),
            _ => {
                let around = [
                    Delimiter::Parenthesis,
                    Delimiter::Brace,
                    Delimiter::Bracket,
                    Delimiter::None,
                ];
                let length = self.below(6);
                let inside = (0..length).map(|_| self.token(depth + 1)).collect();
                Group::new(around[self.below(around.len())], inside).into()
            }
        }
    }

    fn literal(&mut self) -> TokenTree {
        match self.below(9) {
            0 => Literal::f64_unsuffixed(1e308),
            1 => Literal::f64_unsuffixed(0.0),
            2 => Literal::u64_unsuffixed(u64::MAX),
            3 => Literal::string("text"),
            4 => Literal::f32_suffixed(1.5),
            5 => Literal::character('x'),
            6 => Literal::byte_string(b"bytes"),
            7 => "1e999".parse().expect("a literal"),
            _ => Literal::i32_unsuffixed(3),
        }
        .into()
    }

    /// The tokens of a declaration with some of them dropped, doubled, swapped or replaced, at any depth.
    fn mutated(&mut self, tokens: TokenStream, depth: usize) -> TokenStream {
        let mut all: Vec<TokenTree> = Vec::new();
        for token in tokens {
            match token {
                TokenTree::Group(group) => {
                    let inside = self.mutated(group.stream(), depth + 1);
                    all.push(Group::new(group.delimiter(), inside).into());
                }
                other => all.push(other),
            }
        }
        for _ in 0..self.below(3) {
            let (i, j) = (self.below(all.len()), self.below(all.len()));
            if all.is_empty() {
                break;
            }
            match self.below(5) {
                0 => drop(all.remove(i)),
                1 => all.insert(i, all[j].clone()),
                2 => all.swap(i, j),
                3 => all[i] = self.token(depth),
                _ => all.insert(i, self.token(depth)),
            }
        }
        all.into_iter().collect()
    }
}

/// Both macros on the same tokens: something must come out, be it errors, and be it soon.
fn answered(tokens: &TokenStream) {
    let clock = Instant::now();
    let out = [expand::model(tokens.clone()), expand::law(tokens.clone())];
    let time = clock.elapsed();
    assert!(time < Duration::from_secs(5), "{time:?} for {tokens}");
    // What is no declaration of the one kind or the other is at least told so.
    assert!(
        out.iter().any(|out| !out.is_empty()),
        "silence about {tokens}"
    );
}

fn for_many(mut one: impl FnMut(&mut Dice)) {
    let mut dice = Dice(20);
    for _ in 0..INPUTS {
        one(&mut dice);
    }
}

#[test]
fn random_tokens() {
    for_many(|dice| {
        let length = dice.below(40);
        let body = (0..length).map(|_| dice.token(0)).collect::<TokenStream>();
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
    let model: TokenStream = format!("pub struct M {{ {BELT} }}")
        .parse()
        .expect("tokens");
    let law: TokenStream = LAW.parse().expect("tokens");
    for_many(|dice| {
        let from = if dice.below(3) == 0 { &law } else { &model };
        let mut tokens = from.clone();
        for _ in 0..=dice.below(3) {
            tokens = dice.mutated(tokens, 0);
        }
        answered(&tokens);
    });
}

/// The message for a formula without end: `--------x`, `((((x))))`, `x + x + x`.
#[test]
fn formulas_without_end() {
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
