//! Why something that was followed ended, as it is reported.

use crate::continuation::{Ending, Kind, Lost, Stop, Unexplained};
use crate::flow::FlowError;
use crate::study::question::Along;

/// Why a branch or a curve ended.
#[derive(Debug, Clone, PartialEq)]
pub struct Ended {
    /// Which way, the design variable as the continuation counts it.
    pub ending: Ending<FlowError>,
    /// In a sentence.
    pub reason: String,
}

impl Ended {
    /// Of what was followed up to this value of the design variable, where that is known.
    pub(super) fn of(ending: &Ending<FlowError>, along: Along, last: Option<f64>) -> Self {
        let reason = match (ending, last) {
            (Ending::Stopped(stop @ Stop::StepTooSmall(_)), Some(last)) => {
                format!("beyond {} {stop}", rounded(along.value(last)))
            }
            _ => reason(ending, along),
        };
        Self {
            reason,
            ending: ending.clone(),
        }
    }

    /// In one word, for instance `reached-end`.
    #[must_use]
    pub fn word(&self) -> &'static str {
        match &self.ending {
            Ending::Stopped(Stop::ReachedEnd) => "reached-end",
            Ending::Stopped(Stop::ReachedStart) => "reached-start",
            Ending::Stopped(Stop::TooManyPoints) => "too-many-points",
            Ending::Stopped(Stop::Refused(FlowError::Vanished { .. })) => "equilibrium",
            Ending::Stopped(Stop::Refused(_)) => "refused",
            Ending::Stopped(Stop::StepTooSmall(_) | Stop::Creeping(_) | Stop::Upright(_))
            | Ending::FallsBack(_) => "step-too-small",
            Ending::At(kind, _) | Ending::Meets(kind, _) => kind.name(),
            Ending::Undecided(..) => "undecided",
            Ending::Closed(_) => "closed",
            Ending::Left => Kind::Window.name(),
            Ending::Endless(_) => "infinite-period",
            Ending::Unbounded(_) => "unbounded",
            Ending::Homoclinic(_) => "homoclinic",
            Ending::Family(_) => "family",
            Ending::Lost(_) => "lost",
            Ending::Interrupted => "interrupted",
            Ending::Unexplained(_) => "unexplained-change",
        }
    }

    /// Whether all that was asked for was followed.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        matches!(self.ending, Ending::Stopped(Stop::ReachedEnd))
    }

    /// Whether it ended where the range of its design variable does, at whichever side.
    #[must_use]
    pub fn reaches_bound(&self) -> bool {
        matches!(
            self.ending,
            Ending::Stopped(Stop::ReachedEnd | Stop::ReachedStart)
        )
    }

    /// Whether this is a reason that lies in the branch and not in the computation.
    #[must_use]
    pub fn is_located(&self) -> bool {
        match &self.ending {
            Ending::Stopped(stop) => match stop {
                Stop::ReachedEnd | Stop::ReachedStart => true,
                Stop::Refused(error) => {
                    matches!(error, FlowError::Vanished { .. } | FlowError::LetsGo)
                }
                Stop::StepTooSmall(_)
                | Stop::Creeping(_)
                | Stop::Upright(_)
                | Stop::TooManyPoints => false,
            },
            Ending::At(..)
            | Ending::Meets(..)
            | Ending::Closed(_)
            | Ending::Left
            | Ending::Endless(_)
            | Ending::Unbounded(_)
            | Ending::Homoclinic(_)
            | Ending::Family(_) => true,
            Ending::Undecided(..)
            | Ending::FallsBack(_)
            | Ending::Lost(_)
            | Ending::Interrupted
            | Ending::Unexplained(_) => false,
        }
    }

    /// Whether it ended because whoever watched it wanted no more.
    #[must_use]
    pub fn is_interrupted(&self) -> bool {
        self.ending.is_interrupted()
    }

    /// Whether it came round to where it began.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        matches!(self.ending, Ending::Closed(_))
    }
}

