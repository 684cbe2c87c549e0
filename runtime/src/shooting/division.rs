//! Into which segments an orbit is divided: errors grow along an unstable one, and no start would be sharp enough to come
//! back to itself once around. From segment to segment they stay small (Ascher, Mattheij, Russell 1995, ch. 4).

use nalgebra::DMatrix;

use crate::flow::{FlowError, Want};
use crate::motion::{Event, Flow, Modes, Passage, Place};

/// An orbit is divided if errors grow this many times once around,
const UNSTABLE: f64 = 1e5;
/// until they grow no more than this along any segment.
const GROWTH: f64 = 1e2;
/// Parts in which it is told how errors grow on the way.
const PARTS: usize = 64;
/// How often a segment is halved at most, and how many there are at most.
const HALVINGS: u32 = 7;
const MOST: usize = 512;
/// What errors grow by along either half is that of the whole if it is no less than this share of it.
const SAME: f64 = 0.5;
/// Share of the period below which a segment is not divided along one half of which errors grow as along all of it, and a contact
/// switches: they grow there at once, as at a slow impact.
const BRIEF: f64 = 0.05;
/// Shares of a segment at which it may be divided, and of it by which all events are to be avoided.
const SEAMS: [f64; 5] = [0.5, 0.45, 0.55, 0.4, 0.6];
const MARGIN: f64 = 0.02;

/// Where segments begin, and the share of the period that each takes.
#[derive(Debug, Clone, PartialEq)]
pub struct Division {
    /// Where each segment begins.
    pub starts: Vec<Place>,
    /// The share of the period that each takes: their sum is 1.
    pub shares: Vec<f64>,
}

/// What a division is measured by.
pub(super) struct Measure<'a> {
    pub(super) flow: &'a dyn Flow,
    pub(super) period: f64,
    /// Usual magnitudes of the states.
    pub(super) magnitude: &'a [f64],
}

impl Division {
    /// The modes in which its segments begin.
    pub(super) fn modes(&self) -> Vec<Modes> {
        self.starts
            .iter()
            .map(|place| place.modes.clone())
            .collect()
    }

    /// One segment.
    #[must_use]
    pub fn whole(start: Place) -> Self {
        Self {
            starts: vec![start],
            shares: vec![1.0],
        }
    }

    /// This many segments of equal length.
    ///
    /// # Errors
    /// The motion cannot be followed to their starts.
    pub fn equal(
        flow: &dyn Flow,
        start: Place,
        period: f64,
        segments: usize,
    ) -> Result<Self, FlowError> {
        let share = 1.0 / segments.max(1) as f64;
        let mut division = Self {
            starts: vec![start],
            shares: vec![share; segments.max(1)],
        };
        while division.starts.len() < segments {
            let from = &division.starts[division.starts.len() - 1];
            let next = flow.advance(from, share * period, Want::default())?.end;
            division.starts.push(next);
        }
        Ok(division)
    }

    /// Whether this is one segment.
    #[must_use]
    pub fn is_whole(&self) -> bool {
        self.shares.len() == 1
    }

    /// The division that an orbit needs which was followed in this one; `None` if it is the same.
    ///
    /// # Errors
    /// The motion cannot be followed to a start.
    pub(super) fn refined(
        &self,
        measure: &Measure<'_>,
        passages: &[Passage],
    ) -> Result<Option<Self>, FlowError> {
        let allowed = if self.is_whole() {
            UNSTABLE
        } else {
            GROWTH * GROWTH
        };
        let grows = |passage: &Passage| measure.growth(passage) > allowed;
        let seams = if self.is_whole() {
            Vec::new()
        } else {
            seams(passages)
        };
        if !passages.iter().any(grows) && !seams.contains(&true) {
            return Ok(None);
        }
        let mut refined = Self {
            starts: Vec::new(),
            shares: Vec::new(),
        };
        for (start, share) in self.without(&seams) {
            let passage = measure.follow(&start, share)?;
            refined.divide(measure, (start, share), &passage, HALVINGS)?;
        }
        Ok((refined != *self && refined.shares.len() <= MOST).then_some(refined))
    }

    /// The division of an orbit along which errors grow on the way, though they may be gone once around: along a canard they
    /// first shrink more than they grow. `None` if they do not.
    ///
    /// # Errors
    /// The motion cannot be followed.
    pub(super) fn on_the_way(
        measure: &Measure<'_>,
        start: Place,
    ) -> Result<Option<Self>, FlowError> {
        let parts = Self::equal(measure.flow, start, measure.period, PARTS)?;
        let follow = |(start, share): (&Place, &f64)| measure.follow(start, *share);
        let passages = parts.starts.iter().zip(&parts.shares).map(follow);
        let passages = passages.collect::<Result<Vec<_>, _>>()?;
        if measure.growth_on_the_way(&passages) <= GROWTH * GROWTH {
            return Ok(None);
        }
        let refined = parts.refined(measure, &passages)?;
        Ok(Some(refined.unwrap_or(parts)))
    }

