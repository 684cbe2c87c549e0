//! What a field asks of friction laws with internal state: their kinks, and how large their states become.

use crate::friction::{ContactRule, FrictionLaw};
use crate::memory::{Answer, MemoryLaw};
use crate::model::Model;
use crate::scalar::Inline;

/// Numbers the kinks of all laws with internal state, and keeps the value of one of them.
struct Corners {
    wanted: usize,
    seen: usize,
    value: f64,
}

impl ContactRule<f64> for Corners {
    fn force<L: FrictionLaw<f64>>(&mut self, _: usize, _: &L, _: f64) -> f64 {
        0.0
    }

    fn recall<L: MemoryLaw<f64, S>, const S: usize>(
        &mut self,
        _: usize,
        law: &L,
        memory: [f64; S],
        speed: f64,
    ) -> Answer<f64, S> {
        law.kinks(memory, speed, |value| {
            if self.seen == self.wanted {
                self.value = value;
            }
            self.seen += 1;
        });
        nothing()
    }
}

/// An answer that moves nothing: only the question matters.
const fn nothing<const S: usize>() -> Answer<f64, S> {
    Answer {
        force: 0.0,
        rates: [0.0; S],
    }
}

/// How many surfaces laws with internal state have on which they are not smooth.
pub(super) fn corners<M: Model<N>, const N: usize>(params: &M::Params<f64>) -> usize {
    if M::INFO.memories.is_empty() {
        return 0;
    }
    let start = crate::scalar::filled(|i| M::INFO.states[i].start);
    let mut rule = Corners {
        wanted: usize::MAX,
        seen: 0,
        value: 1.0,
    };
    let _ = M::rhs(params, start, &mut rule);
    rule.seen
}

/// A function that changes its sign on corner number `index`.
pub(super) fn corner<M: Model<N>, const N: usize>(
    params: &M::Params<f64>,
    index: usize,
    y: &[f64; N],
) -> f64 {
    let mut rule = Corners {
        wanted: index,
        seen: 0,
        value: 1.0,
    };
    let _ = M::rhs(params, *y, &mut rule);
    rule.value
}

/// Magnitudes no larger than the internal states of laws become while their contacts slide steadily.
pub(super) fn bounded<M: Model<N>, const N: usize>(
    params: &M::Params<f64>,
    mut magnitude: [f64; N],
) -> [f64; N] {
    if !M::INFO.memories.is_empty() {
        let start = crate::scalar::filled(|i| M::INFO.states[i].start);
        let stops = super::Stops::of::<M>(params, &Inline::from_fn(|_| 0.0));
        for (i, magnitude) in magnitude.iter_mut().enumerate() {
            if stops.bound(i) > 0.0 {
                *magnitude = magnitude.min(stops.bound(i));
            }
        }
        let mut rule = Saturation::<M, N> {
            magnitude: &mut magnitude,
            model: std::marker::PhantomData,
        };
        let _ = M::rhs(params, start, &mut rule);
    }
    magnitude
}

/// Notes where the internal state of each law stops growing.
struct Saturation<'a, M, const N: usize> {
    magnitude: &'a mut [f64; N],
    model: std::marker::PhantomData<M>,
}

impl<M: Model<N>, const N: usize> ContactRule<f64> for Saturation<'_, M, N> {
    fn force<L: FrictionLaw<f64>>(&mut self, _: usize, _: &L, _: f64) -> f64 {
        0.0
    }

    fn recall<L: MemoryLaw<f64, S>, const S: usize>(
        &mut self,
        element: usize,
        law: &L,
        _: [f64; S],
        _: f64,
    ) -> Answer<f64, S> {
        let carrier = match M::INFO.memories.get(element).map(|memory| memory.states) {
            Some([carrier]) => self.magnitude.get_mut(*carrier),
            _ => None,
        };
        if let Some(magnitude) = carrier {
            let grows = |z: f64| law.answer([z; S], 1.0).rates[0] > 0.0;
            let mut reached = SMALLEST * *magnitude;
            while reached < *magnitude && grows(reached) {
                reached *= 2.0;
            }
            *magnitude = magnitude.min(reached);
        }
        nothing()
    }
}

/// Part of a magnitude below which internal states are not looked for.
const SMALLEST: f64 = 1e-15;
