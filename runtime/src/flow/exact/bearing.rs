//! Which presses at closed gaps bear: those whose reactions push, where no other gap closes further.

use super::ExactFlow;
use super::guard::Departure;
use super::press::Presses;
use super::settle::{Rest, Verdict};
use crate::field::exact::{Mode, Modes};
use crate::flow::FlowError;
use crate::model::Model;

/// Presses among which all combinations are searched.
const SEARCHED: usize = 8;
/// A reaction, or what a gap does without it, that is rounding error, relative to its terms.
const NOTHING: f64 = 1e-11;

impl<M: Model<N>, const N: usize> ExactFlow<M, N> {
    /// The modes of all contacts: of the combinations of presses that bear the first that holds together, beginning with
    /// all that could; `rest` says which contacts have no relative speed then.
    ///
    /// # Errors
    /// No combination does.
    pub(super) fn borne<'s>(
        &'s self,
        state: &[f64; N],
        time: f64,
        presses: &Presses<M, N>,
        rest: &dyn Fn(Modes<M, N>) -> Rest<'s, M, N>,
    ) -> Result<Verdict<M, N>, FlowError> {
        if const { Modes::<M, N>::PRESSED } {
            if !presses.closed.is_empty() {
                return self.bearing(state, time, presses, rest);
            }
        }
        presses.settle(rest(presses.modes))
    }

    /// The same where gaps are closed.
    fn bearing<'s>(
        &'s self,
        state: &[f64; N],
        time: f64,
        presses: &Presses<M, N>,
        rest: &dyn Fn(Modes<M, N>) -> Rest<'s, M, N>,
    ) -> Result<Verdict<M, N>, FlowError> {
        let (closed, mut failure) = (&presses.closed, None);
        for bearing in combinations(closed.len()) {
            let mut modes = presses.modes;
            for (k, press) in closed.iter().enumerate() {
                let bears = k >= SEARCHED || bearing >> k & 1 == 1;
                modes.set(*press, if bears { Mode::Rest } else { Mode::Open });
            }
            let rest = rest(self.system.pressed(modes, state));
            let settled = presses.settle(rest).and_then(|mut verdict| {
                let holds = self.bears(state, closed, &mut verdict)?;
                Ok(holds.then_some(verdict))
            });
            match settled {
                Ok(Some(verdict)) => return Ok(verdict),
                Ok(None) => {}
                Err(error) => {
                    failure.get_or_insert(error);
                }
            }
        }
        let contacts = closed.iter().map(|&i| M::INFO.contact_id(i)).collect();
        Err(failure.unwrap_or(FlowError::NotBorne { contacts, time }))
    }

    /// Whether every reaction pushes, and every gap without one opens; notes to which order it does.
    fn bears(
        &self,
        state: &[f64; N],
        closed: &[usize],
        verdict: &mut Verdict<M, N>,
    ) -> Result<bool, FlowError> {
        let moving = self.system.moving(state, &verdict.modes)?;
        let bends = self
            .system
            .second_rates(state, &verdict.modes, &moving.field);
        for &press in closed {
            let mut held = verdict.modes;
            held.set(press, Mode::Rest);
            let terms = NOTHING * self.system.terms_of_reaction(state, &held, press);
            if verdict.modes.as_slice()[press] == Mode::Rest {
                let reaction = moving.stick.as_ref()[press];
                let pushes = reaction.re > terms || (reaction.re >= -terms && reaction.eps >= 0.0);
                if !pushes {
                    return Ok(false);
                }
                continue;
            }
            let bend = bends.as_ref()[press];
            let none = terms * self.compliance(state, &held, press);
            if bend < -none {
                return Ok(false);
            }
            let order = if bend > none { 2 } else { 3 };
            let departure = Departure { side: 0.0, order };
            let note = &mut verdict.notes.as_mut()[press];
            (note.side, note.departure) = (departure.side, departure.order);
        }
        Ok(true)
    }

    /// What a unit reaction does to the rate of its gap.
    fn compliance(&self, state: &[f64; N], modes: &Modes<M, N>, press: usize) -> f64 {
        let affine = self.system.affine(state, modes);
        affine.compliance.as_ref()[press].as_ref()[press].abs()
    }
}

/// All subsets of so many as bits, those with more members first.
fn combinations(count: usize) -> Vec<usize> {
    let mut all: Vec<usize> = (0..1 << count.min(SEARCHED)).rev().collect();
    all.sort_by_key(|bits| std::cmp::Reverse(bits.count_ones()));
    all
}
