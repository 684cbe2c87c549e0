//! Guards: functions of the state that are positive while a contact keeps its mode, watched along a step.

use crate::field::exact::{ContactError, ExactSystem, Mode, Modes, Snapshot};
use crate::integrate::Dense;
use crate::integrate::event::Bernstein;
use crate::model::Model;
use crate::scalar::{Inline, Scalar, mapped};

/// Relative difference between a guard and its interpolant above which the interval is halved.
const RESOLVED: f64 = 1e-6;
/// Halvings after which the interpolant is taken as it is.
const HALVINGS: u32 = 10;
/// Rounding error of a guard's coefficients relative to the terms of the guard, of its interpolant more.
const NOISE: f64 = 16.0 * f64::EPSILON;
const SAMPLED_NOISE: f64 = 128.0 * f64::EPSILON;
/// Places where the interpolant is checked, away from its nodes.
const CHECKS: [f64; 2] = [0.27, 0.62];

/// What ends the mode of a contact when it falls through zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Guard {
    /// Number of the contact.
    pub(super) contact: usize,
    /// The force limit that a sticking contact meets: stick − side·λ; 0 for the speed of a sliding one, and for the gap of
    /// a press, 1 for what holds that closed.
    pub(super) side: f64,
}

impl Guard {
    /// The guards of a contact in this mode.
    pub(super) fn of(contact: usize, mode: Mode) -> impl Iterator<Item = Self> {
        let sides: &[f64] = match mode {
            Mode::Stick => &[1.0, -1.0],
            Mode::SlideForward | Mode::SlideBackward | Mode::Open => &[0.0],
            Mode::Closed | Mode::Parted => &[0.0, 1.0],
            Mode::Rest => &[1.0],
            Mode::Loose | Mode::PinnedForward | Mode::PinnedBackward => &[],
        };
        sides.iter().map(move |&side| Self { contact, side })
    }

    /// Its value over any scalar.
    pub(super) fn value<M: Model<N>, D: Scalar, const N: usize>(
        &self,
        modes: &Modes<M, N>,
        at: &Snapshot<M, D, N>,
    ) -> D {
        let i = self.contact;
        match modes.as_slice()[i] {
            mode if self.side == 0.0 => at.speed.as_ref()[i] * mode.sign(),
            Mode::Closed | Mode::Rest => at.stick.as_ref()[i],
            Mode::Parted => -at.stick.as_ref()[i],
            _ => at.stick.as_ref()[i] - at.force.as_ref()[i] * self.side,
        }
    }
}

/// Where a guard falls, or comes nearest to falling, on the dense output of a step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Sighting {
    pub(super) guard: Guard,
    /// Where on the step, in [0, 1].
    pub(super) theta: f64,
    /// Up to where it has not risen again.
    pub(super) until: f64,
    /// How far below zero its parabola there reaches before it turns back; infinite if it does not turn.
    pub(super) depth: f64,
}

/// The guards of each contact, at most two, as polynomials.
type Models<M, const N: usize> = <M as Model<N>>::PerContact<[Bernstein; 2]>;

/// Watches all guards along one step.
pub(super) struct Watch<'a, M: Model<N>, const N: usize> {
    pub(super) system: &'a ExactSystem<M, N>,
    pub(super) modes: &'a Modes<M, N>,
    pub(super) dense: &'a Dense<N>,
    /// How far that is off, relative to the magnitude of the motion.
    pub(super) blur: f64,
    /// wᵢ at the beginning of the step.
    pub(super) speeds: &'a M::PerContact<f64>,
    /// Magnitude of the terms of wᵢ.
    pub(super) scales: &'a M::PerContact<f64>,
    /// How many derivatives of each guard vanish at the beginning of the step.
    pub(super) departure: &'a M::PerContact<Departure>,
    /// The first fall.
    pub(super) fall: Option<Sighting>,
    /// Whether a guard comes so near to zero that it may fall, or not, or elsewhere.
    pub(super) doubtful: bool,
    /// Local minima that stay positive, if they are wanted.
    pub(super) nearest: Option<&'a mut Vec<Sighting>>,
}

