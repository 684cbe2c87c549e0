//! The flow of an exact system, of any number of states.

use nalgebra::{DMatrix, DVector};

use super::passage::fixed;
use super::{Contact, Contacts, Derivatives, Flow, Passage, Place, Reading, Row, Velocity};
use crate::field::exact::{Mode, Modes};
use crate::flow::exact::ExactFlow;
use crate::flow::{self, FlowError, Want};
use crate::model::{Model, Values};
use crate::scalar::Lanes;

pub(crate) fn place<M: Model<N>, const N: usize>(at: &Place) -> flow::Place<N, Modes<M, N>> {
    flow::Place {
        state: fixed(&at.state),
        mode: fixed_modes(&at.modes),
    }
}

pub(crate) fn fixed_modes<M: Model<N>, const N: usize>(modes: &[Mode]) -> Modes<M, N> {
    let held = Modes::<M, N>::held();
    Modes::from_fn(|i| modes.get(i).copied().unwrap_or(held.as_slice()[i]))
}

impl<M: Model<N>, const N: usize> ExactFlow<M, N> {
    /// How far each contact that holds something is from letting go: the reaction of a press at rest, and what friction that
    /// sticks could bear besides.
    fn reserves(&self, at: &Place) -> Vec<(usize, f64)> {
        let binds = |i: &usize| at.modes[*i].binds();
        let binding: Vec<usize> = (0..at.modes.len()).filter(binds).collect();
        if binding.is_empty() {
            return Vec::new();
        }
        let place = place::<M, N>(at);
        let known = self.system().linear(&place.state, &place.mode);
        let reserve = |i: usize| {
            let Ok(known) = &known else {
                return f64::NAN;
            };
            let force = row(&known.force.as_ref()[i]).value;
            match at.modes[i] {
                Mode::Stick => row(&known.stick.as_ref()[i]).value - force.abs(),
                _ => force,
            }
        };
        binding.into_iter().map(|i| (i, reserve(i))).collect()
    }
}

fn modes<M: Model<N>, const N: usize>(modes: &Modes<M, N>) -> super::Modes {
    modes.as_slice().to_vec()
}

fn row<L: Lanes<N>, const N: usize>(lanes: &L) -> Row {
    let (slopes, design) = lanes.slopes();
    Row {
        value: lanes.re(),
        slopes: slopes.to_vec(),
        design,
    }
}

impl<M: Model<N>, const N: usize> Flow for ExactFlow<M, N> {
    fn order(&self) -> usize {
        N
    }

    fn phase(&self) -> Option<usize> {
        M::INFO.drive
    }

    fn values(&self, state: &[f64]) -> Values {
        Values::of(M::INFO, state)
    }

    fn place(&self, state: &[f64]) -> Result<Place, FlowError> {
        let place = flow::Flow::place(self, fixed(state))?;
        Ok(Place::of(&place, modes))
    }

    fn place_in(&self, state: &[f64], modes: &[Mode]) -> Result<Place, FlowError> {
        let reached = Place {
            state: state.to_vec(),
            modes: modes.to_vec(),
        };
        let known = modes.len() == self.system().contacts() && self.is_still(&place(&reached));
        let begun = || self.advance(&reached, 0.0, Want::default()).ok();
        match known.then(begun).flatten() {
            Some(passage) => Ok(passage.end),
            None => Flow::place(self, state),
        }
    }

    fn advance(&self, from: &Place, time: f64, want: Want) -> Result<Passage, FlowError> {
        let passage = flow::Flow::advance(self, &place(from), time, want);
        let passage = passage.map_err(|error| {
            let values = self.system().values().as_ref();
            error.of(M::INFO).undefined(M::INFO, values, &|state| {
                let at = flow::Flow::place(self, fixed(state)).ok()?;
                flow::Flow::velocity(self, &at)
                    .ok()
                    .map(|rate| rate.f.to_vec())
            })
        })?;
        let passage = Passage::of(passage, modes);
        Ok(passage.without_rounding(self, from, &self.system().magnitude))
    }

    fn velocity(&self, at: &Place) -> Result<Velocity, FlowError> {
        let velocity = flow::Flow::velocity(self, &place(at));
        let values = self.system().values().as_ref();
        let velocity =
            velocity.map_err(|error| error.undefined(M::INFO, values, &|_| None).named(M::INFO))?;
        Ok(velocity.into())
    }

    fn glide(&self, from: &Place, time: f64) -> Result<(Place, Derivatives), FlowError> {
        let (end, derivatives) = ExactFlow::glide(self, &place(from), time)?;
        Ok((Place::of(&end, modes), derivatives.into()))
    }

    fn touch(&self, at: &Place, contact: usize) -> Result<Option<[f64; 2]>, FlowError> {
        ExactFlow::touch(self, &place(at), contact)
    }

    fn hold(&self, at: &Place, contact: usize) -> Result<Option<[f64; 2]>, FlowError> {
        ExactFlow::hold(self, &place(at), contact)
    }

    fn loosening(&self, state: &[f64], contact: usize) -> f64 {
        ExactFlow::loosening(self, &fixed(state), contact)
    }

    fn kick(&self, at: &Place, contact: usize) -> Result<Option<Vec<f64>>, FlowError> {
        if const { Modes::<M, N>::PRESSED } {
            if M::INFO.is_rigid(contact) {
                let kick = ExactFlow::kick(self, &place(at), contact)?;
                return Ok(Some(kick.to_vec()));
            }
        }
        Ok(None)
    }

    // Where w = 0 nothing happens to a contact that no force ever holds.
    fn margins(&self, at: &Place) -> Vec<(usize, f64)> {
        let (speeds, rounding) = self.speeds(&fixed(&at.state));
        let signs = at.modes.iter().map(|mode| mode.sign());
        signs
            .enumerate()
            .filter(|(i, sign)| *sign != 0.0 && !self.system().is_idle(*i))
            .map(|(i, sign)| (i, sign * speeds.as_ref()[i] - rounding.as_ref()[i]))
            .chain(self.reserves(at))
            .collect()
    }

    fn speeds(&self, state: &[f64]) -> Vec<f64> {
        self.system().speeds(&fixed(state)).as_ref().to_vec()
    }

    fn loosened(&self, of: super::Modes, speeds: &[f64]) -> super::Modes {
        modes(&self.system().loosened(fixed_modes(&of), speeds))
    }

    fn pinned(&self, of: super::Modes, state: &[f64]) -> super::Modes {
        modes(&self.system().pinned(fixed_modes(&of), &fixed(state)))
    }

    fn check(&self, at: &Place) -> Result<(), FlowError> {
        let held = self.within_laws(fixed(&at.state));
        held.map_err(|error| error.named(M::INFO))
    }

    fn read(&self, at: &Place) -> Result<Reading, FlowError> {
        self.reading(&place(at))
    }

    fn contacts(&self, at: &Place) -> Result<Contacts, FlowError> {
        let flow::Place { state, mode } = place::<M, N>(at);
        let known = self.system().linear(&state, &mode)?;
        let field = known.field.each_ref().map(row);
        let contact = |i: usize| Contact {
            speed: row(&known.speed.as_ref()[i]),
            force: row(&known.force.as_ref()[i]),
            stick: row(&known.stick.as_ref()[i]),
        };
        Ok(Contacts {
            f: DVector::from_fn(N, |i, _| field[i].value),
            jacobian: DMatrix::from_fn(N, N, |i, j| field[i].slopes[j]),
            all: (0..self.system().contacts()).map(contact).collect(),
        })
    }
}
