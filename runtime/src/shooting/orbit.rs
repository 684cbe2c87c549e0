//! A periodic orbit with everything that is known of it.

use nalgebra::DVector;

use super::division::Division;
use super::guess::Guess;
use super::lows::section;
use super::pin::{Pin, through, told};
use super::shot::{Shot, usual};
use crate::bifurcation::{Disturbances, Floquet, floquet};
use crate::continuation::own_scale;
use crate::field::Work;
use crate::motion::{Event, Family, Place, Segment, most_stuck};

/// A periodic orbit.
#[derive(Debug, Clone)]
pub struct Orbit {
    /// The design variable.
    pub r: f64,
    /// Its start: on the default section, the first state least; with a drive, where its phase begins.
    pub place: Place,
    /// Where shooting begins instead, if a contact switches just there.
    pub calm: Option<Place>,
    /// Its minimal period.
    pub period: f64,
    /// Largest value of each state, from the dense motion.
    pub max: Vec<f64>,
    /// Smallest value of each state.
    pub min: Vec<f64>,
    /// Crossings of the section der(first state) = 0, upwards, in one period; with a drive, how often that turns.
    pub period_count: usize,
    /// Stability.
    pub floquet: Floquet,
    /// Norm of the shooting residual, relative to the extents of the states.
    pub residual: f64,
    /// Estimated relative error of period and extrema.
    pub error_estimate: f64,
    /// Stretches in constant mode.
    pub segments: Vec<Segment>,
    /// What happened at the contacts, or nearly did; nothing for a smooth system.
    pub events: Vec<Event>,
    /// Its points on the default section, where the first state is least, in the order of time.
    pub section: Vec<Vec<f64>>,
    /// What is held in neutral directions: orbits beside it are orbits too.
    pub pins: Vec<Pin>,
    /// What the states gain once around, where it runs on: a shift that changes nothing.
    pub shift: Option<Vec<f64>>,
    /// Its segments, if errors grow so much along it that it was divided for shooting.
    pub division: Option<Division>,
    /// Where it stands on its branch.
    pub heading: Heading,
    /// Work of finding it.
    pub work: Work,
}

/// Where an orbit stands on its branch, so that another branch can set out from there.
#[derive(Debug, Clone, PartialEq)]
pub struct Heading {
    /// Where shooting starts: not always on the section.
    pub start: Place,
    /// Unit tangent of the branch in scaled coordinates (start, period, r); `None` off any branch, or
    /// where shooting has several segments.
    pub tangent: Option<DVector<f64>>,
    /// The tangent of the branch in the units of (start, period, r), if it is known.
    pub way: Option<DVector<f64>>,
    /// The magnitude of r in these coordinates.
    pub r_scale: f64,
    /// r-component of the unit tangent; 1 off any branch.
    pub slope: f64,
}

impl Heading {
    /// Takes the tangent of the branch, r in this magnitude.
    pub(crate) fn follow(&mut self, tangent: &DVector<f64>, r_scale: f64) {
        self.r_scale = r_scale;
        self.slope = tangent[tangent.len() - 1];
        self.tangent = (tangent.len() == self.start.state.len() + 2).then(|| tangent.clone());
    }
}

/// A converged solution of the shooting equations.
#[derive(Clone)]
pub(crate) struct Solution<'a> {
    pub(crate) shot: &'a Shot,
    pub(crate) z: &'a DVector<f64>,
    pub(crate) r: f64,
    pub(crate) residual: f64,
}

impl Solution<'_> {
    /// Where shooting starts.
    fn start(&self) -> Place {
        let order = self.shot.start.state.len();
        Place {
            state: self.z.rows(0, order).iter().copied().collect(),
            modes: self.shot.start.modes.clone(),
        }
    }
}

/// The start of the orbit if it lies on the default section, else the lowest of its minima of the first state; and a place
/// at which shooting had better begin, if a contact switches just there.
fn section_place(family: &Family, solution: &Solution<'_>) -> (Place, Option<Place>) {
    let (shot, start) = (solution.shot, solution.start());
    if shot.starts_on_section() {
        let switches = shot.switches_at(0.0);
        return (start, switches.then(|| shot.passages[0].calm.place.clone()));
    }
    let lowest = shot.minima().min_by(|a, b| a.1[0].total_cmp(&b.1[0]));
    let place = lowest.and_then(|(time, state)| {
        let flow = family.at(solution.r).ok()?;
        let place = shot.place(flow.as_ref(), time, &state).ok()?;
        Some((place, shot.switches_at(time).then(|| start.clone())))
    });
    place.unwrap_or((start, None))
}

