//! Declarations as they are written.

use std::fmt::{Display, Formatter, Result};

use proc_macro2::{Ident, TokenStream};
use syn::{Attribute, Path, Token, Visibility};

use crate::formula::{Formula, Number, tight, underlined};
use crate::repeated::Repeated;
use crate::structure::Structures;

/// The words that join the parts of a line.
pub(crate) mod word {
    syn::custom_keyword!(at);
    syn::custom_keyword!(closing);
    syn::custom_keyword!(der);
    syn::custom_keyword!(keeping);
    syn::custom_keyword!(opposing);
    syn::custom_keyword!(with);
}

/// `pub struct Name { lines }`.
pub(crate) struct Declaration {
    pub(crate) header: Header,
    pub(crate) lines: Vec<Line>,
    pub(crate) repeated: Repeated,
    pub(crate) structures: Structures,
}

/// What stands before the braces.
#[derive(Clone)]
pub(crate) struct Header {
    pub(crate) docs: Vec<Attribute>,
    pub(crate) visibility: Visibility,
    pub(crate) keyword: Token![struct],
    pub(crate) name: Ident,
}

pub(crate) enum Line {
    State(Value),
    Param(Value),
    Let(Rule),
    Friction(Friction),
    Press(Friction),
    Derivative(Rule),
    Stick(Rule),
    Slip(Rule),
    Force(Rule),
    Rebound(Rule),
    Stop(Rule),
    Drive(Rule),
    /// A line that could not be read; what it declares is known nevertheless.
    Broken(Broken),
}

/// `state name: unit = number;` or `param name: unit = number where bounds;`, in a law without the number.
pub(crate) struct Value {
    pub(crate) docs: Vec<Attribute>,
    pub(crate) name: Ident,
    pub(crate) unit: Option<Unit>,
    /// The start of a state, or the default of a parameter.
    pub(crate) number: Option<Number>,
    pub(crate) bounds: Option<Bounds>,
}

/// A word, a name and a formula: `let name = formula;`, `der(state) = formula;`, `stick = formula;`,
/// `slip(speed) = formula;`, `force(speed) = formula;`, `force(depth, rate) = formula;`, `rebound(speed) = formula;`,
/// `stop state at formula;` or `drive phase at formula;`.
pub(crate) struct Rule {
    pub(crate) docs: Vec<Attribute>,
    pub(crate) word: Ident,
    /// What the formula is of; for `stick`, that word.
    pub(crate) name: Ident,
    /// The second of what it is of: the rate of a depth.
    pub(crate) rate: Option<Ident>,
    pub(crate) formula: Formula,
}

/// `friction name: unit = Law { fields } opposing speed with states;`, the last part only where the law has memory, or
/// `press name: unit = Law { fields } closing gap;`.
pub(crate) struct Friction {
    pub(crate) docs: Vec<Attribute>,
    pub(crate) name: Ident,
    pub(crate) unit: Option<Unit>,
    pub(crate) law: Path,
    pub(crate) fields: Vec<Field>,
    /// The relative speed; of a press, the gap.
    pub(crate) speed: Formula,
    /// The states that carry the internal states of the law.
    pub(crate) memory: Vec<Ident>,
}

/// `name: formula` in the braces of a law.
pub(crate) struct Field {
    pub(crate) name: Ident,
    pub(crate) formula: Formula,
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

/// The first power of a unit: roots of units occur, and are whole in these.
pub(crate) const TWELFTHS: i32 = 12;

/// Symbols with their exponents: `kg*m/s^2`, nothing at all for `1`.
#[derive(Clone)]
pub(crate) struct Unit {
    pub(crate) factors: Vec<UnitFactor>,
    pub(crate) source: TokenStream,
}

#[derive(Clone)]
pub(crate) struct UnitFactor {
    pub(crate) symbol: Ident,
    /// Its power in twelfths.
    pub(crate) twelfths: i32,
    pub(crate) divides: bool,
}

/// As written, without spaces.
impl Display for Unit {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        f.write_str(&tight(&self.source))
    }
}

