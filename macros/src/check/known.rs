//! Declarations that are known to be good: nothing can go wrong any more.

use std::borrow::Cow;
use std::collections::HashSet;

use proc_macro2::Ident;
use syn::{Attribute, Path};

use super::dimension::Dimension;
use crate::formula::Formula;
use crate::syntax::Header;

pub(crate) struct Model<'a> {
    pub(crate) header: Header<'a>,
    pub(crate) states: Vec<State<'a>>,
    pub(crate) parameters: Vec<Parameter<'a>>,
    /// Whether the last of the states is the phase of a drive.
    pub(crate) driven: bool,
    /// `let` and friction lines in the order in which they are computed.
    pub(crate) steps: Vec<Step<'a>>,
}

pub(crate) struct State<'a> {
    pub(crate) docs: &'a [Attribute],
    pub(crate) name: &'a Ident,
    pub(crate) unit: Option<Unit>,
    pub(crate) start: f64,
    /// The state as named on the left of its equation.
    pub(crate) left: &'a Ident,
    /// The right side of its equation; of a state that carries the memory of a law, a name for what the law says.
    pub(crate) rate: Cow<'a, Formula>,
    /// The force whose memory it carries, if it does.
    pub(crate) carries: Option<&'a Ident>,
}

/// A parameter of a model, or of a law, where it has no default.
pub(crate) struct Parameter<'a> {
    pub(crate) docs: &'a [Attribute],
    pub(crate) name: &'a Ident,
    pub(crate) unit: Option<Unit>,
    pub(crate) default: Option<f64>,
    pub(crate) bounds: Bounds,
    /// The parameter as named in its bounds.
    pub(crate) bounded: Option<&'a Ident>,
}

pub(crate) struct Unit {
    pub(crate) text: String,
    pub(crate) dimension: Dimension,
}

/// Each end with whether it belongs to the interval, and the whole as written.
#[derive(Default)]
pub(crate) struct Bounds {
    pub(crate) lower: Option<(f64, bool)>,
    pub(crate) upper: Option<(f64, bool)>,
    pub(crate) text: String,
}

pub(crate) enum Step<'a> {
    Let(Let<'a>),
    Contact(Contact<'a>),
    Memory(Memory<'a>),
}

pub(crate) struct Let<'a> {
    pub(crate) docs: &'a [Attribute],
    pub(crate) name: &'a Ident,
    /// The unit of its formula, where it is known.
    pub(crate) unit: Option<Unit>,
    pub(crate) formula: &'a Formula,
}

pub(crate) struct Contact<'a> {
    pub(crate) docs: &'a [Attribute],
    pub(crate) name: &'a Ident,
    pub(crate) unit: Option<Unit>,
    pub(crate) law: &'a Path,
    pub(crate) fields: Vec<Field<'a>>,
    pub(crate) speed: &'a Formula,
    /// The unit of the speed, where it is known.
    pub(crate) speed_unit: Option<Unit>,
    pub(crate) measures: Measures,
}

/// `name: formula` in the braces of a law, and its dimension where it is known.
pub(crate) struct Field<'a> {
    pub(crate) name: &'a Ident,
    pub(crate) formula: &'a Formula,
    pub(crate) dimension: Option<Dimension>,
}

/// The dimensions against which a contact measures the fields of its law.
pub(crate) struct Measures {
    pub(crate) force: Option<Dimension>,
    pub(crate) speed: Option<Dimension>,
    pub(crate) time: Dimension,
}

/// A contact whose law has internal state.
pub(crate) struct Memory<'a> {
    pub(crate) contact: Contact<'a>,
    pub(crate) carriers: Vec<Carrier>,
}

/// A state that carries an internal state of a law.
pub(crate) struct Carrier {
    pub(crate) state: Ident,
    pub(crate) formula: Formula,
    pub(crate) dimension: Option<Dimension>,
    /// What the law says of its rate.
    pub(crate) rate: Ident,
}

pub(crate) enum Law<'a> {
    Static(StaticLaw<'a>),
    Memory(MemoryLaw<'a>),
}

/// A law without internal state; nothing in its formulas is abbreviated any more.
pub(crate) struct StaticLaw<'a> {
    pub(crate) header: Header<'a>,
    pub(crate) parameters: Vec<Parameter<'a>>,
    pub(crate) speed: &'a Ident,
    pub(crate) stick: Formula,
    pub(crate) slip: Formula,
}

