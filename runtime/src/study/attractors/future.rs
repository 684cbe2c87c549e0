//! A start followed until it is known on which of the motions it settles that the first starts have found.

use std::collections::VecDeque;

use super::cloud::Kept;
use super::pursuit::Pursuit;
use super::returns::{SETTLED, returns};
use super::scouted::Scouted;
use super::track::Track;
use super::trap::Hold;
use crate::flow::FlowError;
use crate::motion::Passage;

/// Passages for which a start is followed to a motion that is known.
const PASSAGES: usize = 1500;
/// Steps of the integrator for that.
const STEPS: u64 = 2_000_000;
/// Crossings that are looked back at.
const BACK: usize = 20;

impl Scouted<'_> {
    /// The motion on which a start settles, as soon as that is known, and the way until then.
    pub(super) fn future(&self, start: &[f64], track: &mut Track) -> Option<usize> {
        self.followed(start, track).ok().flatten()
    }

    fn followed(&self, start: &[f64], track: &mut Track) -> Result<Option<usize>, FlowError> {
        let ground = &self.ground;
        let mut pursuit = Pursuit::new(ground.flow.as_ref(), start)?;
        let mut holds: Vec<Option<Hold>> = vec![None; self.traps.len()];
        let section = ground.flow.phase().unwrap_or(0);
        let mut kept_to = Kept::new(&self.clouds);
        let mut latest: VecDeque<Vec<f64>> = VecDeque::new();
        for _ in 0..PASSAGES {
            let (begun, modes) = (pursuit.time, pursuit.place.modes.clone());
            let passage = pursuit.on()?;
            let new = track.note(&passage, modes, &self.shifts);
            let mut crossed = false;
            let mut roams = None;
            for minimum in passage.minima(section) {
                crossed = true;
                latest.push_front(minimum.state.clone());
                latest.truncate(BACK);
                let home = self.shifts.home(&minimum.state);
                roams = roams.or(kept_to.watch(&self.clouds, &home, latest.iter(), &ground.usual));
            }
            let future = self
                .memo
                .future(&track.releases[new], &ground.usual)
                .or_else(|| self.held(&passage, &mut holds));
            let future = future.or_else(|| {
                let mut rests = self.rests.iter();
                Some(
                    rests
                        .find(|rest| rest.holds(&pursuit.place, &self.shifts, &self.copies))?
                        .of,
                )
            });
            let future = future.or(roams);
            let rests = future.is_none() && ground.rests(&passage, pursuit.time - begun)?;
            if future.is_some() {
                return Ok(future);
            }
            if rests {
                let found = ground.rest(&pursuit.place)?;
                return Ok(self
                    .attractors
                    .iter()
                    .position(|known| self.same(known, &found)));
            }
            if pursuit.steps > STEPS
                || (crossed && returns(latest.iter(), &ground.usual, SETTLED).is_some())
            {
                break;
            }
        }
        Ok(None)
    }

    /// The orbit that holds the motion for good after this passage, if one does.
    fn held(&self, passage: &Passage, holds: &mut [Option<Hold>]) -> Option<usize> {
        for (trap, hold) in self.traps.iter().zip(holds) {
            for minimum in passage.minima(trap.section()) {
                match trap.watch(*hold, &minimum.state, &self.shifts) {
                    Ok(next) => *hold = next,
                    Err(of) => return Some(of),
                }
            }
        }
        None
    }
}
