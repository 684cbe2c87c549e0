//! A step, and what the guards do along it.

use super::guard::{Sighting, Watch};
use super::run::Run;
use super::steps::Steps;
use crate::flow::FlowError;
use crate::flow::saltation::Tracked;
use crate::integrate::event::polish;
use crate::integrate::{Dense, IntegrationError};
use crate::model::Model;

/// A step's dense output, the first fall of a guard along it, and where guards came near to falling.
pub(super) type Look<const N: usize> = (Dense<N>, Option<Sighting>, Vec<Sighting>);

impl<'f, M: Model<N>, V: Tracked<N>, const N: usize> Run<'f, M, V, N> {
    /// Makes a step, so short that its dense output leaves no doubt whether a guard falls.
    pub(super) fn look(
        &mut self,
        stepper: &mut Steps<'_, 'f, M, V, N>,
    ) -> Result<Look<N>, FlowError> {
        let mut limit = self.approach(stepper).min(self.span - self.time);
        loop {
            stepper
                .attempt(limit)
                .map_err(|error| self.explain(error))?;
            stepper.stop_at_corner()?;
            let dense = stepper.dense();
            // Between finite ends the way may overflow, and no event would be seen on it.
            if dense.state(0.5).iter().any(|number| !number.is_finite()) {
                return Err(self.explain(IntegrationError::NotFinite {
                    time: self.time,
                    state: self.carried.state().to_vec().into(),
                }));
            }
            let mut nearest = Vec::new();
            match self.watch(stepper, &dense, &mut nearest)? {
                Some(fall) => return Ok((dense, fall, nearest)),
                None => limit = 0.5 * stepper.length(),
            }
        }
    }

    /// The first fall of a guard along the step, if any falls; `None` if that cannot be told.
    fn watch(
        &self,
        stepper: &Steps<'_, 'f, M, V, N>,
        dense: &Dense<N>,
        nearest: &mut Vec<Sighting>,
    ) -> Result<Option<Option<Sighting>>, FlowError> {
        let system = &self.flow.system;
        let speeds = system.speeds(stepper.from().state());
        let scales = stepper.terms_of_speeds(system, &speeds);
        let mut watch = Watch {
            system,
            modes: &self.modes,
            dense,
            blur: stepper.blur(),
            scales: scales.as_ref().unwrap_or(&self.scales),
            speeds: &speeds,
            departure: &self.departure,
            fall: None,
            doubtful: false,
            nearest: self.want.extrema.then_some(nearest),
        };
        watch.run()?;
        Ok((!watch.doubtful).then_some(watch.fall))
    }

    /// The length of the step at whose end the guard vanishes, by Newton's method on the step map.
    pub(super) fn locate(&self, stepper: &mut Steps<'_, 'f, M, V, N>, fall: &Sighting) -> f64 {
        let length = stepper.length();
        polish(0.0, fall.until * length, fall.theta * length, |tau| {
            let state = stepper.step_map(tau);
            self.flow
                .system
                .moving(&state, &self.modes)
                .map_or((f64::NAN, f64::NAN), |at| {
                    let guard = fall.guard.value(&self.modes, &at);
                    (guard.re, guard.eps)
                })
        })
    }
}