/// A law with internal state; nothing in its formulas is abbreviated any more.
pub(crate) struct MemoryLaw<'a> {
    pub(crate) header: Header<'a>,
    pub(crate) parameters: Vec<Parameter<'a>>,
    pub(crate) lets: Vec<Let<'a>>,
    pub(crate) speed: &'a Ident,
    pub(crate) states: Vec<LawState<'a>>,
    pub(crate) force: Formula,
    /// The force as written.
    pub(crate) written: &'a Formula,
}

pub(crate) struct LawState<'a> {
    pub(crate) docs: &'a [Attribute],
    pub(crate) name: &'a Ident,
    pub(crate) unit: Option<Unit>,
    pub(crate) rate: Formula,
    /// The rate as written.
    pub(crate) written: &'a Formula,
    pub(crate) stop: Option<Stop<'a>>,
}

/// The magnitude at which an internal state stops.
pub(crate) struct Stop<'a> {
    pub(crate) bound: Formula,
    /// The same as written.
    pub(crate) written: &'a Formula,
}

impl<'a> Model<'a> {
    pub(crate) fn lets(&self) -> impl Iterator<Item = &Let<'a>> {
        self.steps.iter().filter_map(|step| match step {
            Step::Let(quantity) => Some(quantity),
            Step::Contact(_) | Step::Memory(_) => None,
        })
    }

    pub(crate) fn contacts(&self) -> impl Iterator<Item = &Contact<'a>> {
        self.steps.iter().filter_map(|step| match step {
            Step::Contact(contact) => Some(contact),
            Step::Let(_) | Step::Memory(_) => None,
        })
    }

    /// Whether a field of a law reads a state, itself or by what it is named.
    pub(crate) fn moving(&self) -> bool {
        let mut moving: HashSet<&Ident> = self.states.iter().map(|state| state.name).collect();
        let moves = |moving: &HashSet<&Ident>, formula: &Formula| {
            formula.names().iter().any(|name| moving.contains(name))
        };
        for quantity in self.lets() {
            if moves(&moving, quantity.formula) {
                moving.insert(quantity.name);
            }
        }
        let remembering = self.memories().map(|memory| &memory.contact);
        let mut fields = self
            .contacts()
            .chain(remembering)
            .flat_map(|contact| &contact.fields);
        fields.any(|field| moves(&moving, field.formula))
    }

    pub(crate) fn memories(&self) -> impl Iterator<Item = &Memory<'a>> {
        self.steps.iter().filter_map(|step| match step {
            Step::Memory(memory) => Some(memory),
            Step::Let(_) | Step::Contact(_) => None,
        })
    }
}

impl<'a> Step<'a> {
    pub(crate) fn name(&self) -> &'a Ident {
        match self {
            Self::Let(quantity) => quantity.name,
            Self::Contact(contact) => contact.name,
            Self::Memory(memory) => memory.contact.name,
        }
    }

    pub(crate) fn docs(&self) -> &'a [Attribute] {
        match self {
            Self::Let(quantity) => quantity.docs,
            Self::Contact(contact) => contact.docs,
            Self::Memory(memory) => memory.contact.docs,
        }
    }

    /// Every quantity that the step computes: its name, and the rates that it answers.
    pub(crate) fn computes(&self) -> Vec<&Ident> {
        match self {
            Self::Let(_) | Self::Contact(_) => vec![self.name()],
            Self::Memory(memory) => {
                let rates = memory.carriers.iter().map(|carrier| &carrier.rate);
                rates.chain([memory.contact.name]).collect()
            }
        }
    }

    /// The formulas from which the step is computed.
    pub(crate) fn formulas(&self) -> Vec<&Formula> {
        match self {
            Self::Let(quantity) => vec![quantity.formula],
            Self::Contact(contact) => contact.formulas().collect(),
            Self::Memory(memory) => {
                let carriers = memory.carriers.iter().map(|carrier| &carrier.formula);
                memory.contact.formulas().chain(carriers).collect()
            }
        }
    }
}

impl<'a> Contact<'a> {
    fn formulas(&self) -> impl Iterator<Item = &'a Formula> {
        let fields = self.fields.iter().map(|field| field.formula);
        fields.chain([self.speed])
    }
}
