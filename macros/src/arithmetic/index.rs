//! Whole numbers that say which element of an array is meant.

use quote::ToTokens;
use syn::{BinOp, Expr, ExprLit, Lit, UnOp};

use crate::formula::tight;

/// What is no index, and how one is written.
fn wrong(expression: &Expr) -> syn::Error {
    let written = tight(&expression.to_token_stream());
    let message = format!(
        "`{written}` is no whole number that is known here: an index and the ends of a loop are made of counters of `for`, \
         whole numbers, `+ - * %` and parentheses"
    );
    syn::Error::new_spanned(expression, message)
}

/// The value of an index.
pub(crate) fn index(expression: &Expr) -> syn::Result<i64> {
    let wrong = || wrong(expression);
    match expression {
        Expr::Lit(ExprLit {
            lit: Lit::Int(whole),
            ..
        }) if whole.suffix().is_empty() => whole.base10_parse(),
        Expr::Paren(inner) => index(&inner.expr),
        Expr::Group(inner) => index(&inner.expr),
        Expr::Unary(unary) if matches!(unary.op, UnOp::Neg(_)) => {
            index(&unary.expr)?.checked_neg().ok_or_else(wrong)
        }
        Expr::Binary(binary) => {
            let (left, right) = (index(&binary.left)?, index(&binary.right)?);
            let value = match binary.op {
                BinOp::Add(_) => left.checked_add(right),
                BinOp::Sub(_) => left.checked_sub(right),
                BinOp::Mul(_) => left.checked_mul(right),
                BinOp::Rem(_) => left.checked_rem_euclid(right),
                _ => None,
            };
            value.ok_or_else(wrong)
        }
        _ => Err(wrong()),
    }
}
