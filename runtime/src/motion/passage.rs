//! One motion from a place to another, and how its end depends on its beginning.

use borsh::{BorshDeserialize, BorshSerialize};
use nalgebra::{DMatrix, DVector};

use super::{Modes, Node, written};
use crate::field::Work;
use crate::field::exact::Mode;
use crate::flow::{self, EventKind};

/// A point of phase space from which a motion continues in one way only.
#[derive(Debug, Clone, PartialEq, BorshSerialize, BorshDeserialize)]
pub struct Place {
    /// The state.
    pub state: Vec<f64>,
    /// The modes of the contacts.
    pub modes: Modes,
}

/// The field at a place, with its derivatives where the motion continues.
#[derive(Debug, Clone, PartialEq)]
pub struct Velocity {
    /// f.
    pub f: DVector<f64>,
    /// ∂fᵢ/∂yⱼ.
    pub jacobian: DMatrix<f64>,
    /// ∂f/∂r.
    pub design: DVector<f64>,
    /// How many internal states rest on their stops: their rows of the Jacobian are zero.
    pub lost: usize,
}

/// One motion from a place to another.
#[derive(Debug, Clone, PartialEq, BorshSerialize, BorshDeserialize)]
pub struct Passage {
    /// Where it ended.
    pub end: Place,
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
    /// What it cost.
    pub work: Work,
}

/// The place between two steps of which the shorter one is longest.
///
/// Next to a short step something is about to happen, or has just happened: a start there would
/// soon fall before it or behind it as the design variable changes.
#[derive(Debug, Clone, PartialEq, BorshSerialize, BorshDeserialize)]
pub struct Calm {
    /// Where.
    pub place: Place,
    /// Least value of each state at the ends of the steps.
    pub low: Vec<f64>,
    /// Largest value of each state there.
    pub high: Vec<f64>,
}

/// How the end of a passage depends on its beginning, on the design variable and on its duration.
#[derive(Debug, Clone, PartialEq, BorshSerialize, BorshDeserialize)]
pub struct Derivatives {
    /// Φ = ∂φ/∂y.
    #[borsh(
        serialize_with = "written::matrix",
        deserialize_with = "written::read_matrix"
    )]
    pub state: DMatrix<f64>,
    /// ∂φ/∂r.
    #[borsh(
        serialize_with = "written::vector",
        deserialize_with = "written::read_vector"
    )]
    pub design: DVector<f64>,
    /// ∂φ/∂t: the velocity at the end.
    #[borsh(
        serialize_with = "written::vector",
        deserialize_with = "written::read_vector"
    )]
    pub time: DVector<f64>,
    /// ∫ tr J dt over the smooth stretches: ln det Φ by Liouville where no event lies between.
    pub trace: f64,
    /// Factors of Φ = Fₘ ⋯ F₁ in the order of time, if wanted.
    pub factors: Vec<Factor>,
    /// The most internal states that rested on their stops at once: as many multipliers of an orbit are exactly zero,
    /// and `trace` says nothing of Φ.
    pub lost: usize,
}

/// A factor of Φ over one stretch of a motion.
#[derive(Debug, Clone, PartialEq, BorshSerialize, BorshDeserialize)]
pub struct Factor {
    /// ∂(end)/∂(beginning) of the stretch.
    #[borsh(
        serialize_with = "written::matrix",
        deserialize_with = "written::read_matrix"
    )]
    pub state: DMatrix<f64>,
    /// ∫ J dt over the stretch, where an implicit step damps what decays fast far less than the motion does.
    #[borsh(
        serialize_with = "written::growth",
        deserialize_with = "written::read_growth"
    )]
    pub growth: Option<DMatrix<f64>>,
}

/// A local extremum of one state along a motion.
#[derive(Debug, Clone, PartialEq, BorshSerialize, BorshDeserialize)]
pub struct Extremum {
    /// Which state.
    pub index: usize,
    /// Whether it is a maximum.
    pub maximum: bool,
    /// When, from the beginning of the passage.
    pub time: f64,
    /// The whole state there.
    pub state: Vec<f64>,
}

/// A stretch of a motion in constant mode.
#[derive(Debug, Clone, PartialEq, BorshSerialize, BorshDeserialize)]
pub struct Segment {
    /// The modes of the contacts during it.
    pub modes: Modes,
    /// Its duration.
    pub duration: f64,
}

/// A state on a motion.
#[derive(Debug, Clone, PartialEq, BorshSerialize, BorshDeserialize)]
pub struct Sample {
    /// Time from the beginning of the passage.
    pub time: f64,
    /// State at that time.
    pub state: Vec<f64>,
}

/// Something that happened at a contact.
#[derive(Debug, Clone, PartialEq, BorshSerialize, BorshDeserialize)]
pub struct Event {
    /// What.
    pub kind: EventKind,
    /// Number of the contact.
    pub contact: usize,
    /// Mode of the contact afterwards.
    pub mode: Mode,
    /// When, from the beginning of the passage.
    pub time: f64,
    /// The whole state there.
    pub state: Vec<f64>,
    /// Rate at which the guard of the contact fell; 0 where it only came near, or where others made it switch.
    pub rate: f64,
}

impl Place {
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
    pub(super) fn of<const N: usize, M>(
        passage: flow::Passage<N, M>,
        modes: impl Fn(&M) -> Modes,
    ) -> Self {
        let segment = |segment: &flow::Segment<M>| Segment {
            modes: modes(&segment.mode),
            duration: segment.duration,
        };
        Self {
            end: Place::of(&passage.end, &modes),
            derivatives: passage.derivatives.map(Derivatives::from),
            extrema: passage.extrema.iter().map(Extremum::from).collect(),
            segments: passage.segments.iter().map(segment).collect(),
            events: passage.events.iter().map(Event::from).collect(),
            path: passage.path.iter().map(Sample::from).collect(),
            nodes: passage.nodes.iter().map(Node::from).collect(),
            calm: Calm {
                place: Place::of(&passage.calm.place, &modes),
                low: passage.calm.low.to_vec(),
                high: passage.calm.high.to_vec(),
            },
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
        Self {
            state: matrix(&derivatives.state),
            design: vector(&derivatives.design),
            time: vector(&derivatives.time),
            trace: derivatives.trace,
            factors: derivatives.factors.iter().map(Factor::from).collect(),
            lost: derivatives.lost,
        }
    }
}

impl<const N: usize> From<&flow::Factor<N>> for Factor {
    fn from(factor: &flow::Factor<N>) -> Self {
        Self {
            state: matrix(&factor.state),
            growth: factor.growth.as_ref().map(matrix),
        }
    }
}

impl<const N: usize> From<&flow::Extremum<N>> for Extremum {
    fn from(extremum: &flow::Extremum<N>) -> Self {
        Self {
            index: extremum.index,
            maximum: extremum.maximum,
            time: extremum.time,
            state: extremum.state.to_vec(),
        }
    }
}

impl<const N: usize> From<&flow::Event<N>> for Event {
    fn from(event: &flow::Event<N>) -> Self {
        Self {
            kind: event.kind,
            contact: event.contact,
            mode: event.mode,
            time: event.time,
            state: event.state.to_vec(),
            rate: event.rate,
        }
    }
}

impl<const N: usize> From<&flow::Sample<N>> for Sample {
    fn from(sample: &flow::Sample<N>) -> Self {
        Self {
            time: sample.time,
            state: sample.state.to_vec(),
        }
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
    std::array::from_fn(|j| state.get(j).copied().unwrap_or(f64::NAN))
}
