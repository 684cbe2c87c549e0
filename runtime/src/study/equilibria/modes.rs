//! The modes in which equilibria are looked for.

use crate::field::exact::Mode;
use crate::model::ModelInfo;
use crate::motion::{Flow, Modes, Segment, word};

/// Contacts whose modes are tried in every combination.
const COMBINED: usize = 5;

/// Modes as a word of one letter for each contact; `None` where there is no mode.
pub(in crate::study) fn spelt(info: &ModelInfo, modes: &Modes) -> Option<String> {
    let segment = Segment {
        modes: modes.clone(),
        duration: 0.0,
    };
    (!modes.is_empty()).then(|| word(info, &[segment]))
}

/// The modes in which every contact slides as it does at `state`.
pub(in crate::study) fn sliding_mode(flow: &dyn Flow, state: &[f64]) -> Modes {
    flow.speeds(state).into_iter().map(Mode::sliding).collect()
}

/// The modes in which every contact slides, first those in which it does at `state`; of a smooth flow, the only ones.
pub(in crate::study) fn sliding_modes(flow: &dyn Flow, state: &[f64]) -> Vec<Modes> {
    let speeds = flow.speeds(state);
    let count = speeds.len();
    let turns = if count > COMBINED { 1 } else { 1 << count };
    let turned = |k: usize, i: usize| if k >> i & 1 == 0 { 1.0 } else { -1.0 };
    let slides = |k: usize, i: usize| Mode::sliding(turned(k, i) * speeds[i]);
    (0..turns)
        .map(|k| (0..count).map(|i| slides(k, i)).collect())
        .collect()
}

/// The modes of `count` contacts of which at least one sticks: in every combination, or all of them.
pub(in crate::study) fn sticking_modes(count: usize) -> Vec<Modes> {
    const LETTERS: [Mode; 3] = [Mode::Stick, Mode::SlideBackward, Mode::SlideForward];
    if count > COMBINED {
        return vec![vec![Mode::Stick; count]];
    }
    let letter = |k: usize, i: usize| LETTERS[k / 3_usize.pow(i as u32) % 3];
    (0..3_usize.pow(count as u32))
        .map(|k| (0..count).map(|i| letter(k, i)).collect())
        .filter(|modes: &Modes| modes.contains(&Mode::Stick))
        .collect()
}
