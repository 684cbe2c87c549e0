//! Declarations that are known to be good: nothing can go wrong any more.

use std::borrow::Cow;
use std::collections::HashSet;

use proc_macro2::Ident;
use syn::Attribute;

use super::dimension::Dimension;
use crate::formula::Formula;
use crate::structure::Structure;
use crate::syntax::{Friction, Header, Rule, Value};

pub(crate) struct Model<'a> {
    pub(crate) header: &'a Header,
    pub(crate) states: Vec<State<'a>>,
    pub(crate) parameters: Vec<Parameter<'a>>,
    /// Whether the last of the states is the phase of a drive.
    pub(crate) driven: bool,
    /// Whether a press stands in a product with a force, in a denominator or inside a function.
    pub(crate) bent: bool,
    /// `let`, friction and press lines in the order in which they are computed.
    pub(crate) steps: Vec<Step<'a>>,
    /// Structures, of whose modes states, parameters and steps are made.
    pub(crate) structures: &'a [Structure],
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

/// A parameter of a model, or of a law.
pub(crate) struct Parameter<'a> {
    pub(crate) line: &'a Value,
    pub(crate) unit: Option<Unit>,
}

pub(crate) struct Unit {
    pub(crate) text: String,
    pub(crate) dimension: Dimension,
}

pub(crate) enum Step<'a> {
    Let(Let<'a>),
    Contact(Box<Contact<'a>>),
}

pub(crate) struct Let<'a> {
    pub(crate) line: &'a Rule,
    /// The unit of its formula, where it is known.
    pub(crate) unit: Option<Unit>,
}

pub(crate) struct Contact<'a> {
    pub(crate) line: &'a Friction,
    /// Its number, among the contacts with internal state if it has such; that of a press follows those of friction.
    pub(crate) place: usize,
    /// Of a press, the rate of its gap.
    pub(crate) rate: Option<Formula>,
    pub(crate) unit: Option<Unit>,
    /// The dimensions of the fields of its law, where they are known.
    pub(crate) fields: Vec<Option<Dimension>>,
    /// The unit of the speed or the gap, where it is known.
    pub(crate) speed_unit: Option<Unit>,
    pub(crate) measures: Measures,
    /// The states that carry the internal states of its law, if that has such.
    pub(crate) carriers: Vec<Carrier<'a>>,
}

/// The dimensions against which a contact measures the fields of its law.
pub(crate) struct Measures {
    pub(crate) force: Option<Dimension>,
    pub(crate) speed: Option<Dimension>,
    pub(crate) time: Dimension,
}

/// A state that carries an internal state of a law.
pub(crate) struct Carrier<'a> {
    pub(crate) state: &'a Ident,
    pub(crate) formula: Formula,
    pub(crate) dimension: Option<Dimension>,
    /// What the law says of its rate.
    pub(crate) rate: Ident,
}

pub(crate) struct Law<'a> {
    pub(crate) header: &'a Header,
    pub(crate) parameters: Vec<Parameter<'a>>,
    pub(crate) lets: Vec<Let<'a>>,
    pub(crate) speed: &'a Ident,
    /// The rate of its depth, if it is a law of presses: then `speed` is the depth.
    pub(crate) rate: Option<&'a Ident>,
    /// The internal states, if it has such.
    pub(crate) states: Vec<LawState<'a>>,
    pub(crate) force: Force<'a>,
}

pub(crate) enum Force<'a> {
    /// Without internal state: at rest, and while sliding.
    Static(Whole<'a>, Whole<'a>),
    /// With internal state, at any speed.
    Memory(Whole<'a>),
    /// Of a press, at any depth and rate.
    Press(Whole<'a>),
    /// Of a press that does not give way: its speed after an impact.
    Rigid(Whole<'a>),
}

pub(crate) struct LawState<'a> {
    pub(crate) line: &'a Value,
    pub(crate) unit: Option<Unit>,
    pub(crate) rate: Whole<'a>,
    /// The magnitude at which it stops.
    pub(crate) stop: Option<Whole<'a>>,
}

/// A formula of a law.
pub(crate) struct Whole<'a> {
    /// Nothing in it is abbreviated any more.
    pub(crate) formula: Formula,
    pub(crate) written: &'a Formula,
}

