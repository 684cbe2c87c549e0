//! Internal states of laws that never meet their stops: what they hold is free, and their swing is held about the middle.

use nalgebra::{DVector, RowDVector};

use super::echelon::Echelon;
use super::neutral::{Null, is_conserved};
use super::pin::{Condition, Pin, through};
use super::problem::OrbitProblem;
use super::shot::Shot;
use crate::continuation::{Linearisation, ZeroProblem};
use crate::flow::{FlowError, Want};
use crate::motion::Flow;

/// A state this near to its stop, relatively, is on it.
const ON: f64 = 1e-13;

impl OrbitProblem {
    /// Lets internal states of laws swing about the middle of their stops, whatever they hold at r.
    ///
    /// # Errors
    /// There is no flow at r.
    pub(super) fn centre(&mut self, r: f64) -> Result<(), FlowError> {
        let flow = self.family.at(r)?;
        let stops = |j: &usize| flow.stop(*j).is_finite();
        self.centred = (0..self.magnitude.len()).filter(stops).collect();
        let held = |pin: &Pin| self.centred.iter().any(|&j| pin.combination[j] != 0.0);
        self.pins.retain(|pin| !held(pin));
        Ok(())
    }

    /// These equations with the conditions that hold at this motion.
    ///
    /// # Errors
    /// The motion cannot be followed again.
    pub(super) fn held(
        &mut self,
        flow: &dyn Flow,
        z: &DVector<f64>,
        mut at: Linearisation<Shot>,
    ) -> Result<Linearisation<Shot>, FlowError> {
        let aside = self.leave_stops(flow, z, &mut at);
        let free: Vec<usize> = self
            .centred
            .iter()
            .copied()
            .filter(|&j| met(flow, &at.extra, j) == [false; 2])
            .collect();
        let known = |state: &usize| self.pins.iter().any(|pin| pin.combination[*state] != 0.0);
        if !free.iter().all(known) {
            self.pins.retain(|pin| pin.centred.is_none());
            let found = centred(flow, &at, &self.scale(), &self.magnitude, &free);
            self.pins.extend(found);
        }
        self.run(&mut at);
        let holds = |pin: &&Pin| pin.centred.is_none_or(|state| free.contains(&state));
        let pins: Vec<Pin> = self.pins.iter().filter(holds).cloned().collect();
        for pin in &pins {
            let condition = match pin.centred {
                Some(state) => match &aside {
                    Some(aside) => self.swing(flow, &(z + aside), &at.extra, state)?,
                    None => self.swing(flow, z, &at.extra, state)?,
                },
                None => pin.condition(&at.extra.start.state, &self.magnitude, z.len()),
            };
            condition.enter(&self.holds(pin), &mut at);
        }
        at.extra.pins = through(&pins, &at.extra.start.state);
        if let Some(aside) = aside {
            at.residual -= &at.jacobian * aside;
        }
        Ok(at)
    }

    /// Moves states that meet one of their stops only, though they would find room between both, away from it, and says
    /// how far, if any do. What they hold is lost at a stop, and where they could be as well does not show there.
    fn leave_stops(
        &mut self,
        flow: &dyn Flow,
        z: &DVector<f64>,
        at: &mut Linearisation<Shot>,
    ) -> Option<DVector<f64>> {
        let one: Vec<usize> = self.one_sided(flow, &at.extra).collect();
        if one.is_empty() {
            return None;
        }
        let (low, high) = at.extra.extent();
        let mut aside = DVector::zeros(z.len());
        for (i, shift) in aside.iter_mut().take(z.len() - 1).enumerate() {
            let j = i % low.len();
            if one.contains(&j) {
                *shift = -f64::midpoint(low[j], high[j]);
            }
        }
        let moved = self.once_around(flow, &(z + &aside)).ok()?;
        let clear = |j: &usize| met(flow, &moved.extra, *j) == [false; 2];
        one.iter().all(clear).then(|| {
            *at = moved;
            aside
        })
    }

    /// The states that meet one of their stops only.
    fn one_sided(&self, flow: &dyn Flow, shot: &Shot) -> impl Iterator<Item = usize> {
        let states = self.centred.iter().copied();
        states.filter(move |&j| {
            let [lower, upper] = met(flow, shot, j);
            lower != upper
        })
    }

    /// What meets one of its stops only all along an orbit always slides the same way.
    ///
    /// # Errors
    /// There is no flow at r.
    pub(super) fn leave_centres(&mut self, r: f64, shot: &Shot) -> Result<(), FlowError> {
        if !self.centred.is_empty() {
            let flow = self.family.at(r)?;
            let one: Vec<usize> = self.one_sided(flow.as_ref(), shot).collect();
            self.centred.retain(|j| !one.contains(j));
        }
        Ok(())
    }

    /// The middle of the swing of a state, over its magnitude: its rate vanishes at both ends, so that they may be taken
    /// where they are.
    fn swing(
        &self,
        flow: &dyn Flow,
        z: &DVector<f64>,
        shot: &Shot,
        state: usize,
    ) -> Result<Condition, FlowError> {
        let mut middle = Condition {
            value: 0.0,
            gradient: RowDVector::zeros(z.len()),
            design: 0.0,
        };
        for sign in [1.0, -1.0] {
            let (segment, time) = farthest(shot, state, sign);
            let passage = flow.advance(&self.start(z, segment), time, Want::DERIVATIVES)?;
            middle.value += passage.end.state[state];
            if let Some(derivatives) = &passage.derivatives {
                let order = self.magnitude.len();
                let mut slopes = middle.gradient.columns_mut(segment * order, order);
                slopes += derivatives.state.row(state);
                middle.design += derivatives.design[state];
            }
        }
        Ok(middle.over(2.0 * self.magnitude[state]))
    }
}

/// The segment in which a state is greatest, or least, and the time since that began.
fn farthest(shot: &Shot, state: usize, sign: f64) -> (usize, f64) {
    let passages = shot.passages.iter().enumerate();
    let turns = passages.flat_map(|(segment, passage)| {
        let turns = passage.extrema.iter().filter(|turn| turn.index == state);
        turns.map(move |turn| (sign * turn.state[state], (segment, turn.time)))
    });
    let start = (sign * shot.start.state[state], (0, 0.0));
    turns
        .fold(
            start,
            |most, turn| if turn.0 > most.0 { turn } else { most },
        )
        .1
}

/// Which stops of a state a motion meets: the lower one, and the upper one.
fn met(flow: &dyn Flow, shot: &Shot, state: usize) -> [bool; 2] {
    let (low, high) = shot.extent();
    let stop = flow.stop(state) * (1.0 - ON);
    [-low[state] >= stop, high[state] >= stop]
}

/// The condition for each of these states that is free along a motion.
fn centred(
    flow: &dyn Flow,
    at: &Linearisation<Shot>,
    scale: &DVector<f64>,
    magnitude: &[f64],
    free: &[usize],
) -> Vec<Pin> {
    let left = Null::of(at, scale).map_or_else(Vec::new, |null| null.left);
    let combinations = Echelon::of(&left, magnitude.len(), free).conditions(magnitude);
    let pin = |(combination, left): (Vec<f64>, DVector<f64>)| {
        let state = free.iter().find(|&&state| combination[state] != 0.0)?;
        is_conserved(flow, &combination, &at.extra).then_some(Pin {
            combination,
            value: 0.0,
            direction: None,
            centred: Some(*state),
            left,
        })
    };
    let pairs = combinations.into_iter().zip(left);
    pairs.filter_map(pin).collect()
}
