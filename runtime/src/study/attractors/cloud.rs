//! Places that a chaotic motion visits: what keeps to them has the same future.

use super::ground::Ground;
use super::returns::returns;
use super::statistics::visited;
use crate::flow::FlowError;
use crate::motion::{apart, half_extents};
use crate::shooting::Shifts;

/// So many crossings on end are judged together.
const CROSSINGS: u32 = 100;
/// A crossing this near to one of the places, in half extents, is no stray.
const NEAR: f64 = 0.02;
/// What comes back on end as near as this, in usual sizes, may settle on an orbit there.
const CLOSE: f64 = 1e-3;

/// Where a chaotic motion crosses its section.
#[derive(Debug, Clone)]
pub(super) struct Cloud {
    /// The place of the motion in the list.
    pub(super) of: usize,
    points: Vec<Vec<f64>>,
    units: Vec<f64>,
    /// Most strays among crossings on end of the motion itself, its later ones held against its earlier ones.
    strays: u32,
}

impl Cloud {
    /// The places that the motion from `start` visits, which settles on motion number `of`.
    pub(super) fn of(
        ground: &Ground<'_>,
        of: usize,
        start: &[f64],
        shifts: &Shifts,
    ) -> Result<Option<Self>, FlowError> {
        let Some(points) = visited(ground, start)? else {
            return Ok(None);
        };
        let points: Vec<Vec<f64>> = points.iter().map(|point| shifts.home(point)).collect();
        let bound = |far: fn(f64, f64) -> f64, from: f64| -> Vec<f64> {
            let most = |j: usize| points.iter().fold(from, |most, point| far(most, point[j]));
            (0..start.len()).map(most).collect()
        };
        let (low, high) = (
            bound(f64::min, f64::INFINITY),
            bound(f64::max, f64::NEG_INFINITY),
        );
        let mut units = half_extents(&low, &high, &ground.usual);
        if let Some(phase) = ground.flow.phase() {
            units[phase] = f64::INFINITY;
        }
        let mut cloud = Self {
            of,
            points,
            units,
            strays: 0,
        };
        cloud.strays = cloud.own_strays();
        Ok(Some(cloud))
    }

    fn own_strays(&self) -> u32 {
        let (earlier, later) = self.points.split_at(self.points.len() / 2);
        let mut latest = Latest::default();
        let counts = later.iter().map(|state| {
            latest.note(self.strays_from(earlier, state));
            latest.strays()
        });
        counts.max().unwrap_or(0)
    }

    fn strays_from(&self, places: &[Vec<f64>], state: &[f64]) -> bool {
        let mut places = places.iter();
        !places.any(|place| apart(state, place, &self.units) <= NEAR)
    }
}

/// Which of the latest crossings were strays.
#[derive(Debug, Clone, Copy, Default)]
struct Latest {
    seen: u32,
    /// A bit for each, the latest lowest.
    bits: u128,
}

impl Latest {
    fn note(&mut self, strays: bool) {
        self.seen += 1;
        self.bits = ((self.bits << 1) | u128::from(strays)) & ((1 << CROSSINGS) - 1);
    }

    fn strays(self) -> u32 {
        self.bits.count_ones()
    }
}

/// How well a motion has kept to each of the clouds.
#[derive(Debug, Clone)]
pub(super) struct Kept(Vec<Latest>);

impl Kept {
    pub(super) fn new(clouds: &[Cloud]) -> Self {
        Self(vec![Latest::default(); clouds.len()])
    }

    /// The motion to whose places another one keeps as well as it does itself, after one more crossing: there but for shifts
    /// that change nothing, and the first of those that are `latest`.
    pub(super) fn watch<'a>(
        &mut self,
        clouds: &[Cloud],
        home: &[f64],
        latest: impl Iterator<Item = &'a Vec<f64>>,
        usual: &[f64],
    ) -> Option<usize> {
        let mut kept = None;
        for (cloud, own) in clouds.iter().zip(&mut self.0) {
            own.note(cloud.strays_from(&cloud.points, home));
            if own.seen >= CROSSINGS && own.strays() <= cloud.strays {
                kept = kept.or(Some(cloud.of));
            }
        }
        kept.filter(|_| returns(latest, usual, CLOSE).is_none())
    }
}
