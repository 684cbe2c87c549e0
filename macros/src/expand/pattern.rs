//! Which state each equation reads, followed through `let` and friction lines.

use std::collections::{HashMap, HashSet};

use proc_macro2::Ident;

use crate::check::Model;
use crate::formula::{Formula, Kind};

/// In place i the index j where the equation is `der(i) = j`, plainly another state.
pub(super) fn kinematic(model: &Model) -> Vec<Option<usize>> {
    let index_of = |name: &Ident| model.states.iter().position(|state| state.name == name);
    let kinematic = |(i, rate): (usize, &Formula)| match &rate.bare().kind {
        Kind::Name(name) => index_of(name).filter(|j| *j != i),
        _ => None,
    };
    let rates = model.states.iter().map(|state| state.rate);
    rates.enumerate().map(kinematic).collect()
}

/// Whether the equation of state i reads state j, in row i and column j.
pub(super) fn sparsity(model: &Model) -> Vec<Vec<bool>> {
    let mut reads: HashMap<&Ident, HashSet<usize>> = HashMap::new();
    for (index, state) in model.states.iter().enumerate() {
        reads.insert(state.name, HashSet::from([index]));
    }
    for step in &model.steps {
        let read = read_by(&step.formulas(), &reads);
        reads.insert(step.name(), read);
    }
    let row = |read: HashSet<usize>| (0..model.states.len()).map(|j| read.contains(&j)).collect();
    let rates = model
        .states
        .iter()
        .map(|state| read_by(&[state.rate], &reads));
    rates.map(row).collect()
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
pub(super) fn needed<'a>(model: &Model<'a>) -> HashSet<&'a Ident> {
    let rates = model.states.iter().map(|state| state.rate);
    let mut needed: HashSet<&Ident> = rates.flat_map(Formula::names).collect();
    needed.extend(model.contacts().map(|contact| contact.name));
    for step in model.steps.iter().rev() {
        if needed.contains(step.name()) {
            needed.extend(step.formulas().into_iter().flat_map(Formula::names));
        }
    }
    needed
}
