//! What is known in closed form, exactly or in a limit, with a bound for the rest.

use std::f64::consts::{LN_2, TAU};

use stickslip::field::Kernel;
use stickslip::study::{Case, Dynamics, OrbitRecord};

use super::super::ask::Subject;
use crate::closed_form;
use crate::{BeltOscillator, BeltPair, DrillString};

/// Three times the modulus of the first zero of Ai, as in Dorodnicyn's expansion of the period.
const AIRY: f64 = 7.014_322_339_2;
/// Period and largest displacement of the belt oscillator at its defaults, from an independent computation.
const BELT: (f64, f64) = (12.001_031_294_830_579, 1.133_944_676_441_657);

/// What is known of an orbit without computing it.
#[derive(Debug, Clone, Copy)]
pub(super) struct Limit {
    /// Which quantity.
    of: fn(&OrbitRecord) -> f64,
    /// Its value there.
    value: f64,
    /// How far from it the true value may be, relative to it.
    remainder: f64,
}

impl Limit {
    /// A period known but for this relative remainder.
    pub(super) const fn period(value: f64, remainder: f64) -> Self {
        let of = |orbit: &OrbitRecord| orbit.period;
        Self {
            of,
            value,
            remainder,
        }
    }

    /// A largest value of the first state known but for this relative remainder.
    pub(super) const fn max(value: f64, remainder: f64) -> Self {
        let of = |orbit: &OrbitRecord| orbit.max.first().copied().unwrap_or(f64::NAN);
        Self {
            of,
            value,
            remainder,
        }
    }

    /// A largest magnitude of the first state known but for this relative remainder.
    pub(super) const fn amplitude(value: f64, remainder: f64) -> Self {
        let of = |orbit: &OrbitRecord| orbit.max_abs.first().copied().unwrap_or(f64::NAN);
        Self {
            of,
            value,
            remainder,
        }
    }

    /// By how much more than the remainder an orbit is off; nothing if it is not.
    pub(super) fn error(&self, orbit: &OrbitRecord) -> f64 {
        let off = ((self.of)(orbit) / self.value - 1.0).abs() - self.remainder;
        if off.is_nan() { 1.0 } else { off.max(0.0) }
    }
}

/// Nothing is known.
pub(super) fn none(_: &Case, _: f64) -> Vec<Limit> {
    Vec::new()
}

/// Van der Pol: expansions for small ν by Lindstedt and Poincaré, for large ν by Dorodnicyn.
pub(super) fn van_der_pol(_: &Case, nu: f64) -> Vec<Limit> {
    if nu <= 0.1 {
        let (square, rest) = (nu * nu, nu.powi(4));
        let period = TAU * (1.0 + square / 16.0 - 5.0 * rest / 3072.0);
        return vec![
            Limit::period(period, rest * square),
            Limit::amplitude(2.0 + square / 96.0, 2e-3 * rest),
        ];
    }
    if nu >= 10.0 {
        let period = (3.0 - 2.0 * LN_2) * nu + AIRY * nu.powf(-1.0 / 3.0);
        return vec![Limit::period(period, nu.ln() / (nu * nu))];
    }
    Vec::new()
}

/// The cycle of the drill string in closed form.
pub(super) fn drill_string(case: &Case, _: f64) -> Vec<Limit> {
    let [eta, theta, kinetic, zeta] = [0, 1, 2, 3].map(|i| case.parameters[i]);
    let model = DrillString {
        eta,
        theta,
        kinetic,
        zeta,
    };
    let cycle = closed_form::drill_string(&model);
    cycle.map_or_else(
        || vec![Limit::period(f64::NAN, 0.0)],
        |cycle| {
            vec![
                Limit::period(cycle.period(), 0.0),
                Limit::max(cycle.max, 0.0),
            ]
        },
    )
}

/// A slow belt pulls the mass just as far as friction holds; above a fast one it swings freely.
pub(super) fn belt_speed(_: &Case, speed: f64) -> Vec<Limit> {
    if speed <= 1e-2 {
        vec![Limit::max(1.0, speed)]
    } else if speed >= 10.0 {
        vec![Limit::period(TAU, 1.0 / (speed * speed))]
    } else {
        Vec::new()
    }
}

/// Weak friction is no friction.
pub(super) fn belt_force(_: &Case, force: f64) -> Vec<Limit> {
    if force <= 1e-2 {
        vec![Limit::period(TAU, 10.0 * force)]
    } else {
        Vec::new()
    }
}

/// Without weakening the mass swings about its equilibrium; with much of it only rest feels friction.
pub(super) fn belt_weakening(_: &Case, delta: f64) -> Vec<Limit> {
    if delta <= 1e-2 {
        vec![Limit::period(TAU, delta), Limit::max(1.2, delta)]
    } else if delta >= 1e4 {
        vec![
            Limit::period(TAU, 50.0 / delta),
            Limit::max(1.04_f64.sqrt(), 50.0 / delta),
        ]
    } else {
        Vec::new()
    }
}

/// The same oscillator in other units.
pub(super) fn belt_units(case: &Case, _: f64) -> Vec<Limit> {
    let [mass, stiffness, force] = [0, 1, 3].map(|i| case.parameters[i]);
    vec![
        Limit::period(BELT.0 * (mass / stiffness).sqrt(), 0.0),
        Limit::max(BELT.1 * force / stiffness, 0.0),
    ]
}

/// Two equal masses that move together are one.
pub(super) fn belt_pair_together(case: &Case, _: f64) -> Vec<Limit> {
    let one = Subject::new(BeltOscillator::v_dr);
    let mut alone = Case::declared(one.info(), Dynamics::Exact);
    let index = BeltOscillator::v_dr.index;
    alone.parameters[index] = case.parameters[BeltPair::v_dr.index];
    one.orbit(&alone).map_or_else(
        |_| Vec::new(),
        |one| {
            vec![
                Limit::period(one.period, 0.0),
                Limit::amplitude(one.max_abs[0], 0.0),
            ]
        },
    )
}

/// The copy tends to the exact system with the order of its kernel.
pub(super) fn copy_of_belt(case: &Case, size: f64) -> Vec<Limit> {
    let off = match case.smoothing().map(|smoothing| smoothing.kernel) {
        Some(Kernel::Arctan) => 13.0 * size.powf(-2.0 / 3.0),
        Some(Kernel::Algebraic) => 10.0 * size.powf(-0.8),
        _ => 30.0 / size,
    };
    if off > 0.1 {
        return Vec::new();
    }
    vec![Limit::period(BELT.0, off), Limit::max(BELT.1, off)]
}

/// A thin bump tends to the exact drill string.
pub(super) fn copy_of_drill_string(case: &Case, width: f64) -> Vec<Limit> {
    let off = 2.0 * width.powf(2.0 / 3.0);
    if off > 0.1 {
        return Vec::new();
    }
    let exact = drill_string(case, width);
    let widened = exact.into_iter().map(|limit| Limit {
        remainder: off,
        ..limit
    });
    widened.collect()
}
