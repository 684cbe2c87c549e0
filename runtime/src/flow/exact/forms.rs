//! Guards of a linear stretch: each is linear, too, and known without a look at the model.

use std::f64::consts::{FRAC_PI_2, PI};

use super::guard::Guard;
use crate::field::exact::{ExactSystem, Modes};
use crate::field::{Form, GENERIC, Strip, generic_state};
use crate::integrate::Dense;
use crate::integrate::event::Bernstein;
use crate::integrate::linear::LinearStepper;
use crate::model::Model;
use crate::scalar::{Inline, Lanes, dot, filled};

/// Difference between a guard and its form, relative to its terms, above which it is not linear.
const LINEAR: f64 = 1e-9;

/// The guards of each contact, at most two.
pub(super) type Forms<M, const N: usize> = <M as Model<N>>::PerContact<[Option<Form<N>>; 2]>;

/// The guards of each contact, at most two, as polynomials.
pub(super) type Models<M, const N: usize> = <M as Model<N>>::PerContact<[Bernstein; 2]>;

/// The guards in these modes, but for those that are known to be affine; `None` if they are not linear, whatever the field is.
pub(super) fn forms<M: Model<N>, const N: usize>(
    system: &ExactSystem<M, N>,
    modes: &Modes<M, N>,
) -> Option<Forms<M, N>> {
    let guards = |i: usize| {
        let watched = Guard::of(i, modes.as_slice()[i]).enumerate();
        watched.filter(move |(_, guard)| !system.is_idle(i) && !guard.is_affine(system))
    };
    if (0..system.contacts()).all(|i| guards(i).next().is_none()) {
        return Some(Inline::from_fn(|_| [None; 2]));
    }
    let phase = M::INFO.drive;
    let turned = |angle| filled(|i| if Some(i) == phase { angle } else { 0.0 });
    let lanes = system.linear(&[0.0; N], modes).ok()?;
    let mut at = Vec::with_capacity(4);
    let elsewhere = generic_state::<M, N>(GENERIC[0]);
    for state in [turned(0.0), turned(FRAC_PI_2), turned(PI), elsewhere] {
        at.push(system.snapshot(&state, modes).ok()?);
    }
    let wave = phase.map_or([1.0, 1.0, 0.0], |phase| {
        [1.0, elsewhere[phase].cos(), elsewhere[phase].sin()]
    });
    let mut linear = true;
    let forms = Inline::from_fn(|i| {
        let mut both = [None; 2];
        for (place, guard) in guards(i) {
            let (gradient, _) = guard.value(modes, &lanes).slopes();
            let values = [0, 1, 2].map(|k| guard.value(modes, &at[k]));
            let form = Form::new(gradient, values, phase);
            let off = form.value(&elsewhere, &wave) - guard.value(modes, &at[3]);
            linear &= off.abs() <= LINEAR * form.terms(&elsewhere, &wave);
            both[place] = Some(form);
        }
        both
    });
    linear.then_some(forms)
}

/// What is known of the guards along one step of a linear stretch.
pub(super) struct Linear<'a, M: Model<N>, const N: usize> {
    forms: &'a Forms<M, N>,
    /// How far the dense output is off in each state, beside what is relative to the magnitude of the motion.
    errors: &'a [f64; N],
    /// The way of the wave along the step, and how far that is off; `None` without a drive, or where no form asks for it.
    wave: Option<(Dense<3>, [f64; 3])>,
}

/// Guards along a step, and how far each is off.
pub(super) struct Way<M: Model<N>, const N: usize> {
    pub(super) guards: Models<M, N>,
    pub(super) errors: M::PerContact<[f64; 2]>,
}

impl<'a, M: Model<N>, const N: usize> Linear<'a, M, N> {
    /// Along the last attempt at a step.
    pub(super) fn new(forms: &'a Forms<M, N>, stepper: &'a LinearStepper<'_, N>) -> Self {
        let asked = forms.as_ref().iter().flatten().any(Option::is_some);
        Self {
            forms,
            errors: stepper.errors(),
            wave: if asked { stepper.wave() } else { None },
        }
    }

    /// All guards along the step with this dense output.
    pub(super) fn along(&self, dense: &Dense<N>) -> Way<M, N> {
        let nothing = Bernstein::new(&[0.0; 8]);
        let mut errors: M::PerContact<[f64; 2]> = Inline::from_fn(|_| [0.0; 2]);
        let guards = Inline::from_fn(|i| {
            let mut both = [nothing; 2];
            for (place, form) in self.forms.as_ref()[i].iter().enumerate() {
                let Some(Form { row, wave: factors }) = form else {
                    continue;
                };
                let still = row.dot(dense.start()) + factors[0];
                let (mut way, mut error) =
                    (dense.along(still, |term| row.dot(term)), self.error(row));
                if let Some((wave, off)) = &self.wave {
                    let turning = [0.0, factors[1], factors[2]];
                    let begins = dot(&turning, wave.start());
                    way = way.plus(&wave.along(begins, |term| dot(&turning, term)));
                    error += dot(&turning.map(f64::abs), off);
                }
                (both[place], errors.as_mut()[i][place]) = (way, error);
            }
            both
        });
        Way { guards, errors }
    }

    /// How far a number with this gradient is off.
    pub(super) fn error(&self, gradient: &Strip<N>) -> f64 {
        gradient
            .iter()
            .map(|(j, slope)| slope.abs() * self.errors[j])
            .sum()
    }
}
