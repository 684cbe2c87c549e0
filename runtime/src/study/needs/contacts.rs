//! What each contact does, and which could be written away.

use super::stage::{Scene, Stage};
use crate::field::exact::Mode;
use crate::flow::{FlowError, Want};
use crate::motion::{Contacts, Flow, Modes, Place};
use crate::study::system::System;

/// Panels of a period in which margins are looked at.
const PANELS: f64 = 50.0;

/// What a contact does in a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactNeed {
    /// The name of its force.
    pub name: &'static str,
    /// What it does.
    pub role: Role,
    /// How far it is from doing anything else, as a share of what it does at most: of its limit at rest, its speed, its gap or
    /// its force. `None` where it does more than one thing, and where a press holds it: then that of the press tells.
    pub margin: Option<f64>,
    /// How often it switches, on all orbits together.
    pub switches: usize,
}

/// What a contact does on all orbits of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// It does more than one thing: it is needed.
    Switches,
    /// It slides both ways and never sticks.
    NeverSticks,
    /// It slides one way: its force is a function of its speed.
    SlidesOneWay,
    /// It never slides: it is a joint.
    NeverSlides,
    /// It rubs under a press that is open: there is no force.
    NeverRubs,
    /// A press that is always open.
    NeverCloses,
    /// A press that is never open.
    NeverOpens,
}

impl Role {
    /// Its name in documents.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Switches => "switches",
            Self::NeverSticks => "never-sticks",
            Self::SlidesOneWay => "slides-one-way",
            Self::NeverSlides => "never-slides",
            Self::NeverRubs => "never-rubs",
            Self::NeverCloses => "never-closes",
            Self::NeverOpens => "never-opens",
        }
    }

    /// What could be written instead; nothing where the contact is needed as it is.
    #[must_use]
    pub const fn instead(self) -> Option<&'static str> {
        match self {
            Self::Switches => None,
            Self::NeverSticks => Some("its law at rest"),
            Self::SlidesOneWay => Some("its sliding force, as a function of the speed"),
            Self::NeverSlides => Some("a joint"),
            Self::NeverRubs | Self::NeverCloses => Some("nothing"),
            Self::NeverOpens => Some("its law, as a force of any sign"),
        }
    }

    /// What a contact does that is in all these modes.
    fn of(modes: &[Mode]) -> Self {
        let all = |one: &[Mode]| modes.iter().all(|mode| one.contains(mode));
        match modes {
            [] => Self::Switches,
            _ if all(&[Mode::SlideForward]) || all(&[Mode::SlideBackward]) => Self::SlidesOneWay,
            _ if all(&HELD) => Self::NeverSlides,
            _ if all(&[Mode::SlideForward, Mode::SlideBackward]) => Self::NeverSticks,
            _ if all(&[Mode::Loose]) => Self::NeverRubs,
            _ if all(&[Mode::Open, Mode::Parted]) => Self::NeverCloses,
            _ if all(&[Mode::Closed]) || all(&[Mode::Rest]) => Self::NeverOpens,
            _ => Self::Switches,
        }
    }
}

/// What is known of contacts at a place on an orbit.
struct Reading {
    modes: Modes,
    contacts: Contacts,
    /// Forces of all contacts, presses last.
    forces: Vec<f64>,
    /// Relative speeds, of presses the gaps.
    speeds: Vec<f64>,
}

impl System {
    /// What each contact does on all orbits of a stage.
    pub(super) fn roles(&self, stage: &Stage) -> Vec<ContactNeed> {
        if !self.info().touches() {
            return Vec::new();
        }
        // Where forces are not determined, neither are margins.
        let readings = stage.scenes.iter().map(|scene| self.readings(scene));
        let readings: Vec<Vec<Reading>> = readings.collect::<Result<_, _>>().unwrap_or_default();
        let readings: Vec<Reading> = readings.into_iter().flatten().collect();
        let names = self.info().forces().enumerate();
        names
            .map(|(contact, (name, _))| self.role(stage, &readings, contact, name))
            .collect()
    }

    fn role(
        &self,
        stage: &Stage,
        readings: &[Reading],
        contact: usize,
        name: &'static str,
    ) -> ContactNeed {
        let segments = stage.scenes.iter().flat_map(|scene| &scene.orbit.segments);
        let mut modes: Vec<Mode> = segments.map(|one| one.modes[contact]).collect();
        // Between the places it may do more.
        modes.extend(stage.words.iter().flat_map(|word| entered(word, name)));
        let events = stage.scenes.iter().flat_map(|scene| &scene.orbit.events);
        let own = events.filter(|event| event.contact == contact && event.kind.is_switch());
        let role = Role::of(&modes);
        ContactNeed {
            name,
            role,
            margin: self.margin(role, readings, contact),
            switches: own.count(),
        }
    }

