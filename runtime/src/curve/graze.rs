//! Where an orbit grazes, and how the motion around it is divided.

use crate::field::exact::Mode;
use crate::flow::EventKind;
use crate::motion::Modes;
use crate::shooting::Orbit;

/// A stretch of this share of the period is none.
pub(super) const BRIEF: f64 = 1e-3;

/// Where an orbit grazes, or nearly does.
#[derive(Debug, Clone, PartialEq)]
pub struct Graze {
    pub(super) contact: usize,
    pub(super) state: Vec<f64>,
    /// Modes before and after.
    pub(super) modes: [Modes; 2],
    /// Shares of the period up to which the motion is held in its mode, and from which on.
    pub(super) held: [f64; 2],
}

impl Graze {
    /// The place of an orbit that is nearest to a graze: a contact that lands most slowly, or slides by
    /// most closely; `None` if no contact slides.
    #[must_use]
    pub fn of(orbit: &Orbit) -> Option<Self> {
        let margin = |kind: &EventKind, rate: f64| match kind {
            EventKind::Landing { .. } | EventKind::Crossing { .. } if rate < 0.0 => Some(-rate),
            EventKind::Nearest { margin } => Some(*margin),
            _ => None,
        };
        let near = orbit.events.iter().filter_map(|event| {
            let value = margin(&event.kind, event.rate)?;
            let stuck = matches!(event.kind, EventKind::Nearest { .. })
                && (event.mode == Mode::Stick || event.mode.is_of_press());
            (!stuck).then_some((value, event))
        });
        let (_, event) = near.min_by(|a, b| a.0.total_cmp(&b.0))?;
        let (before, after, stays) = around(orbit, event.time)?;
        let others = orbit.events.iter().filter(|other| {
            other.kind.is_switch() && (other.time - event.time).abs() > BRIEF * orbit.period
        });
        let ahead = |time: f64| (time - event.time).rem_euclid(orbit.period) / orbit.period;
        let gaps: Vec<f64> = others.map(|other| ahead(other.time)).collect();
        let next = gaps.iter().copied().fold(1.0, f64::min);
        let last = gaps.iter().copied().fold(0.0, f64::max);
        Some(Self {
            contact: event.contact,
            state: event.state.clone(),
            modes: [before.clone(), if stays { after } else { before }],
            held: [if stays { 0.0 } else { 0.5 * next }, 0.5 + 0.5 * last],
        })
    }
}

/// The modes before and after a time of an orbit, and whether the later one lasts.
fn around(orbit: &Orbit, time: f64) -> Option<(Modes, Modes, bool)> {
    let near = BRIEF * 1e-3 * orbit.period;
    let mut end = 0.0;
    for (i, segment) in orbit.segments.iter().enumerate() {
        end += segment.duration;
        if (end - time).abs() <= near {
            let after = &orbit.segments[(i + 1) % orbit.segments.len()];
            let stays = after.modes != segment.modes && after.duration > BRIEF * orbit.period;
            return Some((segment.modes.clone(), after.modes.clone(), stays));
        }
        if end > time {
            return Some((segment.modes.clone(), segment.modes.clone(), false));
        }
    }
    None
}
