//! A step, and what the guards do along it.

use super::forms::Linear;
use super::guard::Sighting;
use super::run::Run;
use super::steps::Steps;
use super::watch::Watch;
use crate::flow::FlowError;
use crate::integrate::event::polish;
use crate::integrate::{Dense, IntegrationError};
use crate::model::Model;

impl<'f, M: Model<N>, const N: usize> Run<'f, M, N> {
    /// Makes a step at most `limit` long.
    pub(super) fn reach(
        &self,
        stepper: &mut Steps<'_, 'f, M, N>,
        limit: f64,
    ) -> Result<(), FlowError> {
        stepper
            .attempt(limit)
            .map_err(|error| self.explain(error))?;
        Ok(stepper.stop_at_corner()?)
    }

    /// The first fall of a guard along the step, if any falls; `None` if that cannot be told.
    pub(super) fn watch(
        &self,
        stepper: &Steps<'_, 'f, M, N>,
        speeds: &M::PerContact<f64>,
        dense: &Dense<N>,
        nearest: &mut Vec<Sighting>,
    ) -> Result<Option<Option<Sighting>>, FlowError> {
        // Between finite ends the way may overflow, and no event would be seen on it.
        if dense.state(0.5).iter().any(|number| !number.is_finite()) {
            return Err(self.explain(IntegrationError::NotFinite {
                time: self.time,
                state: self.carried.state().to_vec().into(),
            }));
        }
        nearest.clear();
        let system = &self.flow.system;
        let scales = stepper.terms_of_speeds(system, speeds);
        let known = stepper.linear();
        let linear = known.map(|(stepper, forms)| Linear::new(forms, stepper));
        let mut watch = Watch {
            system,
            modes: &self.modes,
            dense,
            // Of a motion in closed form it is an approximation of its own, that of DOP853 errs as the step does.
            blur: known.map_or(0.0, |(stepper, _)| stepper.error()),
            linear: linear.as_ref(),
            scales: scales.as_ref().unwrap_or(&self.scales),
            speeds,
            departure: &self.departure,
            fall: None,
            doubtful: false,
            nearest: self.want.looks_for_extrema().then_some(&mut *nearest),
        };
        watch.run()?;
        let fall = (!watch.doubtful).then_some(watch.fall);
        // Those of one guard come after those of another.
        nearest.sort_by(|a, b| a.theta.total_cmp(&b.theta));
        Ok(fall)
    }

    /// The length of the step at whose end the guard vanishes, by Newton's method on the step map.
    pub(super) fn locate(&self, stepper: &mut Steps<'_, 'f, M, N>, fall: &Sighting) -> f64 {
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
