//! Formulas: numbers, names, arithmetic and smooth functions.

use std::collections::HashMap;
use std::fmt::{Display, Formatter, Result};

use proc_macro2::{Ident, TokenStream};
use quote::ToTokens;
use syn::Path;
use syn::ext::IdentExt;

/// A literal with its sign.
#[derive(Clone)]
pub(crate) struct Number {
    pub(crate) value: f64,
    pub(crate) source: TokenStream,
}

/// A formula with the tokens it was read from.
#[derive(Clone)]
pub(crate) struct Formula {
    pub(crate) kind: Kind,
    pub(crate) source: TokenStream,
}

#[derive(Clone)]
pub(crate) enum Kind {
    Number(Number),
    /// `std::f64::consts::PI`
    Constant(Path),
    Name(Ident),
    Group(Box<Formula>),
    Minus(Box<Formula>),
    Binary(Box<Formula>, Operator, Box<Formula>),
    /// A function of one argument.
    Call(Ident, Box<Formula>),
    /// `powi(base, exponent)`
    Power(Box<Formula>, i32),
    /// `powf(base, exponent)`
    RealPower(Ident, Box<Formula>, Box<Formula>),
}

#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Operator {
    Add,
    Subtract,
    Multiply,
    Divide,
}

impl Formula {
    /// The formula that is only a name.
    pub(crate) fn name(name: &Ident) -> Self {
        Self {
            kind: Kind::Name(name.clone()),
            source: name.to_token_stream(),
        }
    }

    /// The formula without the parentheses around it.
    pub(crate) fn bare(&self) -> &Self {
        match &self.kind {
            Kind::Group(inner) => inner.bare(),
            _ => self,
        }
    }

    /// The number that it is, sign and parentheses aside.
    pub(crate) fn literal(&self) -> Option<f64> {
        match &self.bare().kind {
            Kind::Number(number) => Some(number.value),
            Kind::Minus(inner) => inner.literal().map(|value| -value),
            _ => None,
        }
    }

    /// The formulas of which this one is made.
    pub(crate) fn parts(&self) -> Vec<&Self> {
        match &self.kind {
            Kind::Number(_) | Kind::Constant(_) | Kind::Name(_) => Vec::new(),
            Kind::Group(x) | Kind::Minus(x) | Kind::Call(_, x) | Kind::Power(x, _) => vec![x],
            Kind::Binary(x, _, y) | Kind::RealPower(_, x, y) => vec![x, y],
        }
    }

    /// The formula in which each of these names is replaced by what it abbreviates.
    pub(crate) fn unabbreviated(&self, meanings: &HashMap<&Ident, Self>) -> Self {
        let boxed = |part: &Self| Box::new(part.unabbreviated(meanings));
        let kind = match &self.kind {
            Kind::Name(name) => match meanings.get(name) {
                Some(meaning) => Kind::Group(Box::new(meaning.clone())),
                None => self.kind.clone(),
            },
            Kind::Number(_) | Kind::Constant(_) => self.kind.clone(),
            Kind::Group(x) => Kind::Group(boxed(x)),
            Kind::Minus(x) => Kind::Minus(boxed(x)),
            Kind::Binary(x, operator, y) => Kind::Binary(boxed(x), *operator, boxed(y)),
            Kind::Call(function, x) => Kind::Call(function.clone(), boxed(x)),
            Kind::Power(x, exponent) => Kind::Power(boxed(x), *exponent),
            Kind::RealPower(function, x, y) => {
                Kind::RealPower(function.clone(), boxed(x), boxed(y))
            }
        };
        let source = self.source.clone();
        Self { kind, source }
    }

    /// Every call of one of these functions: its name and argument, inner ones first.
    pub(crate) fn calls_of(&self, functions: &[&str]) -> Vec<(&Ident, &Self)> {
        let parts = self.parts().into_iter();
        let mut calls: Vec<_> = parts.flat_map(|part| part.calls_of(functions)).collect();
        if let Kind::Call(function, argument) = &self.kind
            && functions.iter().any(|known| function == known)
        {
            calls.push((function, argument));
        }
        calls
    }

    /// Every name that occurs, from left to right.
    pub(crate) fn names(&self) -> Vec<&Ident> {
        match &self.kind {
            Kind::Name(name) => vec![name],
            _ => self.parts().into_iter().flat_map(Self::names).collect(),
        }
    }
}

/// What is underlined of these: the tokens from which they were read.
macro_rules! underlined {
    ($($read:ty),*) => {$(
        impl quote::ToTokens for $read {
            fn to_tokens(&self, tokens: &mut proc_macro2::TokenStream) {
                self.source.to_tokens(tokens);
            }
        }
    )*};
}

pub(crate) use underlined;

underlined!(Formula, Number);

/// As written, with tidy spacing.
impl Display for Formula {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        match &self.kind {
            Kind::Number(number) => write!(f, "{number}"),
            Kind::Constant(path) => write!(f, "{}", tight(&path.to_token_stream())),
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

/// The last word of a path.
pub(crate) fn last_word(path: &Path) -> String {
    let last = path.segments.last();
    last.map_or_else(String::new, |segment| segment.ident.to_string())
}

/// Tokens as text without spaces.
pub(crate) fn tight(tokens: &TokenStream) -> String {
    tokens
        .clone()
        .into_iter()
        .map(|token| token.to_string())
        .collect()
}
