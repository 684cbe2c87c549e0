//! How the answer changes with a parameter: exactly, from the derivatives of shooting and of the flow.

use nalgebra::DVector;

use super::answer::Reach;
use super::stage::Scene;
use crate::continuation::{Failure, correct_at};
use crate::field::Design;
use crate::flow::{FlowError, Want};
use crate::integrate::Tolerance;
use crate::motion::{Flow, Place};
use crate::shooting::{OrbitError, problem};
use crate::study::error::StudyError;
use crate::study::question::{Along, Case};
use crate::study::system::System;

/// How near to an extremum its two sides are looked at, as a share of the period.
const SIDE: f64 = 1e-6;

/// The derivative of the state at a fixed time, and the field there.
type Side = (DVector<f64>, DVector<f64>);

/// An orbit with its derivative by a parameter.
struct Moving<'a> {
    flow: &'a dyn Flow,
    start: Place,
    period: f64,
    /// Derivatives of the start and of the period.
    start_moves: DVector<f64>,
    period_moves: f64,
}

impl System {
    /// The largest relative change of the answer of a scene per unit of a parameter.
    ///
    /// # Errors
    /// The orbit is not singled out, or has no derivative.
    pub(super) fn sensitivity(&self, scene: &Scene, parameter: usize) -> Result<f64, StudyError> {
        let value = scene.case.parameters[parameter];
        let along = Along {
            design: Design::Parameter(parameter),
            from: value,
            to: value,
        };
        let case = Case {
            along: Some(along),
            ..scene.case.clone()
        };
        let family = self.family(&case).with_magnitude(&scene.orbit.magnitude());
        let family = family.with_tolerance(Tolerance::for_accuracy(case.accuracy));
        let (mut problem, z) = problem(family.clone(), value, &scene.orbit.guess(), 1)?;
        let found =
            correct_at(&mut problem, z, value, case.accuracy).map_err(OrbitError::Newton)?;
        let linear = found.linearisation;
        let moves = linear.jacobian.lu().solve(&-linear.design);
        let singular = OrbitError::Newton(Failure::Singular { r: value });
        let moves = moves
            .filter(|moves| moves.iter().all(|one| one.is_finite()))
            .ok_or(singular)?;
        let (order, last) = (family.order(), moves.len() - 1);
        let flow = family.at(value)?;
        let moving = Moving {
            flow: flow.as_ref(),
            start: Place {
                state: found.z.rows(0, order).iter().copied().collect(),
                modes: linear.extra.start.modes.clone(),
            },
            period: found.z[last],
            start_moves: moves.rows(0, order).into_owned(),
            period_moves: moves[last],
        };
        self.largest_change(scene, &moving)
    }

    fn largest_change(&self, scene: &Scene, moving: &Moving<'_>) -> Result<f64, StudyError> {
        let (reaches, _) = self.reaches(moving.flow, &moving.start, moving.period)?;
        let period = scene
            .answer
            .period
            .map_or(0.0, |period| (moving.period_moves / period).abs());
        let mut largest = period;
        for (reach, size) in reaches.iter().zip(&scene.answer.sizes) {
            for change in self.changes(moving, reach)? {
                largest = largest.max((change / size).abs());
            }
        }
        Ok(largest)
    }

    /// The derivatives of what something reaches.
    fn changes(&self, moving: &Moving<'_>, reach: &Reach) -> Result<[f64; 2], FlowError> {
        let value = |vector: &DVector<f64>| reach.of.value(self.info(), vector.as_slice());
        let mut changes = [0.0; 2];
        for (change, &time) in changes.iter_mut().zip(&reach.times) {
            let [before, after] = moving.sides(time)?;
            let [a, b] = [value(&before.0), value(&after.0)];
            let [f, g] = [value(&before.1), value(&after.1)];
            // Both sides meet where they turn, at a time that moves by t': a + f t' = b + g t'.
            let shift = (a - b) / (g - f);
            *change = if shift.is_finite() {
                a + f * shift
            } else {
                0.5 * (a + b)
            };
        }
        Ok(changes)
    }
}

impl Moving<'_> {
    fn at(&self, time: f64) -> Result<Side, FlowError> {
        let passage = self.flow.advance(&self.start, time, Want::DERIVATIVES)?;
        let none = DVector::zeros(self.start_moves.len());
        Ok(passage.derivatives.map_or((none.clone(), none), |one| {
            (one.state * &self.start_moves + one.design, one.time)
        }))
    }

    /// The same on both sides of a time; before the start lies the end, whose time moves with the period.
    fn sides(&self, time: f64) -> Result<[Side; 2], FlowError> {
        let step = SIDE * self.period;
        let wraps = time < step || time > self.period - step;
        let (before, after) = match wraps {
            true => (self.period - step, step),
            false => (time - step, time + step),
        };
        let (mut moves, field) = self.at(before)?;
        if wraps {
            moves += &field * self.period_moves;
        }
        Ok([(moves, field), self.at(after)?])
    }
}
