//! One motion from a place to another, and how its end depends on its beginning.

use nalgebra::{DMatrix, DVector};
use serde::{Deserialize, Serialize};

use super::{Flow, Modes, sticking};
use crate::field::Work;
use crate::flow::{self, FlowError, passage};

/// Share of a motion up to which two times are the same instant.
const INSTANT: f64 = 1e-9;

/// A field, with its derivatives.
pub type Velocity = passage::Velocity<DVector<f64>, DMatrix<f64>>;
/// How the end of a passage depends on its beginning.
pub type Derivatives = passage::Derivatives<DVector<f64>, DMatrix<f64>>;
/// A factor of Φ.
pub type Factor = passage::Factor<DMatrix<f64>>;
/// A local extremum of one state.
pub type Extremum = passage::Extremum<Vec<f64>>;
/// A state on a motion.
pub type Sample = passage::Sample<Vec<f64>>;
/// A node of a quadrature over a motion.
pub type Node = passage::Node<Vec<f64>>;
/// Something that happened at a contact.
pub type Event = passage::Event<Vec<f64>>;

/// A point of phase space from which a motion continues in one way only.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Place {
    /// The state.
    pub state: Vec<f64>,
    /// The modes of the contacts.
    pub modes: Modes,
}

/// One motion from a place to another.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Passage {
    /// Where it ended.
    pub end: Place,
    /// How long it took: what was asked, unless it has the samples that suffice.
    pub time: f64,
    /// How the end depends on the beginning, if that was wanted.
    pub derivatives: Option<Derivatives>,
    /// Extrema of the states in the order of time, if wanted.
    pub extrema: Vec<Extremum>,
    /// Stretches in constant mode, in the order of time; one for a smooth system.
    pub segments: Vec<Segment>,
    /// What happened at the contacts, in the order of time; nothing for a smooth system.
    pub events: Vec<Event>,
    /// Samples of the motion, if wanted.
    pub path: Vec<Sample>,
    /// Nodes of a quadrature over the motion, if wanted.
    pub nodes: Vec<Node>,
    /// Where the motion is calmest: a good place to begin an orbit.
    pub calm: Calm,
    /// How far rounding of what vanished at its events may have put the state off, in its usual magnitudes: the most at one of
    /// them; 0 without derivatives.
    pub rounding: f64,
    /// What it cost.
    pub work: Work,
}

/// The place between two steps of which the shorter one is longest.
///
/// Next to a short step something is about to happen, or has just happened: a start there would
/// soon fall before it or behind it as the design variable changes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Calm {
    /// Where.
    pub place: Place,
    /// Least value of each state at the ends of the steps.
    pub low: Vec<f64>,
    /// Largest value of each state there.
    pub high: Vec<f64>,
}

/// A stretch of a motion in constant mode.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Segment {
    /// The modes of the contacts during it.
    pub modes: Modes,
    /// Its duration.
    pub duration: f64,
    /// The contact whose impact began it, if one did.
    pub impact: Option<usize>,
}

impl Place {
    /// A state in modes that are known, or else in those that the flow finds.
    ///
    /// # Errors
    /// The flow has no place there.
    pub(crate) fn known(
        flow: &dyn Flow,
        state: &[f64],
        modes: Option<&Modes>,
    ) -> Result<Self, FlowError> {
        match modes {
            Some(modes) => Ok(Self {
                state: state.to_vec(),
                modes: modes.clone(),
            }),
            None => flow.place(state),
        }
    }

    pub(super) fn of<const N: usize, M>(
        place: &flow::Place<N, M>,
        modes: impl Fn(&M) -> Modes,
    ) -> Self {
        Self {
            state: place.state.to_vec(),
            modes: modes(&place.mode),
        }
    }
}

impl Passage {
    /// The minima of a state, or the beginnings of the phase of a drive; a rest with which the passage begins or ends is one, too.
    pub(crate) fn lows(&self, state: usize) -> impl Iterator<Item = &Extremum> {
        let all = self.extrema.iter();
        all.filter(move |one| one.index == state && !one.maximum)
    }

    /// The same as parts of a longer motion: a rest with which the passage begins has been told before, or the motion goes on
    /// after it as it came.
    pub(crate) fn minima(&self, state: usize) -> impl Iterator<Item = &Extremum> {
        self.lows(state).filter(|one| one.time > 0.0)
    }

    /// The modes at a time inside a stretch of constant mode: of what rests, a state with rounding errors does not tell them.
    /// `None` where they change.
    pub(crate) fn modes_within(&self, time: f64) -> Option<&Modes> {
        let (mut begins, near) = (0.0, INSTANT * self.time);
        self.segments.iter().find_map(|segment| {
            let within = begins + near < time && time < begins + segment.duration - near;
            begins += segment.duration;
            within.then_some(&segment.modes)
        })
    }

