//! A trade at one set of parameters, or at both ends of a range.

use super::copy::Copies;
use super::gather::gathered;
use super::record::{Need, Scope, Trade, Truth};
use super::task::{Part, range};
use crate::field::Kernel;
use crate::model::ModelInfo;
use crate::study::error::{StudyError, TradeError};
use crate::study::question::{Along, Case, Dynamics};
use crate::study::system::System;
use crate::study::work::{List, Watch};

/// How accurately the exact orbit is found.
const ACCURACY: f64 = 1e-11;

/// Error against cost, whatever model it belongs to.
#[derive(Debug, Clone, PartialEq)]
pub struct TradeRecord {
    /// The range whose ends are judged, if one was given.
    pub along: Option<Along>,
    /// One trade, or one for each end of the range.
    pub ends: Vec<End>,
    /// How many items are not there, because it was interrupted.
    pub missing: usize,
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
    /// The cheapest setting of a kernel where it is most demanding: the number of that end, and the setting.
    #[must_use]
    pub fn need(&self, kernel: Kernel) -> Option<(usize, Result<Need, String>)> {
        let needs = self.ends.iter().enumerate().filter_map(|(end, here)| {
            let mut curves = here.trade.curves.iter();
            let curve = curves.find(|curve| curve.kernel == kernel)?;
            Some((end, curve.need.clone()?))
        });
        let demand = |need: &Result<Need, String>| match need {
            Ok(need) => need.smoothing.sharpness(),
            Err(_) => f64::INFINITY,
        };
        needs.reduce(|a, b| if demand(&b.1) > demand(&a.1) { b } else { a })
    }
}

impl System {
    /// Error against cost of every smoothing, near the exact orbit of the case; at both ends if a parameter is followed.
    /// `list` has an item for each copy, see [`Scope::rows`], and `watch` sees each. All but times is the same each time.
    ///
    /// # Errors
    /// There is no friction, or no exact orbit.
    pub fn trade_watched(
        &self,
        case: &Case,
        scope: &Scope,
        list: &List<Part>,
        watch: Watch<'_, Part>,
    ) -> Result<TradeRecord, StudyError> {
        tradable(self.info())?;
        let (tasks, along) = (scope.tasks(), range(case));
        let ends = cases(case, along).map(|case| {
            let copies = Copies::of(self, case, scope)?;
            let truth = copies.measured()?;
            Ok((copies, truth))
        });
        let ends = ends.collect::<Result<Vec<(Copies<'_>, Truth)>, StudyError>>()?;
        let items = tasks.len() * ends.len();
        let one = |item: usize| {
            let (copies, truth) = &ends[item / tasks.len()];
            copies.part(tasks[item % tasks.len()], truth)
        };
        let mut found = list.work(items, one, watch);
        let missing = items - found.len();
        let mut record = |(copies, truth): &(Copies<'_>, Truth), end: usize| {
            let parts = tasks.iter().zip(end * tasks.len()..);
            let parts = parts.filter_map(|(task, item)| Some((*task, found.remove(&item)?)));
            End {
                parameters: copies.case.parameters.clone(),
                trade: gathered(scope, truth, parts),
            }
        };
        let ends = ends.iter().zip(0..).map(|(one, end)| record(one, end));
        Ok(TradeRecord {
            along,
            ends: ends.collect(),
            missing,
        })
    }
}

/// The exact case, or that at each end of a range.
fn cases(case: &Case, along: Option<Along>) -> impl Iterator<Item = Case> {
    let values = along.map_or(vec![None], |along| vec![Some(along.from), Some(along.to)]);
    values.into_iter().map(move |value| Case {
        dynamics: Dynamics::Exact,
        along: None,
        accuracy: ACCURACY,
        ..value.map_or_else(|| case.clone(), |value| case.at(value))
    })
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
