//! Declarations as they are written.

use std::fmt::{Display, Formatter, Result};

use proc_macro2::{Ident, TokenStream};
use quote::ToTokens;
use syn::{Attribute, Path, Token, Visibility};

use crate::formula::{Formula, Number, tight};
use crate::repeated::Repeated;

/// The words that join the parts of a line.
pub(crate) mod word {
    syn::custom_keyword!(at);
    syn::custom_keyword!(opposing);
    syn::custom_keyword!(with);
}

/// `pub struct Name { lines }`.
pub(crate) struct Declaration {
    pub(crate) docs: Vec<Attribute>,
    pub(crate) visibility: Visibility,
    pub(crate) keyword: Token![struct],
    pub(crate) name: Ident,
    pub(crate) lines: Vec<Line>,
    pub(crate) repeated: Repeated,
}

/// What stands before the braces.
#[derive(Clone, Copy)]
pub(crate) struct Header<'a> {
    pub(crate) docs: &'a [Attribute],
    pub(crate) visibility: &'a Visibility,
    pub(crate) keyword: Token![struct],
    pub(crate) name: &'a Ident,
}

impl Declaration {
    pub(crate) fn header(&self) -> Header<'_> {
        Header {
            docs: &self.docs,
            visibility: &self.visibility,
            keyword: self.keyword,
            name: &self.name,
        }
    }
}

pub(crate) enum Line {
    State(State),
    Param(Param),
    Let(Let),
    Friction(Friction),
    Derivative(Derivative),
    Stick(Stick),
    Slip(Slip),
    Force(Force),
    Stop(Stop),
    Drive(Drive),
    /// A line that could not be read; what it declares is known nevertheless.
    Broken(Broken),
}

/// `state name: unit = start;`, in a law without the start.
pub(crate) struct State {
    pub(crate) docs: Vec<Attribute>,
    pub(crate) name: Ident,
    pub(crate) unit: Option<Unit>,
    pub(crate) start: Option<Number>,
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

/// `friction name: unit = Law { fields } opposing speed with states;`, the last part only where the law has memory.
pub(crate) struct Friction {
    pub(crate) docs: Vec<Attribute>,
    pub(crate) name: Ident,
    pub(crate) unit: Option<Unit>,
    pub(crate) law: Path,
    pub(crate) fields: Vec<Field>,
    pub(crate) speed: Formula,
    /// The states that carry the internal states of the law.
    pub(crate) memory: Vec<Ident>,
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

/// `force(speed) = formula;`
pub(crate) struct Force {
    pub(crate) word: Ident,
    pub(crate) speed: Ident,
    pub(crate) formula: Formula,
}

/// `stop state at formula;`
pub(crate) struct Stop {
    pub(crate) state: Ident,
    pub(crate) bound: Formula,
}

/// `drive phase at rate;`
pub(crate) struct Drive {
    pub(crate) docs: Vec<Attribute>,
    pub(crate) name: Ident,
    pub(crate) rate: Formula,
}

/// What is left of a line that could not be read.
#[derive(Default)]
pub(crate) struct Broken {
    pub(crate) keyword: Option<&'static str>,
    pub(crate) name: Option<Ident>,
}

/// `low < name <= high`, either end absent.
#[derive(Clone)]
pub(crate) struct Bounds {
    pub(crate) name: Ident,
    pub(crate) lower: Option<Bound>,
    pub(crate) upper: Option<Bound>,
    pub(crate) source: TokenStream,
}

#[derive(Clone)]
pub(crate) struct Bound {
    pub(crate) number: Number,
    pub(crate) inclusive: bool,
}

/// Symbols with their exponents: `kg*m/s^2`, nothing at all for `1`.
#[derive(Clone)]
pub(crate) struct Unit {
    pub(crate) factors: Vec<UnitFactor>,
    pub(crate) source: TokenStream,
}

#[derive(Clone)]
pub(crate) struct UnitFactor {
    pub(crate) symbol: Ident,
    pub(crate) exponent: i32,
    pub(crate) divides: bool,
}

/// As written, without spaces.
impl Display for Unit {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        f.write_str(&tight(&self.source))
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
    lets: Let;
    frictions: Friction;
    derivatives: Derivative;
    sticks: Stick;
    slips: Slip;
    forces: Force;
    stops: Stop;
    drives: Drive;
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
            Self::Force(line) => vec![&line.formula],
            Self::Stop(line) => vec![&line.bound],
            Self::Drive(line) => vec![&line.rate],
            Self::Friction(line) => {
                let fields = line.fields.iter().map(|field| &field.formula);
                fields.chain([&line.speed]).collect()
            }
        }
    }
}

impl Declaration {
    /// Whether this law has internal state: any line that only such a law has, broken or not.
    pub(crate) fn has_memory(&self) -> bool {
        self.lines.iter().any(|line| match line {
            Line::State(_) | Line::Derivative(_) | Line::Force(_) | Line::Stop(_) => true,
            Line::Broken(line) => line
                .keyword
                .is_some_and(|word| ["state", "der", "force", "stop"].contains(&word)),
            _ => false,
        })
    }
}