    /// How far a contact is from doing anything else.
    fn margin(&self, role: Role, readings: &[Reading], contact: usize) -> Option<f64> {
        let all = |of: &dyn Fn(&Reading) -> f64| -> Option<[f64; 2]> {
            let values = readings.iter().map(of);
            let ends = values.fold([f64::INFINITY, 0.0_f64], |[least, most], value| {
                [least.min(value), most.max(value)]
            });
            (ends[0].is_finite() && ends[1] > 0.0).then_some(ends)
        };
        let share = |[least, most]: [f64; 2]| least / most;
        match role {
            _ if readings.is_empty() => None,
            Role::NeverSlides if readings.iter().any(|at| at.modes[contact] != Mode::Stick) => None,
            Role::NeverSlides => {
                let load = |at: &Reading| {
                    let one = &at.contacts.all[contact];
                    one.force.value.abs() / one.stick.value
                };
                let loads = readings.iter().map(load).fold(0.0, f64::max);
                Some(1.0 - loads).filter(|margin| margin.is_finite())
            }
            Role::SlidesOneWay | Role::NeverCloses => {
                all(&|at| at.speeds[contact].abs()).map(share)
            }
            Role::NeverOpens => all(&|at| at.forces[contact].abs()).map(share),
            Role::Switches | Role::NeverSticks | Role::NeverRubs => None,
        }
    }

    /// What is known of contacts along an orbit.
    fn readings(&self, scene: &Scene) -> Result<Vec<Reading>, FlowError> {
        let flow = self
            .family(&scene.case)
            .with_magnitude(&scene.orbit.magnitude())
            .at(0.0)?;
        let want = Want {
            panel: scene.orbit.period / PANELS,
            ..Want::default()
        };
        let passage = flow.advance(&scene.orbit.place, scene.orbit.period, want)?;
        let nodes = passage.nodes.iter().map(|node| (node.time, &node.state));
        let places = passage.places(nodes);
        places.map(|place| reading(flow.as_ref(), place)).collect()
    }
}

fn reading(flow: &dyn Flow, place: Place) -> Result<Reading, FlowError> {
    Ok(Reading {
        contacts: flow.contacts(&place)?,
        forces: flow.read(&place)?.0,
        speeds: flow.speeds(&place.state),
        modes: place.modes,
    })
}

/// The modes that a contact enters in the word of an orbit; none if it stays in one.
fn entered(word: &str, name: &str) -> Vec<Mode> {
    let own = word
        .split(' ')
        .filter_map(|letter| letter.strip_suffix(')')?.split_once('('));
    let own: Vec<&str> = own
        .filter(|(_, of)| *of == name)
        .map(|(letter, _)| letter)
        .collect();
    if own.len() == 1 && own[0] != IMPACT {
        return Vec::new();
    }
    let modes = own.into_iter().flat_map(|letter| match letter {
        IMPACT => vec![Mode::Open, Mode::Rest],
        "close" => vec![Mode::Closed],
        letter => EVERY
            .into_iter()
            .filter(|mode| mode.to_string() == letter)
            .collect(),
    });
    modes.collect()
}

const IMPACT: &str = "impact";
/// At rest by friction, or by a press that friction helps.
const HELD: [Mode; 3] = [Mode::Stick, Mode::PinnedForward, Mode::PinnedBackward];
const EVERY: [Mode; 7] = [
    Mode::SlideForward,
    Mode::SlideBackward,
    Mode::Stick,
    Mode::PinnedForward,
    Mode::PinnedBackward,
    Mode::Open,
    Mode::Rest,
];

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_tell_what_contacts_enter() {
        let slides = [Mode::Stick, Mode::SlideBackward];
        assert_eq!(entered("stick(F) slip-(F) slip+(G)", "F"), slides);
        assert_eq!(entered("stick(F) slip+(G)", "F"), []);
        assert_eq!(entered("impact(R)", "R"), [Mode::Open, Mode::Rest]);
        assert_eq!(entered("open(N) close(N)", "N"), [Mode::Open, Mode::Closed]);
    }

    #[test]
    fn roles_are_told_from_modes() {
        assert_eq!(Role::of(&[Mode::Stick; 2]), Role::NeverSlides);
        assert_eq!(Role::of(&[Mode::PinnedForward]), Role::NeverSlides);
        assert_eq!(Role::of(&[Mode::SlideForward; 3]), Role::SlidesOneWay);
        assert_eq!(Role::of(&[Mode::Stick, Mode::SlideForward]), Role::Switches);
        assert_eq!(Role::of(&[Mode::Parted, Mode::Open]), Role::NeverCloses);
    }
}
