//! Laws with internal state whose speed is that of a contact that slides: on which side of zero it is, is known.

use crate::memory::{Answer, MemoryLaw, same};
use crate::model::Model;
use crate::scalar::Scalar;

/// Of each law with internal state, by its number, the contact that opposes the same speed, if one does.
pub(super) const fn twins<M: Model<N>, const N: usize>() -> [Option<usize>; N] {
    let (memories, contacts) = (M::INFO.memories, M::INFO.contacts);
    let mut twins = [None; N];
    let mut i = 0;
    while i < memories.len() && i < N {
        let mut j = 0;
        while j < contacts.len() {
            if same(memories[i].speed, contacts[j].speed) {
                twins[i] = Some(j);
            }
            j += 1;
        }
        i += 1;
    }
    twins
}

/// What the law says while its speed has this sign, continued to the other one by reflection in the point at zero: stages
/// that overshoot the surface on which the contact comes to rest meet no kink, and the slope at zero is that of its side.
#[inline]
pub(super) fn beside<D: Scalar, L: MemoryLaw<D, S>, const S: usize>(
    law: &L,
    memory: [D; S],
    speed: D,
    sign: f64,
) -> Answer<D, S> {
    let next_to = D::from(sign * f64::MIN_POSITIVE);
    let speed = speed + next_to;
    if sign * speed.re() > 0.0 {
        return law.answer(memory, speed);
    }
    let at = law.answer(memory, next_to);
    let beyond = law.answer(memory, -speed);
    let reflected = |at: D, beyond: D| at * 2.0 - beyond;
    Answer {
        force: reflected(at.force, beyond.force),
        rates: crate::scalar::filled(|i| reflected(at.rates[i], beyond.rates[i])),
    }
}
