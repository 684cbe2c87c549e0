//! What is asked of an orbit, and how far two answers are apart.

use crate::flow::{FlowError, Want};
use crate::integrate::Tolerance;
use crate::model::ModelInfo;
use crate::motion::{Flow, Node, Passage, Place};
use crate::shooting::Orbit;
use crate::study::question::Case;
use crate::study::system::System;

/// Panels of a period in which displacements of points are looked at.
const PANELS: f64 = 100.0;
/// A point that moves less than this share of another one of its structure is measured against that share.
const STILL: f64 = 1e-3;
/// Halvings after which an extremum between two nodes is where it is.
const HALVINGS: usize = 40;

/// Something that is measured along an orbit.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Of {
    /// A state.
    State(usize),
    /// The displacement of a point of a structure, by their numbers.
    Point(usize, usize),
}

/// How far it reaches, and when.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Reach {
    pub(super) of: Of,
    /// Least and largest value.
    pub(super) ends: [f64; 2],
    pub(super) times: [f64; 2],
}

/// The answer of an orbit.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Answer {
    /// The period, where no drive sets it.
    pub(super) period: Option<f64>,
    pub(super) reaches: Vec<Reach>,
    /// Against what errors of each of them are measured.
    pub(super) sizes: Vec<f64>,
    /// Accepted steps once around.
    pub(super) steps: u64,
}

impl Of {
    /// All that is measured: states that are no modes and no phase, and the points of structures.
    pub(super) fn all(info: &ModelInfo) -> Vec<Self> {
        let modes = info.structures.iter().flat_map(|one| one.modes);
        let modal: Vec<usize> = modes
            .flat_map(|mode| mode.amplitude.into_iter().chain(mode.rate))
            .collect();
        let states =
            (0..info.states.len()).filter(|j| !modal.contains(j) && info.drive != Some(*j));
        let structures = info.structures.iter().enumerate();
        let points =
            structures.flat_map(|(s, one)| (0..one.points.len()).map(move |p| Self::Point(s, p)));
        states.map(Self::State).chain(points).collect()
    }

    /// Its value in a state.
    pub(super) fn value(self, info: &ModelInfo, state: &[f64]) -> f64 {
        match self {
            Self::State(j) => state[j],
            Self::Point(structure, point) => info.structures[structure].at(point, state, false),
        }
    }

    /// What it cannot exceed where no state exceeds these.
    pub(super) fn bound(self, info: &ModelInfo, largest: &[f64]) -> f64 {
        match self {
            Self::State(j) => largest[j],
            Self::Point(structure, point) => {
                let modes = info.structures[structure].modes.iter();
                let terms = modes
                    .filter_map(|mode| Some(mode.shape[point].abs() * largest[mode.amplitude?]));
                terms.sum()
            }
        }
    }
}

impl System {
    /// The answer of the orbit of a case.
    pub(super) fn answer(&self, case: &Case, orbit: &Orbit) -> Result<Answer, FlowError> {
        let info = self.info();
        let family = self.family(case).with_magnitude(&orbit.magnitude());
        let flow = family
            .with_tolerance(Tolerance::for_accuracy(case.accuracy))
            .at(0.0)?;
        let (reaches, steps) = self.reaches(flow.as_ref(), &orbit.place, orbit.period)?;
        let sizes = reaches
            .iter()
            .map(|one| size(info, one, &reaches))
            .collect();
        Ok(Answer {
            period: info.drive.is_none().then_some(orbit.period),
            reaches,
            sizes,
            steps,
        })
    }

    /// How far everything reaches from a place on for a period, and the accepted steps of that.
    pub(super) fn reaches(
        &self,
        flow: &dyn Flow,
        from: &Place,
        period: f64,
    ) -> Result<(Vec<Reach>, u64), FlowError> {
        let points = !self.info().structures.is_empty();
        let panel = if points { period / PANELS } else { 0.0 };
        let want = Want {
            panel,
            ..Want::EXTREMA
        };
        let passage = flow.advance(from, period, want)?;
        let nodes = nodes(from, &passage);
        let reach = |of| match of {
            Of::State(j) => state(j, from, &passage),
            Of::Point(structure, point) => self.point([structure, point], &nodes),
        };
        let reaches = Of::all(self.info()).into_iter().map(reach);
        Ok((reaches.collect(), passage.work.steps))
    }

