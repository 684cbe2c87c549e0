//! A curve against time, thinned while it is drawn so that none of its peaks is lost.

/// Stretches into which a curve is divided at most; more could not be told apart.
const MOST: usize = 1000;

/// The lowest and the highest point of each of at most a thousand stretches of a curve.
///
/// Of up to two thousand points none is left out.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Envelope {
    /// Points in each stretch; 0 before there is one.
    every: usize,
    /// Points in the last stretch.
    last: usize,
    /// The lowest and the highest point of each.
    stretches: Vec<[[f64; 2]; 2]>,
}

impl Envelope {
    /// One more point, later than all others.
    pub fn add(&mut self, point: [f64; 2]) {
        self.every = self.every.max(1);
        if self.last == self.every || self.stretches.is_empty() {
            if self.stretches.len() == MOST {
                self.halve();
            }
            self.stretches.push([point; 2]);
            self.last = 1;
        } else if let Some(stretch) = self.stretches.last_mut() {
            *stretch = joined([*stretch, [point; 2]]);
            self.last += 1;
        }
    }

    /// Joins each two neighbours.
    fn halve(&mut self) {
        let pairs = self.stretches.chunks(2);
        self.stretches = pairs
            .map(|pair| pair.iter().copied().reduce(|a, b| joined([a, b])))
            .map(Option::unwrap_or_default)
            .collect();
        self.every *= 2;
    }

    /// What is left of the curve, in the order of time.
    #[must_use]
    pub fn points(&self) -> Vec<[f64; 2]> {
        let in_time = |&[low, high]: &[[f64; 2]; 2]| match low[0].total_cmp(&high[0]) {
            std::cmp::Ordering::Less => vec![low, high],
            std::cmp::Ordering::Equal => vec![low],
            std::cmp::Ordering::Greater => vec![high, low],
        };
        self.stretches.iter().flat_map(in_time).collect()
    }
}

impl FromIterator<[f64; 2]> for Envelope {
    fn from_iter<I: IntoIterator<Item = [f64; 2]>>(points: I) -> Self {
        let mut envelope = Self::default();
        points.into_iter().for_each(|point| envelope.add(point));
        envelope
    }
}

/// The lowest and the highest point of two stretches; the earlier ones of equals.
fn joined([first, second]: [[[f64; 2]; 2]; 2]) -> [[f64; 2]; 2] {
    let low = if second[0][1] < first[0][1] {
        second[0]
    } else {
        first[0]
    };
    let high = if second[1][1] > first[1][1] {
        second[1]
    } else {
        first[1]
    };
    [low, high]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn wave(count: usize) -> Vec<[f64; 2]> {
        (0..count)
            .map(|i| i as f64)
            .map(|t| [t, (0.7 * t * t).sin()])
            .collect()
    }

    #[test]
    fn few_points_are_all_drawn() {
        for count in [0, 1, 2, 999, 1000, 1001, 1999, 2000] {
            let wave = wave(count);
            let drawn = wave.iter().copied().collect::<Envelope>().points();
            assert_eq!(drawn, wave, "{count}");
        }
    }

    #[test]
    fn each_stretch_keeps_its_lowest_and_highest_point() {
        for count in [2001, 4000, 123_457] {
            let wave = wave(count);
            let envelope: Envelope = wave.iter().copied().collect();
            let drawn = envelope.points();
            assert!(
                drawn.len() <= 2 * MOST && drawn.is_sorted_by(|a, b| a[0] < b[0]),
                "{count}"
            );
            let size = count.div_ceil(MOST).next_power_of_two();
            for stretch in wave.chunks(size) {
                let values = || stretch.iter().map(|point| point[1]);
                let (low, high) = (values().fold(1.0, f64::min), values().fold(-1.0, f64::max));
                for wanted in [low, high] {
                    let there = drawn.iter().any(|point| {
                        point[1] == wanted
                            && stretch[0][0] <= point[0]
                            && point[0] <= stretch[stretch.len() - 1][0]
                    });
                    assert!(there, "{count}: {wanted}");
                }
            }
        }
    }
}
