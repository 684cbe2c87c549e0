//! Formulas of the lines that a structure stands for.

use proc_macro2::{Literal, Punct, Spacing, TokenStream};
use quote::{ToTokens, quote};

use crate::formula::{Formula, Kind, Number, Operator};

/// A number that is not negative.
pub(crate) fn number(span: proc_macro2::Span, value: f64) -> Number {
    let text = format!("{value:e}");
    let mut literal: Literal = text
        .parse()
        .unwrap_or_else(|_| Literal::f64_unsuffixed(value));
    literal.set_span(span);
    Number {
        value,
        source: literal.into_token_stream(),
    }
}

pub(super) fn times(factor: f64, of: &Formula) -> Formula {
    let number = number(proc_macro2::Span::call_site(), factor.abs());
    let source = number.source.clone();
    let product = product(
        &Formula {
            kind: Kind::Number(number),
            source,
        },
        of,
    );
    if factor < 0.0 {
        return negative(product);
    }
    product
}

pub(super) fn negative(of: Formula) -> Formula {
    let source = joined(&TokenStream::new(), '-', &of.source);
    Formula {
        kind: Kind::Minus(Box::new(of)),
        source,
    }
}

pub(super) fn product(left: &Formula, right: &Formula) -> Formula {
    binary(left.clone(), Operator::Multiply, '*', right.clone())
}

/// The sum of all terms; 0 if there are none.
pub(super) fn sum(terms: Vec<Formula>) -> Formula {
    let all = terms.into_iter().reduce(|left, right| match right.kind {
        Kind::Minus(right) => binary(left, Operator::Subtract, '-', *right),
        _ => binary(left, Operator::Add, '+', right),
    });
    all.unwrap_or_else(|| {
        let zero = number(proc_macro2::Span::call_site(), 0.0);
        let source = zero.source.clone();
        Formula {
            kind: Kind::Number(zero),
            source,
        }
    })
}

/// The formula in parentheses.
pub(super) fn group(inner: Formula) -> Formula {
    let source = inner.source.clone();
    Formula {
        kind: Kind::Group(Box::new(inner)),
        source: quote!((#source)),
    }
}

/// One less this.
pub(super) fn rest(of: &Formula) -> Formula {
    let one = number(proc_macro2::Span::call_site(), 1.0);
    let source = one.source.clone();
    let one = Formula {
        kind: Kind::Number(one),
        source,
    };
    group(binary(one, Operator::Subtract, '-', of.clone()))
}

fn binary(left: Formula, operator: Operator, mark: char, right: Formula) -> Formula {
    let source = joined(&left.source, mark, &right.source);
    Formula {
        kind: Kind::Binary(Box::new(left), operator, Box::new(right)),
        source,
    }
}

fn joined(left: &TokenStream, mark: char, right: &TokenStream) -> TokenStream {
    let mark = Punct::new(mark, Spacing::Alone);
    quote!(#left #mark #right)
}
