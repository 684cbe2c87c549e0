//! A symmetry that is lost on a step: Newton's method does not settle on the way to there.

use super::Hunt;
use crate::continuation::kind::Kind;
use crate::continuation::located::Located;
use crate::continuation::path::{Path, Spot, Watched};

impl<Q: Path> Hunt<'_, '_, Q> {
    /// Where a symmetry is lost between these two, if it is found on points that have it.
    pub(super) fn lost(&mut self, ends: [&Spot<Q::Point>; 2]) -> Option<Located<Q::Point>> {
        let (point, [error, lasting]) = self.path.lost_between(ends.map(|spot| &spot.point))?;
        let [from, to] = ends.map(|spot| (spot.point.r(), spot.share));
        let share = from.1 + (point.r() - from.0) / (to.0 - from.0) * (to.1 - from.1);
        Some(Located {
            error,
            lasting,
            ..Located::between(Kind::SymmetryBreaking, ends, Spot { share, point })
        })
    }
}
