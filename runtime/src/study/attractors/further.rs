//! Unstable orbits that lie on no edge between two starts: Newton's method, from between and beside what is known.

use super::ground::Ground;
use super::record::{Attractor, Survey};
use crate::bifurcation::Stability;
use crate::motion::Place;
use crate::shooting::{Guess, Orbit, closest, further};

/// Shares of the way from a point of an orbit to one of another motion at which it is begun.
const SHARES: [f64; 3] = [0.0, 0.5, 1.1];
/// Laps of the known orbit for which a further one may take.
const LAPS: [f64; 2] = [1.0, 2.0];
/// Most points of a motion that are taken.
const POINTS: usize = 4;

impl Ground<'_> {
    /// Unstable orbits besides the motions of a survey: those to which Newton's method leads from between and beside these,
    /// once they are no solutions any more. There may be others.
    pub(super) fn further(&self, survey: &Survey) -> Vec<Attractor> {
        let found = survey.found.iter().map(|one| &one.attractor);
        let saddles = survey.saddles().map(|(_, saddle)| saddle);
        let motions: Vec<&Attractor> = found.chain(saddles).collect();
        let orbits: Vec<Orbit> = motions.iter().filter_map(|one| self.known(one)).collect();
        let seeds = orbits.iter().flat_map(|orbit| self.seeds(orbit, &motions));
        let seeds: Vec<Guess> = seeds.collect();
        let search = self.search(Vec::new(), None);
        let found = further(&self.family, 0.0, &seeds, &search, &orbits);
        let unstable = found
            .iter()
            .filter(|orbit| orbit.floquet.stability == Stability::Unstable);
        unstable.map(|orbit| self.orbit(orbit)).collect()
    }

    /// The orbit of a motion that is one.
    fn known(&self, motion: &Attractor) -> Option<Orbit> {
        let search = self.search(motion.state.clone(), Some(motion.period?));
        closest(&self.family, 0.0, &search).ok()
    }

    /// Where further orbits may begin: on the way from an orbit to each of the motions.
    fn seeds(&self, orbit: &Orbit, motions: &[&Attractor]) -> Vec<Guess> {
        let mut seeds = Vec::new();
        for from in orbit.section.iter().take(POINTS) {
            for to in motions.iter().flat_map(|motion| points(motion)) {
                let between = |share: f64| -> Vec<f64> {
                    let pairs = from.iter().zip(to);
                    pairs.map(|(a, b)| a + share * (b - a)).collect()
                };
                let places = SHARES.iter().map(|share| between(*share));
                let places = places.filter_map(|state| self.flow.place(&state).ok());
                seeds.extend(places.flat_map(|place| laps(orbit, &place)));
            }
        }
        seeds
    }
}

/// The points of a motion from which others are looked for: of a state of rest, that state.
fn points(motion: &Attractor) -> impl Iterator<Item = &Vec<f64>> {
    let rest = motion.points.is_empty().then_some(&motion.state);
    motion.points.iter().take(POINTS).chain(rest)
}

fn laps(orbit: &Orbit, place: &Place) -> [Guess; 2] {
    LAPS.map(|laps| Guess {
        place: place.clone(),
        period: laps * orbit.period,
        magnitude: orbit.magnitude(),
        pins: Vec::new(),
        shift: orbit
            .shift
            .as_ref()
            .map(|shift| shift.iter().map(|gain| laps * gain).collect()),
        division: None,
    })
}
