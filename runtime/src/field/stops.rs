//! Internal states of laws that rest on their stops: a Jenkins element slips there.
//!
//! Each state with stops has an automaton of three modes: free, on its upper stop, on its lower stop. A free state meets a
//! stop where ±z reaches its bound, and one that rests leaves it where its rate turns inwards (Iwan 1966). The mode
//! follows from the state alone, so that a place needs no memory of it.

use num_dual::Dual64;

use crate::friction::{ContactRule, FrictionLaw};
use crate::memory::{Answer, MemoryLaw};
use crate::model::Model;
use crate::scalar::{Inline, Scalar};

/// Guards of one state: its upper stop, its lower stop, and its way off either.
pub(crate) const GUARDS: usize = 3;
/// Share of a bound within which a state is on its stop: rounding errors.
const ON: f64 = 16.0 * f64::EPSILON;

/// Where the stops of each state stand, and which states rest on one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Stops<const N: usize> {
    /// Magnitude at which each state stops; infinite where it does not.
    bound: [f64; N],
    /// The derivative of that with respect to the design variable.
    along: [f64; N],
    /// The sign of the stop on which each state rests; 0 if it is free.
    side: [f64; N],
    /// The states that have stops, and their number.
    states: [usize; N],
    count: usize,
}

impl<const N: usize> Stops<N> {
    /// No stops at all.
    pub(crate) const NONE: Self = Self {
        bound: [f64::INFINITY; N],
        along: [0.0; N],
        side: [0.0; N],
        states: [0; N],
        count: 0,
    };

    /// The stops of a model at these parameters, which move with the design variable as `seeds` say.
    pub(super) fn of<M: Model<N>>(values: &M::Params<f64>, seeds: &M::Params<f64>) -> Self {
        let mut stops = Self::NONE;
        if M::INFO.has_stops() {
            let params = Inline::from_fn(|i| Dual64::new(values.as_ref()[i], seeds.as_ref()[i]));
            let start = crate::scalar::filled(|i| Dual64::from(M::INFO.states[i].start));
            let mut rule = Bounds::<M, N> {
                stops: &mut stops,
                model: std::marker::PhantomData,
            };
            let _ = M::rhs(&params, start, &mut rule);
        }
        stops
    }

    /// Adds the stops of state number `state`.
    pub(crate) fn put(&mut self, state: usize, bound: f64, along: f64) {
        if state < N && self.count < N {
            self.bound[state] = bound;
            self.along[state] = along;
            self.states[self.count] = state;
            self.count += 1;
        }
    }

    /// The states that have stops.
    fn states(&self) -> impl Iterator<Item = usize> + use<N> {
        self.states.into_iter().take(self.count)
    }

    /// The first state whose bound is no finite number above 0, and that bound.
    pub(crate) fn misplaced(&self) -> Option<(usize, f64)> {
        let bounds = self.states().map(|i| (i, self.bound[i]));
        // A comparison that fails for NaN too.
        bounds
            .into_iter()
            .find(|(_, bound)| !(*bound > 0.0 && bound.is_finite()))
    }

    /// Number of guards.
    pub(crate) fn guards(&self) -> usize {
        GUARDS * self.count
    }

    /// The bound of a state; infinite if it has none.
    pub(crate) fn bound(&self, state: usize) -> f64 {
        self.bound[state]
    }

    /// How many states rest.
    pub(crate) fn resting(&self) -> usize {
        self.side.iter().filter(|side| **side != 0.0).count()
    }

    /// What rests has no rate.
    #[inline]
    pub(crate) fn hold(&self, rates: &mut [f64; N]) {
        for (rate, side) in rates.iter_mut().zip(&self.side) {
            if *side != 0.0 {
                *rate = 0.0;
            }
        }
    }

    /// Whether a state rests.
    #[inline]
    pub(crate) fn rests(&self, state: usize) -> bool {
        self.side[state] != 0.0
    }

    /// The state and the sign of the stop that guard number `index` watches, if it does at present; 0 for the way off.
    fn watched(&self, index: usize) -> Option<(usize, f64)> {
        let state = self.states[index / GUARDS];
        match (index % GUARDS, self.rests(state)) {
            (0, false) => Some((state, 1.0)),
            (1, false) => Some((state, -1.0)),
            (2, true) => Some((state, 0.0)),
            _ => None,
        }
    }

    /// The magnitude of the terms of guard number `index`, of a rate 0; `None` if it watches nothing at present.
    pub(crate) fn terms(&self, index: usize) -> Option<f64> {
        let (state, side) = self.watched(index)?;
        Some(side.abs() * self.bound[state])
    }

