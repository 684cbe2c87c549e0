//! The modes in which equilibria are looked for.

use crate::field::exact::{ExactSystem, Mode, Modes};
use crate::flow::{Segment, word};
use crate::model::Model;

/// Contacts whose modes are tried in every combination.
const COMBINED: usize = 5;

/// A mode as a word of one letter for each contact.
pub(super) fn spelt<M: Model<N>, const N: usize>(mode: Modes<M, N>) -> Option<String> {
    let segment = Segment {
        mode,
        duration: 0.0,
    };
    (!M::INFO.contacts.is_empty()).then(|| word::<M, N>(&[segment]))
}

/// The mode in which every contact slides as it does at `state`.
pub(super) fn sliding_mode<M: Model<N>, const N: usize>(
    model: &M,
    state: &[f64; N],
) -> Modes<M, N> {
    let speeds = ExactSystem::new(model, None).speeds(state);
    Modes::from_fn(|i| Mode::sliding(speeds.as_ref()[i]))
}

/// The modes in which every contact slides, first the one in which it does at `state`.
pub(super) fn sliding_modes<M: Model<N>, const N: usize>(
    model: &M,
    state: &[f64; N],
) -> Vec<Modes<M, N>> {
    let system = ExactSystem::new(model, None);
    let speeds = system.speeds(state);
    let count = M::INFO.contacts.len();
    let turns = if count > COMBINED { 1 } else { 1 << count };
    let turned = |k: usize, i: usize| if k >> i & 1 == 0 { 1.0 } else { -1.0 };
    (0..turns)
        .map(|k| Modes::from_fn(|i| Mode::sliding(turned(k, i) * speeds.as_ref()[i])))
        .collect()
}

/// The modes in which at least one contact sticks: in every combination, or all of them.
pub(super) fn sticking_modes<M: Model<N>, const N: usize>() -> Vec<Modes<M, N>> {
    const LETTERS: [Mode; 3] = [Mode::Stick, Mode::SlideBackward, Mode::SlideForward];
    let count = M::INFO.contacts.len();
    if count > COMBINED {
        return vec![Modes::from_fn(|_| Mode::Stick)];
    }
    let letter = |k: usize, i: usize| LETTERS[k / 3_usize.pow(i as u32) % 3];
    (0..3_usize.pow(count as u32))
        .map(|k| Modes::from_fn(|i| letter(k, i)))
        .filter(|modes: &Modes<M, N>| modes.sticking().next().is_some())
        .collect()
}
