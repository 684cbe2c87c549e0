//! Questions about random branches.

use std::fmt;
use std::ops::ControlFlow;

use stickslip::field::Design;
use stickslip::study::{Along, Beginning, Case, Dynamics, Switch, System};
use stickslip_models::systems;
use stickslip_tests::random::Random;
use stickslip_tests::row::Row;

use crate::answer::Answer;

/// Points after which a branch is left, if nothing else is said.
const MOST: usize = 600;
const ACCURACY: f64 = 1e-9;

/// A branch that is asked for.
#[derive(Debug, Clone)]
pub(crate) struct Question {
    system: System,
    case: Case,
    along: Along,
    /// Points after which the branch is left.
    most: usize,
}

impl Question {
    /// Random parameters of a random system, one of them followed.
    pub(crate) fn random(dice: &mut Random) -> Self {
        let systems = [
            systems::van_der_pol,
            systems::belt_oscillator,
            systems::belt_pair,
            systems::belt_pair,
            systems::drill_string,
            systems::forced_belt,
            systems::forced_belt,
            System::of::<Row, _>,
            System::of::<Row, _>,
        ];
        let system = systems[(dice.unit() * systems.len() as f64) as usize]();
        let dynamics = if system.info().contacts.is_empty() {
            Dynamics::Smooth
        } else {
            Dynamics::Exact
        };
        let mut case = Case::declared(system.info(), dynamics);
        for value in &mut case.parameters {
            *value *= dice.positive(0.4, 2.5);
        }
        case.accuracy = ACCURACY;
        let index = (dice.unit() * case.parameters.len() as f64) as usize;
        let from = case.parameters[index];
        let along = Along {
            design: Design::Parameter(index),
            from,
            to: from * dice.positive(0.4, 2.5),
        };
        Self {
            system,
            case,
            along,
            most: MOST,
        }
    }

    /// The answer; `None` if there is no orbit to begin with.
    pub(crate) fn answer(&self) -> Option<Answer> {
        let case = Case {
            along: Some(self.along),
            ..self.case.clone()
        };
        let mut points = 0;
        let found = self.system.branch_watched(&case, &mut |_| {
            points += 1;
            if points < self.most {
                ControlFlow::Continue(())
            } else {
                ControlFlow::Break(())
            }
        });
        found
            .ok()
            .filter(|found| !found.is_interrupted())
            .map(Answer::of)
    }

    /// The same, left after so many points.
    pub(crate) fn left_after(self, most: usize) -> Self {
        Self { most, ..self }
    }

    /// The same at another accuracy.
    pub(crate) fn at_accuracy(&self, accuracy: f64) -> Self {
        let mut other = self.clone();
        other.case.accuracy = accuracy;
        other
    }

    /// The same, up to this share of the way; begun with the orbit that was found, as the search for it knows no far end.
    pub(crate) fn up_to(&self, answer: &Answer, share: f64) -> Option<Self> {
        let first = answer.record.points.first()?;
        let mut other = self.begin(&first.state, first.period);
        other.along.to = self.along.from + share * (self.along.to - self.along.from);
        Some(other)
    }

    /// The same the other way round, if the branch went all the way.
    pub(crate) fn reversed(&self, answer: &Answer) -> Option<Self> {
        let last = answer.record.points.last()?;
        (answer.record.ended.word() == "reached-end").then(|| {
            let mut other = self.clone();
            (other.along.from, other.along.to) = (self.along.to, self.along.from);
            other.begin(&last.state, last.period)
        })
    }

    /// The same, begun with an orbit within.
    pub(crate) fn begun_within(&self, answer: &Answer, share: f64) -> Option<Self> {
        let points = &answer.record.points;
        let point = points.get((share * points.len() as f64) as usize)?;
        let (low, high) = (
            self.along.from.min(self.along.to),
            self.along.from.max(self.along.to),
        );
        let r = point.r.filter(|r| *r > low && *r < high);
        r.map(|r| {
            let mut other = self.begin(&point.state, point.period);
            other.case.beginning = Beginning::At(r);
            other
        })
    }

    /// The same with the branches that leave it at flips.
    pub(crate) fn with_doubled(&self) -> Self {
        let mut other = self.clone();
        other.case.switch = Switch {
            flips: true,
            depth: 1,
            ..Switch::default()
        };
        other
    }

    fn begin(&self, state: &[f64], period: f64) -> Self {
        let mut other = self.clone();
        (other.case.start, other.case.period) = (Some(state.to_vec()), Some(period));
        other
    }
}

impl fmt::Display for Question {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let info = self.system.info();
        write!(
            f,
            "branch {} --accuracy {:e}",
            info.name, self.case.accuracy
        )?;
        for (parameter, value) in info.parameters.iter().zip(&self.case.parameters) {
            if parameter.name != self.along.name(info) {
                write!(f, " --set {}={value}", parameter.name)?;
            }
        }
        if let Some(start) = &self.case.start {
            let pairs = info.states.iter().zip(start);
            let pairs: Vec<String> = pairs
                .map(|(state, x)| format!("{}={x}", state.name))
                .collect();
            write!(f, " --start {}", pairs.join(","))?;
        }
        if let Some(period) = self.case.period {
            write!(f, " --period {period}")?;
        }
        let (from, to) = (self.along.from, self.along.to);
        write!(f, " --along {}={from}..{to}", self.along.name(info))?;
        if let Beginning::At(r) = self.case.beginning {
            write!(f, " --from {r}")?;
        }
        Ok(())
    }
}
