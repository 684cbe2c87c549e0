//! What is found at a node.

use serde::{Deserialize, Serialize};

use crate::study::attractors::Attractor;

/// The answer at one node.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Cell {
    /// What it is, in a few words.
    pub kind: String,
    /// The number that was asked for, where there is one.
    pub value: Option<f64>,
    /// The motion on which the start settles, if one was sought.
    pub motion: Option<Box<Attractor>>,
    /// Why there is no more.
    pub reason: Option<String>,
}

impl Cell {
    /// A node without an answer, and why.
    pub(super) fn failed(reason: String) -> Self {
        Self {
            kind: "failed".to_owned(),
            value: None,
            motion: None,
            reason: Some(reason),
        }
    }

    /// A node whose answer is a number.
    pub(super) fn number(kind: impl Into<String>, value: Option<f64>) -> Self {
        Self {
            kind: kind.into(),
            value,
            motion: None,
            reason: None,
        }
    }
}