    /// The segments without these starts, unless none would be left.
    fn without(&self, dropped: &[bool]) -> Vec<(Place, f64)> {
        let mut kept: Vec<(Place, f64)> = Vec::new();
        let mut ahead = 0.0;
        for (i, (start, share)) in self.starts.iter().zip(&self.shares).enumerate() {
            match (dropped.get(i), kept.last_mut()) {
                (Some(true), Some(last)) => last.1 += share,
                (Some(true), None) => ahead += share,
                _ => kept.push((start.clone(), *share)),
            }
        }
        if let Some(last) = kept.last_mut() {
            last.1 += ahead;
        } else {
            kept.push((self.starts[0].clone(), 1.0));
        }
        kept
    }

    /// Adds a segment, or its parts. It is left whole where errors grow along either half as they do along it, which is a matter of
    /// units, and where they grow at once.
    fn divide(
        &mut self,
        measure: &Measure<'_>,
        (start, share): (Place, f64),
        passage: &Passage,
        halvings: u32,
    ) -> Result<(), FlowError> {
        let growth = measure.growth(passage);
        if halvings == 0 || growth <= GROWTH {
            self.add(start, share);
            return Ok(());
        }
        let seam = SEAMS.into_iter().find(|seam| clear(passage, *seam));
        let seam = seam.unwrap_or(SEAMS[0]);
        let first = measure.follow(&start, seam * share)?;
        let middle = first.end.clone();
        let second = measure.follow(&middle, (1.0 - seam) * share)?;
        let halves = [&first, &second].map(|half| measure.growth(half) >= SAME * growth);
        let at_once = |half: &Passage| half.events.iter().any(|event| event.kind.is_switch());
        let at_once =
            share < BRIEF && (halves[0] && at_once(&first) || halves[1] && at_once(&second));
        if at_once || halves == [true; 2] {
            self.add(start, share);
            return Ok(());
        }
        self.divide(measure, (start, seam * share), &first, halvings - 1)?;
        self.divide(
            measure,
            (middle, (1.0 - seam) * share),
            &second,
            halvings - 1,
        )
    }

    fn add(&mut self, start: Place, share: f64) {
        self.starts.push(start);
        self.shares.push(share);
    }
}

impl Measure<'_> {
    fn follow(&self, from: &Place, share: f64) -> Result<Passage, FlowError> {
        self.flow
            .advance(from, share * self.period, Want::DERIVATIVES)
    }

    /// How much errors grow at most along a passage, in units of the magnitudes; 1 if that was not asked for.
    fn growth(&self, passage: &Passage) -> f64 {
        self.scaled(passage).map_or(1.0, |scaled| scaled.amax())
    }

    /// How much they grow at most along any stretch of the parts of an orbit.
    fn growth_on_the_way(&self, parts: &[Passage]) -> f64 {
        let all: Option<Vec<_>> = parts.iter().map(|part| self.scaled(part)).collect();
        let Some(all) = all else { return 1.0 };
        let from = |first: usize| {
            let mut along = DMatrix::identity(self.magnitude.len(), self.magnitude.len());
            let parts = all.iter().cycle().skip(first).take(all.len());
            let stretches = parts.map(move |part| {
                along = part * &along;
                along.amax()
            });
            stretches.fold(1.0, f64::max)
        };
        (0..all.len()).map(from).fold(1.0, f64::max)
    }

    /// The derivatives of the end of a passage by its start, in units of the magnitudes.
    fn scaled(&self, passage: &Passage) -> Option<DMatrix<f64>> {
        let derivatives = passage.derivatives.as_ref()?;
        let order = self.magnitude.len();
        Some(DMatrix::from_fn(order, order, |i, j| {
            derivatives.state[(i, j)] * self.magnitude[j] / self.magnitude[i]
        }))
    }
}

/// Whether no contact switches near the place at this share of a passage.
fn clear(passage: &Passage, share: f64) -> bool {
    let near = |event: &Event| {
        event.kind.is_switch() && (event.time / passage.time - share).abs() < MARGIN
    };
    !passage.events.iter().any(near)
}

/// Which starts lie so near to an event that they would leave their modes as r changes.
fn seams(passages: &[Passage]) -> Vec<bool> {
    let count = passages.len();
    let near =
        |i: usize| !clear(&passages[i], 0.0) || !clear(&passages[(i + count - 1) % count], 1.0);
    (0..count).map(near).collect()
}