fn reason(ending: &Ending<FlowError>, along: Along) -> String {
    let value = |r: &f64| rounded(along.value(*r) + 0.0);
    match ending {
        Ending::Stopped(stop) => stop.to_string(),
        Ending::At(Kind::Fold, r) => {
            format!("it turns at {}, too sharply to be followed round", value(r))
        }
        Ending::At(kind @ (Kind::Resonance1 | Kind::Resonance2 | Kind::BogdanovTakens), _) => {
            format!(
                "it meets a {} point, beyond which it is a curve of neutral saddles",
                kind.name()
            )
        }
        Ending::At(Kind::BoundaryEquilibrium, r) => format!(
            "at {} the speed or the force of a contact reaches zero, and with it the mode in which it was followed ends",
            value(r)
        ),
        Ending::At(Kind::Hopf, r) => format!(
            "it shrinks to an equilibrium at {}, a hopf point: there its orbits begin",
            value(r)
        ),
        Ending::At(kind, r) => format!(
            "it meets {} point at {}: no orbit continues it",
            with_article(kind.name()),
            value(r)
        ),
        Ending::Undecided(kind, r) => format!(
            "it meets {} point at {}: an orbit should continue it, and none was found",
            with_article(kind.name()),
            value(r)
        ),
        Ending::Meets(_, r) => format!(
            "at {} both halves of the orbit become one: it meets the branch from which it doubles",
            value(r)
        ),
        Ending::FallsBack(r) => format!(
            "at {} it falls back on orbits that it has come by, or on a shorter one, however short the step",
            value(r)
        ),
        Ending::Closed(r) => format!(
            "it is closed: it came back to the orbit at {} with which it began",
            value(r)
        ),
        Ending::Left => "it reaches an end of the range of the first design variable".to_owned(),
        Ending::Endless(times) => format!("its period has grown more than {times:e} times"),
        Ending::Unbounded(r) => format!("it grows without bound towards {}", value(r)),
        Ending::Homoclinic(r) => format!(
            "at {} it stands still while its period grows without bound: its orbits come to one that leaves an equilibrium and \
             comes back to it (homoclinic)",
            value(r)
        ),
        Ending::Family(r) => format!(
            "at {} it stands still while its orbits go on changing: there they are a family, each as good as the others",
            value(r)
        ),
        Ending::Lost(lost) => match lost {
            Lost::Off(off) => {
                format!("what was followed is no such bifurcation any more: off by {off:.1e}")
            }
            Lost::Becomes(kind) => format!(
                "what was followed becomes {} next to its last point: there both kinds are one",
                kind.name()
            ),
            Lost::Largest => {
                "what vanishes along it is least no more next to its last point, but largest: \
                              beyond, no orbit comes to this border"
                    .to_owned()
            }
        },
        Ending::Interrupted => "it was interrupted".to_owned(),
        Ending::Unexplained(change) => unexplained(change, along),
    }
}

/// A value with the ten digits that special points are printed with at most.
fn rounded(value: f64) -> f64 {
    format!("{value:.9e}").parse().unwrap_or(value)
}

fn with_article(name: &str) -> String {
    let article = if name.starts_with(['a', 'e', 'i', 'o', 'u']) {
        "an"
    } else {
        "a"
    };
    format!("{article} {name}")
}

fn unexplained(change: &Unexplained, along: Along) -> String {
    let [from, to] = change.between.map(|r| along.value(r));
    let reason = &change.reason;
    let what = match change.unstable {
        [before, after] if before == after => {
            "its events change, or a multiplier that is not known well enough passes 1,".to_owned()
        }
        [before, after] => format!("its {before} unstable multipliers become {after}"),
    };
    format!(
        "between {from} and {to} {what} and no bifurcation was located there: {reason}; asking for more accuracy may tell it"
    )
}
