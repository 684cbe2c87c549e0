//! Declarations that are known to be good: nothing can go wrong any more.

use proc_macro2::Ident;
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
    pub(crate) rate: &'a Formula,
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
}

pub(crate) struct Let<'a> {
    pub(crate) docs: &'a [Attribute],
    pub(crate) name: &'a Ident,
    pub(crate) formula: &'a Formula,
}

pub(crate) struct Contact<'a> {
    pub(crate) docs: &'a [Attribute],
    pub(crate) name: &'a Ident,
    pub(crate) unit: Option<Unit>,
    pub(crate) law: &'a Path,
    pub(crate) fields: Vec<Field<'a>>,
    pub(crate) speed: &'a Formula,
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

pub(crate) struct Law<'a> {
    pub(crate) header: Header<'a>,
    pub(crate) parameters: Vec<Parameter<'a>>,
    pub(crate) speed: &'a Ident,
    pub(crate) stick: &'a Formula,
    pub(crate) slip: &'a Formula,
}

/// Takes over a model in which no mistake was found.
pub(super) fn model<'a>(written: &'a Declaration, units: &Units) -> Option<Model<'a>> {
    let states: Option<_> = written
        .states()
        .map(|line| state(line, written, units))
        .collect();
    Some(Model {
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
    let (stick, slip) = (written.sticks().next()?, written.slips().next()?);
    Some(Law {
        header: written.header(),
        parameters: parameters(written, units),
        speed: &slip.speed,
        stick: &stick.formula,
        slip: &slip.formula,
    })
}

fn state<'a>(
    line: &'a syntax::State,
    written: &'a Declaration,
    units: &Units,
) -> Option<State<'a>> {
    let equation = written
        .derivatives()
        .find(|equation| equation.state == line.name)?;
    Some(State {
        docs: &line.docs,
        name: &line.name,
        unit: unit(&line.name, line.unit.as_ref(), units),
        start: line.start.value,
        left: &equation.state,
        rate: &equation.formula,
    })
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
        Line::Let(line) => Some(Step::Let(Let {
            docs: &line.docs,
            name: &line.name,
            formula: &line.formula,
        })),
        Line::Friction(line) => Some(Step::Contact(contact(line, units))),
        _ => None,
    }
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

impl<'a> Model<'a> {
    pub(crate) fn lets(&self) -> impl Iterator<Item = &Let<'a>> {
        self.steps.iter().filter_map(|step| match step {
            Step::Let(quantity) => Some(quantity),
            Step::Contact(_) => None,
        })
    }

    pub(crate) fn contacts(&self) -> impl Iterator<Item = &Contact<'a>> {
        self.steps.iter().filter_map(|step| match step {
            Step::Contact(contact) => Some(contact),
            Step::Let(_) => None,
        })
    }
}

impl<'a> Step<'a> {
    pub(crate) fn name(&self) -> &'a Ident {
        match self {
            Self::Let(quantity) => quantity.name,
            Self::Contact(contact) => contact.name,
        }
    }

    pub(crate) fn docs(&self) -> &'a [Attribute] {
        match self {
            Self::Let(quantity) => quantity.docs,
            Self::Contact(contact) => contact.docs,
        }
    }

    /// The formulas from which the step is computed.
    pub(crate) fn formulas(&self) -> Vec<&'a Formula> {
        match self {
            Self::Let(quantity) => vec![quantity.formula],
            Self::Contact(contact) => {
                let fields = contact.fields.iter().map(|field| field.formula);
                fields.chain([contact.speed]).collect()
            }
        }
    }
}
