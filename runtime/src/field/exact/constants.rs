//! What does not depend on the state: gradients of affine speeds, and how forces enter.

use super::affine::{Snapshot, Square, input, speed_rates};
use super::mode::{Mode, Modes};
use super::rule::Branches;
use super::solve::solve;
use super::strip::Strip;
use crate::model::Model;
use crate::scalar::{Inline, Lanes, Scalar};

/// Seeds of two generic states: what is the same at both is taken to be the same everywhere.
pub(super) const GENERIC: [f64; 2] = [0.317, 0.871];

/// w_y, w_r, B and G of a model in which they are the same at every state and every value of the design variable.
#[derive(Clone, Copy)]
pub(crate) struct Constants<M: Model<N>, const N: usize> {
    /// w_y of each contact.
    pub(crate) gradient: M::PerContact<Strip<N>>,
    /// Bᵢ of each contact.
    pub(crate) input: M::PerContact<Strip<N>>,
    /// G.
    pub(crate) compliance: Square<M, f64, N>,
    /// Which contacts act on the speed of another, or are acted on: where the matrix is not diagonal.
    coupled: M::PerContact<bool>,
    /// Which speeds and gaps are affine: all speeds are.
    straight: M::PerContact<bool>,
    /// Whether a contact reads several states, which others may hold with it.
    braced: bool,
}

impl<M: Model<N>, const N: usize> Constants<M, N> {
    /// Finds them, or `None` if second derivatives at generic states show that they are not constant.
    pub(super) fn find(params: &M::Params<M::Lanes>) -> Option<Self> {
        let [first, second] = GENERIC.map(|seed| Self::at(params, &generic_state::<M, N>(seed)));
        let (first, second) = (first?, second?);
        let rubbing = M::INFO.contacts.len();
        let same = |i: usize| first.gradient.as_ref()[i] == second.gradient.as_ref()[i];
        let pushes_alike = first.input.as_ref() == second.input.as_ref();
        let straight = |i: usize| same(i) && first.straight.as_ref()[i];
        (pushes_alike && (0..rubbing).all(straight)).then_some(Self {
            straight: Inline::from_fn(straight),
            ..first
        })
    }

    /// Whether a speed or gap is affine, so that its gradient is known.
    pub(super) fn is_straight(&self, contact: usize) -> bool {
        self.straight.as_ref()[contact]
    }

