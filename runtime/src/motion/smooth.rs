//! The flow of a smooth system, of any number of states.

use super::passage::fixed;
use super::{Contacts, Derivatives, Flow, Passage, Place, Reading, Velocity};
use crate::field::Field;
use crate::flow::{self, FlowError, SmoothFlow, Want};
use crate::model::{Model, Values};

fn place<const N: usize>(at: &Place) -> flow::Place<N, ()> {
    flow::Place {
        state: fixed(&at.state),
        mode: (),
    }
}

fn modeless((): &()) -> super::Modes {
    Vec::new()
}

impl<M: Model<N>, const N: usize> Flow for SmoothFlow<M, N> {
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
        Ok(Place::of(&place, modeless))
    }

    fn advance(&self, from: &Place, time: f64, want: Want) -> Result<Passage, FlowError> {
        let passage = flow::Flow::advance(self, &place(from), time, want);
        let passage = passage.map_err(|error| {
            let values = self.field().values().as_ref();
            error.of(M::INFO).undefined(M::INFO, values, &|state| {
                let at = flow::Place {
                    state: fixed(state),
                    mode: (),
                };
                flow::Flow::velocity(self, &at)
                    .ok()
                    .map(|rate| rate.f.to_vec())
            })
        })?;
        let passage = Passage::of(passage, modeless);
        Ok(passage.without_rounding(self, from, self.field().magnitude()))
    }

    fn velocity(&self, at: &Place) -> Result<Velocity, FlowError> {
        let velocity = flow::Flow::velocity(self, &place(at));
        let values = self.field().values().as_ref();
        let velocity =
            velocity.map_err(|error| error.undefined(M::INFO, values, &|_| None).named(M::INFO))?;
        Ok(velocity.into())
    }

    /// Nothing switches: gliding is moving.
    fn glide(&self, from: &Place, time: f64) -> Result<(Place, Derivatives), FlowError> {
        let passage = Flow::advance(self, from, time, Want::DERIVATIVES)?;
        let derivatives = passage.derivatives.ok_or(FlowError::BadTime { time })?;
        Ok((passage.end, derivatives))
    }

    fn corners(&self) -> usize {
        Field::corners(self.field())
    }

    fn stop(&self, state: usize) -> f64 {
        self.field().stops().bound(state)
    }

    fn check(&self, at: &Place) -> Result<(), FlowError> {
        let held = self.within_laws(fixed(&at.state));
        held.map_err(|error| error.named(M::INFO))?;
        match self.field().backwards(&fixed(&at.state)) {
            Some((contact, speed)) => Err(FlowError::Backwards {
                contact: M::INFO.contact_id(contact),
                time: 0.0,
                speed,
            }),
            None => Ok(()),
        }
    }

    fn read(&self, at: &Place) -> Result<Reading, FlowError> {
        let state = fixed(&at.state);
        let forces = self.field().forces(&state).as_ref().to_vec();
        Ok((forces, self.field().observables(&state).as_ref().to_vec()))
    }

    fn contacts(&self, at: &Place) -> Result<Contacts, FlowError> {
        let Velocity { f, jacobian, .. } = Flow::velocity(self, at)?;
        Ok(Contacts {
            f,
            jacobian,
            all: Vec::new(),
        })
    }
}
