//! The cells of the map, and what each is to hold: the one place where they are written down.

use std::ops::RangeInclusive;

use stickslip::field::{Kernel, Smoothing};
use stickslip::model::ModelInfo;
use stickslip::study::{Case, Dynamics};

use super::super::ask::Subject;
use super::judge::Limit;
use super::limits;
use crate::{BeltOscillator, BeltPair, DrillString, VanDerPol};

/// What a cell of the map is to hold.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Expected {
    /// An orbit with at least this many true digits.
    Digits(u8),
    /// An error of this kind.
    Refused(&'static str),
}

/// A reference system.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum System {
    /// [`VanDerPol`].
    VanDerPol,
    /// [`BeltOscillator`].
    BeltOscillator,
    /// [`BeltPair`].
    BeltPair,
    /// [`DrillString`].
    DrillString,
}

impl System {
    /// Its name on the command line.
    #[must_use]
    pub fn command(self) -> &'static str {
        self.subject().info().command
    }

    /// The system as it answers.
    pub(super) fn subject(self) -> Subject {
        match self {
            Self::VanDerPol => Subject::new(VanDerPol::nu),
            Self::BeltOscillator => Subject::new(BeltOscillator::v_dr),
            Self::BeltPair => Subject::new(BeltPair::v_dr),
            Self::DrillString => Subject::new(DrillString::eta),
        }
    }
}

/// What is varied, and what its values are to lead to.
#[derive(Clone)]
pub struct Range {
    /// The system.
    pub system: System,
    /// What is varied, in words.
    pub varied: &'static str,
    /// The same on the axis of a figure.
    pub axis: &'static str,
    /// Sets a value.
    pub(super) set: fn(&mut Case, &ModelInfo, f64),
    /// What is known there.
    pub(super) known: fn(&Case, f64) -> Vec<Limit>,
    /// Every value with what it is to lead to.
    pub cells: Vec<(f64, Expected)>,
}

/// Sets the parameter of this name.
fn put(case: &mut Case, info: &ModelInfo, name: &str, value: f64) {
    let place = info
        .parameters
        .iter()
        .position(|declared| declared.name == name);
    if let Some(place) = place.and_then(|index| case.parameters.get_mut(index)) {
        *place = value;
    }
}

/// Sets mass or stiffness of the belt oscillator, and all else such that its nondimensional motion stays the same.
fn in_other_units(case: &mut Case, info: &ModelInfo, mass: f64, stiffness: f64) {
    put(case, info, "m", mass);
    put(case, info, "k", stiffness);
    let impedance = (mass * stiffness).sqrt();
    put(case, info, "v_dr", 0.2 / impedance);
    put(case, info, "delta", 3.0 * impedance);
}

/// Two equal masses that begin together, on the belt.
fn together(case: &mut Case, info: &ModelInfo, coupling: f64) {
    put(case, info, "alpha", coupling);
    put(case, info, "beta", 1.0);
    case.start = Some(vec![0.0, 0.14, 0.0, 0.14]);
}

/// A parameter of a system by its name, or a value set in another way.
macro_rules! range {
    ($system:ident, $varied:literal, $axis:literal, $known:path) => {
        range!($system, $varied, $axis, $known, |case, info, value| {
            put(case, info, $varied, value);
        })
    };
    ($system:ident, $varied:literal, $axis:literal, $known:path, $set:expr) => {
        Range {
            system: System::$system,
            varied: $varied,
            axis: $axis,
            set: $set,
            known: $known,
            cells: Vec::new(),
        }
    };
}

/// The size of a smoothing.
macro_rules! copy {
    ($system:ident, $kernel:ident, $name:literal, $known:path) => {
        range!($system, $name, "*ε*", $known, |case, _, size| {
            let kernel = Kernel::$kernel;
            case.dynamics = Dynamics::Smoothed(Smoothing { kernel, size });
        })
    };
}

