//! What is asked of a model: at which parameters, with which friction, from where, how accurately.

use std::ops::Range;

use super::choice::choose;
use super::dynamics::Dynamics;
use crate::bifurcation::Kind;
use crate::continuation::Located;
use crate::field::{Design, Smoothing};
use crate::model::{Model, ModelInfo, ParamId};
use crate::motion::Modes;

/// A question to a model.
#[derive(Debug, Clone, PartialEq)]
pub struct Case {
    /// Values of all parameters in the order of declaration; of a followed one, where it begins.
    pub parameters: Vec<f64>,
    /// How friction acts.
    pub dynamics: Dynamics,
    /// The design variable, if one is followed.
    pub along: Option<Along>,
    /// Where to begin; the declared start if nothing is said.
    pub start: Option<Vec<f64>>,
    /// The modes of its contacts in which that was reached; empty where the state alone decides.
    pub modes: Modes,
    /// A guess of the period.
    pub period: Option<f64>,
    /// Relative accuracy of period and extrema.
    pub accuracy: f64,
    /// Where on the way of the design variable a branch of orbits begins.
    pub beginning: Beginning,
    /// Which branches that leave it are followed too.
    pub switch: Switch,
    /// Which harmonics of orbits are wanted: multiples of the drive's frequency, or, without a drive, of the orbit's.
    pub harmonics: Vec<usize>,
}

/// Where on the way of its design variable a branch begins.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum Beginning {
    /// At the beginning of the way.
    #[default]
    End,
    /// At this value between its ends, in both directions.
    At(f64),
    /// At the first Hopf point of the equilibrium that begins at the beginning of the way.
    Hopf,
}

/// The special points at which other branches are followed, too.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Switch {
    /// Flips: the doubled orbits.
    pub flips: bool,
    /// Branch points: the branch that crosses.
    pub branch_points: bool,
    /// How many switches lie between the first branch and the last at most.
    pub depth: usize,
}

impl Switch {
    /// Whether another branch is wanted at this kind of point.
    pub(in crate::study) fn wants(&self, kind: Kind) -> bool {
        match kind {
            Kind::Flip => self.flips,
            Kind::BranchPoint | Kind::SymmetryBreaking => self.branch_points,
            _ => false,
        }
    }
}

/// A design variable and its way, in the user's own values.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Along {
    /// What is followed.
    pub design: Design,
    /// Where it begins.
    pub from: f64,
    /// Where it shall end.
    pub to: f64,
}

impl Case {
    /// The case of a model with these parameters: friction by its exact law, if it has any, at the relative accuracy 1e-9.
    #[must_use]
    pub fn of<M: Model<N>, const N: usize>(model: &M) -> Self {
        Self {
            parameters: model.values().as_ref().to_vec(),
            ..Self::declared(M::INFO, choose(M::INFO, None, 1e-9).dynamics)
        }
    }

    /// The case of a model as declared, with `dynamics`, at the relative accuracy 1e-9.
    #[must_use]
    pub fn declared(info: &ModelInfo, dynamics: Dynamics) -> Self {
        Self {
            parameters: info.parameters.iter().map(|p| p.default).collect(),
            dynamics,
            along: None,
            start: None,
            modes: Modes::new(),
            period: None,
            accuracy: 1e-9,
            beginning: Beginning::End,
            switch: Switch::default(),
            harmonics: Vec::new(),
        }
    }

    /// The same case with this value of a parameter of its model: `case.with(Pad::disc, 0.3)`.
    #[must_use]
    pub fn with<M>(mut self, parameter: ParamId<M>, value: f64) -> Self {
        if let Some(place) = self.parameters.get_mut(parameter.index) {
            *place = value;
        }
        self
    }

