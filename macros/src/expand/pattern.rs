//! Which state each equation reads, followed through `let` and friction lines.

use std::collections::{HashMap, HashSet};

use proc_macro2::Ident;

use crate::check::{Contact, Model, Step};
use crate::formula::{Formula, Kind};

/// In place i the index j where the equation is `der(i) = j`, plainly another state.
pub(super) fn kinematic(model: &Model) -> Vec<Option<usize>> {
    let index_of = |name: &Ident| model.states.iter().position(|state| state.name == name);
    let kinematic = |(i, rate): (usize, &Formula)| match &rate.bare().kind {
        Kind::Name(name) => index_of(name).filter(|j| *j != i),
        _ => None,
    };
    let rates = model.states.iter().map(|state| state.rate.as_ref());
    rates.enumerate().map(kinematic).collect()
}

/// The states that the equation of each state reads, in their order.
pub(super) fn sparsity(model: &Model) -> Vec<Vec<usize>> {
    let reads = reads(model);
    let row = |read: HashSet<usize>| {
        let mut row: Vec<usize> = read.into_iter().collect();
        row.sort_unstable();
        row
    };
    let rates = model
        .states
        .iter()
        .map(|state| read_by(&[state.rate.as_ref()], &reads));
    rates.map(row).collect()
}

/// The states that stand behind each name.
fn reads<'m>(model: &'m Model<'_>) -> HashMap<&'m Ident, HashSet<usize>> {
    let mut reads: HashMap<&Ident, HashSet<usize>> = HashMap::new();
    for (index, state) in model.states.iter().enumerate() {
        reads.insert(state.name, HashSet::from([index]));
    }
    for step in &model.steps {
        let read = read_by(&step.formulas(), &reads);
        for name in step.computes() {
            reads.insert(name, read.clone());
        }
    }
    reads
}

/// Whether a formula is one of the parameters alone.
pub(super) fn stands_still(formula: &Formula, model: &Model) -> bool {
    read_by(&[formula], &reads(model)).is_empty()
}

/// The numbers of the presses that the law of a contact reads, itself or by what it is named.
pub(super) fn presses_of(contact: &Contact, model: &Model) -> Vec<usize> {
    let mut presses: HashMap<&Ident, HashSet<usize>> = HashMap::new();
    for step in &model.steps {
        let read = match step {
            Step::Contact(press) if press.is_press() => HashSet::from([press.place]),
            _ => read_by(&step.formulas(), &presses),
        };
        presses.insert(step.name(), read);
    }
    let fields = contact.line.fields.iter();
    let fields: Vec<&Formula> = fields.map(|field| &field.formula).collect();
    let mut read: Vec<usize> = read_by(&fields, &presses).into_iter().collect();
    read.sort_unstable();
    read
}

fn read_by(formulas: &[&Formula], reads: &HashMap<&Ident, HashSet<usize>>) -> HashSet<usize> {
    let names = formulas.iter().flat_map(|formula| formula.names());
    names
        .filter_map(|name| reads.get(name))
        .flatten()
        .copied()
        .collect()
}

/// The names of the steps without which no rate and no friction force can be computed.
pub(super) fn needed<'m>(model: &'m Model<'_>) -> HashSet<&'m Ident> {
    let rates = model.states.iter().map(|state| state.rate.as_ref());
    let mut needed: HashSet<&Ident> = rates.flat_map(Formula::names).collect();
    let contacts = model.contacts().chain(model.presses());
    needed.extend(contacts.map(|contact| &contact.line.name));
    for step in model.steps.iter().rev() {
        if step.computes().iter().any(|name| needed.contains(name)) {
            needed.extend(step.formulas().into_iter().flat_map(Formula::names));
        }
    }
    needed
}
