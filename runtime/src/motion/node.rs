//! Nodes of quadratures over motions.

use borsh::{BorshDeserialize, BorshSerialize};

use crate::flow;

/// A node of a quadrature over a motion: the integral of a function is the sum of its values, each times its weight.
#[derive(Debug, Clone, PartialEq, BorshSerialize, BorshDeserialize)]
pub struct Node {
    /// Time from the beginning of the passage.
    pub time: f64,
    /// Weight, in units of time.
    pub weight: f64,
    /// State at that time.
    pub state: Vec<f64>,
}

impl<const N: usize> From<&flow::Node<N>> for Node {
    fn from(node: &flow::Node<N>) -> Self {
        Self {
            time: node.time,
            weight: node.weight,
            state: node.state.to_vec(),
        }
    }
}
