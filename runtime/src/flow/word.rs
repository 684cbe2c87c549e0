//! The event word of an orbit: what its contacts do, in order.

use super::Segment;
use crate::field::exact::{Mode, Modes};
use crate::model::Model;

/// The cyclic word of an orbit, for instance `stick(F) slip-(F)`: a letter for each contact that enters
/// a mode, in its least rotation (sticking before sliding). With no event at all, the mode of every contact.
#[must_use]
pub fn word<M: Model<N>, const N: usize>(segments: &[Segment<Modes<M, N>>]) -> String {
    let letters = letters(segments);
    let name = |(mode, contact): &(Mode, usize)| {
        let force = M::INFO
            .contacts
            .get(*contact)
            .map_or("?", |contact| contact.name);
        format!("{mode}({force})")
    };
    let names: Vec<String> = letters.iter().map(name).collect();
    names.join(" ")
}

fn letters<M: Model<N>, const N: usize>(segments: &[Segment<Modes<M, N>>]) -> Vec<(Mode, usize)> {
    let count = segments.len();
    let mut letters = Vec::new();
    for (i, segment) in segments.iter().enumerate() {
        let before = segments[(i + count - 1) % count].mode;
        let pairs = segment.mode.as_slice().iter().zip(before.as_slice());
        for (contact, (mode, old)) in pairs.enumerate() {
            if mode != old {
                letters.push((*mode, contact));
            }
        }
    }
    if letters.is_empty() {
        let modes = segments.first().map(|segment| segment.mode);
        return modes
            .iter()
            .flat_map(|m| m.as_slice().iter().copied().zip(0..))
            .collect();
    }
    least_rotation(letters)
}

fn least_rotation(letters: Vec<(Mode, usize)>) -> Vec<(Mode, usize)> {
    let rank = |&(mode, contact): &(Mode, usize)| {
        let order = match mode {
            Mode::Stick => 0,
            Mode::SlideBackward => 1,
            Mode::SlideForward => 2,
        };
        (order, contact)
    };
    let rotated = |start: usize| letters[start..].iter().chain(&letters[..start]).map(rank);
    let best = (0..letters.len())
        .min_by(|&a, &b| rotated(a).cmp(rotated(b)))
        .unwrap_or(0);
    letters[best..]
        .iter()
        .chain(&letters[..best])
        .copied()
        .collect()
}