    /// A function that is positive until the mode ends in the way of guard number `index`.
    pub(crate) fn guard(&self, index: usize, y: &[f64; N], rate: impl FnOnce(usize) -> f64) -> f64 {
        match self.watched(index) {
            None => 1.0,
            Some((state, 0.0)) => self.side[state] * rate(state),
            Some((state, side)) => self.bound[state] - side * y[state],
        }
    }

    /// The modes with which a motion begins at `y`, whose states are put between their stops, and what is caught there.
    ///
    /// `heading` gives the sign with which a free state sets out.
    pub(crate) fn settled(
        mut self,
        y: &mut [f64; N],
        heading: impl Fn(&Self, &[f64; N], usize) -> f64,
    ) -> Settled<N> {
        self.side = [0.0; N];
        let mut caught = [0.0; N];
        for i in self.states() {
            if y[i].abs() > self.bound[i] {
                caught[i] = y[i].signum();
            }
            if y[i].abs() >= self.bound[i] * (1.0 - ON) {
                y[i] = self.bound[i].copysign(y[i]);
            }
        }
        for i in self.states().filter(|&i| y[i].abs() == self.bound[i]) {
            let side = y[i].signum();
            if heading(&self, y, i) * side > 0.0 {
                self.side[i] = side;
                caught[i] = side;
            }
        }
        Settled {
            stops: self,
            caught,
        }
    }

    /// The modes after guard number `index` has fallen at `y`, and what is caught there; `rates` are those of free states.
    ///
    /// What is as near to its own stop switches too: elements alike reach theirs together.
    pub(crate) fn switched(
        mut self,
        y: &mut [f64; N],
        index: usize,
        rates: &[f64; N],
    ) -> Settled<N> {
        let fallen = self.watched(index);
        let off = self.guard(index, y, |state| rates[state]).abs();
        let mut caught = [0.0; N];
        for i in self.states() {
            let is = |side: f64| fallen == Some((i, side));
            if self.rests(i) {
                if is(0.0) || self.side[i] * rates[i] <= 0.0 {
                    self.side[i] = 0.0;
                }
                continue;
            }
            let near = off.max(ON * self.bound[i]);
            for side in [1.0, -1.0] {
                let gap = self.bound[i] - side * y[i];
                if is(side) || (gap <= near && side * rates[i] > 0.0) {
                    (self.side[i], caught[i]) = (side, side);
                    y[i] = side * self.bound[i];
                }
            }
        }
        Settled {
            stops: self,
            caught,
        }
    }
}

/// The modes after an instant at which they may change.
pub(crate) struct Settled<const N: usize> {
    /// The stops with their modes.
    pub(crate) stops: Stops<N>,
    /// The sign of the stop by which each state was caught, wherever it came from; 0 for the others.
    caught: [f64; N],
}

impl<const N: usize> Settled<N> {
    /// Each state that was caught.
    pub(crate) fn caught(&self) -> impl Iterator<Item = Caught> + '_ {
        let states = self
            .stops
            .states()
            .filter(|&state| self.caught[state] != 0.0);
        states.map(|state| Caught {
            state,
            side: self.caught[state],
            along: self.caught[state] * self.stops.along[state],
        })
    }
}

/// A state caught by one of its stops.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Caught {
    /// Its number.
    pub(crate) state: usize,
    /// The sign of the stop.
    pub(crate) side: f64,
    /// The derivative of the state, which is that of the stop, with respect to the design variable.
    pub(crate) along: f64,
}

/// Notes the stops of each law.
struct Bounds<'a, M, const N: usize> {
    stops: &'a mut Stops<N>,
    model: std::marker::PhantomData<M>,
}

impl<M: Model<N>, const N: usize> ContactRule<Dual64> for Bounds<'_, M, N> {
    fn force<L: FrictionLaw<Dual64>>(&mut self, _: usize, _: &L, _: Dual64) -> Dual64 {
        Dual64::from(0.0)
    }

    fn recall<L: MemoryLaw<Dual64, S>, const S: usize>(
        &mut self,
        element: usize,
        law: &L,
        _: [Dual64; S],
        _: Dual64,
    ) -> Answer<Dual64, S> {
        let carriers = M::INFO.memories.get(element).map(|memory| memory.states);
        law.stops(|place, bound| {
            if let Some(state) = carriers.and_then(|carriers| carriers.get(place)) {
                self.stops.put(*state, bound.re, bound.eps);
            }
        });
        let nothing = Dual64::from(0.0);
        Answer {
            force: nothing,
            rates: [nothing; S],
        }
    }
}

/// No force at all: for what no contact decides.
pub(crate) struct Frictionless;

impl<D: Scalar> ContactRule<D> for Frictionless {
    fn force<L: FrictionLaw<D>>(&mut self, _: usize, _: &L, _: D) -> D {
        D::from(0.0)
    }
}
