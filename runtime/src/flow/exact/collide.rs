//! Impacts with the friction that they cause: it sticks or slides as Coulomb's law says of impulses.

use super::ExactFlow;
use crate::field::exact::{ExactField, Impact, Impulses, Mode, Modes};
use crate::flow::{FlowError, Place};
use crate::integrate::Carried;
use crate::model::Model;

/// Contacts under one press among which all combinations are searched.
const SEARCHED: usize = 6;
/// Relative difference between rates at which friction grows with a reaction that is rounding error.
const SAME: f64 = 1e-9;
/// Work of impulses, relative to that of the press at the terms of its speed, that is rounding error.
const NO_WORK: f64 = 1e-12;

/// An impact, and which impulses it has.
pub(super) type Collision<M, const N: usize> = (Impulses<M, N>, Impact<M, f64, N>);

impl<M: Model<N>, const N: usize> ExactFlow<M, N> {
    /// The impact of a press, after which it stays closed if it `lasts`.
    ///
    /// With Λ the impulse of the press and μ how friction grows with its force, friction sticks with |Λ_T| ≤ μ Λ, its
    /// contact at rest after the impact, or slides with μ Λ against the motion after it (Moreau).
    ///
    /// # Errors
    /// No impulses are consistent, or they would do work.
    pub(super) fn collide(
        &self,
        state: &[f64; N],
        press: usize,
        lasts: bool,
        time: f64,
    ) -> Result<Collision<M, N>, FlowError> {
        let rubbing = self.rubbing(state, press, time)?;
        let mut failure = None;
        for code in 0..3_usize.pow(rubbing.len() as u32) {
            let impulses = Impulses {
                press,
                modes: taking_part(press, &rubbing, code),
                lasts,
            };
            match self.system.impact(state, &impulses) {
                Ok(impact) if consistent(&impulses, &impact, &rubbing) => {
                    let energy = work(&impulses, &impact, &rubbing);
                    let terms = self.system.rate_scale(state, press);
                    if energy > NO_WORK * impact.impulse.as_ref()[press].abs() * terms {
                        return Err(FlowError::Gains {
                            contact: M::INFO.contact_id(press),
                            time,
                            energy,
                        });
                    }
                    return Ok((impulses, impact));
                }
                Ok(_) => {}
                Err(error) => {
                    failure.get_or_insert(error);
                }
            }
        }
        Err(match failure {
            Some(error) => error.into(),
            None => FlowError::NoImpulse {
                contact: M::INFO.contact_id(press),
                time,
            },
        })
    }

    /// What a unit speed of approach adds to the state at an impact that is as slow as may be: friction slides as it does, and
    /// what is knocked loose sticks again in no time.
    ///
    /// # Errors
    /// The impulses are not unique, or push the wrong way.
    pub(crate) fn kick(
        &self,
        at: &Place<N, Modes<M, N>>,
        press: usize,
    ) -> Result<[f64; N], FlowError> {
        let (system, state) = (&self.system, &at.state);
        let rubbing = self.rubbing(state, press, 0.0)?;
        let mut modes = taking_part(press, &rubbing, 0);
        let speeds = system.speeds(state);
        for (contact, _) in &rubbing {
            let speed = speeds.as_ref()[*contact];
            modes.set(*contact, Mode::sliding(speed));
        }
        let mut kick = system.kick(state, press, &modes)?;
        let field = ExactField::new(system, at.mode, state)?;
        let off = field.correction(state, &system.rates_along(state, &at.mode, &kick));
        kick.add(-1.0, &off);
        Ok(kick)
    }

    /// The contacts that rub under a press, and how their friction grows with its force.
    fn rubbing(
        &self,
        state: &[f64; N],
        press: usize,
        time: f64,
    ) -> Result<Vec<(usize, f64)>, FlowError> {
        let under = || {
            M::INFO
                .rubs_under(press)
                .filter(|i| !self.system.is_idle(*i))
        };
        if under().next().is_none() {
            return Ok(Vec::new());
        }
        let grips = self.system.grips(state, press);
        let grip = |friction: usize| {
            let [still, moving] = grips.as_ref()[friction];
            if (still - moving).abs() > SAME * (still.abs() + moving.abs()) {
                return Err(FlowError::Impulsive {
                    contact: M::INFO.contact_id(press),
                    friction: M::INFO.contact_id(friction),
                    time,
                });
            }
            Ok((friction, still))
        };
        under().take(SEARCHED).map(grip).collect()
    }
}

/// The press at rest and its friction in one of three modes each, sticking first; nothing else acts.
fn taking_part<M: Model<N>, const N: usize>(
    press: usize,
    rubbing: &[(usize, f64)],
    code: usize,
) -> Modes<M, N> {
    const CHOICES: [Mode; 3] = [Mode::Stick, Mode::SlideForward, Mode::SlideBackward];
    let mut modes = Modes::from_fn(|i| match i {
        i if i == press => Mode::Rest,
        i if i < M::INFO.contacts.len() => Mode::Loose,
        _ => Mode::Open,
    });
    let mut rest = code;
    for (contact, _) in rubbing {
        modes.set(*contact, CHOICES[rest % 3]);
        rest /= 3;
    }
    modes
}

fn consistent<M: Model<N>, const N: usize>(
    impulses: &Impulses<M, N>,
    impact: &Impact<M, f64, N>,
    rubbing: &[(usize, f64)],
) -> bool {
    let push = impact.impulse.as_ref()[impulses.press];
    let all = |(contact, grip): &(usize, f64)| {
        let (mode, i) = (impulses.modes.as_slice()[*contact], *contact);
        match mode {
            Mode::Stick => impact.impulse.as_ref()[i].abs() <= grip * push,
            mode => impact.after.as_ref()[i] * mode.sign() >= 0.0,
        }
    };
    // What begins behind its wall by a rounding error may be on its way out.
    (push >= 0.0 || impulses.lasts) && rubbing.iter().all(all)
}

/// ½ Σ Λ (w⁺ + w⁻): what the impulses add to the kinetic energy.
fn work<M: Model<N>, const N: usize>(
    impulses: &Impulses<M, N>,
    impact: &Impact<M, f64, N>,
    rubbing: &[(usize, f64)],
) -> f64 {
    let push = impact.impulse.as_ref()[impulses.press];
    let friction = |(contact, grip): &(usize, f64)| {
        let mode = impulses.modes.as_slice()[*contact];
        let impulse = match mode {
            Mode::Stick => impact.impulse.as_ref()[*contact],
            mode => -mode.sign() * grip * push,
        };
        impulse * (impact.before.as_ref()[*contact] + impact.after.as_ref()[*contact])
    };
    let own = push * (impact.departure - impact.approach);
    0.5 * (own + rubbing.iter().map(friction).sum::<f64>())
}
