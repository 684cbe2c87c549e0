//! What a scene asks for that its model lacks.

use super::modes::ModesNeed;
use crate::continuation::Failure;
use crate::flow::FlowError;
use crate::shooting::OrbitError;
use crate::study::error::StudyError;

/// Something that a model lacks.
#[derive(Debug, Clone, PartialEq)]
pub enum Lack {
    /// A field of a law that must not be negative becomes so: a contact that would have to open.
    Press {
        /// The force whose law it is.
        force: &'static str,
        /// The bounds of the field, as a user writes them.
        bound: String,
        /// What it comes to.
        value: f64,
        /// When.
        time: f64,
    },
    /// A structure needs more modes than are kept.
    Modes {
        /// The structure.
        structure: &'static str,
        /// How many are kept.
        kept: usize,
        /// How many its file has.
        there: usize,
        /// How many of those are needed; `None` if they do not suffice.
        needed: Option<usize>,
        /// The estimated error of what is left out.
        error: f64,
        /// The angular frequency of the first that is left out, if the file has one.
        next: Option<f64>,
    },
}

/// What the model lacks if this stands in the way of an answer.
pub(super) fn lack(error: &StudyError) -> Option<Lack> {
    let flow = match error {
        StudyError::Flow(flow) => flow,
        StudyError::Orbit(error) => of_orbit(error)?,
        _ => return None,
    };
    match flow {
        FlowError::OutOfLaw {
            force,
            bound,
            value,
            time,
            ..
        } if *value <= 0.0 => Some(Lack::Press {
            force,
            bound: bound.clone(),
            value: *value,
            time: *time,
        }),
        _ => None,
    }
}

fn of_orbit(error: &OrbitError) -> Option<&FlowError> {
    match error {
        OrbitError::Flow(flow) | OrbitError::Newton(Failure::Evaluation(flow)) => Some(flow),
        OrbitError::NotSettled { last, .. } => of_orbit(last.as_deref()?),
        _ => None,
    }
}

impl ModesNeed {
    /// That more modes are needed than are kept, if they are.
    pub(super) fn lack(&self) -> Option<Lack> {
        let lacking = self.needed.is_none();
        lacking.then_some(Lack::Modes {
            structure: self.structure,
            kept: self.kept,
            there: self.there,
            needed: self.more,
            error: self.beyond,
            next: self.next,
        })
    }
}
