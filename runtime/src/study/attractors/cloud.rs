//! Places that a chaotic motion visits: what keeps to them has the same future.

use super::ground::Ground;
use super::returns::returns;
use super::statistics::visited;
use crate::flow::FlowError;
use crate::motion::{apart, half_extents};

/// A motion keeps to these places if each of so many crossings on end is this near to one of them, in half extents.
const CROSSINGS: usize = 100;
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
}

impl Cloud {
    /// The places that the motion from `start` visits, which settles on motion number `of`.
    pub(super) fn of(
        ground: &Ground<'_>,
        of: usize,
        start: &[f64],
    ) -> Result<Option<Self>, FlowError> {
        let Some(points) = visited(ground, start)? else {
            return Ok(None);
        };
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
        Ok(Some(Self { of, points, units }))
    }

    /// How many crossings on end have kept to it after one more.
    fn kept(&self, before: usize, state: &[f64]) -> usize {
        let near = |point: &Vec<f64>| apart(state, point, &self.units) <= NEAR;
        match self.points.iter().any(near) {
            true => before + 1,
            false => 0,
        }
    }
}

/// How long a motion has kept to each of the clouds.
#[derive(Debug, Clone)]
pub(super) struct Kept(Vec<usize>);

impl Kept {
    pub(super) fn new(clouds: &[Cloud]) -> Self {
        Self(vec![0; clouds.len()])
    }

    /// The motion to whose places another one keeps after one more crossing, the last of those that are `latest`.
    pub(super) fn watch<'a>(
        &mut self,
        clouds: &[Cloud],
        latest: impl Iterator<Item = &'a Vec<f64>> + Clone,
        usual: &[f64],
    ) -> Option<usize> {
        let state = latest.clone().next()?;
        let mut kept = None;
        for (cloud, count) in clouds.iter().zip(&mut self.0) {
            *count = cloud.kept(*count, state);
            if *count >= CROSSINGS {
                kept = kept.or(Some(cloud.of));
            }
        }
        kept.filter(|_| !returns(latest, usual, CLOSE))
    }
}