    /// The same case, followed along a parameter of its model: `case.following(Pad::disc, 0.2..0.6)`, in either direction.
    #[must_use]
    pub fn following<M>(mut self, parameter: ParamId<M>, way: Range<f64>) -> Self {
        self.along = Some(Along {
            design: Design::Parameter(parameter.index),
            from: way.start,
            to: way.end,
        });
        self.with(parameter, way.start)
    }

    /// The same case where the followed variable has this value.
    #[must_use]
    pub fn at(&self, value: f64) -> Self {
        let mut case = self.clone();
        match (self.design(), &mut case.dynamics) {
            (Design::Parameter(index), _) => {
                if let Some(place) = case.parameters.get_mut(index) {
                    *place = value;
                }
            }
            (Design::Smoothing, Dynamics::Smoothed(smoothing)) => smoothing.size = value,
            _ => {}
        }
        case
    }

    /// What is followed.
    pub(in crate::study) fn design(&self) -> Design {
        self.along.map_or(Design::None, |along| along.design)
    }

    /// The smoothing of the contacts, if there is one.
    #[must_use]
    pub fn smoothing(&self) -> Option<Smoothing> {
        match self.dynamics {
            Dynamics::Smoothed(smoothing) => Some(smoothing),
            Dynamics::Smooth | Dynamics::Exact => None,
        }
    }
}

impl Along {
    /// The name of the variable on the command line.
    #[must_use]
    pub fn name(&self, info: &ModelInfo) -> &'static str {
        match self.design {
            Design::Parameter(index) => info.parameters.get(index).map_or("", |p| p.name),
            Design::Smoothing => "smooth",
            Design::None => "",
        }
    }

    /// Both ends as a family counts them: the size of a smoothing in its logarithm.
    #[must_use]
    pub fn span(&self) -> (f64, f64) {
        match self.design {
            Design::Smoothing => (self.from.ln(), self.to.ln()),
            Design::Parameter(_) | Design::None => (self.from, self.to),
        }
    }

    /// The user's value of a family's r: the inverse of [`Along::span`], exact at both ends.
    #[must_use]
    pub fn value(&self, r: f64) -> f64 {
        let (from, to) = self.span();
        match self.design {
            _ if r == from => self.from,
            _ if r == to => self.to,
            Design::Smoothing => r.exp(),
            Design::Parameter(_) | Design::None => r,
        }
    }

    /// This many values as a family counts them, evenly spaced, smallest first, both ends among them.
    #[must_use]
    pub(in crate::study) fn spaced(&self, values: usize) -> Vec<f64> {
        let (from, to) = self.span();
        let (low, high) = (from.min(to), from.max(to));
        let last = values.max(2) - 1;
        let value = |k: usize| match k {
            0 => low,
            k if k == last => high,
            k => low + (high - low) * k as f64 / last as f64,
        };
        (0..=last).map(value).collect()
    }

    /// The estimated error of r at a special point, in the user's own values; `None` where it could not be measured.
    #[must_use]
    pub(in crate::study) fn error<P>(&self, at: &Located<P>) -> Option<f64> {
        let own = match self.design {
            Design::Smoothing => at.r.exp() * at.error,
            Design::Parameter(_) | Design::None => at.error,
        };
        own.is_finite().then_some(own)
    }

    /// The share of the way done at the user's value `value`, between 0 and 1.
    #[must_use]
    pub fn share(&self, value: f64) -> f64 {
        let here = Self {
            from: value,
            ..*self
        };
        let (from, to) = self.span();
        ((here.span().0 - from) / (to - from)).clamp(0.0, 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_smoothing_is_followed_in_its_logarithm() {
        let along = Along {
            design: Design::Smoothing,
            from: 1e2,
            to: 1e7,
        };
        let (from, to) = along.span();
        assert_eq!((along.value(from), along.value(to)), (1e2, 1e7));
        assert!((along.value(1e3_f64.ln()) / 1e3 - 1.0).abs() < 1e-14);
        assert!((along.share(1e3) - 0.2).abs() < 1e-14);
    }
}
