//! Returns of a motion that settles, and what comes of them: the orbit that is meant, or why it is none.

use super::anchor::anchored;
use super::converge::{calmly, from};
use super::damped::damped;
use super::error::OrbitError;
use super::guess::Guess;
use super::least::midway;
use super::neutral::neutral;
use super::orbit::Orbit;
use super::sought::Search;
use super::stay::stays;
use crate::bifurcation::Stability;
use crate::field::exact::Mode;
use crate::motion::Family;

/// Returns that are all looked at; of later ones every eighth.
const OFTEN: usize = 64;
const SELDOM: usize = 8;
/// Returns at most that are looked at beyond one that leads to an orbit which hardly attracts.
const DOUBTED: usize = 32;

/// Which orbit is meant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Meant {
    /// The first to which a return leads.
    First,
    /// That on which the motion stays.
    Last,
}

impl Meant {
    /// Longest period sought, in crossings of the section.
    pub(super) const fn longest(self) -> usize {
        match self {
            Self::First => 32,
            Self::Last => 512,
        }
    }
}

/// The orbit about which a motion swings to and fro that comes back after two turns.
pub(super) fn swung_about(
    family: &Family,
    r: f64,
    guess: &Guess,
    search: &Search,
) -> Option<Orbit> {
    let flow = family.with_magnitude(&guess.magnitude).at(r).ok()?;
    let midway = midway(flow.as_ref(), guess).ok()??;
    from(family, r, &midway, search, &anchored).ok()
}

/// Returns of a motion that were no orbits, or not the one that is meant.
pub(super) struct Failed {
    meant: Meant,
    count: usize,
    pub(super) last: Option<OrbitError>,
    pub(super) magnitude: Option<Vec<f64>>,
    /// The last orbit that hardly attracts, and how many there were.
    pub(super) doubtful: Option<Orbit>,
    doubted: usize,
}

impl Failed {
    pub(super) fn new(meant: Meant) -> Self {
        Self {
            meant,
            count: 0,
            last: None,
            magnitude: None,
            doubtful: None,
            doubted: 0,
        }
    }

    /// Whether the motion may settle elsewhere: where friction holds what slides ever less in any of many places, the last orbit
    /// along which it slides is none of them.
    fn doubts(&self, orbit: &Orbit) -> bool {
        let sticks = |mode: &Mode| *mode == Mode::Stick;
        let held = orbit
            .segments
            .iter()
            .any(|one| one.modes.iter().any(sticks));
        let hardly = orbit.floquet.stability == Stability::Undecided && held;
        hardly && self.doubted < DOUBTED
    }

    /// The orbit, unless another is meant.
    pub(super) fn taken(
        &self,
        family: &Family,
        r: f64,
        guess: &Guess,
        (orbit, search): (Orbit, &Search),
    ) -> Result<Orbit, OrbitError> {
        if self.meant == Meant::First || stays(family, r, guess, (&orbit, &search.start))? {
            return Ok(orbit);
        }
        Err(OrbitError::Passed {
            period: orbit.period,
            stability: orbit.floquet.stability.name(),
        })
    }

    /// The orbit near a return; `None` if it is no orbit either.
    ///
    /// Of many returns that lead nowhere only the first, second, fourth and so on are looked at closely.
    pub(super) fn unless(
        &mut self,
        family: &Family,
        r: f64,
        guess: &Guess,
        search: &Search,
    ) -> Option<Result<Orbit, OrbitError>> {
        if self.count > OFTEN && !self.count.is_multiple_of(SELDOM) {
            self.count += 1;
            return None;
        }
        let orbit = from(family, r, guess, search, &anchored);
        let error = match orbit.and_then(|orbit| self.taken(family, r, guess, (orbit, search))) {
            Ok(orbit) if self.doubts(&orbit) => {
                self.doubtful = Some(orbit);
                self.doubted += 1;
                return None;
            }
            Ok(orbit) => return Some(Ok(orbit)),
            Err(error) => error,
        };
        self.count += 1;
        self.magnitude = Some(guess.magnitude.clone());
        // What runs on always has neighbours: they are shifted.
        let runs = guess.shift.is_some();
        if self.count == 1
            && !runs
            && let Some(error) = of_a_family(family, r, guess, search)
        {
            return Some(Err(error));
        }
        let newton = matches!(error, OrbitError::Newton(_));
        // An orbit on which the motion does not stay says more than one that was not reached.
        let passed = matches!(self.last, Some(OrbitError::Passed { .. }));
        if !(passed && newton) {
            self.last = Some(error);
        }
        if !(newton && self.count.is_power_of_two()) {
            return None;
        }
        let taken = |orbit| self.taken(family, r, guess, (orbit, search)).ok();
        let calm = calmly(family, r, guess, search).and_then(Result::ok);
        let drawn = |orbit: &_| stays(family, r, guess, (orbit, &search.start)).unwrap_or(false);
        let other = || swung_about(family, r, guess, search).filter(drawn);
        let damped = || damped(family, r, guess, search).and_then(taken);
        let found = calm.and_then(taken).or_else(damped).or_else(other).map(Ok);
        let one_of_many =
            || (runs && self.count == 1).then(|| of_a_family(family, r, guess, search));
        found.or_else(|| one_of_many().flatten().map(Err))
    }
}

/// That orbits beside this return are as good.
fn of_a_family(family: &Family, r: f64, guess: &Guess, search: &Search) -> Option<OrbitError> {
    let one = neutral(family, r, guess)?;
    let flow = family.at(r).ok()?;
    let (motion, errors) = (
        (&*one.place.state, one.period),
        guess.shares(search.accuracy),
    );
    Some(OrbitError::one_of_many(&*flow, motion, errors))
}
