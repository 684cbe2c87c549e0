//! A law sampled at relative speeds of both signs.

use crate::app::spreadsheet::{Columns, Spreadsheet};
use crate::field::{Kernel, Smoothing};
use crate::study::Characteristic;

/// Speeds of one sign at which a law is sampled.
const POINTS: i32 = 120;
/// Speeds that a table shows.
const SHOWN: i32 = 10;

/// Friction force against relative speed, beside a smooth copy.
pub(super) struct Curve {
    /// The largest speed.
    pub(super) speed: f64,
    /// Units of speed and force; empty where they are not known.
    pub(super) units: [&'static str; 2],
    /// Largest force at rest, and the limit of the force at slow sliding.
    pub(super) limits: [f64; 2],
    pub(super) smoothing: Option<Smoothing>,
    pub(super) samples: Vec<Sample>,
}

/// Forces at one relative speed; positive where they act against a positive speed.
#[derive(Clone, Copy)]
pub(super) struct Sample {
    pub(super) speed: f64,
    pub(super) force: f64,
    /// Of the copy; a bump stands for one direction only.
    pub(super) copy: Option<f64>,
}

impl Curve {
    /// The law from the fastest backward speed to the fastest forward one, at rest from one end of the set to the other;
    /// speed and copy are chosen where they are not given.
    pub(super) fn of(
        law: &dyn Characteristic,
        units: [&'static str; 2],
        speed: Option<f64>,
        smoothing: Option<Smoothing>,
    ) -> Self {
        let most = speed.unwrap_or_else(|| characteristic_speed(law));
        let smoothing = smoothing.or_else(|| visible(law, most));
        let at = |speed: f64| {
            let stands = smoothing.filter(|copy| speed >= 0.0 || !copy.kernel.is_bump());
            Sample {
                speed,
                force: speed.signum() * law.sliding(speed.abs()),
                copy: stands.map(|smoothing| law.copied(smoothing, speed)),
            }
        };
        let (rest, start) = (law.at_rest(), law.sliding(0.0));
        let set = [-start, -rest, rest, start].map(|force| Sample { force, ..at(0.0) });
        let speeds = speeds(most);
        let backward = speeds.iter().rev().map(|speed| at(-speed));
        let forward = speeds.iter().map(|&speed| at(speed));
        Self {
            speed: most,
            units,
            limits: [rest, start],
            smoothing,
            samples: backward.chain(set).chain(forward).collect(),
        }
    }

    /// The samples that a table shows: forward, at even speeds.
    pub(super) fn shown(&self) -> impl Iterator<Item = &Sample> {
        let at = |speed| self.samples.iter().find(move |one| one.speed == speed);
        (1..=SHOWN).filter_map(move |i| at(even(self.speed, i)))
    }

    /// What the columns of speed, force and copy hold, with their units.
    pub(super) fn heads(&self) -> Vec<String> {
        let [speed, force] = self.units;
        let copy = self.smoothing;
        let copy = copy.map(|smoothing| with_unit(&smoothing.to_string(), force));
        let heads = [with_unit("speed", speed), with_unit("force", force)];
        heads.into_iter().chain(copy).collect()
    }

    /// All samples as a table.
    pub(super) fn sheet(&self) -> Spreadsheet {
        let columns = Columns::new().numbers(self.heads(), |one: &Sample, j| {
            [Some(one.speed), Some(one.force), one.copy][j]
        });
        columns.sheet(&self.samples)
    }
}

/// Speed number `i` of those that a table shows.
fn even(most: f64, i: i32) -> f64 {
    most * f64::from(i) / f64::from(SHOWN)
}

/// The speeds of one sign at which a law is sampled: denser towards rest, where a copy has its layer.
fn speeds(most: f64) -> Vec<f64> {
    let dense = (1..POINTS).map(|i| {
        let share = f64::from(i) / f64::from(POINTS);
        most * (share * 6.0).sinh() / 6.0_f64.sinh()
    });
    let mut all: Vec<f64> = (1..=SHOWN).map(|i| even(most, i)).chain(dense).collect();
    all.sort_by(f64::total_cmp);
    all
}

/// A word with its unit in parentheses.
pub(super) fn with_unit(word: &str, unit: &str) -> String {
    match unit {
        "" | "1" => word.to_owned(),
        unit => format!("{word} ({unit})"),
    }
}

/// A round speed by which most of what a law does has happened: four times that at which its force has changed by a quarter.
fn characteristic_speed(law: &dyn Characteristic) -> f64 {
    let start = law.sliding(0.0);
    let changed = |speed: &f64| (law.sliding(*speed) - start).abs() >= 0.25 * start;
    let speeds = (-120..=120).map(|i| 10_f64.powf(f64::from(i) / 20.0));
    let found = if start > 0.0 {
        speeds.into_iter().find(changed)
    } else {
        None
    };
    found.map_or(1.0, |speed| round(4.0 * speed))
}

/// The next of 1, 2, 5 times a power of ten.
fn round(value: f64) -> f64 {
    let decade = 10_f64.powf(value.log10().floor());
    let steps = [1.0, 2.0, 5.0, 10.0].map(|step| step * decade);
    steps
        .into_iter()
        .find(|step| *step >= value * (1.0 - 1e-9))
        .unwrap_or(value)
}

/// A copy so coarse that its layer can be seen: the first kernel that the law accepts.
fn visible(law: &dyn Characteristic, speed: f64) -> Option<Smoothing> {
    let of = |kernel: Kernel| Smoothing {
        kernel,
        size: if kernel.is_bump() {
            round(0.02 * speed)
        } else {
            round(20.0 / speed)
        },
    };
    Kernel::ALL
        .into_iter()
        .map(of)
        .find(|smoothing| law.accepts(*smoothing).is_ok())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examples::Weakening;

    fn law(peak: f64) -> Weakening<f64> {
        Weakening {
            peak,
            limit: 1.0,
            decay: 3.0,
        }
    }

    #[test]
    fn the_set_at_rest_stands_between_the_directions() {
        let curve = Curve::of(&law(1.5), ["m/s", "N"], None, None);
        assert_eq!(curve.speed, 0.5);
        assert!(
            curve
                .samples
                .windows(2)
                .all(|pair| pair[0].speed <= pair[1].speed)
        );
        let rest = curve.samples.iter().filter(|sample| sample.speed == 0.0);
        let forces: Vec<f64> = rest.map(|sample| sample.force).collect();
        assert_eq!(forces, [-1.0, -1.5, 1.5, 1.0]);
    }

    #[test]
    fn the_copy_is_one_that_the_law_accepts() {
        let kernel = |peak| {
            Curve::of(&law(peak), ["", ""], None, None)
                .smoothing
                .map(|s| s.kernel)
        };
        assert_eq!(kernel(1.0), Some(Kernel::Arctan));
        assert_eq!(kernel(1.5), Some(Kernel::Quartic));
    }

    #[test]
    fn steps_are_round() {
        assert_eq!([0.9, 1.0, 1.1, 0.03].map(round), [1.0, 1.0, 2.0, 0.05]);
    }
}
