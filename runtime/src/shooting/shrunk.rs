//! The Hopf point of an equilibrium onto which orbits have shrunk.

use std::f64::consts::TAU;

use nalgebra::DVector;

use super::orbit::Orbit;
use super::problem::OrbitProblem;
use super::shot::Shot;
use super::size::{Size, hopf};
use crate::continuation::{Kind, Located};
use crate::equilibrium::settle;
use crate::flow::FlowError;
use crate::motion::{Family, Place};

/// An orbit that has shrunk to this share of its largest extent ends in an equilibrium.
const VANISHED: f64 = 1e-4;
/// A state that moves by less than this share of the most that it has, beside others that have not shrunk with it, is measured as
/// if it did: where it keeps still, its own swing is rounding errors.
const STILL: f64 = 1e-4;

impl OrbitProblem {
    /// Takes the sizes of one more orbit of a branch; it is refused where it has shrunk to an equilibrium.
    pub(super) fn measure(
        &mut self,
        z: &DVector<f64>,
        r: f64,
        shot: &Shot,
    ) -> Result<(), FlowError> {
        self.magnitude = shot.magnitude(&self.magnitude);
        let sizes = self.magnitude.iter().zip(&mut self.largest);
        let share = sizes.fold(0.0_f64, |most, (size, largest)| {
            let share = size / *largest;
            *largest = largest.max(*size);
            most.max(share)
        });
        for (size, largest) in self.magnitude.iter_mut().zip(&self.largest) {
            *size = size.max(STILL * share * largest);
        }
        let size = Size { r, share };
        let before = self.size.replace(size);
        let (start, period) = (self.start(z, 0), shot.period);
        let known = self.accuracy * r.abs();
        let small = |before| size.vanishes(before, &self.family, (&start, period), known);
        if share < VANISHED || before.is_some_and(small) {
            let state = resting(&self.family, r, &start);
            return Err(FlowError::Vanished {
                state: self.family.at(r)?.values(&state),
            });
        }
        Ok(())
    }
}

/// The Hopf point onto which these orbits have shrunk.
pub(super) fn shrunk(family: &Family, orbits: &[Orbit]) -> Option<Located<Orbit>> {
    let [.., before, last] = orbits else {
        return None;
    };
    let step = (last.r - before.r).abs();
    let found = hopf(family, (last.r, step), (&last.place, last.period))?;
    let mut orbit = last.clone();
    orbit.r = found.r;
    orbit.period = TAU / found.point.frequency()?;
    orbit.place.state.clone_from(&found.point.state);
    (orbit.min, orbit.max) = (found.point.state.clone(), found.point.state);
    orbit.section = vec![orbit.place.state.clone()];
    let mut met = Located::at(Kind::Hopf, found.r, orbit);
    (met.error, met.last) = (found.error, true);
    Some(met)
}

/// The state of the equilibrium within a small orbit, or where that begins if it is not found.
fn resting(family: &Family, r: f64, place: &Place) -> Vec<f64> {
    let found = settle(family, r, place).map(|found| found.place.state);
    found.unwrap_or_else(|| place.state.clone())
}
