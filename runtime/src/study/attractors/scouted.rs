//! What the first starts have found, and how later ones are recognised by it.

use std::collections::VecDeque;

use super::basin::Basin;
use super::cloud::{Cloud, Kept};
use super::ground::Ground;
use super::memo::Memo;
use super::pursuit::{Pursuit, minima};
use super::record::{Attractor, Class, Fate};
use super::returns::{SETTLED, returns};
use super::statistics::irregular;
use super::track::Track;
use super::trap::{Hold, Rest, Trap};
use crate::bifurcation::Stability;
use crate::flow::FlowError;
use crate::motion::Passage;
use crate::shooting::{Shifts, unshifted};

/// Starts that are looked at closely before any other.
const SCOUTS: usize = 32;
/// Passages for which a start is followed to a motion that is known.
const PASSAGES: usize = 1500;
/// Steps of the integrator for that.
const STEPS: u64 = 2_000_000;
/// Crossings that are looked back at.
const BACK: usize = 20;

pub(super) struct Scouted<'a> {
    ground: Ground<'a>,
    /// The motions, in the order in which they were found.
    pub(super) attractors: Vec<Attractor>,
    traps: Vec<Trap>,
    rests: Vec<Rest>,
    clouds: Vec<Cloud>,
    memo: Memo,
    /// Shifts of states that change nothing.
    shifts: Vec<Vec<f64>>,
}

impl<'a> Scouted<'a> {
    /// Looks at the first starts, each with what those before have found.
    pub(super) fn new(ground: Ground<'a>, starts: usize) -> Self {
        let memo = Memo::new(Shifts::of(ground.flow.as_ref(), &ground.usual));
        let mut scouted = Self {
            ground,
            attractors: Vec::new(),
            traps: Vec::new(),
            rests: Vec::new(),
            clouds: Vec::new(),
            memo,
            shifts: Vec::new(),
        };
        scouted.equilibria();
        for k in 0..starts.min(SCOUTS) {
            let start = scouted.ground.start(k);
            let mut track = Track::default();
            let of = match scouted.future(&start, &mut track) {
                Some(of) => of,
                None => {
                    let of = scouted.take(scouted.ground.closely(&start));
                    scouted.visit(of, &start);
                    of
                }
            };
            let class = scouted.attractors[of].class;
            scouted
                .memo
                .learn(track, (of, class), &scouted.ground.usual);
        }
        scouted
    }

    /// Stable equilibria, wherever starts lie: a start need not come to rest to be known as one that will.
    fn equilibria(&mut self) {
        let ground = &self.ground;
        let found = ground.system.equilibria(&ground.case).unwrap_or_default();
        let stable = found
            .iter()
            .filter(|one| one.stability == Stability::Stable && one.set.is_none());
        let places: Vec<_> = stable
            .filter_map(|one| ground.flow.place(&one.state).ok())
            .collect();
        for place in places {
            if let Ok(found) = self.ground.rest(&place)
                && found.class == Class::Equilibrium
            {
                self.take(found);
            }
        }
    }

    /// The place of a motion in the list, where it is put if it is new.
    fn take(&mut self, new: Attractor) -> usize {
        let usual = &self.ground.usual;
        if let Some(known) = self
            .attractors
            .iter()
            .position(|known| known.is(&new, usual))
        {
            return known;
        }
        let copied = |known: &Attractor| {
            let alike = known.class == new.class && known.word == new.word;
            let resting = new.class == Class::Equilibrium;
            (alike && resting).then(|| self.ground.is_copy(&known.state, &new.state))?
        };
        let copy = self
            .attractors
            .iter()
            .enumerate()
            .find_map(|(of, known)| Some((of, copied(known)?)));
        if let Some((of, shift)) = copy {
            self.shift(shift);
            return of;
        }
        let of = self.attractors.len();
        self.watch(of, &new);
        self.attractors.push(new);
        of
    }

    /// Notes where the motion from a start goes, if it is a chaotic one that is not known so yet.
    fn visit(&mut self, of: usize, start: &[f64]) {
        let chaos = self.attractors[of].class == Class::Chaos;
        if chaos
            && self.clouds.iter().all(|cloud| cloud.of != of)
            && let Ok(Some(cloud)) = Cloud::of(&self.ground, of, start)
        {
            self.clouds.push(cloud);
        }
    }

