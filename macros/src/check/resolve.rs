//! From what is written to what is known, once every rule has been checked.

use std::borrow::Cow;
use std::collections::HashMap;

use proc_macro2::Ident;
use quote::format_ident;
use syn::ext::IdentExt;

use super::dimension::Dimension;
use super::equations::bends;
use super::known::{
    Carrier, Contact, Force, Law, LawState, Let, Measures, Model, Parameter, State, Step, Unit,
    Whole,
};
use super::presses::rate_of_gap;
use super::units::Units;
use crate::formula::Formula;
use crate::syntax::{self, Declaration, Friction, Line, Rule, Value};

/// Takes over a model in which no mistake was found.
pub(super) fn model<'a>(written: &'a Declaration, units: &Units) -> Option<Model<'a>> {
    let states = written.states().map(|line| state(line, written, units));
    let phase = written.drives().map(|line| Some(phase(line, units)));
    Some(Model {
        driven: written.drives().next().is_some(),
        bent: bends(written),
        header: &written.header,
        states: states.chain(phase).collect::<Option<_>>()?,
        parameters: parameters(written, units),
        steps: steps(written, units),
        structures: &written.structures.all,
    })
}

/// Takes over a law in which no mistake was found.
pub(super) fn law<'a>(written: &'a Declaration, units: &Units) -> Option<Law<'a>> {
    let meanings = meanings(written);
    let whole = |written: &'a Formula| Whole {
        formula: written.unabbreviated(&meanings),
        written,
    };
    let (speed, rate, force) = if let Some(force) = written.forces().next() {
        let (rate, formula) = (force.rate.as_ref(), whole(&force.formula));
        let force_of = rate.map_or(Force::Memory as fn(_) -> _, |_| Force::Press);
        (&force.name, rate, force_of(formula))
    } else if let Some(rebound) = written.rebounds().next() {
        (&rebound.name, None, Force::Rigid(whole(&rebound.formula)))
    } else {
        let (stick, slip) = (written.sticks().next()?, written.slips().next()?);
        let [stick, sliding] = [stick, slip].map(|line| whole(&line.formula));
        (&slip.name, None, Force::Static(stick, sliding))
    };
    let states = written.states().map(|line| {
        let rate = written.derivatives().find(|one| one.name == line.name)?;
        let stop = written.stops().find(|stop| stop.name == line.name);
        Some(LawState {
            line,
            unit: unit(&line.name, line.unit.as_ref(), units),
            rate: whole(&rate.formula),
            stop: stop.map(|stop| whole(&stop.formula)),
        })
    });
    Some(Law {
        header: &written.header,
        parameters: parameters(written, units),
        lets: written.lets().map(|line| quantity(line, units)).collect(),
        speed,
        rate,
        states: states.collect::<Option<_>>()?,
        force,
    })
}

/// What the `let` lines abbreviate.
pub(super) fn meanings(written: &Declaration) -> HashMap<&Ident, Formula> {
    let mut meanings = HashMap::new();
    for line in written.lets() {
        let meaning = line.formula.unabbreviated(&meanings);
        meanings.insert(&line.name, meaning);
    }
    meanings
}

fn quantity<'a>(line: &'a Rule, units: &Units) -> Let<'a> {
    let unit = units.of_name(&line.name).and_then(familiar);
    Let { line, unit }
}

fn state<'a>(line: &'a Value, written: &'a Declaration, units: &Units) -> Option<State<'a>> {
    let mut equations = written.derivatives();
    let (left, rate) = match equations.find(|equation| equation.name == line.name) {
        Some(equation) => (&equation.name, Cow::Borrowed(&equation.formula)),
        None => (&line.name, Cow::Owned(Formula::name(&rate_of(&line.name)))),
    };
    let mut owners = written.frictions();
    let owner = owners.find(|friction| friction.memory.contains(&line.name));
    Some(State {
        docs: &line.docs,
        name: &line.name,
        unit: unit(&line.name, line.unit.as_ref(), units),
        start: line.number.as_ref()?.value,
        left,
        rate,
        carries: owner.map(|friction| &friction.name),
    })
}

/// The phase of a drive is a state like any other to everything but orbits.
fn phase<'a>(line: &'a Rule, units: &Units) -> State<'a> {
    let unit = units.of_name(&line.name).map(|dimension| Unit {
        text: "rad".to_owned(),
        dimension,
    });
    State {
        docs: &line.docs,
        name: &line.name,
        unit,
        start: 0.0,
        left: &line.name,
        rate: Cow::Borrowed(&line.formula),
        carries: None,
    }
}

fn parameters<'a>(written: &'a Declaration, units: &Units) -> Vec<Parameter<'a>> {
    let parameter = |line: &'a Value| Parameter {
        line,
        unit: unit(&line.name, line.unit.as_ref(), units),
    };
    written.params().map(parameter).collect()
}

fn steps<'a>(written: &'a Declaration, units: &Units) -> Vec<Step<'a>> {
    let rubbing = written.frictions().filter(|line| line.memory.is_empty());
    let (mut contacts, mut memories, mut presses) = (0.., 0.., rubbing.count()..);
    let step = |line: &'a Line| match line {
        Line::Let(line) => Some(Step::Let(quantity(line, units))),
        Line::Friction(line) => {
            let places = if line.memory.is_empty() {
                &mut contacts
            } else {
                &mut memories
            };
            let contact = contact(line, places.next()?, units);
            Some(Step::Contact(Box::new(contact)))
        }
        Line::Press(line) => {
            let rate = rate_of_gap(line, written)?;
            let contact = press(line, rate, presses.next()?, units);
            Some(Step::Contact(Box::new(contact)))
        }
        _ => None,
    };
    written.lines.iter().filter_map(step).collect()
}

/// What a law of presses measures lengths by is the gap.
fn press<'a>(line: &'a Friction, rate: Formula, place: usize, units: &Units) -> Contact<'a> {
    let mut contact = contact(line, place, units);
    let gap = contact.measures.speed;
    contact.measures.speed = gap.map(|gap| gap.over(units.time));
    contact.rate = Some(rate);
    contact
}

fn contact<'a>(line: &'a Friction, place: usize, units: &Units) -> Contact<'a> {
    let speed = units.of_formula(&line.speed);
    let fields = line.fields.iter();
    let carriers = line.memory.iter();
    Contact {
        line,
        place,
        rate: None,
        unit: unit(&line.name, line.unit.as_ref(), units),
        fields: fields
            .map(|field| units.of_formula(&field.formula))
            .collect(),
        speed_unit: speed.and_then(familiar),
        measures: Measures {
            force: units.of_name(&line.name),
            speed,
            time: units.time,
        },
        carriers: carriers.map(|state| carrier(state, units)).collect(),
    }
}

fn carrier<'a>(state: &'a Ident, units: &Units) -> Carrier<'a> {
    Carrier {
        state,
        formula: Formula::name(state),
        dimension: units.of_name(state),
        rate: rate_of(state),
    }
}

/// The name under which a law's answer to the rate of a state is kept.
fn rate_of(state: &Ident) -> Ident {
    format_ident!("__der_{}", state.unraw(), span = state.span())
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
