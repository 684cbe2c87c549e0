//! What is free where its bounds are never met: it is held where it swings about their middle. Internal states of laws hold
//! something of their own; what a contact holds that sticks all along depends on where it does so.

use nalgebra::{DVector, RowDVector};

use super::conserved::is_conserved;
use super::echelon::Echelon;
use super::neutral::Null;
use super::pin::{Condition, Pin, Swing, through};
use super::problem::OrbitProblem;
use super::shot::Shot;
use super::swing::{met, sticks};
use crate::continuation::{Linearisation, ZeroProblem};
use crate::flow::{FlowError, Want};
use crate::motion::{Flow, Segment};

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

    /// Lets contacts that stick all along bear as much the one way as the other, as far as what is free tells that: of two
    /// that hold one spring between them, one settles what the other bears.
    pub(super) fn balance(&mut self, segments: &[Segment], (z, r): (&DVector<f64>, f64)) {
        if self.modes.len() > 1 {
            return;
        }
        let contacts = 0..segments.first().map_or(0, |first| first.modes.len());
        for contact in contacts.filter(|&i| sticks(segments, i)) {
            for k in 0..self.pins.len() {
                if self.pins[k].centred.is_some() {
                    continue;
                }
                self.pins[k].centred = Some(Swing::Force(contact));
                let at = self.evaluate(z, r);
                if at.is_ok_and(|at| Null::of(&at, &self.scale()).is_none()) {
                    break;
                }
                self.pins[k].centred = None;
            }
        }
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
            self.pins.retain(|pin| !pin.holds_state());
            let found = centred(flow, &at, &self.scale(), &self.magnitude, &free);
            self.pins.extend(found);
        }
        self.run(&mut at);
        let free = |pin: &&Pin| {
            pin.centred
                .is_none_or(|swing| swing.is_free(flow, &at.extra))
        };
        let slides = |pin: &Pin| !pin.holds_state() && !free(&pin);
        if self.pins.iter().any(slides) {
            return Err(FlowError::LetsGo);
        }
        let pins: Vec<Pin> = self.pins.iter().filter(free).cloned().collect();
        let moved = aside.as_ref().map(|aside| z + aside);
        for pin in &pins {
            let condition = match pin.centred {
                Some(swing) => self.middle(flow, moved.as_ref().unwrap_or(z), &at.extra, swing)?,
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

    /// The middle of what swings, over its magnitude: its rate vanishes at both ends, so that they may be taken where they
    /// are.
    fn middle(
        &self,
        flow: &dyn Flow,
        z: &DVector<f64>,
        shot: &Shot,
        swing: Swing,
    ) -> Result<Condition, FlowError> {
        let mut middle = Condition {
            value: 0.0,
            gradient: RowDVector::zeros(z.len()),
            design: 0.0,
        };
        let order = self.magnitude.len();
        for turn in swing.turns(flow, shot)? {
            let start = self.start(z, turn.segment);
            let mut passage = flow.advance(&start, turn.time, Want::DERIVATIVES)?;
            if let (Some(instant), Some(at)) = (&turn.instant, &mut passage.derivatives) {
                instant.carry(flow, &passage.end.state, at)?;
            }
            let row = swing.row(flow, &passage.end.state, &turn)?;
            middle.value += row.value;
            middle.design += row.design;
            if let Some(derivatives) = &passage.derivatives {
                let row = RowDVector::from_vec(row.slopes);
                let mut slopes = middle.gradient.columns_mut(turn.segment * order, order);
                slopes += &row * &derivatives.state;
                middle.design += (row * &derivatives.design)[0];
            }
        }
        let unit = match swing {
            Swing::State(state) => self.magnitude[state],
            Swing::Force(_) => 1.0,
        };
        Ok(middle.over(2.0 * unit))
    }
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
        is_conserved(flow, &combination, &at.extra, magnitude).then_some(Pin {
            combination,
            value: 0.0,
            told: 0.0,
            direction: None,
            driven: false,
            centred: Some(Swing::State(*state)),
            left,
        })
    };
    let pairs = combinations.into_iter().zip(left);
    pairs.filter_map(pin).collect()
}
