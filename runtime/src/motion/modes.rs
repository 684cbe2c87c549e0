//! The modes of all contacts, and the word that an orbit spells with them.

use super::Segment;
use crate::field::exact::Mode;
use crate::model::ModelInfo;

/// The mode of every contact in the order of declaration; none for a smooth system.
pub type Modes = Vec<Mode>;

/// How many contacts stick: as many multipliers of an orbit through these modes are exactly zero.
#[must_use]
pub fn sticking(modes: &[Mode]) -> usize {
    modes.iter().filter(|mode| **mode == Mode::Stick).count()
}

/// The modes of all contacts in the order of declaration, for a message.
#[must_use]
pub fn spelt(modes: &[Mode]) -> String {
    let all: Vec<String> = modes.iter().map(Mode::to_string).collect();
    all.join(" ")
}

/// The cyclic word of an orbit, for instance `stick(F) slip-(F)`: a letter for each contact that enters
/// a mode, in its least rotation (sticking before sliding). With no event at all, the mode of every contact.
#[must_use]
pub fn word(info: &ModelInfo, segments: &[Segment]) -> String {
    let name = |(mode, contact): &(Mode, usize)| {
        let letter = if *mode == Mode::Closed {
            "close".to_owned()
        } else {
            mode.to_string()
        };
        format!("{letter}({})", info.contact(*contact).unwrap_or("?"))
    };
    let names: Vec<String> = letters(segments).iter().map(name).collect();
    names.join(" ")
}

fn letters(segments: &[Segment]) -> Vec<(Mode, usize)> {
    let count = segments.len();
    let mut letters = Vec::new();
    for (i, segment) in segments.iter().enumerate() {
        let before = &segments[(i + count - 1) % count].modes;
        for (contact, (mode, old)) in segment.modes.iter().zip(before).enumerate() {
            letters.extend(letter(*old, *mode).map(|letter| (letter, contact)));
        }
    }
    if letters.is_empty() {
        let modes = segments.first().map(|segment| &segment.modes);
        return modes.into_iter().flatten().copied().zip(0..).collect();
    }
    least_rotation(letters)
}

/// The letter for a change of mode, if it has one: a contact that is pressed again slides as it did, and how the gap of a
/// press opens after its force has vanished is no event.
fn letter(old: Mode, new: Mode) -> Option<Mode> {
    match (old, new) {
        (old, new) if old == new => None,
        (Mode::Parted, Mode::Open) | (_, Mode::Loose) => None,
        (Mode::Loose, Mode::SlideForward | Mode::SlideBackward) => None,
        (_, Mode::Parted) => Some(Mode::Open),
        _ => Some(new),
    }
}

fn least_rotation(letters: Vec<(Mode, usize)>) -> Vec<(Mode, usize)> {
    let rank = |&(mode, contact): &(Mode, usize)| {
        let order = match mode {
            Mode::Stick => 0,
            Mode::SlideBackward => 1,
            Mode::SlideForward => 2,
            Mode::Loose => 3,
            Mode::Closed => 4,
            Mode::Open | Mode::Parted => 5,
        };
        (order, contact)
    };
    let rotated = |start: usize| letters[start..].iter().chain(&letters[..start]).map(rank);
    let best = (0..letters.len())
        .min_by(|&a, &b| rotated(a).cmp(rotated(b)))
        .unwrap_or(0);
    let turned = letters[best..].iter().chain(&letters[..best]);
    turned.copied().collect()
}