impl<'a> Model<'a> {
    pub(crate) fn lets(&self) -> impl Iterator<Item = &Let<'a>> {
        self.steps.iter().filter_map(|step| match step {
            Step::Let(quantity) => Some(quantity),
            Step::Contact(_) => None,
        })
    }

    /// The contacts that rub, with laws that have no internal state.
    pub(crate) fn contacts(&self) -> impl Iterator<Item = &Contact<'a>> {
        let all = self.all_contacts();
        all.filter(|contact| !contact.has_memory() && !contact.is_press())
    }

    /// The contacts whose laws have internal state.
    pub(crate) fn memories(&self) -> impl Iterator<Item = &Contact<'a>> {
        self.all_contacts().filter(|contact| contact.has_memory())
    }

    /// The contacts that press.
    pub(crate) fn presses(&self) -> impl Iterator<Item = &Contact<'a>> {
        self.all_contacts().filter(|contact| contact.is_press())
    }

    /// Whether a field of a law reads a state, itself or by what it is named.
    pub(crate) fn moving(&self) -> bool {
        let mut moving: HashSet<&Ident> = self.states.iter().map(|state| state.name).collect();
        let moves = |moving: &HashSet<&Ident>, formula: &Formula| {
            formula.names().iter().any(|name| moving.contains(name))
        };
        for step in &self.steps {
            if step.formulas().iter().any(|line| moves(&moving, line)) {
                moving.extend(step.computes());
            }
        }
        let mut fields = self.all_contacts().flat_map(|contact| &contact.line.fields);
        fields.any(|field| moves(&moving, &field.formula))
    }

    fn all_contacts(&self) -> impl Iterator<Item = &Contact<'a>> {
        self.steps.iter().filter_map(|step| match step {
            Step::Contact(contact) => Some(contact.as_ref()),
            Step::Let(_) => None,
        })
    }
}

impl<'a> Law<'a> {
    /// What changes along a motion, in the order in which it is given to the law: the speed and the internal states, or
    /// the depth and its rate.
    pub(crate) fn moving(&self) -> impl Iterator<Item = &'a Ident> {
        let states = self.states.iter().map(|state| &state.line.name);
        std::iter::once(self.speed).chain(self.rate).chain(states)
    }
}

impl<'a> Step<'a> {
    pub(crate) fn name(&self) -> &'a Ident {
        match self {
            Self::Let(quantity) => &quantity.line.name,
            Self::Contact(contact) => &contact.line.name,
        }
    }

    pub(crate) fn docs(&self) -> &'a [Attribute] {
        match self {
            Self::Let(quantity) => &quantity.line.docs,
            Self::Contact(contact) => &contact.line.docs,
        }
    }

    /// Every quantity that the step computes: the rates that it answers, and its name.
    pub(crate) fn computes(&self) -> Vec<&Ident> {
        let carriers = match self {
            Self::Let(_) => &[],
            Self::Contact(contact) => contact.carriers.as_slice(),
        };
        let rates = carriers.iter().map(|carrier| &carrier.rate);
        rates.chain([self.name()]).collect()
    }

    /// The formulas from which the step is computed.
    pub(crate) fn formulas(&self) -> Vec<&Formula> {
        match self {
            Self::Let(quantity) => vec![&quantity.line.formula],
            Self::Contact(contact) => {
                let carriers = contact.carriers.iter().map(|carrier| &carrier.formula);
                let lines = contact.line.formulas().chain(&contact.rate);
                lines.chain(carriers).collect()
            }
        }
    }
}

impl Contact<'_> {
    pub(crate) fn has_memory(&self) -> bool {
        !self.carriers.is_empty()
    }

    pub(crate) fn is_press(&self) -> bool {
        self.rate.is_some()
    }
}
