//! The mode of every press: its gap decides, and the sign of its force; where either vanishes, its rate.

use super::ExactFlow;
use super::guard::Departure;
use super::settle::{Rest, Verdict};
use crate::field::exact::{Mode, Modes};
use crate::flow::FlowError;
use crate::model::Model;
use crate::scalar::Lanes;

/// Rounding error of a gap or of what holds a press closed, in units of its terms.
const ROUNDING: f64 = 4.0 * f64::EPSILON;
/// Speed at a closed gap, in units of its terms, below which a contact that does not give way may stay closed.
const RESTS: f64 = 1e-13;
/// The same where it was closed before.
const STAYS: f64 = 1e-11;
/// Distance on the wrong side of its gap, relative to its scale, from which a motion may still depart.
const WRONG_SIDE: f64 = 1e-6;

/// Order of the lowest derivative of a gap that does not vanish where its reaction does, unless friction drops there.
const TANGENTIAL: usize = 3;

/// What is known to vanish at a press.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Vanishing {
    /// Whatever is as small as rounding errors.
    Rounded,
    /// The gap.
    Gap,
    /// What holds it closed.
    Hold,
    /// The gap and its rate.
    Both,
}

/// The modes of all presses, and which of their guards vanish where the motion goes on.
pub(super) struct Presses<M: Model<N>, const N: usize> {
    pub(super) modes: Modes<M, N>,
    /// Those that do not give way and whose gaps neither open nor close: whether they bear, their reactions say.
    pub(super) closed: Vec<usize>,
    departures: Vec<(usize, Departure)>,
}

impl<M: Model<N>, const N: usize> Presses<M, N> {
    /// Decides about contacts at rest, and takes over which guards of presses vanish.
    ///
    /// # Errors
    /// Those of [`Rest::settle`].
    pub(super) fn settle(&self, mut rest: Rest<'_, M, N>) -> Result<Verdict<M, N>, FlowError> {
        let mut verdict = rest.settle()?;
        for (press, departure) in &self.departures {
            let drops = departure.order == TANGENTIAL && rest.drops(*press);
            let order = departure.order - usize::from(drops);
            let note = &mut verdict.notes.as_mut()[*press];
            (note.side, note.departure) = (departure.side, order);
        }
        Ok(verdict)
    }
}

impl<M: Model<N>, const N: usize> ExactFlow<M, N> {
    /// The numbers of the presses among all contacts.
    pub(super) fn presses() -> std::ops::Range<usize> {
        let first = M::INFO.contacts.len();
        first..first + M::INFO.presses.len()
    }

    /// The modes with which a motion goes on from `state`, presses as their gaps are, and what they press loose or not.
    ///
    /// # Errors
    /// The forces are not determined there.
    pub(super) fn with_presses(
        &self,
        state: &[f64; N],
        modes: Modes<M, N>,
        vanishing: &dyn Fn(usize) -> Option<Vanishing>,
    ) -> Result<Presses<M, N>, FlowError> {
        let mut presses = Presses {
            modes,
            closed: Vec::new(),
            departures: Vec::new(),
        };
        if const { Modes::<M, N>::PRESSED } {
            self.judge(&mut presses, state, vanishing)?;
        }
        Ok(presses)
    }

    /// Finds the mode of each press.
    fn judge(
        &self,
        presses: &mut Presses<M, N>,
        state: &[f64; N],
        vanishing: &dyn Fn(usize) -> Option<Vanishing>,
    ) -> Result<(), FlowError> {
        let modes = presses.modes;
        for press in Self::presses() {
            let rests = modes.as_slice()[press] == Mode::Rest;
            let Some(vanishing) = vanishing(press) else {
                presses.closed.extend(rests.then_some(press));
                continue;
            };
            if M::INFO.is_rigid(press) {
                match self.flies(state, press, vanishing, rests)? {
                    Some(departure) => {
                        presses.modes.set(press, Mode::Open);
                        presses.departures.push((press, departure));
                    }
                    None => {
                        presses.modes.set(press, Mode::Rest);
                        presses.closed.push(press);
                    }
                }
            } else {
                let (mode, departure) = self.judged(state, &modes, press, vanishing)?;
                presses.modes.set(press, mode);
                presses.departures.push((press, departure));
            }
        }
        presses.modes = self.system.pressed(presses.modes, state);
        Ok(())
    }

    /// The magnitude of the terms of what holds a press closed: of its force, and of the states in its depth and rate.
    pub(super) fn hold_scale(
        &self,
        state: &[f64; N],
        modes: &Modes<M, N>,
        press: usize,
    ) -> Result<f64, FlowError> {
        let at = self.system.linear(state, modes)?;
        let (slopes, _): ([f64; N], f64) = at.stick.as_ref()[press].slopes();
        let terms = slopes.iter().zip(state).map(|(slope, y)| (slope * y).abs());
        let own = if modes.as_slice()[press] == Mode::Rest {
            self.system.terms_of_reaction(state, modes, press)
        } else {
            self.system.terms_of_hold(state, press)
        };
        Ok(terms.sum::<f64>() + own)
    }

