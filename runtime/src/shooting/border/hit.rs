//! How orbits that are hit leave the grazing of a contact that does not give way.
//!
//! They, and r, are smooth functions of the speed v of their impact (Nordmark), although the return map has a root of the
//! depth g to which the gap would have fallen, v² = −2 g g̈: to first order (I − A) δy = k v and g_y δy + g_r δr = 0 with the
//! kick k of a unit speed.

use nalgebra::{DMatrix, DVector};

use super::sides::Sides;

/// How often a guess is aimed: what is off falls by its second order.
const AIMED: usize = 3;

/// The way out of a grazing, in scaled coordinates (start, period, r).
pub(super) struct Hit {
    /// Its direction, of unit length, in which the speed of the impact grows.
    pub(super) direction: DVector<f64>,
    /// By how much it does along that.
    speed: f64,
    /// What a unit of the gap adds.
    gap: DVector<f64>,
    /// g̈.
    bend: f64,
}

/// How many times the rest of the map what an impact adds to it is, where it is as slow as that.
const STEEP: f64 = 1e3;

impl Sides {
    /// Φ of orbits that are hit so slowly that their multiplier which grows without bound is large, in these units: with
    /// v² = −2 g g̈ it is A − k g_y g̈/v.
    pub(super) fn steep(&self, units: &[f64]) -> Option<DMatrix<f64>> {
        let (kick, _) = self.kick.as_ref()?;
        let (along, map) = (&self.number.0, &self.map_once(true).state);
        let units = DVector::from_column_slice(units);
        let added = kick.component_div(&units).norm() * along.component_mul(&units).norm();
        let inner = DMatrix::from_fn(units.len(), units.len(), |i, j| {
            map[(i, j)] * units[j] / units[i]
        });
        let share = STEEP * inner.norm().max(1.0) / added;
        let once = map - kick * along.transpose() * share;
        let map = if self.is_half() { &once * &once } else { once };
        map.iter().all(|entry| entry.is_finite()).then_some(map)
    }

    /// The way out; `None` if nothing is hit, or if that is not determined.
    pub(super) fn hit(
        &self,
        phase: &DVector<f64>,
        scale: &DVector<f64>,
        r_scale: f64,
    ) -> Option<Hit> {
        let (kick, bend) = self.kick.as_ref()?;
        let order = kick.len();
        let n = order + 1;
        let mut matrix = self.matrix(true, phase, scale, r_scale);
        let (along, by_r) = &self.number;
        let mut kicked = DVector::zeros(n + 1);
        for i in 0..order {
            matrix[(n, i)] = along[i] * scale[i];
            kicked[i] = -kick[i] / scale[i];
        }
        matrix[(n, n)] = by_r * r_scale;
        let size = matrix.row(n).norm();
        matrix.row_mut(n).unscale_mut(size);
        let lu = matrix.lu();
        let way = lu.solve(&kicked)?;
        let gap = lu.solve(&DVector::from_fn(n + 1, |i, _| {
            if i == n { 1.0 / size } else { 0.0 }
        }))?;
        let length = way.norm();
        let regular = way.iter().chain(&gap).all(|x| x.is_finite()) && length > 0.0;
        regular.then(|| Hit {
            direction: way / length,
            speed: 1.0 / length,
            gap,
            bend: *bend,
        })
    }
}

/// How a motion once around meets the wall.
pub(super) enum Met {
    /// It is hit at this speed.
    Hit(f64),
    /// Its gap keeps this width.
    Missed(f64),
}

impl Hit {
    /// The same without looking: so deep as a share of what belongs to the speed.
    pub(super) fn behind(&self, distance: f64, share: f64) -> DVector<f64> {
        let speed = self.speed * distance;
        &self.direction * distance - &self.gap * (share * speed * speed / (2.0 * self.bend))
    }

    /// Where to look at this distance: as deep behind the wall as belongs to the speed of the impact, which the first order
    /// leaves open, so that Newton's method sees the root; `met` says how a motion from there meets the wall.
    pub(super) fn guess(
        &self,
        distance: f64,
        met: impl Fn(&DVector<f64>) -> Option<Met>,
    ) -> DVector<f64> {
        let depth = |speed: f64| speed * speed / (2.0 * self.bend);
        let wanted = depth(self.speed * distance);
        let mut guess = &self.direction * distance;
        for _ in 0..AIMED {
            let found = match met(&guess) {
                Some(Met::Hit(speed)) => depth(speed),
                Some(Met::Missed(gap)) => -gap,
                None => break,
            };
            guess -= &self.gap * (wanted - found);
        }
        guess
    }
}
