//! The modes of all contacts, and the word that an orbit spells with them.

use super::Segment;
use crate::field::exact::Mode;
use crate::model::ModelInfo;

/// The mode of every contact in the order of declaration; none for a smooth system.
pub type Modes = Vec<Mode>;

/// How many directions of motion these modes take away, one for each contact that sticks and two for each press at rest: as
/// many multipliers of an orbit through them are exactly zero.
#[must_use]
pub fn sticking(modes: &[Mode]) -> usize {
    modes.iter().map(|mode| mode.lost()).sum()
}

/// The modes of all contacts in the order of declaration, for a message.
#[must_use]
pub fn spelt(modes: &[Mode]) -> String {
    let all: Vec<String> = modes.iter().map(Mode::to_string).collect();
    all.join(" ")
}

/// The cyclic word of an orbit, for instance `stick(F) slip-(F)`: a letter for each contact that enters
/// a mode or is hit, in its least rotation (sticking before sliding). With no event at all, the mode of every contact.
#[must_use]
pub fn word(info: &ModelInfo, segments: &[Segment]) -> String {
    let name = |(letter, contact): &(Letter, usize)| {
        let letter = match letter {
            Letter::Impact => "impact".to_owned(),
            Letter::Mode(Mode::Closed) => "close".to_owned(),
            Letter::Mode(mode) => mode.to_string(),
        };
        format!("{letter}({})", info.contact(*contact).unwrap_or("?"))
    };
    let names: Vec<String> = letters(segments).iter().map(name).collect();
    names.join(" ")
}

/// What happens to a contact.
#[derive(Debug, Clone, Copy, PartialEq)]
enum Letter {
    Impact,
    Mode(Mode),
}

fn letters(segments: &[Segment]) -> Vec<(Letter, usize)> {
    let count = segments.len();
    let mut letters = Vec::new();
    for (i, segment) in segments.iter().enumerate() {
        let before = &segments[(i + count - 1) % count].modes;
        letters.extend(segment.impact.map(|contact| (Letter::Impact, contact)));
        for (contact, (mode, old)) in segment.modes.iter().zip(before).enumerate() {
            letters.extend(letter(*old, *mode).map(|mode| (Letter::Mode(mode), contact)));
        }
    }
    if letters.is_empty() {
        let modes = segments.first().map(|segment| &segment.modes);
        let modes = modes.into_iter().flatten().map(|mode| Letter::Mode(*mode));
        return modes.zip(0..).collect();
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

fn least_rotation(letters: Vec<(Letter, usize)>) -> Vec<(Letter, usize)> {
    let rank = |&(letter, contact): &(Letter, usize)| {
        let order = match letter {
            Letter::Mode(Mode::Stick) => 0,
            Letter::Mode(Mode::SlideBackward) => 1,
            Letter::Mode(Mode::SlideForward) => 2,
            Letter::Mode(Mode::Loose | Mode::PinnedForward | Mode::PinnedBackward) => 3,
            Letter::Impact => 4,
            Letter::Mode(Mode::Rest) => 5,
            Letter::Mode(Mode::Closed) => 6,
            Letter::Mode(Mode::Open | Mode::Parted) => 7,
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
