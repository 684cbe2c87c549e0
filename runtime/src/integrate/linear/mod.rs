//! Motions of linear fields in closed form: exp(A t) by its Taylor series, with no error but rounding.
//!
//! A series needs no eigenvectors, so that equal and vanishing eigenvalues are nothing special to it. A step over which it
//! is short is made by maps that are computed once for each field; what is left of one, up to an event, by a series. Where
//! fast motions have died away, steps are longer, along maps that are doubled as often as need be.

mod bridge;
mod jump;
mod leap;
mod past;
mod piece;
mod powers;
mod series;
mod stepper;

use std::iter::repeat_n;
use std::sync::OnceLock;

use super::Tolerance;
use crate::field::{LinearField, Point};
use jump::Jump;
use leap::Leap;
use powers::Powers;
use series::degree;
pub(crate) use stepper::LinearStepper;

/// Part of the motion that the dense output may be off.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Blur {
    /// As little as the tolerance asks for: extrema are looked for on it.
    Fine,
    /// More: only guards are looked at, anew along a shorter step where they come as near to falling.
    Coarse,
}

/// Tolerances that a fine dense output need not, and may not, differ from.
const FINE: [f64; 2] = [1e-10, 1e-8];
/// How far a coarse one is off.
const COARSE: f64 = 1e-6;
/// Largest error of the dense output of (ρh)⁸/8!: 27/256 b⁴ with b = a (1 − a), a where it meets the series.
const FACTOR: f64 = 3.0e-4 / 40_320.0;

impl Blur {
    fn error(self, tolerance: Tolerance) -> f64 {
        match self {
            Self::Fine => tolerance.relative.clamp(FINE[0], FINE[1]),
            Self::Coarse => COARSE,
        }
    }
}

/// Maps of doubled lengths, from that of a quarter of a step on.
const LEAPS: usize = 44;
/// Number of the map of one step among them.
const ONE: usize = 2;

/// Steps up to which, and states up to which, a map is doubled later than it is made so many times.
const FEW: usize = 8;

/// The flow of a linear field.
#[derive(Debug)]
pub(crate) struct LinearFlow<const N: usize> {
    field: LinearField<N>,
    /// The longest step: so long that the dense output is within the tolerance.
    longest: f64,
    /// How far that is off along the longest step, relative to the magnitude of the motion.
    error: f64,
    /// Number of terms of its series.
    degree: usize,
    /// The step of this length, where there is one.
    whole: Option<Box<Jump<N>>>,
    /// What motions of a quarter of it, half of it, all of it, two of it and so on do, as they are needed.
    leaps: Box<[OnceLock<Box<Leap<N>>>; LEAPS]>,
    /// What any part of a step does, once that is needed.
    powers: OnceLock<Powers<N>>,
}

impl<const N: usize> LinearFlow<N> {
    /// The flow of a field; `None` if it is faster than numbers tell.
    pub(crate) fn new(field: LinearField<N>, tolerance: Tolerance, blur: Blur) -> Option<Self> {
        let fastest = field.fastest();
        let error = blur.error(tolerance);
        let reach = (error / FACTOR).sqrt().sqrt().sqrt();
        let longest = reach / fastest;
        // A comparison that fails for NaN too.
        let regular = longest > 0.0;
        if !regular {
            return None;
        }
        let degree = degree(reach);
        let whole = longest.is_finite();
        let whole = whole.then(|| Box::new(Jump::new(&field, longest, degree)));
        Some(Self {
            field,
            longest,
            error,
            degree,
            whole,
            leaps: Box::new([const { OnceLock::new() }; LEAPS]),
            powers: OnceLock::new(),
        })
    }

    /// The step of this length, if it is the longest.
    fn whole(&self, length: f64) -> Option<&Jump<N>> {
        let whole = self.whole.as_deref();
        whole.filter(|jump| jump.length() == length)
    }

    /// A point, by its state.
    fn at(&self, state: [f64; N]) -> Point<N> {
        (state, self.field.wave(&state))
    }

    /// The map of this number.
    fn leap(&self, number: usize) -> &Leap<N> {
        let designed = self.field.is_designed();
        let whole = self.whole.as_deref().filter(|_| number == ONE);
        self.leaps[number].get_or_init(|| {
            Box::new(match (whole, number) {
                (Some(jump), _) => jump.leap(designed),
                (None, 0) => {
                    Jump::new(&self.field, 0.25 * self.longest, self.degree).leap(designed)
                }
                (None, _) => self.leap(number - 1).doubled(&self.field),
            })
        })
    }

    /// What parts of a step do; where any step is true, of one of this length.
    fn powers(&self, length: f64) -> &Powers<N> {
        let whole = match self.longest.is_finite() {
            true => self.longest,
            false => length,
        };
        self.powers
            .get_or_init(|| Powers::new(&self.field, whole, self.degree))
    }

    /// How often a step may be doubled and be no longer than this.
    fn doublings(&self, limit: f64) -> usize {
        let within = |doublings: &usize| self.longest * (*doublings as f64).exp2() <= limit;
        let most = if self.whole.is_some() { LEAPS - ONE } else { 1 };
        (1..most).take_while(within).last().unwrap_or(0)
    }

    /// Numbers of the maps that make so many steps on end: of few steps and states none is doubled.
    fn numbers(steps: u64) -> impl Iterator<Item = usize> {
        let alone = if N <= FEW && steps <= FEW as u64 {
            steps
        } else {
            0
        };
        let (doubled, top) = (steps - alone, LEAPS - 1);
        let largest = repeat_n(top, (doubled >> (top - ONE)) as usize);
        let numbers = (ONE..top).filter(move |number| doubled >> (number - ONE) & 1 == 1);
        repeat_n(ONE, alone as usize).chain(numbers).chain(largest)
    }

    /// How far the dense output of a step of this length is off, relative to the magnitude of the motion.
    fn error(&self, length: f64) -> f64 {
        self.error * (length / self.longest).powi(8)
    }
}
