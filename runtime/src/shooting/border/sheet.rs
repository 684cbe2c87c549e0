//! The design variables on which a border depends.

use crate::motion::Family;

/// Flows for each p and, where a curve of borders is followed, each q.
pub trait Sheet: Clone {
    /// The flows along p, at this q.
    fn along_p(&self, q: f64) -> Family;

    /// The flows along q, at this p; `None` if there is no q.
    fn along_q(&self, p: f64) -> Option<Family>;
}

impl Sheet for Family {
    fn along_p(&self, _q: f64) -> Family {
        self.clone()
    }

    fn along_q(&self, _p: f64) -> Option<Family> {
        None
    }
}
