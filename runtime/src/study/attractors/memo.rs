//! Places where contacts let go, whose future is known.

use nalgebra::DVector;

use super::record::Class;
use super::track::{Release, Track};
use crate::field::exact::Mode;
use crate::motion::apart;

/// States that agree to this, in usual sizes, are the same but for rounding.
const SAME: f64 = 1e-10;
/// Neighbours on a line are no further apart, in usual sizes,
const NEXT: f64 = 0.02;
/// and what lies between them is off their chord by no more than this share of it.
const BENT: f64 = 0.01;
/// So many switches after each of them are the same at least.
const ALIKE: usize = 16;
/// Most places that are kept.
const MOST: usize = 4096;

/// Where motions have let go of a contact, and on what they settled.
///
/// What sticks loses a dimension, and of a single mass all that it had: all motions that stick let go at one place, and
/// all that let go there share one future. Where one dimension is left, places of letting go lie on a line, and a place
/// between two neighbours whose motions go on through the same switches to the same end goes on so, too: what follows on
/// the line is stretched or shrunk by them, but keeps its order.
///
/// Nothing depends on where along a shift that changes nothing it was: places are those at home.
#[derive(Debug, Clone, Default)]
pub(super) struct Memo {
    known: Vec<Known>,
    ways: Vec<Way>,
}

#[derive(Debug, Clone)]
struct Known {
    release: Release,
    /// The place of its motion among the ways.
    way: usize,
}

/// The switches of a motion that was followed, and what it settled on.
#[derive(Debug, Clone)]
struct Way {
    word: Vec<(usize, Mode)>,
    of: usize,
}

impl Memo {
    /// Told of the way of a motion that settles on motion number `of`. Of irregular ones nothing is kept: neighbours part.
    pub(super) fn learn(&mut self, track: Track, (of, class): (usize, Class), usual: &[f64]) {
        if matches!(class, Class::Chaos | Class::Torus | Class::Unsettled) {
            return;
        }
        let Track { word, releases } = track;
        let way = self.ways.len();
        self.ways.push(Way { word, of });
        for release in releases {
            if self.known.len() < MOST && self.same(&release, usual).is_none() {
                self.known.push(Known { release, way });
            }
        }
    }

    /// On what a motion settles that lets go like one of these, if that is known.
    pub(super) fn future(&self, releases: &[Release], usual: &[f64]) -> Option<usize> {
        let mut releases = releases.iter();
        releases.find_map(|one| self.same(one, usual).or_else(|| self.between(one, usual)))
    }

    /// The known ones that are alike but for their states.
    fn alike(&self, one: &Release) -> impl Iterator<Item = &Known> {
        let all = self.known.iter();
        all.filter(|known| known.release.is_alike(one))
    }

    fn same(&self, one: &Release, usual: &[f64]) -> Option<usize> {
        let same = |known: &&Known| far(one, known, usual) <= SAME;
        self.alike(one)
            .find(same)
            .map(|known| self.ways[known.way].of)
    }

    /// The future of the two neighbours of a place on a line.
    fn between(&self, one: &Release, usual: &[f64]) -> Option<usize> {
        if one.free != 1 {
            return None;
        }
        let far = |known: &Known| far(one, known, usual);
        let nearer = |a: &&Known, b: &&Known| far(a).total_cmp(&far(b));
        let first = self.alike(one).min_by(nearer)?;
        let between = |[a, b]: [&Release; 2]| difference(&a.home, &b.home, usual);
        let from = |known: &Known| between([one, &known.release]);
        let way = from(first);
        let beyond = |known: &&Known| from(known).dot(&way) < 0.0;
        let second = self.alike(one).filter(beyond).min_by(nearer)?;
        let chord = between([&second.release, &first.release]);
        let off = &way - &chord * (way.dot(&chord) / chord.norm_squared());
        let gap = chord.amax();
        (gap <= NEXT && off.amax() <= BENT * gap).then(|| self.common(first, second))?
    }

    /// What both settle on, if they go there through the same switches.
    fn common(&self, a: &Known, b: &Known) -> Option<usize> {
        let after = |known: &Known| &self.ways[known.way].word[known.release.after..];
        let of = |known: &Known| self.ways[known.way].of;
        let (after_a, after_b) = (after(a), after(b));
        let common = after_a.len().min(after_b.len());
        let alike = common >= ALIKE && after_a[..common] == after_b[..common];
        (alike && of(a) == of(b)).then(|| of(a))
    }
}

fn far(one: &Release, known: &Known, usual: &[f64]) -> f64 {
    apart(&one.home, &known.release.home, usual)
}

fn difference(a: &[f64], b: &[f64], units: &[f64]) -> DVector<f64> {
    DVector::from_fn(units.len(), |j, _| (a[j] - b[j]) / units[j])
}