impl Range {
    /// Whether the size of a smoothing is varied.
    pub(super) fn is_copy(&self) -> bool {
        self.axis == "*ε*"
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

/// All ranges of the map.
#[must_use]
pub fn ranges() -> Vec<Range> {
    use Expected::{Digits, Refused};
    let exact = [
        range!(VanDerPol, "nu", "*ν*", limits::van_der_pol)
            .zero(Refused("not-isolated"))
            .at(-8..=-8, Digits(4))
            .at(-7..=-6, Digits(5))
            .at(-5..=-4, Digits(7))
            .at(-3..=4, Digits(8))
            .at(5..=6, Refused("not-settled")),
        range!(BeltOscillator, "v_dr", "*v*_{dr}", limits::belt_speed)
            .zero(Refused("equilibrium"))
            .at(-8..=-6, Digits(6))
            .at(-5..=3, Digits(8)),
        range!(BeltOscillator, "F_s", "*F*_{s}", limits::belt_force)
            .zero(Refused("not-isolated"))
            .at(-12..=-12, Refused("not-isolated"))
            .at(-6..=4, Digits(7)),
        range!(BeltOscillator, "delta", "*δ*", limits::belt_weakening)
            .zero(Refused("not-isolated"))
            .at(-8..=8, Digits(8)),
        range!(
            BeltOscillator,
            "m, nondimensional motion kept",
            "*m*",
            limits::belt_units,
            |case, info, mass| {
                in_other_units(case, info, mass, 1.0);
            }
        )
        .at(-12..=12, Digits(8)),
        range!(
            BeltOscillator,
            "k, nondimensional motion kept",
            "*k*",
            limits::belt_units,
            |case, info, k| {
                in_other_units(case, info, 1.0, k);
            }
        )
        .at(-12..=11, Digits(8))
        .at(12..=12, Refused("not-isolated")),
        range!(DrillString, "eta", "*η*", limits::drill_string)
            .at(-8..=0, Digits(8))
            .at(1..=3, Refused("equilibrium")),
        range!(DrillString, "theta", "*θ*", limits::drill_string)
            .zero(Refused("equilibrium"))
            .at(-6..=0, Refused("equilibrium"))
            .at(1..=8, Digits(8)),
        range!(DrillString, "kinetic", "*T*_{sl}/*k*", limits::drill_string)
            .zero(Digits(8))
            .at(-8..=8, Digits(8)),
        range!(DrillString, "zeta", "*ζ*", limits::drill_string)
            .zero(Digits(8))
            .at(-8..=-2, Digits(8))
            .at(-1..=1, Refused("equilibrium"))
            .at(2..=2, Refused("flow")),
        range!(BeltPair, "v_dr", "*V*_{dr}", limits::none).at(-2..=3, Digits(6)),
        range!(
            BeltPair,
            "alpha, equal masses together",
            "*α*",
            limits::belt_pair_together,
            together
        )
        .zero(Refused("not-isolated"))
        .at(-6..=-6, Digits(5))
        .at(-5..=5, Digits(7))
        .at(6..=6, Refused("not-settled")),
        range!(BeltPair, "beta", "*β*", limits::none).at(-6..=0, Digits(7)),
        range!(BeltPair, "gamma", "*γ*", limits::none).at(-6..=1, Digits(7)),
    ];
    let signs = [
        copy!(BeltOscillator, Arctan, "arctan", limits::copy_of_belt),
        copy!(BeltOscillator, Tanh, "tanh", limits::copy_of_belt),
        copy!(BeltOscillator, Algebraic, "algebraic", limits::copy_of_belt),
        copy!(BeltOscillator, Cubic, "cubic", limits::copy_of_belt),
        copy!(BeltOscillator, Quintic, "quintic", limits::copy_of_belt),
    ];
    let signs = signs.map(|copy| copy.at(0..=0, Refused("equilibrium")).at(1..=12, Digits(7)));
    let bump = copy!(
        DrillString,
        Quartic,
        "quartic",
        limits::copy_of_drill_string
    )
    .at(-8..=0, Digits(7))
    .at(1..=1, Refused("equilibrium"));
    exact.into_iter().chain(signs).chain([bump]).collect()
}
