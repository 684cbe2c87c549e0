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
        impact: None,
    };
    (!modes.is_empty()).then(|| word(info, &[segment]))
}

/// The modes in which every contact slides, and presses or not, as it does at `state`; of a smooth flow, none.
pub(in crate::study) fn sliding_mode(flow: &dyn Flow, info: &ModelInfo, state: &[f64]) -> Modes {
    let measures = flow.speeds(state);
    flow.loosened(sliding(info, &measures, 0), &measures)
}

/// The modes in which no contact sticks, first those in which it does not at `state`; of a smooth flow, the only ones.
pub(in crate::study) fn sliding_modes(
    flow: &dyn Flow,
    info: &ModelInfo,
    state: &[f64],
) -> Vec<Modes> {
    let measures = flow.speeds(state);
    let count = measures.len();
    let turns = if count > COMBINED { 1 } else { 1 << count };
    let mut all: Vec<Modes> = Vec::new();
    for turned in 0..turns {
        let modes = flow.loosened(sliding(info, &measures, turned), &measures);
        if !all.contains(&modes) {
            all.push(modes);
        }
    }
    all
}

/// The modes of sliding at these speeds and of pressing at these gaps, those with a bit of `turned` the other way.
fn sliding(info: &ModelInfo, measures: &[f64], turned: usize) -> Modes {
    let way = |i: usize| if turned >> i & 1 == 0 { 1.0 } else { -1.0 };
    let mode = |(i, measure): (usize, &f64)| match info.contacts.get(i) {
        Some(_) => Mode::sliding(way(i) * measure),
        // What does not give way bears nothing unless contact lasts.
        None if info.is_rigid(i) || way(i) * measure > 0.0 => Mode::Open,
        None => Mode::Closed,
    };
    measures.iter().enumerate().map(mode).collect()
}

/// The modes of all contacts of which at least one sticks, or rests on what does not give way: in every combination, or all
/// of them sticking and pressing.
pub(in crate::study) fn sticking_modes(flow: &dyn Flow, info: &ModelInfo) -> Vec<Modes> {
    const RUBBING: [Mode; 3] = [Mode::Stick, Mode::SlideBackward, Mode::SlideForward];
    const PRESSING: [Mode; 2] = [Mode::Closed, Mode::Open];
    const FLYING: [Mode; 2] = [Mode::Rest, Mode::Open];
    let rubs = info.contacts.iter().map(|_| RUBBING.as_slice());
    let presses = info.presses.iter().map(|press| match press.law.is_rigid() {
        true => FLYING.as_slice(),
        false => PRESSING.as_slice(),
    });
    let choices: Vec<&[Mode]> = rubs.chain(presses).collect();
    if choices.len() > COMBINED {
        return vec![choices.iter().map(|choice| choice[0]).collect()];
    }
    let count: usize = choices.iter().map(|choice| choice.len()).product();
    let combination = |k: usize| {
        let mut rest = k;
        let pick = |choice: &&[Mode]| {
            let mode = choice[rest % choice.len()];
            rest /= choice.len();
            mode
        };
        choices.iter().map(pick).collect()
    };
    let still = vec![0.0; choices.len()];
    (0..count)
        .map(combination)
        .filter(|modes: &Modes| modes.iter().any(|mode| mode.binds()))
        .filter(|modes| flow.loosened(modes.clone(), &still) == *modes)
        .collect()
}
