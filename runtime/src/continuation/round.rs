//! Branches that come round to where they began.

use super::between::Between;
use super::ending::Ending;
use super::located::Unexplained;
use super::path::Watched;
use super::reading::{ErrorOf, Reader};
use super::root::reach;
use super::walk::Walk;

/// Points after which a branch may have come round.
const ROUND: usize = 3;

impl<R: Reader> Walk<'_, R> {
    /// The end of a branch that has come back between these points to where it began; one that comes the other way round has
    /// turned somewhere unseen.
    pub(super) fn round(
        &self,
        path: &mut Between<R>,
        ends: [&R::Point; 2],
    ) -> Option<Ending<ErrorOf<R>>> {
        let first = self
            .points
            .first()
            .filter(|_| R::CLOSES && self.points.len() > ROUND)?;
        let back = reach(path, ends, first.r(), self.followed.accuracy).ok()??;
        if !self.followed.reader.closes(first, &back) {
            return None;
        }
        Some(if first.slope() * back.slope() < 0.0 {
            let reason = "it comes back the other way round to where it began";
            Ending::Unexplained(Unexplained::between(ends, reason))
        } else {
            Ending::Closed(first.r())
        })
    }
}