    fn at(params: &M::Params<M::Lanes>, state: &[f64; N]) -> Option<Self> {
        let modes = Modes::held();
        let lanes: [M::Lanes; N] = crate::scalar::filled(|i| M::Lanes::state(state[i], i));
        let direction = crate::scalar::filled(|i| M::Lanes::constant(generic(i, 0.713)));
        let bend = speed_rates::<M, M::Lanes, N>(params, &lanes, &modes, &direction);
        let mut rule = Branches::<M, M::Lanes, N>::free(modes.as_slice());
        let _ = M::rhs(params, lanes, &mut rule);
        let gradient: M::PerContact<Strip<N>> =
            Inline::from_fn(|i| rule.speed.as_ref()[i].slopes().0.into());
        let mut forces: M::PerContact<Strip<N>> = Inline::from_fn(|_| Strip::ZERO);
        let rubbing = forces.as_mut().iter_mut().take(M::INFO.contacts.len());
        for (contact, slot) in rubbing.enumerate() {
            let column = input::<M, M::Lanes, N>(params, &lanes, &modes, contact);
            let mut entries = [0.0; N];
            for (entry, b) in entries.iter_mut().zip(&column) {
                *entry = flat(b)?;
            }
            *slot = entries.into();
        }
        let compliance: Square<M, f64, N> = Inline::from_fn(|i| {
            Inline::from_fn(|j| gradient.as_ref()[i].dot(forces.as_ref()[j].entries()))
        });
        let acts = |i: usize, j: usize| compliance.as_ref()[i].as_ref()[j] != 0.0;
        let others = |i: usize| (0..M::INFO.contacts.len()).filter(move |&j| j != i);
        let braced = (0..M::INFO.contacts.len()).any(|i| gradient.as_ref()[i].only().is_none());
        Some(Self {
            gradient,
            input: forces,
            coupled: Inline::from_fn(|i| others(i).any(|j| acts(i, j) || acts(j, i))),
            compliance,
            braced,
            straight: Inline::from_fn(|i| flat(&bend.as_ref()[i]).is_some()),
        })
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
    fn still(&self, modes: &Modes<M, N>) -> impl Iterator<Item = usize> {
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
    fn held(&self, modes: &Modes<M, N>) -> Option<[bool; N]> {
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
    fn respond<D: Scalar>(
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

impl<M: Model<N>, const N: usize> Constants<M, N> {
    /// B_S G_SS⁻¹ column by column for the contacts that stick; `None` if G_SS is singular.
    pub(super) fn levers(&self, modes: &Modes<M, N>) -> Option<M::PerContact<Strip<N>>> {
        let mut levers: M::PerContact<Strip<N>> = Inline::from_fn(|_| Strip::ZERO);
        for column in modes.sticking() {
            let unit = Inline::from_fn(|i| f64::from(i == column));
            let push = self.respond::<f64>(modes, unit)?;
            let mut lever = [0.0; N];
            for row in modes.sticking() {
                self.input.as_ref()[row].add_to(&mut lever, push.as_ref()[row]);
            }
            let own = self.gradient.as_ref()[column].only();
            for state in self.still(modes).filter(|state| Some(*state) != own) {
                lever[state] = 0.0;
            }
            levers.as_mut()[column] = lever.into();
        }
        Some(levers)
    }
}

impl<M: Model<N>, const N: usize> Constants<M, N> {
    /// w_y and lever of what holds, in front: of each contact that sticks, or of each state that these hold between them.
    pub(super) fn holds(
        &self,
        modes: &Modes<M, N>,
        levers: &M::PerContact<Strip<N>>,
    ) -> M::PerContact<[Strip<N>; 2]> {
        let mut holds = Inline::from_fn(|_| [Strip::ZERO; 2]);
        let places: &mut [_] = M::PerContact::as_mut(&mut holds);
        if let Some(held) = self.held(modes) {
            let states = (0..N).filter(|state| held[*state]);
            for (place, state) in places.iter_mut().zip(states) {
                *place = self.brace_of(state, &held, modes, levers);
            }
        } else {
            for (place, contact) in places.iter_mut().zip(modes.sticking()) {
                *place = [self.gradient.as_ref()[contact], levers.as_ref()[contact]];
            }
        }
        holds
    }

    /// Gradient and lever of a state that contacts hold between them: of L G, their levers and gradients, nothing is left of
    /// such states but itself.
    fn brace_of(
        &self,
        state: usize,
        held: &[bool; N],
        modes: &Modes<M, N>,
        levers: &M::PerContact<Strip<N>>,
    ) -> [Strip<N>; 2] {
        let mut unit = [0.0; N];
        unit[state] = 1.0;
        let mut lever = [0.0; N];
        for contact in modes.sticking() {
            let share = self.gradient.as_ref()[contact].entries()[state];
            levers.as_ref()[contact].add_to(&mut lever, share);
        }
        for other in (0..N).filter(|other| held[*other]) {
            lever[other] = unit[other];
        }
        [unit.into(), lever.into()]
    }
}

/// The value, if no derivative of it is other than zero.
fn flat<L: Lanes<N>, const N: usize>(number: &L) -> Option<f64> {
    let (state, design) = number.slopes();
    let constant = state.iter().all(|s| *s == 0.0) && design == 0.0;
    (constant && number.re().is_finite()).then_some(number.re())
}

/// A number without meaning in (0, 1), another for each index.
fn generic(index: usize, seed: f64) -> f64 {
    0.1 + 0.8 * (seed + 0.618_033_988_749_895 * (index + 1) as f64).fract()
}

pub(super) fn generic_state<M: Model<N>, const N: usize>(seed: f64) -> [f64; N] {
    crate::scalar::filled(|i| {
        let start = M::INFO.states.get(i).map_or(0.0, |state| state.start);
        start + (1.0 + start.abs()) * generic(i, seed)
    })
}
