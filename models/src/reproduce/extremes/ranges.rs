//! The cells of the map, and what each is to hold: the one place where they are written down.

use std::ops::RangeInclusive;

use stickslip::field::{Kernel, Smoothing};
use stickslip::model::{Model, ParamId};
use stickslip::study::{Case, Dynamics};

use super::super::ask::Subject;
use super::ACCURACY;
use super::limits::{
    Limit, belt_force, belt_pair_together, belt_speed, belt_units, belt_weakening, copy_of_belt,
    copy_of_drill_string, drill_string, none, van_der_pol,
};
use crate::{BeltOscillator, BeltPair, DrillString, VanDerPol};

/// What a cell of the map is to hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Expected {
    /// An orbit with at least this many true digits.
    Digits(u8),
    /// An error of this kind.
    Refused(&'static str),
}

/// What is known of an orbit, given its case and the value of what is varied.
type Known = fn(&Case, f64) -> Vec<Limit>;

/// What is varied, and what its values are to lead to.
pub struct Range {
    pub(super) subject: Subject,
    set: Set,
    /// What is varied, on the axis of a figure.
    pub(super) axis: &'static str,
    pub(super) known: Known,
    /// Every value with what it is to lead to.
    pub cells: Vec<(f64, Expected)>,
}

/// What is set to a value.
#[derive(Clone, Copy)]
enum Set {
    Parameter,
    /// The size of a smoothing.
    Size(Kernel),
    /// Several things, in words, and how.
    Several(&'static str, fn(&mut Case, f64)),
}

fn range<M: Model<N>, const N: usize>(
    parameter: ParamId<M>,
    set: Set,
    axis: &'static str,
    known: Known,
) -> Range {
    Range {
        subject: Subject::new(parameter),
        set,
        axis,
        known,
        cells: Vec::new(),
    }
}

fn parameter<M: Model<N>, const N: usize>(
    parameter: ParamId<M>,
    axis: &'static str,
    known: Known,
) -> Range {
    range(parameter, Set::Parameter, axis, known)
}

fn copy<M: Model<N>, const N: usize>(any: ParamId<M>, kernel: Kernel, known: Known) -> Range {
    range(any, Set::Size(kernel), "*ε*", known)
}

impl Range {
    /// The system, by its name on the command line.
    #[must_use]
    pub fn system(&self) -> &'static str {
        self.subject.info().command
    }

    /// What is varied, in words.
    #[must_use]
    pub fn varied(&self) -> &'static str {
        match self.set {
            Set::Parameter => self.subject.name(),
            Set::Size(kernel) => kernel.name(),
            Set::Several(words, _) => words,
        }
    }

    /// Whether the size of a smoothing is varied.
    pub(super) const fn is_copy(&self) -> bool {
        matches!(self.set, Set::Size(_))
    }

    /// The case at this value.
    pub(super) fn case(&self, value: f64) -> Case {
        let dynamics = match (self.set, self.subject.info().contacts) {
            (Set::Size(kernel), _) => Dynamics::Smoothed(Smoothing {
                kernel,
                size: value,
            }),
            (_, []) => Dynamics::Smooth,
            _ => Dynamics::Exact,
        };
        let mut case = match self.set {
            Set::Parameter => self.subject.case(dynamics, value),
            Set::Size(_) | Set::Several(..) => Case::declared(self.subject.info(), dynamics),
        };
        if let Set::Several(_, set) = self.set {
            set(&mut case, value);
        }
        case.accuracy = ACCURACY;
        case
    }

    fn zero(mut self, expected: Expected) -> Self {
        self.cells.push((0.0, expected));
        self
    }

    /// These powers of ten.
    fn at(mut self, powers: RangeInclusive<i32>, expected: Expected) -> Self {
        let value = |power: i32| format!("1e{power}").parse().unwrap_or(f64::NAN);
        self.cells
            .extend(powers.map(|power| (value(power), expected)));
        self
    }
}

/// Sets mass or stiffness of the belt oscillator, and all else such that its nondimensional motion stays the same.
fn in_other_units(case: &mut Case, mass: f64, stiffness: f64) {
    let impedance = (mass * stiffness).sqrt();
    case.parameters[BeltOscillator::m.index] = mass;
    case.parameters[BeltOscillator::k.index] = stiffness;
    case.parameters[BeltOscillator::v_dr.index] = 0.2 / impedance;
    case.parameters[BeltOscillator::delta.index] = 3.0 * impedance;
}

