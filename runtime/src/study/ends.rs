//! A trade at one set of parameters, or at both ends of a range.

use super::case::{Along, Case, Dynamics};
use super::entry::StudyError;
use super::trade::{Need, Trade, worst};
use crate::field::{Design, Kernel};

/// How accurately the exact orbit is found.
const ACCURACY: f64 = 1e-11;

/// Error against cost, whatever model it belongs to.
#[derive(Debug, Clone, PartialEq)]
pub struct TradeRecord {
    /// The range whose ends are judged, if one was given.
    pub along: Option<Along>,
    /// One trade, or one for each end of the range.
    pub ends: Vec<End>,
}

/// The trade at one set of parameters.
#[derive(Debug, Clone, PartialEq)]
pub struct End {
    /// Values of all parameters.
    pub parameters: Vec<f64>,
    /// What was measured there.
    pub trade: Trade,
}

impl TradeRecord {
    /// Asks `at` at both ends of the range of a case, or once.
    pub(super) fn gather(
        case: &Case,
        at: impl Fn(Case) -> Result<End, StudyError>,
    ) -> Result<Self, StudyError> {
        let along = case
            .along
            .filter(|along| matches!(along.design, Design::Parameter(_)));
        let exact = |value: Option<f64>| Case {
            dynamics: Dynamics::Exact,
            along: None,
            accuracy: ACCURACY,
            ..value.map_or_else(|| case.clone(), |value| case.at(value))
        };
        let values = along.map_or(vec![None], |along| vec![Some(along.from), Some(along.to)]);
        let ends = values.into_iter().map(|value| at(exact(value)));
        Ok(Self {
            along,
            ends: ends.collect::<Result<_, _>>()?,
        })
    }

    /// The cheapest setting of a kernel where it is most demanding: the number of that end, and the setting.
    #[must_use]
    pub fn need(&self, kernel: Kernel) -> Option<(usize, Result<Need, String>)> {
        let trades: Vec<Trade> = self.ends.iter().map(|end| end.trade.clone()).collect();
        worst(&trades, kernel).map(|(end, need)| (end, need.clone()))
    }
}
