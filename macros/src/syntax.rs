//! Declarations as they are written.

use proc_macro2::{Ident, TokenStream};
use quote::ToTokens;
use syn::{Attribute, Path, Visibility};

/// The words that join the parts of a line.
pub(crate) mod word {
    syn::custom_keyword!(opposing);
}

/// `pub struct Name { lines }`.
pub(crate) struct Declaration {
    pub(crate) docs: Vec<Attribute>,
    pub(crate) visibility: Visibility,
    pub(crate) name: Ident,
    pub(crate) lines: Vec<Line>,
}

pub(crate) enum Line {
    State(State),
    Param(Param),
    Let(Let),
    Friction(Friction),
    Derivative(Derivative),
    Stick(Stick),
    Slip(Slip),
    /// A line that could not be read; what it declares is known nevertheless.
    Broken(Broken),
}

/// `state name: unit = start;`
pub(crate) struct State {
    pub(crate) docs: Vec<Attribute>,
    pub(crate) name: Ident,
    pub(crate) unit: Option<Unit>,
    pub(crate) start: Number,
}

/// `param name: unit = default where bounds;`, in a law without the default.
pub(crate) struct Param {
    pub(crate) docs: Vec<Attribute>,
    pub(crate) name: Ident,
    pub(crate) unit: Option<Unit>,
    pub(crate) default: Option<Number>,
    pub(crate) bounds: Option<Bounds>,
}

/// `let name = formula;`
pub(crate) struct Let {
    pub(crate) docs: Vec<Attribute>,
    pub(crate) name: Ident,
    pub(crate) formula: Formula,
}

/// `friction name: unit = Law { fields } opposing speed;`
pub(crate) struct Friction {
    pub(crate) docs: Vec<Attribute>,
    pub(crate) name: Ident,
    pub(crate) unit: Option<Unit>,
    pub(crate) law: Path,
    pub(crate) fields: Vec<Field>,
    pub(crate) speed: Formula,
}

/// `name: formula` in the braces of a law.
pub(crate) struct Field {
    pub(crate) name: Ident,
    pub(crate) formula: Formula,
}

/// `der(state) = formula;`
pub(crate) struct Derivative {
    pub(crate) state: Ident,
    pub(crate) formula: Formula,
}

/// `stick = formula;`
pub(crate) struct Stick {
    pub(crate) word: Ident,
    pub(crate) formula: Formula,
}

/// `slip(speed) = formula;`
pub(crate) struct Slip {
    pub(crate) word: Ident,
    pub(crate) speed: Ident,
    pub(crate) formula: Formula,
}

/// What is left of a line that could not be read.
pub(crate) struct Broken {
    pub(crate) keyword: String,
    pub(crate) name: Option<Ident>,
}

/// A literal with its sign.
#[derive(Clone)]
pub(crate) struct Number {
    pub(crate) value: f64,
    pub(crate) source: TokenStream,
}

/// `low < name <= high`, either end absent.
pub(crate) struct Bounds {
    pub(crate) name: Ident,
    pub(crate) lower: Option<Bound>,
    pub(crate) upper: Option<Bound>,
    pub(crate) source: TokenStream,
}

pub(crate) struct Bound {
    pub(crate) number: Number,
    pub(crate) inclusive: bool,
}

/// Symbols with their exponents: `kg*m/s^2`, nothing at all for `1`.
pub(crate) struct Unit {
    pub(crate) factors: Vec<UnitFactor>,
    pub(crate) source: TokenStream,
}

pub(crate) struct UnitFactor {
    pub(crate) symbol: Ident,
    pub(crate) exponent: i32,
    pub(crate) divides: bool,
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

    /// The formulas of which this one is made.
    pub(crate) fn parts(&self) -> Vec<&Self> {
        match &self.kind {
            Kind::Number(_) | Kind::Constant(_) | Kind::Name(_) => Vec::new(),
            Kind::Group(x) | Kind::Minus(x) | Kind::Call(_, x) | Kind::Power(x, _) => vec![x],
            Kind::Binary(x, _, y) | Kind::RealPower(_, x, y) => vec![x, y],
        }
    }

    /// Every name that occurs, from left to right.
    pub(crate) fn names(&self) -> Vec<&Ident> {
        match &self.kind {
            Kind::Name(name) => vec![name],
            _ => self.parts().into_iter().flat_map(Self::names).collect(),
        }
    }
}

impl ToTokens for Formula {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        self.source.to_tokens(tokens);
    }
}

impl ToTokens for Number {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        self.source.to_tokens(tokens);
    }
}

impl ToTokens for Unit {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        self.source.to_tokens(tokens);
    }
}

impl ToTokens for Bounds {
    fn to_tokens(&self, tokens: &mut TokenStream) {
        self.source.to_tokens(tokens);
    }
}

/// Picks the lines of one kind.
macro_rules! lines_of {
    ($($(#[$doc:meta])* $method:ident: $kind:ident;)*) => {
        impl Declaration {$(
            $(#[$doc])*
            pub(crate) fn $method(&self) -> impl Iterator<Item = &$kind> {
                self.lines.iter().filter_map(|line| match line {
                    Line::$kind(found) => Some(found),
                    _ => None,
                })
            }
        )*}
    };
}

lines_of! {
    states: State;
    params: Param;
    frictions: Friction;
    derivatives: Derivative;
    sticks: Stick;
    slips: Slip;
    broken: Broken;
}

impl Line {
    /// The formulas of this line, from left to right.
    pub(crate) fn formulas(&self) -> Vec<&Formula> {
        match self {
            Self::State(_) | Self::Param(_) | Self::Broken(_) => Vec::new(),
            Self::Let(line) => vec![&line.formula],
            Self::Derivative(line) => vec![&line.formula],
            Self::Stick(line) => vec![&line.formula],
            Self::Slip(line) => vec![&line.formula],
            Self::Friction(line) => {
                let fields = line.fields.iter().map(|field| &field.formula);
                fields.chain([&line.speed]).collect()
            }
        }
    }
}
