//! A motion whose errors are measured against how large its states are, which it shows itself.

use crate::flow::{FlowError, Want};
use crate::motion::{Family, Flow, Passage, Place, half_extents};

/// Usual size of a state, and the largest that errors are measured against.
const USUAL: f64 = 1.0;
/// Samples of the beginning of a motion, which tells whether its states are of the usual size.
const FEW: usize = 64;
/// Times that a stretch is followed anew at most: of states far smaller than what they are measured against, a motion shows
/// little but its errors.
const TRIES: usize = 4;
/// A state that is this much smaller than it was taken to be is measured anew, and one that is larger by as much after that.
const SMALL: f64 = 0.1;
/// Where steps become so many times shorter, what was measured is rounding errors and none of the states.
const SHORTER: f64 = 10.0;

/// A flow that learns how large the states of a motion are, as that goes on.
pub(super) struct Sized<'a> {
    family: &'a Family,
    r: f64,
    sizes: Vec<f64>,
    pub(super) flow: Box<dyn Flow>,
    /// Samples of the next stretch: few as long as a motion of small states may grow.
    samples: usize,
}

impl<'a> Sized<'a> {
    /// That of the flow at r.
    ///
    /// # Errors
    /// There is no flow at r.
    pub(super) fn new(family: &'a Family, r: f64) -> Result<Self, FlowError> {
        Ok(Self {
            family,
            r,
            sizes: vec![USUAL; family.order()],
            flow: family.at(r)?,
            samples: FEW,
        })
    }

    /// The stretch from `place` of at most as many samples as are wanted; where states are small, of fewer, and followed anew
    /// as long as they prove smaller than they were taken to be.
    ///
    /// # Errors
    /// The motion cannot be followed.
    pub(super) fn advance(
        &mut self,
        place: &Place,
        time: f64,
        want: Want,
    ) -> Result<Passage, FlowError> {
        let first = self.samples == FEW;
        let few = self.samples.min(want.samples);
        let (passage, plain) = self.learn(
            place,
            time,
            Want {
                samples: few,
                ..want
            },
        )?;
        let usual = self.is_usual();
        self.samples = if usual { want.samples } else { 2 * few };
        // In one piece, as steps begin anew with each stretch.
        match first && plain && passage.time < time {
            true => self.flow.advance(place, time, want),
            false => Ok(passage),
        }
    }

    /// The flow, once it knows the sizes in the beginning of the motion from `place`.
    ///
    /// # Errors
    /// The motion cannot be followed.
    pub(super) fn learned(mut self, place: &Place, time: f64) -> Result<Box<dyn Flow>, FlowError> {
        let want = Want {
            path: true,
            samples: FEW,
            ..Want::default()
        };
        self.learn(place, time, want)?;
        Ok(self.flow)
    }

    /// The stretch with what it tells of sizes, and whether all were the usual ones on it.
    fn learn(
        &mut self,
        place: &Place,
        time: f64,
        want: Want,
    ) -> Result<(Passage, bool), FlowError> {
        let passage = self.begin(place, time, want)?;
        let passage = self.measured(passage, (place, time, want))?;
        let plain = self.is_usual();
        self.outgrown(&passage)?;
        Ok((passage, plain))
    }

    /// The same stretch, its states measured against what they are, where they are much smaller than they were taken to be.
    fn measured(
        &mut self,
        mut passage: Passage,
        (place, time, want): (&Place, f64, Want),
    ) -> Result<Passage, FlowError> {
        for _ in 0..TRIES {
            let seen = self.seen(&passage);
            if !(0..seen.len()).any(|j| seen[j] < SMALL * self.sizes[j]) {
                break;
            }
            let flow = self.family.with_magnitude(&seen).at(self.r)?;
            match flow.advance(place, time, want) {
                Ok(mut finer) if pace(&passage) <= SHORTER * pace(&finer) => {
                    finer.work += passage.work;
                    (self.sizes, self.flow, passage) = (seen, flow, finer);
                }
                _ => break,
            }
        }
        Ok(passage)
    }

    /// Takes the sizes of states that have become much larger.
    fn outgrown(&mut self, passage: &Passage) -> Result<(), FlowError> {
        let seen = self.seen(passage);
        let mut pairs = self.sizes.iter().zip(&seen);
        if pairs.any(|(size, seen)| *size < SMALL * seen) {
            let pairs = self.sizes.iter().zip(&seen);
            self.sizes = pairs.map(|(size, seen)| size.max(*seen)).collect();
            self.flow = self.family.with_magnitude(&self.sizes).at(self.r)?;
        }
        Ok(())
    }

    /// The stretch, in the sizes known so far; what has outgrown them so much that it is lost in its rounding errors, in the
    /// usual ones.
    fn begin(&mut self, place: &Place, time: f64, want: Want) -> Result<Passage, FlowError> {
        let told = self.flow.advance(place, time, want);
        if told.is_ok() || self.is_usual() {
            return told;
        }
        *self = Self::new(self.family, self.r)?;
        self.flow.advance(place, time, want)
    }

    fn is_usual(&self) -> bool {
        self.sizes.iter().all(|size| *size == USUAL)
    }

    /// Half the extent of each state, at most the usual size; of what rests, the size known so far.
    fn seen(&self, passage: &Passage) -> Vec<f64> {
        let calm = &passage.calm;
        let half = half_extents(&calm.low, &calm.high, &self.sizes);
        half.into_iter().map(|half| half.min(USUAL)).collect()
    }
}

/// The mean length of a step.
fn pace(passage: &Passage) -> f64 {
    passage.time / (passage.work.steps + passage.work.rejected).max(1) as f64
}