    /// The mode of one press, and which of its guards vanishes.
    fn judged(
        &self,
        state: &[f64; N],
        modes: &Modes<M, N>,
        press: usize,
        vanishing: Vanishing,
    ) -> Result<(Mode, Departure), FlowError> {
        let mut closed = *modes;
        closed.set(press, Mode::Closed);
        let at = self.system.moving(state, &closed)?;
        let (gap, hold) = (at.speed.as_ref()[press], at.stick.as_ref()[press]);
        let scale = self.speed_scales(state).as_ref()[press];
        let is_small = |value: f64, terms: f64| value.abs() <= ROUNDING * terms;
        let terms = self.hold_scale(state, &closed, press)?;
        let vanishing = match vanishing {
            Vanishing::Rounded if is_small(gap.re, scale) => Vanishing::Gap,
            Vanishing::Rounded if gap.re < 0.0 && is_small(hold.re, terms) => Vanishing::Hold,
            known => known,
        };
        let side = f64::from(u8::from(vanishing == Vanishing::Hold));
        let pressing = |pushes: bool| if pushes { Mode::Closed } else { Mode::Parted };
        let first = Departure { side, order: 1 };
        Ok(match vanishing {
            Vanishing::Gap | Vanishing::Both if gap.eps < 0.0 => (pressing(hold.re >= 0.0), first),
            Vanishing::Gap | Vanishing::Both if gap.eps > 0.0 => (Mode::Open, first),
            Vanishing::Gap | Vanishing::Both => {
                let mut open = *modes;
                open.set(press, Mode::Open);
                let field = self.system.moving(state, &open)?.field;
                let bend = self.system.second_rates(state, &open, &field);
                let closes = bend.as_ref()[press] < 0.0;
                let mode = if closes { Mode::Closed } else { Mode::Open };
                (mode, Departure { side, order: 2 })
            }
            Vanishing::Hold => (pressing(hold.eps >= 0.0), first),
            Vanishing::Rounded if gap.re > 0.0 => (Mode::Open, Departure::default()),
            Vanishing::Rounded => (pressing(hold.re > 0.0), Departure::default()),
        })
    }

    /// How a press that does not give way leaves its surface, or is off it; `None` where its gap is closed and neither opens
    /// nor closes.
    ///
    /// # Errors
    /// The gap is below zero, or is to close further although it `rests`.
    fn flies(
        &self,
        state: &[f64; N],
        press: usize,
        vanishing: Vanishing,
        rests: bool,
    ) -> Result<Option<Departure>, FlowError> {
        let order = |order: usize| Ok(Some(Departure { side: 0.0, order }));
        let gap = self.system.speeds(state).as_ref()[press];
        let scale = self.speed_scales(state).as_ref()[press];
        let touches = match vanishing {
            Vanishing::Both => return Ok(None),
            Vanishing::Hold => return order(TANGENTIAL),
            Vanishing::Gap => true,
            Vanishing::Rounded => {
                let usual = scale.max(self.system.usual_speed(press));
                rests || (gap <= ROUNDING * scale && gap >= -WRONG_SIDE * usual)
            }
        };
        if !touches && gap < 0.0 {
            return Err(FlowError::Inside {
                contact: M::INFO.contact_id(press),
                gap,
            });
        }
        let (approach, _) = self.system.approach(state, press);
        let still = match rests {
            true => STAYS * self.system.rate_scale(state, press),
            false => RESTS * self.system.rate_terms(state, press),
        };
        if touches && approach.abs() <= still {
            return Ok(None);
        }
        if rests && approach > 0.0 {
            return Err(FlowError::HitTogether {
                contacts: vec![M::INFO.contact_id(press)],
                time: 0.0,
            });
        }
        order(usize::from(touches && approach < 0.0))
    }

    /// Whether each press is as it should be, within what rounding may have done.
    ///
    /// # Errors
    /// A gap that is to be open is closed, or the other way around.
    pub(super) fn check_gaps(
        &self,
        state: &[f64; N],
        modes: &Modes<M, N>,
        time: f64,
    ) -> Result<(), FlowError> {
        if const { !Modes::<M, N>::PRESSED } {
            return Ok(());
        }
        let (gaps, scales) = (self.system.speeds(state), self.speed_scales(state));
        for press in Self::presses() {
            let (mode, gap) = (modes.as_slice()[press], gaps.as_ref()[press]);
            let scale = scales.as_ref()[press].max(self.system.usual_speed(press));
            if mode.sign() * gap < -WRONG_SIDE * scale {
                return Err(FlowError::InconsistentMode {
                    contact: M::INFO.contact_id(press),
                    time,
                    mode,
                    speed: gap,
                    rate: 0.0,
                    second_rate: 0.0,
                });
            }
        }
        Ok(())
    }
}