    /// The displacement of a point: between nodes a cubic through its values and rates.
    fn point(&self, [structure, point]: [usize; 2], nodes: &[Node]) -> Reach {
        let structure_info = &self.info().structures[structure];
        let at = |node: &Node, rate| structure_info.at(point, &node.state, rate);
        let mut reach = Reach::nothing(Of::Point(structure, point));
        for node in nodes {
            reach.offer(node.time, at(node, false));
        }
        for pair in nodes.windows(2) {
            let [a, b] = [&pair[0], &pair[1]];
            let rates = [at(a, true), at(b, true)];
            if rates[0] * rates[1] < 0.0 {
                let (share, value) = turn([at(a, false), at(b, false)], rates, b.time - a.time);
                reach.offer(a.time + share * (b.time - a.time), value);
            }
        }
        reach
    }
}

/// The start, the nodes of the passage and its end.
fn nodes(from: &Place, passage: &Passage) -> Vec<Node> {
    let end = |time, state: &[f64]| Node {
        time,
        weight: 0.0,
        state: state.to_vec(),
    };
    let mut nodes = vec![end(0.0, &from.state)];
    nodes.extend(passage.nodes.iter().cloned());
    nodes.push(end(passage.time, &passage.end.state));
    nodes
}

fn state(j: usize, from: &Place, passage: &Passage) -> Reach {
    let mut reach = Reach::nothing(Of::State(j));
    reach.offer(0.0, from.state[j]);
    for extremum in passage.extrema.iter().filter(|one| one.index == j) {
        reach.offer(extremum.time, extremum.state[j]);
    }
    reach
}

impl Reach {
    fn nothing(of: Of) -> Self {
        Self {
            of,
            ends: [f64::INFINITY, f64::NEG_INFINITY],
            times: [0.0; 2],
        }
    }

    fn offer(&mut self, time: f64, value: f64) {
        if value < self.ends[0] {
            (self.ends[0], self.times[0]) = (value, time);
        }
        if value > self.ends[1] {
            (self.ends[1], self.times[1]) = (value, time);
        }
    }

    /// Its largest magnitude.
    pub(super) fn largest(&self) -> f64 {
        self.ends[0].abs().max(self.ends[1].abs())
    }
}

/// Where the cubic through these values and rates at both ends of a time turns, as a share of that, and its value there.
fn turn([a, b]: [f64; 2], [from, to]: [f64; 2], time: f64) -> (f64, f64) {
    let slope = (b - a) / time;
    let rate = |s: f64| {
        from * (1.0 - s) * (1.0 - 3.0 * s) + to * s * (3.0 * s - 2.0) + 6.0 * s * (1.0 - s) * slope
    };
    let [mut low, mut high] = [0.0, 1.0];
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if rate(middle) * from > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    let s = 0.5 * (low + high);
    let value = (1.0 - s).powi(2) * (a * (1.0 + 2.0 * s) + from * time * s)
        + s * s * (b * (3.0 - 2.0 * s) - to * time * (1.0 - s));
    (s, value)
}

/// Against what errors are measured: its own size, or of a point that hardly moves a share of the largest beside it; 1 for
/// what rests, as everywhere.
fn size(info: &ModelInfo, one: &Reach, all: &[Reach]) -> f64 {
    let beside = all.iter().filter(|other| match (one.of, other.of) {
        (Of::Point(s, p), Of::Point(other, q)) => {
            let points = info.structures[s].points;
            s == other && points[p].turns == points[q].turns
        }
        _ => false,
    });
    let beside = beside.map(Reach::largest).fold(0.0, f64::max);
    let size = one.largest().max(STILL * beside);
    if size > 0.0 { size } else { 1.0 }
}

impl Answer {
    /// The largest relative error of another answer.
    pub(super) fn error(&self, other: &Self) -> f64 {
        let period = self.period.zip(other.period);
        let period = period.map_or(0.0, |(own, other)| (other / own - 1.0).abs());
        let pairs = self.reaches.iter().zip(&other.reaches).zip(&self.sizes);
        let errors = pairs.flat_map(|((own, other), size)| {
            [0, 1].map(|end| (other.ends[end] - own.ends[end]).abs() / size)
        });
        errors.fold(period, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::turn;

    #[test]
    fn a_cubic_turns_where_it_does() {
        // x (1 - x) (2 - x) between 0 and 1.
        let (share, value) = turn([0.0, 0.0], [2.0, -1.0], 1.0);
        let exact = 1.0 - 1.0 / 3.0_f64.sqrt();
        assert!((share - exact).abs() < 1e-11);
        assert!((value - exact * (1.0 - exact) * (2.0 - exact)).abs() < 1e-15);
    }
}
