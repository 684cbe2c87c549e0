//! Shares as areas: along lines across a plane region it is found out where basins end, and the lengths are integrated.

use crate::study::work::parallel_on;

/// Places on a line between which basins are looked for: a basin that is narrower everywhere is overlooked.
const PLACES: usize = 64;
/// Share of a line to which the end of a basin is found.
const ENDS: f64 = 1e-8;
/// Panels into which the lines are divided at first.
const PANELS: usize = 8;
/// Error of the shares at which no more lines are drawn, and most rounds of them.
const ERROR: f64 = 2e-6;
const ROUNDS: usize = 14;

/// The shares of all basins, with the largest of their estimated errors.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Areas {
    pub(super) shares: Vec<f64>,
    pub(super) error: f64,
}

/// The shares of `count` basins of the unit square; `basin` tells to which a point belongs.
pub(super) fn areas(
    count: usize,
    threads: Option<usize>,
    basin: &(dyn Fn([f64; 2]) -> usize + Sync),
) -> Areas {
    let lengths = |y: &f64| line(count, &|x| basin([x, *y]));
    let lines = |heights: &[f64]| parallel_on(threads, heights, lengths);
    let ends: Vec<f64> = (0..=4 * PANELS)
        .map(|k| k as f64 / (4 * PANELS) as f64)
        .collect();
    let first = lines(&ends);
    let mut panels: Vec<Panel> = (0..PANELS)
        .map(|k| {
            Panel::new(
                [ends[4 * k], ends[4 * k + 4]],
                first[4 * k..4 * k + 5].to_vec(),
            )
        })
        .collect();
    for _ in 0..ROUNDS {
        let total: f64 = panels.iter().map(Panel::error).sum();
        if total <= ERROR {
            break;
        }
        // What contributes least can wait: together it is below half of what is allowed.
        let least = 0.5 * ERROR / panels.len() as f64;
        let heights: Vec<f64> = panels
            .iter()
            .filter(|panel| panel.error() > least)
            .flat_map(Panel::between)
            .collect();
        let mut new = lines(&heights).into_iter();
        panels = panels
            .into_iter()
            .flat_map(|panel| panel.halved(least, &mut new))
            .collect();
    }
    let mut shares = vec![0.0; count];
    for panel in &panels {
        for (share, part) in shares.iter_mut().zip(panel.integral()) {
            *share += part;
        }
    }
    Areas {
        shares,
        error: panels.iter().map(Panel::error).sum(),
    }
}

/// The lengths of all basins along a line from 0 to 1.
fn line(count: usize, basin: &dyn Fn(f64) -> usize) -> Vec<f64> {
    let mut lengths = vec![0.0; count];
    let mut add = |of: usize, length: f64| {
        if let Some(sum) = lengths.get_mut(of) {
            *sum += length;
        }
    };
    let (mut from, mut here) = (0.0, basin(0.0));
    for k in 1..=PLACES {
        let (to, there) = (k as f64 / PLACES as f64, basin(k as f64 / PLACES as f64));
        // Between two places there may be a third basin: what is found is where the first one ends.
        while here != there {
            let (mut inside, mut outside, mut next) = (from, to, there);
            while outside - inside > ENDS {
                let middle = 0.5 * (inside + outside);
                match basin(middle) {
                    of if of == here => inside = middle,
                    of => (outside, next) = (middle, of),
                }
            }
            let end = 0.5 * (inside + outside);
            add(here, end - from);
            (from, here) = (end, next);
        }
        add(here, to - from);
        from = to;
    }
    lengths
}

/// Lines at five heights, evenly spaced, over which Simpson's rule is applied once and twice.
struct Panel {
    ends: [f64; 2],
    lines: Vec<Vec<f64>>,
}

impl Panel {
    fn new(ends: [f64; 2], lines: Vec<Vec<f64>>) -> Self {
        Self { ends, lines }
    }

    fn simpson(&self, share: usize, lines: [usize; 3], parts: f64) -> f64 {
        let [a, b, c] = lines.map(|i| self.lines[i][share]);
        (self.ends[1] - self.ends[0]) / parts * (a + 4.0 * b + c) / 6.0
    }

    fn once(&self, share: usize) -> f64 {
        self.simpson(share, [0, 2, 4], 1.0)
    }

    fn twice(&self, share: usize) -> f64 {
        self.simpson(share, [0, 1, 2], 2.0) + self.simpson(share, [2, 3, 4], 2.0)
    }

    fn integral(&self) -> impl Iterator<Item = f64> + '_ {
        (0..self.lines[0].len()).map(|share| self.twice(share))
    }

    /// What the two differ by: where a boundary touches a line, nothing better is known.
    fn error(&self) -> f64 {
        let differ = |share: usize| (self.twice(share) - self.once(share)).abs();
        (0..self.lines[0].len()).map(differ).fold(0.0, f64::max)
    }

    /// The heights between its lines.
    fn between(&self) -> impl Iterator<Item = f64> + use<> {
        let [low, high] = self.ends;
        [1.0, 3.0, 5.0, 7.0]
            .into_iter()
            .map(move |k| low + (high - low) * k / 8.0)
    }

    /// Its halves with new lines between its own, if its error is worth it.
    fn halved(self, least: f64, new: &mut impl Iterator<Item = Vec<f64>>) -> Vec<Self> {
        if self.error() <= least {
            return vec![self];
        }
        let [low, high] = self.ends;
        let middle = 0.5 * (low + high);
        let mut all = Vec::with_capacity(9);
        for line in self.lines {
            all.push(line);
            if all.len() < 9 {
                all.extend(new.next());
            }
        }
        if all.len() < 9 {
            return Vec::new();
        }
        let upper = all[4..].to_vec();
        all.truncate(5);
        vec![
            Self::new([low, middle], all),
            Self::new([middle, high], upper),
        ]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_disc_and_a_strip_have_their_areas() {
        let basin = |[x, y]: [f64; 2]| {
            let inside = (x - 0.4).powi(2) + (y - 0.5).powi(2) < 0.09;
            match () {
                () if inside => 1,
                () if x > 0.8 + 0.1 * y => 2,
                () => 0,
            }
        };
        let found = areas(3, Some(2), &basin);
        let disc = std::f64::consts::PI * 0.09;
        let wanted = [1.0 - disc - 0.15, disc, 0.15];
        assert!(found.error < 1e-5, "{found:?}");
        for (share, wanted) in found.shares.iter().zip(wanted) {
            assert!(
                (share - wanted).abs() < found.error.max(2e-6),
                "{found:?} {wanted}"
            );
        }
    }
}