impl Orbit {
    /// Where it is gone around from: away from events, if there is such a place.
    pub(super) fn begins(&self) -> &Place {
        self.calm.as_ref().unwrap_or(&self.heading.start)
    }

    /// Reads an orbit off its converged shot.
    pub(crate) fn read(family: &Family, solution: Solution<'_>, accuracy: f64, work: Work) -> Self {
        let Solution {
            shot,
            z,
            r,
            residual,
        } = solution;
        let (mut place, calm) = section_place(family, &solution);
        let told = shot.told(family, r, &place);
        let telling = told.as_ref().unwrap_or(shot);
        if let Some(Shot { start, .. }) = &told {
            place.clone_from(start);
        }
        let (min, max) = telling.extent();
        let passages = shot.passages.iter();
        let segments = shot.stretches();
        let zeros = most_stuck(&segments);
        let derivatives = passages.clone().filter_map(|p| p.derivatives.as_ref());
        let zeros = zeros.max(derivatives.map(|d| d.lost).max().unwrap_or(0));
        let (monodromy, determinant) = shot.monodromy();
        let unknown = vec![1.0; min.len()];
        let sizes = usual(&min, &max, shot.shift.as_deref(), &unknown);
        let all = Disturbances {
            monodromy,
            velocity: shot.velocity.f.clone(),
            factors: shot.factors(),
        };
        let all = all.in_units(&sizes);
        Self {
            r,
            pins: shot.pins.clone(),
            shift: shot.shift.clone(),
            division: shot.division(z),
            place,
            calm,
            period: z[z.len() - 1],
            max,
            min,
            period_count: shot.minima().count().max(1),
            floquet: floquet(
                &all.monodromy,
                &all.velocity,
                Some(determinant),
                zeros,
                &all.factors,
                shot.pins.len(),
                accuracy,
            ),
            residual,
            error_estimate: accuracy.max(residual),
            events: shot.events(),
            segments,
            section: telling.points(),
            heading: Heading {
                start: solution.start(),
                tangent: None,
                way: None,
                r_scale: own_scale(solution.r),
                slope: 1.0,
            },
            work,
        }
    }

    /// The state whose minima are its section; with a drive, the phase of that.
    pub(crate) fn crossed(&self, drive: Option<usize>) -> usize {
        section(drive, self.shift.as_deref())
    }

    /// Half the extent of each state; 1 for one that rests, and so has none to be measured against.
    #[must_use]
    pub fn magnitude(&self) -> Vec<f64> {
        let fallback = vec![1.0; self.min.len()];
        usual(&self.min, &self.max, self.shift.as_deref(), &fallback)
    }

    /// The orbit as a guess of itself: at another tolerance, or of one nearby.
    #[must_use]
    pub fn guess(&self) -> Guess {
        let division = self.division.clone();
        let first = division.as_ref().map(|division| &division.starts[0]);
        let place = first.or(self.calm.as_ref()).unwrap_or(&self.place).clone();
        Guess {
            pins: through(&told(&self.pins, &self.place.state), &place.state),
            place,
            period: self.period,
            magnitude: self.magnitude(),
            shift: self.gained(),
            division,
        }
    }

    /// What it gains once around, if it may gain anything: beyond what friction held in any place, nothing is shifted at will.
    fn gained(&self) -> Option<Vec<f64>> {
        let free = self.pins.iter().any(|pin| !pin.conserved());
        let runs = |shift: &&Vec<f64>| free || shift.iter().any(|gain| *gain != 0.0);
        self.shift.as_ref().filter(runs).cloned()
    }

    /// Whether a state is not where it was when the motion has come back.
    pub(crate) fn runs(&self, state: usize) -> bool {
        let shift = self.shift.as_deref();
        shift.is_some_and(|shift| shift[state] != 0.0)
    }

    /// Largest magnitude of each state.
    #[must_use]
    pub fn max_abs(&self) -> Vec<f64> {
        let pairs = self.max.iter().zip(&self.min);
        pairs.map(|(max, min)| max.abs().max(min.abs())).collect()
    }
}