/// Two equal masses that begin together, on the belt.
fn together(case: &mut Case, coupling: f64) {
    case.parameters[BeltPair::alpha.index] = coupling;
    case.parameters[BeltPair::beta.index] = 1.0;
    case.start = Some(vec![0.0, 0.14, 0.0, 0.14]);
}

/// All ranges of the map.
#[must_use]
pub fn ranges() -> Vec<Range> {
    use Expected::{Digits, Refused};
    use Set::Several;
    let exact = [
        parameter(VanDerPol::nu, "*ν*", van_der_pol)
            .zero(Refused("not isolated"))
            .at(-8..=-8, Digits(4))
            .at(-7..=-6, Digits(5))
            .at(-5..=-4, Digits(7))
            .at(-3..=4, Digits(8))
            .at(5..=6, Refused("not settled")),
        parameter(BeltOscillator::v_dr, "*v*_{dr}", belt_speed)
            .zero(Refused("equilibrium"))
            .at(-8..=-6, Digits(6))
            .at(-5..=3, Digits(8)),
        parameter(BeltOscillator::F_s, "*F*_{s}", belt_force)
            .zero(Refused("not isolated"))
            .at(-12..=-12, Refused("not isolated"))
            .at(-6..=4, Digits(7)),
        parameter(BeltOscillator::delta, "*δ*", belt_weakening)
            .zero(Refused("not isolated"))
            .at(-8..=8, Digits(8)),
        range(
            BeltOscillator::m,
            Several("m, nondimensional motion kept", |case, mass| {
                in_other_units(case, mass, 1.0)
            }),
            "*m*",
            belt_units,
        )
        .at(-12..=12, Digits(8)),
        range(
            BeltOscillator::k,
            Several("k, nondimensional motion kept", |case, k| {
                in_other_units(case, 1.0, k)
            }),
            "*k*",
            belt_units,
        )
        .at(-12..=11, Digits(8))
        .at(12..=12, Refused("not settled")),
        parameter(DrillString::eta, "*η*", drill_string)
            .at(-8..=0, Digits(8))
            .at(1..=3, Refused("equilibrium")),
        parameter(DrillString::theta, "*θ*", drill_string)
            .zero(Refused("equilibrium"))
            .at(-6..=0, Refused("equilibrium"))
            .at(1..=8, Digits(8)),
        parameter(DrillString::kinetic, "*T*_{sl}/*k*", drill_string)
            .zero(Digits(8))
            .at(-8..=8, Digits(8)),
        parameter(DrillString::zeta, "*ζ*", drill_string)
            .zero(Digits(8))
            .at(-8..=-2, Digits(8))
            .at(-1..=2, Refused("equilibrium")),
        parameter(BeltPair::v_dr, "*V*_{dr}", none).at(-2..=3, Digits(6)),
        range(
            BeltPair::alpha,
            Several("alpha, equal masses together", together),
            "*α*",
            belt_pair_together,
        )
        // Without a spring between them the masses may move at any time after each other.
        .zero(Refused("not isolated"))
        .at(-6..=-6, Digits(5))
        .at(-5..=6, Digits(7)),
        parameter(BeltPair::beta, "*β*", none).at(-6..=0, Digits(7)),
        parameter(BeltPair::gamma, "*γ*", none).at(-6..=1, Digits(7)),
    ];
    use Kernel::{Algebraic, Arctan, Cubic, Quartic, Quintic, Tanh};
    let signs = [Arctan, Tanh, Algebraic, Cubic, Quintic].map(|kernel| {
        let copy = copy(BeltOscillator::v_dr, kernel, copy_of_belt);
        copy.at(0..=0, Refused("equilibrium")).at(1..=12, Digits(7))
    });
    let bump = copy(DrillString::eta, Quartic, copy_of_drill_string)
        .at(-8..=0, Digits(7))
        .at(1..=1, Refused("equilibrium"));
    exact.into_iter().chain(signs).chain([bump]).collect()
}
