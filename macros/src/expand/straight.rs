//! Where formulas are affine in what moves: which products, quotients and functions of it stand in them.

use std::collections::{BTreeSet, HashMap};

use proc_macro2::Ident;

use crate::check::{Contact, Law, Model, Step, turns};
use crate::formula::{Formula, Kind, Operator};

/// What moves and stands behind a formula, by number.
#[derive(Clone, Default, PartialEq)]
pub(super) struct Reach {
    /// What it reads.
    reads: BTreeSet<usize>,
    /// The pairs of which a second derivative may differ from zero.
    bends: BTreeSet<(usize, usize)>,
}

/// The reach of formulas, from that of names.
struct Reaches<'m> {
    known: HashMap<&'m Ident, Reach>,
    /// The phase of a drive, and the number of what is a sine of it.
    drive: Option<(&'m Ident, usize)>,
}

impl Reach {
    fn of(number: usize) -> Self {
        Self {
            reads: BTreeSet::from([number]),
            ..Self::default()
        }
    }

    fn and(mut self, other: Self) -> Self {
        self.reads.extend(other.reads);
        self.bends.extend(other.bends);
        self
    }

    /// With the products of what the one reads and what the other does.
    fn times(self, other: &Self) -> Self {
        let pairs = self.reads.iter().flat_map(|&a| {
            let others = other.reads.iter();
            others.map(move |&b| (a.min(b), a.max(b)))
        });
        let bends = pairs.collect();
        let reads = other.reads.clone();
        self.and(Self { reads, bends })
    }

    fn curved(self) -> Self {
        let own = self.clone();
        self.times(&own)
    }
}

impl Reaches<'_> {
    fn formula(&self, formula: &Formula) -> Reach {
        let of = |part: &Formula| self.formula(part);
        match &formula.kind {
            Kind::Number(_) | Kind::Constant(_) => Reach::default(),
            Kind::Name(name) => self.known.get(name).cloned().unwrap_or_default(),
            Kind::Group(x) | Kind::Minus(x) | Kind::Power(x, 1) => of(x),
            Kind::Binary(x, Operator::Add | Operator::Subtract, y) => of(x).and(of(y)),
            Kind::Binary(x, Operator::Multiply, y) => of(x).times(&of(y)).and(of(y)),
            Kind::Binary(x, Operator::Divide, y) => of(x).times(&of(y)).and(of(y).curved()),
            Kind::Call(function, x) => self.wave(function, x).unwrap_or_else(|| of(x).curved()),
            Kind::Power(x, _) => of(x).curved(),
            Kind::RealPower(_, x, y) => of(x).and(of(y)).curved(),
        }
    }

    /// A sine or cosine that turns once with the phase of the drive, and with nothing else.
    fn wave(&self, function: &Ident, argument: &Formula) -> Option<Reach> {
        let (phase, number) = self.drive?;
        let once = turns(argument, phase).is_some_and(|turns| turns.abs() == 1.0);
        let alone = self.formula(argument) == self.known[phase];
        ((function == "sin" || function == "cos") && once && alone).then(|| Reach::of(number))
    }
}

/// Pairs of what moves of which the force of a law holds more than a sum, each at its own name.
pub(super) fn bends<'l>(law: &'l Law<'_>, force: &Formula) -> Vec<[&'l Ident; 2]> {
    let parameters = law.parameters.iter().map(|parameter| &parameter.line.name);
    let names: Vec<&Ident> = law.moving().chain(parameters).collect();
    let numbered = names.iter().enumerate();
    let reaches = Reaches {
        known: numbered.map(|(i, name)| (*name, Reach::of(i))).collect(),
        drive: None,
    };
    let bends = reaches.formula(force).bends.into_iter();
    bends.map(|(a, b)| [names[a], names[b]]).collect()
}

/// What moves in a model: the states, of them the phase of a drive as its waves, and the forces.
fn reaches<'m>(model: &'m Model<'_>) -> Reaches<'m> {
    let states = model.states.iter().map(|state| state.name);
    let count = model.states.len();
    let known = states.enumerate().map(|(i, name)| (name, Reach::of(i)));
    let phase = model.states.last().filter(|_| model.driven);
    let mut reaches = Reaches {
        known: known.collect(),
        drive: phase.map(|phase| (phase.name, count)),
    };
    for step in &model.steps {
        let reach = match step {
            Step::Let(quantity) => reaches.formula(&quantity.line.formula),
            Step::Contact(contact) => Reach::of(count + 1 + contact.place),
        };
        reaches.known.insert(step.name(), reach);
    }
    reaches
}

/// Whether all rates, relative speeds, gaps and fields of laws are affine functions of the states, of waves that turn
/// with the phase of the drive, and of the forces.
pub(super) fn is_straight(model: &Model) -> bool {
    let reaches = reaches(model);
    let contacts = || model.contacts().chain(model.presses());
    let rates = model.states.iter().map(|state| state.rate.as_ref());
    let asked = contacts().flat_map(|contact| contact.line.formulas().chain(&contact.rate));
    let straight = |formula: &Formula| reaches.formula(formula).bends.is_empty();
    model.memories().next().is_none() && rates.chain(asked).all(straight)
}

/// The fields of a contact's law that move.
pub(super) fn moving<'m>(contact: &'m Contact, model: &'m Model) -> Vec<&'m Ident> {
    let reaches = reaches(model);
    let moves = |formula: &Formula| !reaches.formula(formula).reads.is_empty();
    let fields = contact.line.fields.iter();
    let fields = fields.filter(|field| moves(&field.formula));
    fields.map(|field| &field.name).collect()
}
