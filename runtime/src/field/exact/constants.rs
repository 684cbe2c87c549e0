//! What does not depend on the state: gradients of affine speeds, and how forces enter.

use num_dual::Dual64;

use super::affine::{Snapshot, Square, input, speed_rates};
use super::mode::{Mode, Modes};
use super::rule::Branches;
use super::solve::solve;
use crate::field::generic::{GENERIC, generic, generic_state};
use crate::field::strip::{Strip, rows};
use crate::model::Model;
use crate::scalar::{Inline, Scalar, filled, mapped};

/// Seeds of the directions in which all states move.
const ALONG: f64 = 0.713;
const ACROSS: f64 = 0.419;

/// w_y, w_r, B and G of a model in which they are the same at every state and every value of the design variable.
#[derive(Clone, Copy)]
pub(crate) struct Constants<M: Model<N>, const N: usize> {
    /// w_y of each contact.
    pub(crate) gradient: M::PerContact<Strip<N>>,
    /// Bᵢ of each contact.
    pub(crate) input: M::PerContact<Strip<N>>,
    /// G.
    pub(crate) compliance: Square<M, f64, N>,
    /// Bᵢ/Gᵢᵢ: the change of the state that changes one speed by one.
    pub(super) lever: M::PerContact<Strip<N>>,
    /// Which contacts act on the speed of another, or are acted on: where the matrix is not diagonal.
    pub(super) coupled: M::PerContact<bool>,
    /// Which speeds and gaps are affine: all speeds are.
    straight: M::PerContact<bool>,
    /// Whether a contact reads several states, which others may hold with it.
    pub(super) braced: bool,
}

impl<M: Model<N>, const N: usize> Constants<M, N> {
    /// Finds them, or `None` if second derivatives at generic states show that they are not constant: of parameters that
    /// move with the design variable.
    pub(super) fn find(turned: &M::Params<Dual64>) -> Option<Self> {
        let at = |seed| Seen::<M, N>::at(turned, &generic_state::<M, N>(seed));
        let [first, second] = GENERIC.map(at);
        let (first, second) = (first?, second?);
        let rubbing = M::INFO.contacts.len();
        let same = |i: usize| first.gradient.as_ref()[i] == second.gradient.as_ref()[i];
        let pushes_alike = first.input.as_ref() == second.input.as_ref();
        let straight = |i: usize| same(i) && first.straight.as_ref()[i];
        (pushes_alike && (0..rubbing).all(straight)).then(|| Self::of(&first, straight))
    }

    /// What follows from what is the same at every state.
    fn of(seen: &Seen<M, N>, straight: impl Fn(usize) -> bool) -> Self {
        let (gradient, input) = (seen.gradient, seen.input);
        let compliance: Square<M, f64, N> = Inline::from_fn(|i| {
            Inline::from_fn(|j| gradient.as_ref()[i].dot(input.as_ref()[j].entries()))
        });
        let lever = |i: usize| {
            let (mut lever, own) = ([0.0; N], compliance.as_ref()[i].as_ref()[i]);
            if own != 0.0 {
                input.as_ref()[i].add_to(&mut lever, 1.0 / own);
            }
            lever.into()
        };
        let acts = |i: usize, j: usize| compliance.as_ref()[i].as_ref()[j] != 0.0;
        let others = |i: usize| (0..M::INFO.contacts.len()).filter(move |&j| j != i);
        let braced = (0..M::INFO.contacts.len()).any(|i| gradient.as_ref()[i].only().is_none());
        Self {
            gradient,
            lever: Inline::from_fn(lever),
            input,
            coupled: Inline::from_fn(|i| others(i).any(|j| acts(i, j) || acts(j, i))),
            compliance,
            braced,
            straight: Inline::from_fn(straight),
        }
    }

    /// Whether a speed or gap is affine, so that its gradient is known.
    pub(super) fn is_straight(&self, contact: usize) -> bool {
        self.straight.as_ref()[contact]
    }

    /// All that is known at a state, over any scalar; `None` if the sticking forces are not unique.
    pub(super) fn snapshot<D: Scalar>(
        &self,
        params: &M::Params<D>,
        state: &[D; N],
        modes: &Modes<M, N>,
    ) -> Option<Snapshot<M, D, N>> {
        let mut rule = Branches::<M, D, N>::free(modes.as_slice());
        let mut field = M::rhs(params, *state, &mut rule);
        for contact in modes.sticking() {
            rule.force.as_mut()[contact] = -self.gradient.as_ref()[contact].dot(&field);
        }
        let force = self.respond(modes, rule.force)?;
        for contact in modes.sticking() {
            self.input.as_ref()[contact].add_to(&mut field, force.as_ref()[contact]);
        }
        // They do not change at all, and a rounding error of the forces would be all that moves.
        for contact in modes.sticking() {
            self.gradient.as_ref()[contact].clear_only(&mut field);
        }
        if self.braced {
            field = self.brace(modes, field);
        }
        Some(Snapshot {
            field,
            speed: rule.speed,
            force,
            stick: rule.stick,
        })
    }