/// Which guard vanishes where a motion begins, and to which order.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct Departure {
    /// Side of the guard; 0 for a speed.
    pub(super) side: f64,
    /// Number of vanishing coefficients.
    pub(super) order: usize,
}

/// Largest error of the dense output θ³ (1 − θ)³ (θ − a)(θ − b) after division by 1, θ, θ² and θ³, over that before.
const DEFLATED: [f64; 4] = [1.0, 5.0, 35.0, 770.0];

/// Whether a polynomial that is off by as much need not fall as it does: a little lower, it would fall at all, or once more
/// before, or it does not go down so far.
fn is_doubtful(polynomial: &Bernstein, fall: Option<(f64, f64)>, error: f64) -> bool {
    let Some((_, lower_until)) = polynomial.raised(-error).first_fall() else {
        return false;
    };
    fall.is_none_or(|(theta, until)| lower_until < theta || polynomial.value(until) > -error)
}

impl<M: Model<N>, const N: usize> Watch<'_, M, N> {
    /// Finds the first fall of any guard.
    ///
    /// # Errors
    /// Sticking forces that are not unique on the way.
    pub(super) fn run(&mut self) -> Result<(), ContactError> {
        let gradients = self.system.gradients();
        let mut sampled = false;
        let modes = self.modes.as_slice().iter().enumerate();
        for (i, mode) in modes.filter(|(i, _)| !self.system.is_idle(*i)) {
            for guard in Guard::of(i, *mode) {
                match gradients {
                    Some(gradients) if self.is_affine(guard) => {
                        let sign = mode.sign();
                        let along = self
                            .dense
                            .along(self.speeds.as_ref()[i], |term| gradients[i].dot(term));
                        let oriented = if sign > 0.0 { along } else { along.negated() };
                        let terms = self.scales.as_ref()[i].max(oriented.magnitude());
                        let heard = oriented.without_noise(NOISE * terms);
                        self.judge(guard, &heard, terms, (0.0, 1.0));
                    }
                    _ => sampled = true,
                }
            }
        }
        if sampled {
            self.sample(0.0, 1.0, HALVINGS)
        } else {
            Ok(())
        }
    }

    /// Watches one guard, whose terms are of this magnitude, on a piece of the step.
    fn judge(
        &mut self,
        guard: Guard,
        polynomial: &Bernstein,
        terms: f64,
        (from, width): (f64, f64),
    ) {
        let departure = self.departure.as_ref()[guard.contact];
        let begins = from == 0.0 && departure.side == guard.side;
        let order = if begins { departure.order } else { 0 };
        let error = self.blur * terms;
        if order == 0 && self.nearest.is_none() && polynomial.lower_bound() >= error {
            return;
        }
        let rest = polynomial.deflated(order);
        // What touches zero by no more than rounding errors does not fall.
        let touches = |theta| order == 0 && polynomial.depth(theta) <= NOISE * terms;
        let fall = rest.first_fall().filter(|(theta, _)| !touches(*theta));
        self.doubtful |=
            error > NOISE * terms && is_doubtful(&rest, fall, error * DEFLATED[order.min(3)]);
        if let Some((theta, until)) = fall {
            let theta = from + width * theta;
            if self.fall.is_none_or(|fall| theta < fall.theta) {
                let until = from + width * until;
                let depth = polynomial.depth((theta - from) / width);
                self.fall = Some(Sighting {
                    guard,
                    theta,
                    until,
                    depth,
                });
            }
        }
        if let Some(nearest) = &mut self.nearest {
            let slope = polynomial.derivative().deflated(order.saturating_sub(1));
            for change in slope.sign_changes().iter().filter(|change| change.rising) {
                if polynomial.value(change.theta) > 0.0 {
                    let theta = from + width * change.theta;
                    nearest.push(Sighting {
                        guard,
                        theta,
                        until: theta,
                        depth: 0.0,
                    });
                }
            }
        }
    }

    /// Interpolates the guards that are not affine, on halves of halves until the interpolant is true.
    fn sample(&mut self, from: f64, width: f64, halvings: u32) -> Result<(), ContactError> {
        let mut values: M::PerContact<[[f64; 8]; 2]> = Inline::from_fn(|_| [[0.0; 8]; 2]);
        for (k, node) in Bernstein::nodes().iter().enumerate() {
            let at = self.snapshot(from + width * node)?;
            self.each_sampled(|place, guard| {
                values.as_mut()[guard.contact][place][k] = guard.value(self.modes, &at);
            });
        }
        let models: Models<M, N> =
            Inline::from_fn(|i| mapped(&values.as_ref()[i], |v| Bernstein::interpolate(&v)));
        if halvings > 0 && !self.resolved(&models, from, width)? {
            self.sample(from, 0.5 * width, halvings - 1)?;
            if self.fall.is_none_or(|fall| fall.theta > from + 0.5 * width) {
                self.sample(from + 0.5 * width, 0.5 * width, halvings - 1)?;
            }
            return Ok(());
        }
        for (contact, mode) in self.modes.as_slice().iter().enumerate() {
            if self.system.is_idle(contact) {
                continue;
            }
            let pair = &models.as_ref()[contact];
            let terms = self.terms(contact, pair);
            for (place, guard) in Guard::of(contact, *mode).enumerate() {
                let terms = terms[place];
                let heard = pair[place].without_noise(SAMPLED_NOISE * terms);
                // What never comes near to letting go has no minimum but that of its rounding errors.
                let still = guard.side != 0.0
                    && mode.is_of_press()
                    && heard.derivative().magnitude() <= RESOLVED * heard.lower_bound();
                if !still && !self.is_affine(guard) {
                    self.judge(guard, &heard, terms, (from, width));
                }
            }
        }
        Ok(())
    }

    /// The magnitudes of the terms of both guards of a contact: those of a press have nothing in common.
    fn terms(&self, contact: usize, pair: &[Bernstein; 2]) -> [f64; 2] {
        let scale = self.scales.as_ref()[contact];
        let [first, second] = [pair[0].magnitude(), pair[1].magnitude()];
        match self.modes.as_slice()[contact] {
            Mode::Rest => [first, second],
            mode if mode.is_of_press() => [first + scale, second],
            _ => [first + second + scale; 2],
        }
    }

    fn resolved(&self, models: &Models<M, N>, from: f64, width: f64) -> Result<bool, ContactError> {
        let mut faithful = true;
        for check in CHECKS {
            let at = self.snapshot(from + width * check)?;
            self.each_sampled(|place, guard| {
                let model = &models.as_ref()[guard.contact][place];
                let off = (model.value(check) - guard.value(self.modes, &at)).abs();
                faithful &= off <= RESOLVED * model.magnitude();
            });
        }
        Ok(faithful)
    }

    fn snapshot(&self, theta: f64) -> Result<Snapshot<M, f64, N>, ContactError> {
        self.system.snapshot(&self.dense.state(theta), self.modes)
    }

    /// Whether a guard is known to be affine.
    fn is_affine(&self, guard: Guard) -> bool {
        guard.side == 0.0 && self.system.is_straight(guard.contact)
    }

    /// The guards that are not, each with its place among those of its contact.
    fn each_sampled(&self, mut visit: impl FnMut(usize, Guard)) {
        for (i, mode) in self.modes.as_slice().iter().enumerate() {
            if !self.system.is_idle(i) {
                let guards = Guard::of(i, *mode).enumerate();
                for (place, guard) in guards.filter(|(_, guard)| !self.is_affine(*guard)) {
                    visit(place, guard);
                }
            }
        }
    }
}
