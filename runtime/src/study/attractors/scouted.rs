//! What the first starts have found, and how later ones are recognised by it.

use super::basin::Basin;
use super::cloud::Cloud;
use super::ground::Ground;
use super::memo::Memo;
use super::record::{Attractor, Class, Fate};
use super::statistics::irregular;
use super::track::Track;
use super::trap::{Rest, Trap};
use crate::bifurcation::Stability;
use crate::shooting::{Shifts, unshifted};

/// Starts that are looked at closely before any other.
const SCOUTS: usize = 32;

pub(super) struct Scouted<'a> {
    pub(super) ground: Ground<'a>,
    /// The motions, in the order in which they were found.
    pub(super) attractors: Vec<Attractor>,
    pub(super) traps: Vec<Trap>,
    pub(super) rests: Vec<Rest>,
    pub(super) clouds: Vec<Cloud>,
    pub(super) memo: Memo,
    /// Shifts of states that change nothing: motions are one but for these.
    pub(super) shifts: Shifts,
    /// Others, by which motions turned out to differ.
    pub(super) copies: Vec<Vec<f64>>,
}

impl<'a> Scouted<'a> {
    /// Looks at the first starts, each with what those before have found.
    pub(super) fn new(ground: Ground<'a>, starts: usize) -> Self {
        let mut scouted = Self {
            shifts: Shifts::of(ground.flow.as_ref(), &ground.usual),
            ground,
            attractors: Vec::new(),
            traps: Vec::new(),
            rests: Vec::new(),
            clouds: Vec::new(),
            memo: Memo::default(),
            copies: Vec::new(),
        };
        scouted.equilibria();
        for k in 0..starts.min(SCOUTS) {
            let start = scouted.ground.start(k);
            let mut track = Track::default();
            let of = match scouted.future(&start, &mut track) {
                Some(of) => of,
                None => {
                    let of = scouted.take(scouted.closely(&start));
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
                self.take(found.turned(&self.shifts));
            }
        }
    }

    /// What a start settles on, angles told within one turn.
    fn closely(&self, start: &[f64]) -> Attractor {
        self.ground.closely(start).turned(&self.shifts)
    }

    /// The place of a motion in the list, where it is put if it is new.
    fn take(&mut self, new: Attractor) -> usize {
        if let Some(known) = self.place(&new) {
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
            self.copied_by(shift);
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
            && let Ok(Some(cloud)) = Cloud::of(&self.ground, of, start, &self.shifts)
        {
            self.clouds.push(cloud);
        }
    }

    fn copied_by(&mut self, shift: Vec<f64>) {
        let square = |shift: &Vec<f64>| shift.iter().map(|d| d * d).sum::<f64>();
        // The shortest of those along one line is the one that the others are whole numbers of.
        match self.copies.first_mut() {
            Some(known) if square(&shift) < square(known) => *known = shift,
            None => self.copies.push(shift),
            Some(_) => {}
        }
    }

    /// Makes a motion one that later starts are recognised by.
    fn watch(&mut self, of: usize, new: &Attractor) {
        let (ground, usual) = (&self.ground, &self.ground.usual);
        match new.class {
            Class::Orbit | Class::Running if new.period.is_some() => {
                self.traps.extend(Trap::around(
                    ground.flow.as_ref(),
                    of,
                    new,
                    usual,
                    &self.shifts,
                ));
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
            self.copied_by(shift.clone());
        }
    }

    /// What becomes of a start.
    pub(super) fn fate(&self, start: &[f64]) -> Fate {
        if let Some(of) = self.future(start, &mut Track::default()) {
            return Fate::Known(of);
        }
        let known = |new: Attractor| match self.place(&new) {
            Some(of) => Fate::Known(of),
            None => Fate::Other(Box::new(new)),
        };
        let wild = |one: &Attractor| matches!(one.class, Class::Torus | Class::Chaos);
        if self.attractors.iter().any(wild)
            && let Ok(Some(new)) = irregular(&self.ground, start)
        {
            return known(new.turned(&self.shifts));
        }
        known(self.closely(start))
    }

    /// The place of a motion in the list, if it is there.
    fn place(&self, new: &Attractor) -> Option<usize> {
        let mut all = self.attractors.iter();
        all.position(|known| known.is(new, &self.ground.usual, &self.shifts))
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
        let is = |b: &Attractor| a.is(b, &self.ground.usual, &self.shifts);
        is(b) || (resting && self.copies.iter().any(|shift| is(&moved(shift))))
    }
}