underlined!(Bounds, Unit);

/// Picks the lines of one kind.
macro_rules! lines_of {
    ($($method:ident: $kind:ident($line:ident);)*) => {
        impl Declaration {$(
            pub(crate) fn $method(&self) -> impl Iterator<Item = &$line> {
                self.lines.iter().filter_map(|line| match line {
                    Line::$kind(found) => Some(found),
                    _ => None,
                })
            }
        )*}
    };
}

lines_of! {
    states: State(Value);
    params: Param(Value);
    lets: Let(Rule);
    frictions: Friction(Friction);
    presses: Press(Friction);
    derivatives: Derivative(Rule);
    sticks: Stick(Rule);
    slips: Slip(Rule);
    forces: Force(Rule);
    rebounds: Rebound(Rule);
    stops: Stop(Rule);
    drives: Drive(Rule);
    broken: Broken(Broken);
}

impl Line {
    /// The word with which it begins, as far as that is known.
    pub(crate) fn keyword(&self) -> Option<&'static str> {
        Some(match self {
            Self::State(_) => "state",
            Self::Param(_) => "param",
            Self::Let(_) => "let",
            Self::Friction(_) => "friction",
            Self::Press(_) => "press",
            Self::Derivative(_) => "der",
            Self::Stick(_) => "stick",
            Self::Slip(_) => "slip",
            Self::Force(_) => "force",
            Self::Rebound(_) => "rebound",
            Self::Stop(_) => "stop",
            Self::Drive(_) => "drive",
            Self::Broken(line) => return line.keyword,
        })
    }

    /// What it declares, or says something of.
    pub(crate) fn name(&self) -> Option<&Ident> {
        match self {
            Self::State(line) | Self::Param(line) => Some(&line.name),
            Self::Friction(line) | Self::Press(line) => Some(&line.name),
            Self::Broken(line) => line.name.as_ref(),
            _ => self.rule().map(|line| &line.name),
        }
    }

    fn rule(&self) -> Option<&Rule> {
        match self {
            Self::Let(line) | Self::Derivative(line) | Self::Stick(line) | Self::Slip(line) => {
                Some(line)
            }
            Self::Force(line) | Self::Rebound(line) | Self::Stop(line) | Self::Drive(line) => {
                Some(line)
            }
            Self::State(_) | Self::Param(_) => None,
            Self::Friction(_) | Self::Press(_) | Self::Broken(_) => None,
        }
    }

    /// The formulas of this line, from left to right.
    pub(crate) fn formulas(&self) -> Vec<&Formula> {
        match self {
            Self::Friction(line) | Self::Press(line) => line.formulas().collect(),
            _ => self.rule().map(|line| &line.formula).into_iter().collect(),
        }
    }
}

impl Friction {
    /// The fields of the law, and the speed or the gap.
    pub(crate) fn formulas(&self) -> impl Iterator<Item = &Formula> {
        let fields = self.fields.iter().map(|field| &field.formula);
        fields.chain([&self.speed])
    }
}

impl Declaration {
    /// What lines of this kind declare or say something of, broken ones too.
    pub(crate) fn named(&self, keyword: &'static str) -> impl Iterator<Item = &Ident> {
        let of_kind = self.lines.iter();
        let of_kind = of_kind.filter(move |line| line.keyword() == Some(keyword));
        of_kind.filter_map(Line::name)
    }

    /// Whether a line of this kind is broken.
    pub(crate) fn lost(&self, keyword: &str) -> bool {
        self.broken().any(|line| line.keyword == Some(keyword))
    }

    /// Whether this law has internal state: any line that only such a law has, broken or not.
    pub(crate) fn has_memory(&self) -> bool {
        let words = self.lines.iter().filter_map(Line::keyword);
        words
            .into_iter()
            .any(|word| ["state", "der", "force", "stop"].contains(&word))
    }
}
