//! Formulas and units as text: as written, with tidy spacing.

use std::fmt::{Display, Formatter, Result};

use syn::ext::IdentExt;

use crate::syntax::{Formula, Kind, Number, Operator, Unit};

impl Display for Formula {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match &self.kind {
            Kind::Number(number) => write!(f, "{number}"),
            Kind::Constant(path) => write!(f, "{}", path_text(path)),
            Kind::Name(name) => write!(f, "{}", name.unraw()),
            Kind::Group(inner) => write!(f, "({inner})"),
            Kind::Minus(inner) => write!(f, "-{inner}"),
            Kind::Binary(left, operator, right) => write!(f, "{left} {operator} {right}"),
            Kind::Call(function, argument) => write!(f, "{function}({argument})"),
            Kind::Power(base, exponent) => write!(f, "powi({base}, {exponent})"),
            Kind::RealPower(function, base, exponent) => {
                write!(f, "{function}({base}, {exponent})")
            }
        }
    }
}

impl Display for Operator {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        f.write_str(match self {
            Self::Add => "+",
            Self::Subtract => "-",
            Self::Multiply => "*",
            Self::Divide => "/",
        })
    }
}

impl Display for Number {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        f.write_str(&tight(&self.source))
    }
}

impl Display for Unit {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        f.write_str(&tight(&self.source))
    }
}

/// A path without spaces.
pub(crate) fn path_text(path: &syn::Path) -> String {
    tight(&quote::ToTokens::to_token_stream(path))
}

fn tight(tokens: &proc_macro2::TokenStream) -> String {
    tokens
        .clone()
        .into_iter()
        .map(|token| token.to_string())
        .collect()
}
