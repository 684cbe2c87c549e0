//! What lies between two neighbouring points of a branch, read as they are.

use super::corrector::Failure;
use super::kind::Kind;
use super::link::Link;
use super::path::{Border, Path};
use super::reading::{ErrorOf, Reader, Reading};
use crate::field::Work;

/// Shares of the sharpness of what lies between two points to which it is found once more, where its error is measured: a
/// sharper one, and a blunter one where rounding leaves none.
const AGAIN: [f64; 2] = [0.1, 10.0];

/// What lies between two neighbouring points.
pub(super) struct Between<R: Reader> {
    reader: R,
    link: Link<R::Problem>,
    straight: bool,
    counted: Work,
}

impl<R: Reader> Between<R> {
    /// What lies between the last two points of a branch, these; `None` at the first.
    pub(super) fn of(reading: &Reading<R>, ends: [&R::Point; 2]) -> Option<Self> {
        let reader = &reading.reader;
        let mut link = reading.branch.link()?.clone();
        reader.sharpen(&mut link.problem, R::SHARPER);
        Some(Self {
            counted: R::work(&link.problem),
            straight: reader.straight(ends),
            reader: reader.clone(),
            link,
        })
    }

    /// Whether the branch goes another way from end to end, as far as is known.
    pub(super) fn leapt(&self) -> bool {
        self.link.leapt()
    }

    /// Work of all points found on it.
    pub(super) fn work(&self) -> Work {
        R::work(&self.link.problem).since(&self.counted)
    }
}

impl<R: Reader> Path for Between<R> {
    type Point = R::Point;
    type Error = Failure<ErrorOf<R>>;

    fn at(&mut self, share: f64) -> Result<R::Point, Self::Error> {
        let level = self.straight.then(|| self.link.level(share).ok());
        let point = match level.flatten() {
            Some(point) => point,
            None => self.link.between(share)?,
        };
        let (problem, chord) = (&self.link.problem, self.link.chord());
        Ok(self.reader.between(problem, &point, chord))
    }

    fn glance(&mut self, share: f64) -> Option<R::Point> {
        let point = self.link.glance(share)?;
        let (problem, chord) = (&self.link.problem, self.link.chord());
        Some(self.reader.between(problem, &point, chord))
    }

    fn again(&mut self, share: f64) -> Option<R::Point> {
        let point = AGAIN.into_iter().find_map(|again| {
            self.link.sharpen(again * R::SHARPER);
            self.reader
                .sharpen(&mut self.link.problem, again * R::SHARPER);
            self.at(share).ok()
        });
        self.link.sharpen(1.0);
        self.reader.sharpen(&mut self.link.problem, R::SHARPER);
        point
    }

    fn border(&mut self, ends: [&R::Point; 2]) -> Option<Border<R::Point>> {
        let r_scale = self.link.r_scale();
        self.reader.border(&mut self.link.problem, ends, r_scale)
    }

    fn lost_between(&mut self, ends: [&R::Point; 2]) -> Option<(R::Point, [f64; 2])> {
        self.reader.lost_between(&self.link.problem, ends)
    }

    fn corner(&mut self, shares: [f64; 2]) -> Option<(f64, f64)> {
        let corner = self.link.corner(shares)?;
        Some((corner.r, corner.error))
    }

    fn name(&mut self, ends: [&R::Point; 2]) -> Kind {
        self.reader.name(&self.link.problem, ends)
    }
}
