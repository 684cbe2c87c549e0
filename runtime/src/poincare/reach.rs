//! How far the states of a motion go.

/// Smallest and largest value of each state along a motion.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Reach {
    pub(super) low: Vec<f64>,
    pub(super) high: Vec<f64>,
}

impl Reach {
    /// Of a motion that has not left this state.
    pub(super) fn at(state: &[f64]) -> Self {
        Self {
            low: state.to_vec(),
            high: state.to_vec(),
        }
    }

    pub(super) fn widen(&mut self, state: &[f64]) {
        for (j, &value) in state.iter().enumerate() {
            self.low[j] = self.low[j].min(value);
            self.high[j] = self.high[j].max(value);
        }
    }

    pub(super) fn join(&mut self, other: &Self) {
        self.widen(&other.low);
        self.widen(&other.high);
    }

    pub(super) fn extent(&self, j: usize) -> f64 {
        self.high[j] - self.low[j]
    }
}
