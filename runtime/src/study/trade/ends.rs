//! A trade at one set of parameters, or at both ends of a range.

use std::ops::ControlFlow;

use super::lost::Lost;
use super::measure::trade;
use super::record::{Finding, Need, Scope, Trade};
use crate::field::Kernel;
use crate::model::ModelInfo;
use crate::study::error::{StudyError, TradeError};
use crate::study::question::{Along, Case, Dynamics};
use crate::study::system::System;

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
    /// Whether it was ended before all of it was there.
    #[must_use]
    pub fn is_interrupted(&self) -> bool {
        self.ends.iter().any(|end| end.trade.interrupted)
    }

    /// The cheapest setting of a kernel where it is most demanding: the number of that end, and the setting.
    #[must_use]
    pub fn need(&self, kernel: Kernel) -> Option<(usize, Result<Need, Lost>)> {
        let needs = self.ends.iter().enumerate().filter_map(|(end, here)| {
            let mut curves = here.trade.curves.iter();
            let curve = curves.find(|curve| curve.kernel == kernel)?;
            Some((end, curve.need.clone()?))
        });
        let demand = |need: &Result<Need, Lost>| match need {
            Ok(need) => need.smoothing.sharpness(),
            Err(_) => f64::INFINITY,
        };
        needs.reduce(|a, b| if demand(&b.1) > demand(&a.1) { b } else { a })
    }
}

impl System {
    /// Error against cost of every smoothing, near the exact orbit of the case; at both ends if a parameter is followed.
    /// `watch` sees what is found at which end as it is found, and may end the trade there.
    ///
    /// # Errors
    /// There is no friction, or no exact orbit.
    pub fn trade_watched(
        &self,
        case: &Case,
        scope: &Scope,
        watch: &mut dyn FnMut(usize, Finding<'_>) -> ControlFlow<()>,
    ) -> Result<TradeRecord, StudyError> {
        tradable(self.info())?;
        let parameter = |along: &Along| along.design.parameter().is_some();
        let along = case.along.filter(parameter);
        let values = along.map_or(vec![None], |along| vec![Some(along.from), Some(along.to)]);
        let ends = Vec::new();
        let mut record = TradeRecord { along, ends };
        for (end, value) in values.into_iter().enumerate() {
            if record.is_interrupted() {
                break;
            }
            let case = Case {
                dynamics: Dynamics::Exact,
                along: None,
                accuracy: ACCURACY,
                ..value.map_or_else(|| case.clone(), |value| case.at(value))
            };
            let exact = self.sought(&case)?.orbit(0.0)?;
            let mut here = |finding: Finding<'_>| watch(end, finding);
            let trade = trade(self, &case, &exact, scope, &mut here)?;
            let parameters = case.parameters;
            record.ends.push(End { parameters, trade });
        }
        Ok(record)
    }
}

/// Whether a model has contacts that can be smoothed.
///
/// # Errors
/// It has none, or only laws with internal state.
fn tradable(info: &ModelInfo) -> Result<(), TradeError> {
    let model = info.command;
    match info.only_form() {
        Some(reason) => Err(TradeError::OnlyForm { model, reason }),
        None if !info.touches() => Err(TradeError::NoFriction { model }),
        None => Ok(()),
    }
}
