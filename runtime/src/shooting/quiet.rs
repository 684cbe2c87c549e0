//! A motion that has stopped: as nothing moves any more, no time will tell more.

/// Share of what a state has moved below which it moves no more.
const NOTHING: f64 = 1e-7;
/// A state moves that changes by more than this share of what it ever did, and by more than noise.
const MOVES: f64 = 1e-3;
const NOISE: f64 = 1e-9;
/// Spans without motion, each twice as long as the one before.
const SPANS: u32 = 8;
/// What creeps goes twice as far in twice the time, and errors of the integrator do not: so often is what they grow by.
const GROWTH: f64 = 16.0;
const ROUNDING: f64 = 4.0 * f64::EPSILON;
/// A rate below this share of the fastest that a state ever had is a rounding error of what makes it.
const STOPPED: f64 = 16.0 * f64::EPSILON;

/// How long nothing has moved.
#[derive(Debug, Clone)]
pub(super) struct Quiet {
    /// How far each state has moved in the last span, and the farthest that it has in one.
    latest: Vec<f64>,
    reach: Vec<f64>,
    /// The fastest that each has moved over one span.
    fastest: Vec<f64>,
    spans: u32,
    /// How many of the last ones nothing moved in but by rounding errors of rates: for however long those go on.
    stopped: u32,
    /// The largest motion in the first of these spans, and in the last one.
    moved: [f64; 2],
}

impl Quiet {
    pub(super) fn new(order: usize) -> Self {
        Self {
            latest: vec![0.0; order],
            reach: vec![0.0; order],
            fastest: vec![0.0; order],
            spans: 0,
            stopped: 0,
            moved: [0.0; 2],
        }
    }

    /// Takes a span of this length from this state, and the smallest and largest values in it.
    pub(super) fn take(&mut self, length: f64, from: &[f64], [low, high]: [&[f64]; 2]) {
        let (mut moved, mut stops) = (0.0_f64, true);
        for (j, reach) in self.reach.iter_mut().enumerate() {
            let change = high[j].max(from[j]) - low[j].min(from[j]);
            self.latest[j] = change;
            self.fastest[j] = self.fastest[j].max(change / length);
            stops &= change / length <= STOPPED * self.fastest[j];
            *reach = reach.max(change);
            let size = reach.max(from[j].abs());
            if change > 0.0 {
                moved = moved.max(change / size);
            }
        }
        self.stopped = if stops { self.stopped + 1 } else { 0 };
        if moved > NOTHING {
            self.spans = 0;
            return;
        }
        if self.spans == 0 {
            self.moved[0] = moved;
        }
        self.moved[1] = moved;
        self.spans += 1;
    }

    /// How far each state has moved in the last span, and the farthest that it has in one.
    pub(super) fn extents(&self) -> [&[f64]; 2] {
        [&self.latest, &self.reach]
    }

    /// How far each state may be from where it comes to rest once nothing counts that it moves by.
    pub(super) fn errors(&self) -> Vec<f64> {
        self.reach.iter().map(|reach| NOTHING * reach).collect()
    }

    /// Which states move by these extents that count for something beside where they are and what they ever did.
    pub(super) fn moving(&self, state: &[f64], extents: &[f64]) -> Vec<usize> {
        let size = |j: usize| state[j].abs().max(self.reach[j]);
        let moves = |j: &usize| extents[*j] > (MOVES * size(*j)).max(NOISE);
        (0..extents.len()).filter(moves).collect()
    }

    /// Whether it has been quiet for so long that it will be so for ever.
    pub(super) fn lasts(&self) -> bool {
        let [first, last] = self.moved;
        let bounded = last <= (GROWTH * first).max(ROUNDING);
        self.spans >= SPANS && (bounded || self.stopped >= SPANS)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn noise_is_quiet_and_what_creeps_is_not() {
        let after = |change: fn(u32) -> f64| {
            let mut quiet = Quiet::new(1);
            quiet.take(1.0, &[1.0], [&[-1.0], &[1.0]]);
            for span in 0..SPANS {
                let length = f64::from(1 << span);
                quiet.take(length, &[0.0], [&[0.0], &[change(span)]]);
            }
            quiet.lasts()
        };
        assert!(after(|_| 0.0));
        assert!(after(|span| [1e-10, 3e-10][span as usize % 2]));
        assert!(after(|span| 1e-8 / f64::from(span + 1)));
        assert!(!after(|span| 1e-12 * f64::from(1 << span)));
        // What rounding makes of a rate creeps as well.
        assert!(after(|span| 1e-15 * f64::from(1 << span)));
        assert!(!after(|_| 1e-3));
    }
}
