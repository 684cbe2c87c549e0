//! From what is written to what is known, once every rule has been checked.

use std::borrow::Cow;
use std::collections::HashMap;

use proc_macro2::Ident;
use quote::format_ident;
use syn::ext::IdentExt;

use super::bounds;
use super::dimension::Dimension;
use super::known::{
    Bounds, Carrier, Contact, Field, Law, LawState, Let, Measures, Memory, MemoryLaw, Model,
    Parameter, State, StaticLaw, Step, Stop, Unit,
};
use super::units::Units;
use crate::formula::Formula;
use crate::syntax::{self, Declaration, Line};

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
