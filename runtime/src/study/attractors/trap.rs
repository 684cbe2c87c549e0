//! Regions of states whose future is known: around orbits.

use super::pursuit::Pursuit;
use super::record::Attractor;
use crate::bifurcation::Stability;
use crate::motion::{Flow, Place};
use crate::shooting::{Shifts, unshifted};

/// Sizes tried, in half extents of the orbit.
const SIZES: [f64; 6] = [0.3, 0.1, 0.03, 0.01, 3e-3, FAINT];
/// The size at which it is found out how many laps that takes, over those that the multipliers alone would need.
const FAINT: f64 = 1e-3;
const FACTORS: [f64; 6] = [1.0, 1.5, 2.0, 3.0, 5.0, 8.0];
/// Share of its size to which a trap is to shrink while it is watched.
const FALL: f64 = 0.5;
/// Most laps for which it is watched.
const LAPS: usize = 400;
/// A motion this close to an orbit is on it.
const ON: f64 = 1e-5;
/// Points of an orbit around which it is looked how motions come nearer.
const POINTS: usize = 4;
/// Passages that a lap takes at most.
const PASSAGES: usize = 64;

/// Neighbourhoods of an orbit's points on its section, from whose borders motions came nearer by half.
#[derive(Debug, Clone)]
pub(super) struct Trap {
    /// The place of its orbit in the list.
    pub(super) of: usize,
    orbit: Attractor,
    units: Vec<f64>,
    size: f64,
    /// Crossings of the section after which a motion is nearer by half.
    crossings: usize,
}

/// A motion that may be in a trap.
#[derive(Debug, Clone, Copy)]
pub(super) struct Hold {
    entered: f64,
    crossings: usize,
}

impl Trap {
    /// The trap of a stable orbit; `None` where nothing draws motions to it beyond doubt.
    pub(super) fn around(
        flow: &dyn Flow,
        of: usize,
        orbit: &Attractor,
        usual: &[f64],
        shifts: &Shifts,
    ) -> Option<Self> {
        if orbit.stability != Some(Stability::Stable) || orbit.points.is_empty() {
            return None;
        }
        let sizes = orbit.multipliers.iter().map(|[re, im]| re.hypot(*im));
        let largest = sizes.fold(0.0_f64, f64::max);
        let laps = (FALL.ln() / largest.ln()).ceil().max(1.0);
        if laps > LAPS as f64 {
            return None;
        }
        let mut units = orbit.magnitude(usual);
        if let Some(phase) = flow.phase() {
            units[phase] = f64::INFINITY;
        }
        let trap = |size: f64, factor: f64| Self {
            of,
            orbit: orbit.clone(),
            units: units.clone(),
            size,
            crossings: (factor * laps).ceil() as usize * orbit.points.len(),
        };
        let held = |trap: &Self| trap.holds(flow, shifts);
        let faint = |factor: &f64| trap(FAINT, *factor).holds(flow, shifts);
        let factor = FACTORS.into_iter().find(faint)?;
        let mut sizes = SIZES.into_iter().map(|size| trap(size, factor));
        sizes.find(held)
    }

    /// The state whose minima are its section.
    pub(super) fn section(&self) -> usize {
        self.orbit.section
    }

    /// The distance of a point of the section to the nearest one of the orbit, in half extents.
    fn distance(&self, state: &[f64], shifts: &Shifts) -> f64 {
        let points = self.orbit.points.iter();
        let far = |point: &Vec<f64>| self.orbit.unshifted(state, point, &self.units, shifts);
        points.map(far).fold(f64::INFINITY, f64::min)
    }

    /// What a crossing of the section makes of a motion: in the trap or not, or, as `Err`, for good.
    pub(super) fn watch(
        &self,
        hold: Option<Hold>,
        state: &[f64],
        shifts: &Shifts,
    ) -> Result<Option<Hold>, usize> {
        let distance = self.distance(state, shifts);
        if distance > self.size {
            return Ok(None);
        }
        let hold = hold.unwrap_or(Hold {
            entered: distance,
            crossings: 0,
        });
        if hold.crossings < self.crossings {
            return Ok(Some(Hold {
                crossings: hold.crossings + 1,
                ..hold
            }));
        }
        let shares = 0.5 * (1.0 + FALL);
        if distance <= ON || distance <= shares * hold.entered {
            return Err(self.of);
        }
        Ok(Some(Hold {
            entered: distance,
            crossings: 1,
        }))
    }

    /// Whether motions from its border, in the direction of each state, come nearer by half.
    fn holds(&self, flow: &dyn Flow, shifts: &Shifts) -> bool {
        let free = |j: &usize| self.units[*j].is_finite();
        let states = (0..self.units.len()).filter(free);
        let directions: Vec<(usize, f64)> = states
            .flat_map(|j| [(j, self.size), (j, -self.size)])
            .collect();
        let points = self.orbit.points.iter().take(POINTS);
        points.into_iter().all(|point| {
            directions.iter().all(|&(j, size)| {
                let mut start = point.clone();
                start[j] += size * self.units[j];
                self.nears(flow, &start, shifts)
            })
        })
    }

    fn nears(&self, flow: &dyn Flow, start: &[f64], shifts: &Shifts) -> bool {
        let Ok(mut pursuit) = Pursuit::new(flow, start) else {
            return false;
        };
        let mut left = self.crossings + self.orbit.points.len();
        for _ in 0..PASSAGES * left {
            let Ok(passage) = pursuit.on() else {
                return false;
            };
            for minimum in passage.minima(self.section()) {
                left -= 1;
                if left == 0 {
                    return self.distance(&minimum.state, shifts) <= FALL * self.size;
                }
            }
        }
        false
    }
}

/// States of rest of one system, as places that hold motions.
#[derive(Debug, Clone)]
pub(super) struct Rest {
    /// The place of its attractor in the list.
    pub(super) of: usize,
    pub(super) state: Vec<f64>,
    /// The region around it in which a Lyapunov function falls.
    pub(super) basin: Option<super::basin::Basin>,
}

impl Rest {
    /// Whether the future of a place is this rest, but for shifts that change nothing, and for `copies`.
    pub(super) fn holds(&self, place: &Place, shifts: &Shifts, copies: &[Vec<f64>]) -> bool {
        let Some(basin) = &self.basin else {
            return false;
        };
        let inside = |state: &[f64]| basin.holds(state);
        inside(&shifts.beside(&place.state, &self.state))
            || copies
                .iter()
                .any(|shift| inside(&unshifted(&place.state, &self.state, shift)))
    }
}
