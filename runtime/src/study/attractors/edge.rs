//! What has no basin: saddles on the edge between two.
//!
//! Between two starts with different futures there is one that goes to neither: it stays on the edge, and settles on a
//! saddle there. It is bisected as far as doubles go, and what the motion comes near to is polished by Newton.

use super::ground::Ground;
use super::pursuit::Pursuit;
use super::record::{Attractor, Class, Edge, Fate, Survey};
use super::scouted::Scouted;
use crate::bifurcation::Stability;
use crate::equilibrium::settle;
use crate::motion::{Place, apart};
use crate::shooting::closest;

/// Starts among which neighbours with different futures are looked for.
const STARTS: usize = 2000;
/// Halvings of the distance of two starts.
const HALVINGS: usize = 60;
/// Passages in which the motion on the edge is slowest near a state of rest.
const PASSAGES: usize = 60;
/// A state of rest is so near to where the motion is slowest, in usual sizes.
const NEAR: f64 = 1e-2;

/// The saddle on the edge of each two basins that have starts, where one was found.
pub(super) fn edges(scouted: &Scouted<'_>, survey: &Survey) -> Vec<Edge> {
    let count = survey.found.len();
    let pairs = (0..count).flat_map(|a| (a + 1..count).map(move |b| [a, b]));
    let edge = |between: [usize; 2]| {
        let [here, there] = nearest(survey, between, scouted.usual())?;
        let on = on_the_edge(scouted, here, there);
        let saddle = scouted.ground().saddle(&on)?;
        Some(Edge { between, saddle })
    };
    pairs.filter_map(edge).collect()
}

/// The nearest two starts of two motions.
fn nearest<'a>(survey: &'a Survey, of: [usize; 2], usual: &[f64]) -> Option<[&'a [f64]; 2]> {
    let starts = || survey.starts.iter().take(STARTS);
    let [these, those] = of.map(|of| starts().filter(move |one| one.1 == of));
    let pairs = these.flat_map(|a| those.clone().map(move |b| [&a.0, &b.0]));
    let distance = |pair: &[&Vec<f64>; 2]| apart(pair[0], pair[1], usual);
    let pair = pairs.min_by(|a, b| distance(a).total_cmp(&distance(b)))?;
    Some(pair.map(Vec::as_slice))
}

/// A start between two with different futures that is as far from both futures as doubles go.
fn on_the_edge(scouted: &Scouted<'_>, here: &[f64], there: &[f64]) -> Vec<f64> {
    let future = scouted.fate(here);
    let is_here = |fate: &Fate| match (fate, &future) {
        (Fate::Other(a), Fate::Other(b)) => scouted.same(a, b),
        (a, b) => a == b,
    };
    let (mut here, mut there) = (here.to_vec(), there.to_vec());
    for _ in 0..HALVINGS {
        let middle: Vec<f64> = here
            .iter()
            .zip(&there)
            .map(|(a, b)| 0.5 * (a + b))
            .collect();
        if middle == here || middle == there {
            break;
        }
        if is_here(&scouted.fate(&middle)) {
            here = middle;
        } else {
            there = middle;
        }
    }
    here
}

impl Ground<'_> {
    /// The unstable orbit or state of rest that the motion from a start on an edge comes near to.
    fn saddle(&self, start: &[f64]) -> Option<Attractor> {
        let search = self.search(start.to_vec(), None);
        let orbit = closest(&self.family, 0.0, &search).ok();
        let orbit = orbit.filter(|orbit| orbit.floquet.stability == Stability::Unstable);
        orbit
            .map(|orbit| self.orbit(&orbit))
            .or_else(|| self.resting_saddle(start))
    }

    fn resting_saddle(&self, start: &[f64]) -> Option<Attractor> {
        let mut pursuit = Pursuit::new(self.flow.as_ref(), start).ok()?;
        let mut slowest: Option<(f64, Place)> = None;
        for _ in 0..PASSAGES {
            let passage = pursuit.on().ok()?;
            for place in [&passage.calm.place, &pursuit.place] {
                let velocity = self.flow.velocity(place).ok()?.f;
                let rates = velocity
                    .iter()
                    .zip(&self.usual)
                    .map(|(rate, usual)| (rate / usual).abs());
                let speed = rates.fold(0.0, f64::max);
                if slowest.as_ref().is_none_or(|(least, _)| speed < *least) {
                    slowest = Some((speed, place.clone()));
                }
            }
        }
        let (_, near) = slowest?;
        let found = settle(&self.family, 0.0, &near)?;
        let apart = apart(&found.place.state, &near.state, &self.usual);
        let saddle = found.spectrum.stability == Stability::Unstable && apart <= NEAR;
        let rest = self.rest(&found.place).ok()?;
        (saddle && rest.class == Class::Equilibrium).then_some(rest)
    }
}