    /// The states that are themselves the speeds of contacts that stick.
    pub(super) fn still(&self, modes: &Modes<M, N>) -> impl Iterator<Item = usize> {
        let gradients = self.gradient.as_ref();
        modes
            .sticking()
            .filter_map(|contact| gradients[contact].only())
    }

    /// The same of all states that sticking contacts hold between them. By value, so that a field that is not braced stays
    /// in registers.
    #[inline(never)]
    fn brace<D: Scalar>(&self, modes: &Modes<M, N>, mut field: [D; N]) -> [D; N] {
        let held = self.held(modes).unwrap_or([false; N]);
        for (rate, held) in field.iter_mut().zip(held) {
            if held {
                *rate = D::from(0.0);
            }
        }
        field
    }

    /// The states that sticking contacts read, if those are as many: together they leave none of them any way.
    pub(super) fn held(&self, modes: &Modes<M, N>) -> Option<[bool; N]> {
        if !self.braced {
            return None;
        }
        let mut read = [false; N];
        for contact in modes.sticking() {
            for (state, slope) in self.gradient.as_ref()[contact].iter() {
                read[state] |= slope != 0.0;
            }
        }
        let count = read.iter().filter(|read| **read).count();
        (count == modes.sticking().count()).then_some(read)
    }

    /// The forces of the sticking contacts that change their speeds at these rates: G_SS⁻¹ w_S; elsewhere as given.
    pub(super) fn respond<D: Scalar>(
        &self,
        modes: &Modes<M, N>,
        mut rates: M::PerContact<D>,
    ) -> Option<M::PerContact<D>> {
        let coupled = |i: usize| self.coupled.as_ref()[i];
        if modes.sticking().any(coupled) {
            let mut rows: Square<M, D, N> = Inline::from_fn(|i| {
                Inline::from_fn(|j| D::from(self.compliance.as_ref()[i].as_ref()[j]))
            });
            let stuck = |i: usize| coupled(i) && modes.as_slice()[i] == Mode::Stick;
            let set: M::PerContact<bool> = Inline::from_fn(stuck);
            solve(rows.as_mut(), rates.as_mut(), set.as_ref())?;
        }
        for contact in modes.sticking().filter(|&i| !coupled(i)) {
            let compliance = self.compliance.as_ref()[contact].as_ref()[contact];
            if compliance == 0.0 {
                return None;
            }
            rates.as_mut()[contact] /= D::from(compliance);
        }
        Some(rates)
    }
}

/// What one state shows.
struct Seen<M: Model<N>, const N: usize> {
    gradient: M::PerContact<Strip<N>>,
    input: M::PerContact<Strip<N>>,
    straight: M::PerContact<bool>,
}

impl<M: Model<N>, const N: usize> Seen<M, N> {
    /// At this state. What is constant does not change along a way on which all states and the design variable move, none as
    /// fast as another; `None` if a force enters in a way that does.
    fn at(turned: &M::Params<Dual64>, state: &[f64; N]) -> Option<Self> {
        let modes = Modes::held();
        let along = generic::<N>(ALONG);
        let moving = filled(|i| Dual64::new(state[i], along[i]));
        let across = mapped(&generic::<N>(ACROSS), Dual64::from);
        let bend = speed_rates::<M, Dual64, N>(turned, &moving, &modes, &across);
        let plain = Inline::from_fn(|i| turned.as_ref()[i].re);
        let column = |unit: &[f64; N]| speed_rates::<M, f64, N>(&plain, state, &modes, unit);
        let gradient = rows::<M, N>(column);
        let mut forces: M::PerContact<Strip<N>> = Inline::from_fn(|_| Strip::ZERO);
        let rubbing = forces.as_mut().iter_mut().take(M::INFO.contacts.len());
        for (contact, slot) in rubbing.enumerate() {
            let column = input::<M, Dual64, N>(turned, &moving, &modes, contact);
            let mut entries = [0.0; N];
            for (entry, b) in entries.iter_mut().zip(&column) {
                *entry = flat(*b)?;
            }
            *slot = entries.into();
        }
        Some(Self {
            gradient,
            input: forces,
            straight: Inline::from_fn(|i| flat(bend.as_ref()[i]).is_some()),
        })
    }
}

/// The value, if it does not change.
fn flat(number: Dual64) -> Option<f64> {
    (number.eps == 0.0 && number.re.is_finite()).then_some(number.re)
}
