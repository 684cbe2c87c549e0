//! What sticking forces take out of the field and its derivatives, and out of states that are off where contacts stick.

use super::affine::{Affine, NOTHING};
use super::closed::Closed;
use super::constants::Constants;
use super::mode::Modes;
use super::{ExactField, linear_of};
use crate::field::{Linear, Strip};
use crate::model::Model;
use crate::scalar::{Lanes, Scalar};

impl<M: Model<N>, const N: usize> ExactField<'_, M, N> {
    /// The field where contacts stick: a call of its own, so that one where all of them slide saves no registers for it,
    /// and with what becomes of it, as what a call hands back goes through memory.
    #[inline(never)]
    pub(super) fn bound<R>(&self, y: &[f64; N], take: impl FnOnce([f64; N]) -> R) -> R {
        let mut field;
        if let Some(constants) = self.constants {
            field = self.free(&self.system.plain, *y);
            self.each_hold(constants, |gradient, lever| {
                hold(&mut field, gradient, lever);
            });
        } else {
            field = self.probe(&self.system.plain, y);
        }
        take(field)
    }

    /// The derivatives where contacts stick: a call of its own, as [`Self::bound`] is.
    #[inline(never)]
    pub(super) fn linearise_bound<R>(&self, y: &[f64; N], take: impl FnOnce(Linear<N>) -> R) -> R {
        let mut linear;
        if let Some(constants) = self.constants {
            linear = self.linearise_free(y);
            self.each_hold(constants, |gradient, lever| linear.hold(gradient, lever));
        } else {
            let state = crate::scalar::filled(|i| M::Lanes::state(y[i], i));
            linear = linear_of(&self.probe(&self.system.lanes, &state));
        }
        take(linear)
    }

    /// The field by probing, over any scalar; NaN where the sticking forces are not unique.
    #[inline(never)]
    fn probe<D: Scalar>(&self, params: &M::Params<D>, state: &[D; N]) -> [D; N] {
        Affine::new(None, params, state, &self.modes)
            .resolve(params, state, &self.modes)
            .map_or([D::from(f64::NAN); N], |snapshot| snapshot.field)
    }

    /// Hands on w_y and lever of all that holds.
    #[inline(always)]
    fn each_hold(&self, constants: &Constants<M, N>, mut take: impl FnMut(&Strip<N>, &Strip<N>)) {
        if let Some(together) = &self.together {
            let holds = together.holds.as_ref().iter().take(self.sticking);
            holds.for_each(|[gradient, lever]| take(gradient, lever));
        } else {
            let (gradients, levers) = (constants.gradient.as_ref(), constants.lever.as_ref());
            self.stuck().for_each(|i| take(&gradients[i], &levers[i]));
        }
    }

    fn stuck(&self) -> impl Iterator<Item = usize> {
        self.stuck.as_ref().iter().copied().take(self.sticking)
    }

    /// The smallest change of the state by sticking forces that changes the speeds of the sticking
    /// contacts, and the rates of the gaps of presses at rest, by `speeds`: B_S G_SS⁻¹ w_S; zero where the forces are not
    /// unique.
    pub(crate) fn correction(&self, state: &[f64; N], speeds: &M::PerContact<f64>) -> [f64; N] {
        let mut change = [0.0; N];
        if let Some(constants) = self.constants {
            let together = self.together.as_ref();
            let levers = together.map_or(&constants.lever, |together| &together.levers);
            for contact in self.stuck() {
                levers.as_ref()[contact].add_to(&mut change, speeds.as_ref()[contact]);
            }
        } else if self.sticks() {
            let affine = self.system.affine(state, &self.modes);
            if let Some(push) = affine.respond(&self.modes, *speeds) {
                for contact in self.stuck() {
                    let (push, input) = (push.as_ref()[contact], &affine.input.as_ref()[contact]);
                    for (c, b) in change.iter_mut().zip(input) {
                        *c += b * push;
                    }
                }
            }
        }
        change
    }

    /// What takes a state back to where contacts stick and gaps are closed.
    pub(crate) fn drift(&self, state: &[f64; N]) -> [f64; N] {
        if const { Modes::<M, N>::PRESSED } {
            if self.modes.rests() {
                return self.back_to_gaps(state);
            }
        }
        if self.sticks() {
            self.correction(state, &self.system.speeds(state))
        } else {
            [0.0; N]
        }
    }

    /// The same where presses are at rest.
    fn back_to_gaps(&self, state: &[f64; N]) -> [f64; N] {
        let Some(closed) = Closed::new(self.system, state, &self.modes) else {
            return [0.0; N];
        };
        let gaps = self.system.speeds(state);
        let mut change = closed.correction(&gaps);
        let moved = crate::scalar::filled(|i| state[i] - change[i]);
        let rates = self.system.rates(&moved, &self.modes);
        let back = self.correction(&moved, &rates);
        for ((c, b), y) in change.iter_mut().zip(back).zip(state) {
            *c += b;
            if (y - *c).abs() <= NOTHING * y.abs() {
                *c = *y;
            }
        }
        change
    }
}

/// Takes out of `column`, f or a derivative of it, what the sticking force takes out: column − lever (w_y column).
///
/// The lever of one contact moves no other, so that they may follow each other. Nothing is left of a speed that is a state.
#[inline(always)]
fn hold<const N: usize>(column: &mut [f64; N], gradient: &Strip<N>, lever: &Strip<N>) {
    let rate = gradient.dot(column);
    lever.add_to(column, -rate);
    gradient.clear_only(column);
}

impl<const N: usize> Linear<N> {
    /// [`hold`] for f, every column of the Jacobian, and the design column.
    #[inline(always)]
    fn hold(&mut self, gradient: &Strip<N>, lever: &Strip<N>) {
        hold(&mut self.f, gradient, lever);
        hold(&mut self.design, gradient, lever);
        let mut rates = [0.0; N];
        for (j, g) in gradient.iter() {
            for (rate, entry) in rates.iter_mut().zip(&self.jacobian[j]) {
                *rate += g * entry;
            }
        }
        for (j, b) in lever.iter() {
            for (entry, rate) in self.jacobian[j].iter_mut().zip(&rates) {
                *entry -= rate * b;
            }
        }
    }
}