    fn shift(&mut self, shift: Vec<f64>) {
        let square = |shift: &Vec<f64>| shift.iter().map(|d| d * d).sum::<f64>();
        // The shortest of those along one line is the one that the others are whole numbers of.
        match self.shifts.first_mut() {
            Some(known) if square(&shift) < square(known) => *known = shift,
            None => self.shifts.push(shift),
            Some(_) => {}
        }
    }

    /// Makes a motion one that later starts are recognised by.
    fn watch(&mut self, of: usize, new: &Attractor) {
        let (ground, usual) = (&self.ground, &self.ground.usual);
        match new.class {
            Class::Orbit | Class::Running if new.period.is_some() => {
                self.traps
                    .extend(Trap::around(ground.flow.as_ref(), of, new, usual));
            }
            Class::Equilibrium => {
                let touches = ground.touches().then_some(new.modes.as_slice());
                let field = ground.system.enclosure(&ground.case, touches);
                let place = crate::motion::Place {
                    state: new.state.clone(),
                    modes: new.modes.clone(),
                };
                let basin = ground.flow.velocity(&place).ok().and_then(|velocity| {
                    Basin::around(field.as_ref(), (&new.state, &velocity.jacobian), usual)
                });
                self.rests.push(Rest {
                    of,
                    state: new.state.clone(),
                    basin,
                });
            }
            _ => {}
        }
        if let (Some(shift), Some(_)) = (&new.shift, new.period) {
            self.shift(shift.clone());
        }
    }

    /// What becomes of a start.
    pub(super) fn fate(&self, start: &[f64]) -> Fate {
        if let Some(of) = self.future(start, &mut Track::default()) {
            return Fate::Known(of);
        }
        let usual = &self.ground.usual;
        let known = |new: &Attractor| {
            self.attractors
                .iter()
                .position(|known| known.is(new, usual))
        };
        let wild = |one: &Attractor| matches!(one.class, Class::Torus | Class::Chaos);
        if self.attractors.iter().any(wild)
            && let Ok(Some(new)) = irregular(&self.ground, start)
        {
            return known(&new).map_or_else(|| Fate::Other(Box::new(new)), Fate::Known);
        }
        let new = self.ground.closely(start);
        known(&new).map_or_else(|| Fate::Other(Box::new(new)), Fate::Known)
    }

    pub(super) fn ground(&self) -> &Ground<'a> {
        &self.ground
    }

    pub(super) fn usual(&self) -> &[f64] {
        &self.ground.usual
    }

    /// Start number `k`.
    pub(super) fn start(&self, k: usize) -> Vec<f64> {
        self.ground.start(k)
    }

    /// The start at these shares of the sides of the region.
    pub(super) fn at(&self, shares: &[f64]) -> Vec<f64> {
        self.ground.at(shares)
    }

    /// Whether two motions are one, but for shifts that change nothing.
    pub(super) fn same(&self, a: &Attractor, b: &Attractor) -> bool {
        let moved = |shift: &Vec<f64>| {
            let mut moved = b.clone();
            moved.state = unshifted(&b.state, &a.state, shift);
            moved
        };
        let resting = a.class == Class::Equilibrium;
        a.is(b, &self.ground.usual)
            || (resting
                && self
                    .shifts
                    .iter()
                    .any(|shift| a.is(&moved(shift), &self.ground.usual)))
    }

    /// The motion on which a start settles, as soon as that is known, and the way until then.
    fn future(&self, start: &[f64], track: &mut Track) -> Option<usize> {
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
            let new = track.note(&passage, modes, &self.memo.shifts);
            let mut crossed = false;
            let mut roams = None;
            for minimum in minima(&passage, section) {
                crossed = true;
                latest.push_front(minimum.state.clone());
                latest.truncate(BACK);
                roams = roams.or(kept_to.watch(&self.clouds, latest.iter(), &ground.usual));
            }
            let future = self
                .memo
                .future(&track.releases[new], &ground.usual)
                .or_else(|| self.held(&passage, &mut holds));
            let future = future.or_else(|| {
                let mut rests = self.rests.iter();
                Some(
                    rests
                        .find(|rest| rest.holds(&pursuit.place, &self.shifts))?
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
            for minimum in minima(passage, trap.section()) {
                match trap.watch(*hold, &minimum.state) {
                    Ok(next) => *hold = next,
                    Err(of) => return Some(of),
                }
            }
        }
        None
    }
}