    /// These states at times in their order, each in the modes of the stretch in which it lies: of what rests, a state with
    /// rounding errors does not tell them.
    pub(crate) fn places<'a>(
        &'a self,
        states: impl Iterator<Item = (f64, &'a Vec<f64>)> + 'a,
    ) -> impl Iterator<Item = Place> + 'a {
        let mut stretches = self.segments.iter();
        let mut current = stretches.next();
        let mut until = current.map_or(0.0, |stretch| stretch.duration);
        states.filter_map(move |(time, state)| {
            while time > until
                && let Some(next) = stretches.next()
            {
                (current, until) = (Some(next), until + next.duration);
            }
            current.map(|stretch| Place {
                state: state.clone(),
                modes: stretch.modes.clone(),
            })
        })
    }

    pub(super) fn of<const N: usize, M>(
        passage: flow::Passage<N, M>,
        modes: impl Fn(&M) -> Modes,
    ) -> Self {
        let segment = |segment: &flow::Segment<M>| Segment {
            modes: modes(&segment.mode),
            duration: segment.duration,
            impact: segment.impact,
        };
        Self {
            end: Place::of(&passage.end, &modes),
            time: passage.time,
            derivatives: passage.derivatives.map(Derivatives::from),
            extrema: passage.extrema.iter().map(extremum).collect(),
            segments: passage.segments.iter().map(segment).collect(),
            events: passage.events.iter().map(event).collect(),
            path: passage.path.iter().map(sample).collect(),
            nodes: passage.nodes.iter().map(node).collect(),
            calm: Calm {
                place: Place::of(&passage.calm.place, &modes),
                low: passage.calm.low.to_vec(),
                high: passage.calm.high.to_vec(),
            },
            rounding: passage.rounding,
            work: passage.work,
        }
    }
}

impl<const N: usize> From<flow::Velocity<N>> for Velocity {
    fn from(velocity: flow::Velocity<N>) -> Self {
        Self {
            f: vector(&velocity.f),
            jacobian: matrix(&velocity.jacobian),
            design: vector(&velocity.design),
            lost: velocity.lost,
        }
    }
}

impl<const N: usize> From<flow::Derivatives<N>> for Derivatives {
    fn from(derivatives: flow::Derivatives<N>) -> Self {
        let factor = |factor: &flow::Factor<N>| Factor {
            state: matrix(&factor.state),
            growth: factor.growth.as_ref().map(matrix),
        };
        Self {
            state: matrix(&derivatives.state),
            design: vector(&derivatives.design),
            time: vector(&derivatives.time),
            determinant: derivatives.determinant,
            factors: derivatives.factors.iter().map(factor).collect(),
            lost: derivatives.lost,
        }
    }
}

fn extremum<const N: usize>(extremum: &flow::Extremum<N>) -> Extremum {
    Extremum {
        index: extremum.index,
        maximum: extremum.maximum,
        time: extremum.time,
        state: extremum.state.to_vec(),
    }
}

fn event<const N: usize>(event: &flow::Event<N>) -> Event {
    Event {
        kind: event.kind,
        contact: event.contact,
        mode: event.mode,
        time: event.time,
        state: event.state.to_vec(),
        rate: event.rate,
    }
}

fn node<const N: usize>(node: &flow::Node<N>) -> Node {
    Node {
        time: node.time,
        weight: node.weight,
        state: node.state.to_vec(),
    }
}

fn sample<const N: usize>(sample: &flow::Sample<N>) -> Sample {
    Sample {
        time: sample.time,
        state: sample.state.to_vec(),
    }
}

pub(super) fn vector<const N: usize>(components: &[f64; N]) -> DVector<f64> {
    DVector::from_column_slice(components)
}

pub(super) fn matrix<const N: usize>(rows: &[[f64; N]; N]) -> DMatrix<f64> {
    DMatrix::from_row_slice(N, N, rows.as_flattened())
}

/// A state of the static floors; NaN where a number is missing, which no integrator takes.
pub(crate) fn fixed<const N: usize>(state: &[f64]) -> [f64; N] {
    crate::scalar::filled(|j| state.get(j).copied().unwrap_or(f64::NAN))
}

/// How many directions of motion that one of these stretches takes away which takes most: at least as many multipliers of an
/// orbit of them are exactly zero.
pub(crate) fn most_stuck(segments: &[Segment]) -> usize {
    let stuck = segments.iter().map(|segment| sticking(&segment.modes));
    stuck.max().unwrap_or(0)
}
