//! Lines that are repeated: `for i in 0..10 { ... }`.

use proc_macro2::{Delimiter, Group, Ident, Literal, TokenStream, TokenTree};
use quote::ToTokens;
use syn::parse::{ParseStream, Parser};
use syn::{Expr, ExprRange, RangeLimits, Token, braced};

use super::shape::{next, with_shape};
use super::{Place, Reader};
use crate::arithmetic;
use crate::errors::Errors;
use crate::formula::tight;
use crate::syntax::{Broken, Line};

/// Most repetitions of a line.
const MOST: i64 = 10_000;
/// Most loops around a line.
const DEEPEST: usize = 8;

const SHAPE: &str = "for i in 0..10 { der(x[i]) = v[i]; }";

/// Whether a line that begins so is a loop.
pub(super) fn begins(first: &TokenTree) -> bool {
    matches!(first, TokenTree::Ident(word) if word == "for")
}

/// Whether a loop ends so.
pub(super) fn ends(last: &TokenTree) -> bool {
    matches!(last, TokenTree::Group(body) if body.delimiter() == Delimiter::Brace)
}

struct Loop {
    counter: Ident,
    from: i64,
    to: i64,
    body: TokenStream,
}

impl Reader<'_> {
    /// The lines inside a loop, once for each value of its counter.
    pub(super) fn repeat(&mut self, tokens: TokenStream) -> Vec<Line> {
        let read = |input: ParseStream| read(input, self.place);
        let found = match read.parse2(tokens) {
            Ok(found) => found,
            Err(error) => {
                self.errors.add(with_shape(error, "a loop", SHAPE));
                return vec![Line::Broken(Broken {
                    keyword: Some("der"),
                    name: None,
                })];
            }
        };
        let place = Place {
            depth: self.place.depth + 1,
            turns: self.place.turns * (found.to - found.from),
            ..self.place
        };
        self.repeated.counters.push(found.counter.clone());
        let mut lines = Vec::new();
        let before = self.errors.len();
        for value in found.from..found.to {
            let body = with_value(found.body.clone(), &found.counter, value);
            // A mistake is told once, for the first value of the counter.
            let mut again = Errors::new();
            let told = self.errors.len() > before;
            let mut inside = Reader {
                place,
                repeated: self.repeated,
                structures: self.structures,
                errors: if told { &mut again } else { self.errors },
            };
            lines.extend(inside.lines(body));
            again.forget();
        }
        lines
    }
}

fn read(input: ParseStream, place: Place) -> syn::Result<Loop> {
    let word: Token![for] = input.parse()?;
    if place.depth >= DEEPEST {
        let message = format!("loops are nested deeper than {DEEPEST} here");
        return Err(syn::Error::new_spanned(word, message));
    }
    let found = next(input).unwrap_or_default();
    let counter: Ident = input
        .parse()
        .map_err(|_| input.error(format!("expected the name of a counter before `{found}`")))?;
    let found = next(input).unwrap_or_default();
    input
        .parse::<Token![in]>()
        .map_err(|_| input.error(format!("expected `in` before `{found}`")))?;
    let range = Expr::parse_without_eager_brace(input)?;
    let (from, to) = ends_of(&range)?;
    let body;
    braced!(body in input);
    let body: TokenStream = body.parse()?;
    if to <= from {
        return Err(syn::Error::new_spanned(
            range,
            format!("nothing is repeated: `{counter}` would begin at {from} and end before {to}"),
        ));
    }
    if to.saturating_sub(from).saturating_mul(place.turns) > MOST {
        return Err(syn::Error::new_spanned(
            range,
            format!(
                "too many repetitions: {MOST} are the most, those of the loops around it counted"
            ),
        ));
    }
    Ok(Loop {
        counter,
        from,
        to,
        body,
    })
}

/// `from..to`, or `from..=last`.
fn ends_of(range: &Expr) -> syn::Result<(i64, i64)> {
    let Expr::Range(ExprRange {
        start: Some(from),
        limits,
        end: Some(to),
        ..
    }) = range
    else {
        return Err(syn::Error::new_spanned(
            range,
            format!(
                "expected a range of whole numbers such as `0..10`, not `{}`",
                tight(&range.to_token_stream())
            ),
        ));
    };
    let last = matches!(limits, RangeLimits::Closed(_));
    let to = arithmetic::index(to)?.saturating_add(i64::from(last));
    Ok((arithmetic::index(from)?, to))
}

/// The tokens with a value in place of the counter.
fn with_value(tokens: TokenStream, counter: &Ident, value: i64) -> TokenStream {
    let replaced = |token| match token {
        TokenTree::Ident(word) if word == *counter => {
            let mut literal = Literal::i64_unsuffixed(value);
            literal.set_span(word.span());
            literal.to_token_stream()
        }
        TokenTree::Group(group) => {
            let inside = with_value(group.stream(), counter, value);
            let mut same = Group::new(group.delimiter(), inside);
            same.set_span(group.span());
            TokenTree::Group(same).into()
        }
        other => other.into(),
    };
    tokens.into_iter().flat_map(replaced).collect()
}
