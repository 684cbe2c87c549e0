//! Declarations that are known to be good: nothing can go wrong any more.

use std::borrow::Cow;
use std::collections::HashMap;

use proc_macro2::Ident;
use quote::format_ident;
use syn::ext::IdentExt;
use syn::{Attribute, Path};

use super::bounds;
use super::dimension::Dimension;
use super::units::Units;
use crate::formula::Formula;
use crate::syntax::{self, Declaration, Header, Line};

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

/// Takes over a model in which no mistake was found.
pub(super) fn model<'a>(written: &'a Declaration, units: &Units) -> Option<Model<'a>> {
    let states = written.states().map(|line| state(line, written, units));
    let states: Option<Vec<_>> = states.collect();
    let phase = written.drives().map(|line| phase(line, units));
    let states = states.map(|states| states.into_iter().chain(phase).collect());
    Some(Model {
        driven: written.drives().next().is_some(),
        header: written.header(),
        states: states?,
        parameters: parameters(written, units),
        steps: written
            .lines
            .iter()
            .filter_map(|line| step(line, units))
            .collect(),
    })
}

/// Takes over a law in which no mistake was found.
pub(super) fn law<'a>(written: &'a Declaration, units: &Units) -> Option<Law<'a>> {
    let (header, parameters) = (written.header(), parameters(written, units));
    let meanings = meanings(written);
    if let Some(force) = written.forces().next() {
        let states: Option<_> = written
            .states()
            .map(|line| law_state(line, written, &meanings, units))
            .collect();
        return Some(Law::Memory(MemoryLaw {
            header,
            parameters,
            lets: written.lets().map(|line| quantity(line, units)).collect(),
            speed: &force.speed,
            states: states?,
            force: force.formula.unabbreviated(&meanings),
            written: &force.formula,
        }));
    }
    let (stick, slip) = (written.sticks().next()?, written.slips().next()?);
    Some(Law::Static(StaticLaw {
        header,
        parameters,
        speed: &slip.speed,
        stick: stick.formula.unabbreviated(&meanings),
        slip: slip.formula.unabbreviated(&meanings),
    }))
}

/// What the `let` lines of a law abbreviate.
fn meanings(written: &Declaration) -> HashMap<&Ident, Formula> {
    let mut meanings = HashMap::new();
    for line in written.lets() {
        let meaning = line.formula.unabbreviated(&meanings);
        meanings.insert(&line.name, meaning);
    }
    meanings
}

fn law_state<'a>(
    line: &'a syntax::State,
    written: &'a Declaration,
    meanings: &HashMap<&Ident, Formula>,
    units: &Units,
) -> Option<LawState<'a>> {
    let equation = written.derivatives().find(|one| one.state == line.name)?;
    Some(LawState {
        docs: &line.docs,
        name: &line.name,
        unit: unit(&line.name, line.unit.as_ref(), units),
        rate: equation.formula.unabbreviated(meanings),
        written: &equation.formula,
        stop: written
            .stops()
            .find(|stop| stop.state == line.name)
            .map(|stop| Stop {
                bound: stop.bound.unabbreviated(meanings),
                written: &stop.bound,
            }),
    })
}

fn quantity<'a>(line: &'a syntax::Let, units: &Units) -> Let<'a> {
    Let {
        docs: &line.docs,
        name: &line.name,
        unit: units.of_name(&line.name).and_then(familiar),
        formula: &line.formula,
    }
}

fn state<'a>(
    line: &'a syntax::State,
    written: &'a Declaration,
    units: &Units,
) -> Option<State<'a>> {
    let equation = written
        .derivatives()
        .find(|equation| equation.state == line.name);
    let (left, rate) = match equation {
        Some(equation) => (&equation.state, Cow::Borrowed(&equation.formula)),
        None => (&line.name, Cow::Owned(Formula::name(&rate_of(&line.name)))),
    };
    Some(State {
        docs: &line.docs,
        name: &line.name,
        unit: unit(&line.name, line.unit.as_ref(), units),
        start: line.start.as_ref()?.value,
        left,
        rate,
        carries: written
            .frictions()
            .find(|friction| friction.memory.contains(&line.name))
            .map(|friction| &friction.name),
    })
}

/// The phase of a drive is a state like any other to everything but orbits.
fn phase<'a>(line: &'a syntax::Drive, units: &Units) -> State<'a> {
    State {
        docs: &line.docs,
        name: &line.name,
        unit: units.of_name(&line.name).map(|dimension| Unit {
            text: "rad".to_owned(),
            dimension,
        }),
        start: 0.0,
        left: &line.name,
        rate: Cow::Borrowed(&line.rate),
        carries: None,
    }
}

fn parameters<'a>(written: &'a Declaration, units: &Units) -> Vec<Parameter<'a>> {
    let parameter = |line: &'a syntax::Param| Parameter {
        docs: &line.docs,
        name: &line.name,
        unit: unit(&line.name, line.unit.as_ref(), units),
        default: line.default.as_ref().map(|number| number.value),
        bounds: line.bounds.as_ref().map(known_bounds).unwrap_or_default(),
        bounded: line.bounds.as_ref().map(|bounds| &bounds.name),
    };
    written.params().map(parameter).collect()
}

fn known_bounds(written: &syntax::Bounds) -> Bounds {
    let end = |bound: &Option<syntax::Bound>| {
        bound
            .as_ref()
            .map(|bound| (bound.number.value, bound.inclusive))
    };
    Bounds {
        lower: end(&written.lower),
        upper: end(&written.upper),
        text: bounds::describe(written),
    }
}

fn step<'a>(line: &'a Line, units: &Units) -> Option<Step<'a>> {
    match line {
        Line::Let(line) => Some(Step::Let(quantity(line, units))),
        Line::Friction(line) if line.memory.is_empty() => Some(Step::Contact(contact(line, units))),
        Line::Friction(line) => Some(Step::Memory(Memory {
            contact: contact(line, units),
            carriers: line
                .memory
                .iter()
                .map(|name| carrier(name, units))
                .collect(),
        })),
        _ => None,
    }
}

fn carrier(state: &Ident, units: &Units) -> Carrier {
    Carrier {
        state: state.clone(),
        formula: Formula::name(state),
        dimension: units.of_name(state),
        rate: rate_of(state),
    }
}

/// The name under which a law's answer to the rate of a state is kept.
fn rate_of(state: &Ident) -> Ident {
    format_ident!("__der_{}", state.unraw(), span = state.span())
}

fn contact<'a>(line: &'a syntax::Friction, units: &Units) -> Contact<'a> {
    let field = |field: &'a syntax::Field| Field {
        name: &field.name,
        formula: &field.formula,
        dimension: units.of_formula(&field.formula),
    };
    Contact {
        docs: &line.docs,
        name: &line.name,
        unit: unit(&line.name, line.unit.as_ref(), units),
        law: &line.law,
        fields: line.fields.iter().map(field).collect(),
        speed: &line.speed,
        speed_unit: units.of_formula(&line.speed).and_then(familiar),
        measures: Measures {
            force: units.of_name(&line.name),
            speed: units.of_formula(&line.speed),
            time: units.time(),
        },
    }
}

fn unit(name: &Ident, stated: Option<&syntax::Unit>, units: &Units) -> Option<Unit> {
    Some(Unit {
        text: stated?.to_string(),
        dimension: units.of_name(name)?,
    })
}

/// A dimension that no line states, as it is usually written.
fn familiar(dimension: Dimension) -> Option<Unit> {
    dimension.exponents()?;
    Some(Unit {
        text: dimension.to_string(),
        dimension,
    })
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
