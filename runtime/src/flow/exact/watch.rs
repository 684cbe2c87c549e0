//! Guards watched along a step: their first fall, on polynomials that leave no doubt about it.

use super::forms::{Linear, Models};
use super::guard::{Departure, Guard, Sighting};
use crate::field::exact::{ContactError, ExactSystem, Mode, Modes, Snapshot};
use crate::integrate::Dense;
use crate::integrate::event::Bernstein;
use crate::model::Model;
use crate::scalar::{Inline, mapped};

/// Relative difference between a guard and its interpolant above which the interval is halved.
const RESOLVED: f64 = 1e-6;
/// Halvings after which the interpolant is taken as it is.
const HALVINGS: u32 = 10;
/// Rounding error of a guard's coefficients relative to the terms of the guard, of its interpolant more.
const NOISE: f64 = 16.0 * f64::EPSILON;
const SAMPLED_NOISE: f64 = 128.0 * f64::EPSILON;
/// What the slope of a polynomial of degree 7 may be off, over what the polynomial is.
const WAVY: f64 = 16.0;
/// Places where the interpolant is checked, away from its nodes.
const CHECKS: [f64; 2] = [0.27, 0.62];

/// Watches all guards along one step.
pub(super) struct Watch<'a, M: Model<N>, const N: usize> {
    pub(super) system: &'a ExactSystem<M, N>,
    pub(super) modes: &'a Modes<M, N>,
    pub(super) dense: &'a Dense<N>,
    /// How far that is off, relative to the magnitude of the motion.
    pub(super) blur: f64,
    /// What is known of a linear stretch.
    pub(super) linear: Option<&'a Linear<'a, M, N>>,
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
                    Some(gradients) if guard.is_affine(self.system) => {
                        let sign = mode.sign();
                        let along = self
                            .dense
                            .along(self.speeds.as_ref()[i], |term| gradients[i].dot(term));
                        let oriented = if sign > 0.0 { along } else { along.negated() };
                        let terms = self.scales.as_ref()[i].max(oriented.magnitude());
                        let heard = oriented.without_noise(NOISE * terms);
                        let off = self.linear.map_or(0.0, |one| one.error(&gradients[i]));
                        self.judge(guard, &heard, (terms, off), (0.0, 1.0));
                    }
                    _ => sampled = true,
                }
            }
        }
        match self.linear {
            _ if !sampled => Ok(()),
            Some(linear) => {
                let way = linear.along(self.dense);
                self.judge_all(
                    &way.guards,
                    &|i, place| way.errors.as_ref()[i][place],
                    (0.0, 1.0),
                );
                Ok(())
            }
            None => self.sample(0.0, 1.0, HALVINGS),
        }
    }

    /// Watches one guard, whose terms are of this magnitude and which is off by as much besides, on a piece of the step.
    fn judge(
        &mut self,
        guard: Guard,
        polynomial: &Bernstein,
        (terms, off): (f64, f64),
        (from, width): (f64, f64),
    ) {
        let departure = self.departure.as_ref()[guard.contact];
        let begins = from == 0.0 && departure.side == guard.side;
        let order = if begins { departure.order } else { 0 };
        let error = self.blur * terms + off;
        if order == 0 && self.nearest.is_none() && polynomial.lower_bound() >= error {
            return;
        }
        let rest = polynomial.deflated(order);
        // What touches zero by no more than rounding errors does not fall. A gap that has just opened may close by less.
        let rubs = self.modes.as_slice()[guard.contact].rubs();
        let touches = |theta| (order == 0 || rubs) && polynomial.depth(theta) <= NOISE * terms;
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
            // Along a doubled step what keeps still is known as states are, and has no minima but those of their errors.
            let noise = if off > 0.0 {
                WAVY * (off + SAMPLED_NOISE * terms)
            } else {
                0.0
            };
            let slope = polynomial.derivative().without_noise(noise);
            let slope = slope.deflated(order.saturating_sub(1));
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
        self.judge_all(&models, &|_, _| 0.0, (from, width));
        Ok(())
    }

    /// Watches the guards that are not affine, which are off by as much besides, on a piece of the step.
    fn judge_all(
        &mut self,
        models: &Models<M, N>,
        off: &dyn Fn(usize, usize) -> f64,
        piece: (f64, f64),
    ) {
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
                if !still && !guard.is_affine(self.system) {
                    let off = off(contact, place);
                    self.judge(guard, &heard, (terms, off), piece);
                }
            }
        }
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

    /// The guards that are not, each with its place among those of its contact.
    fn each_sampled(&self, mut visit: impl FnMut(usize, Guard)) {
        for (i, mode) in self.modes.as_slice().iter().enumerate() {
            if !self.system.is_idle(i) {
                let guards = Guard::of(i, *mode).enumerate();
                for (place, guard) in guards.filter(|(_, guard)| !guard.is_affine(self.system)) {
                    visit(place, guard);
                }
            }
        }
    }
}
