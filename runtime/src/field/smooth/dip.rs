//! Whether a step goes through a layer and back without feeling it.

use super::SmoothField;
use super::rules::{Gaps, Turns};
use crate::model::Model;
use crate::scalar::{Inline, mapped};

/// Where the ends of a step show which way a speed goes.
const NEAR_END: f64 = 0.02;
/// Parts of a step at whose ends it is looked for dips.
const LOOKS: usize = 24;

/// Where the least of these values is, or that of the parabola through the least and its neighbours, and that itself.
fn lowest(values: &[f64; LOOKS + 1]) -> (f64, f64) {
    let least = (0..=LOOKS).min_by(|&a, &b| values[a].total_cmp(&values[b]));
    let Some(k) = least.filter(|k| (1..LOOKS).contains(k)) else {
        return (0.0, values[0].min(values[LOOKS]));
    };
    let (left, right) = (values[k - 1] - values[k], values[k + 1] - values[k]);
    let bend = (left + right).max(f64::MIN_POSITIVE);
    let theta = (k as f64 + 0.5 * (left - right) / bend) / LOOKS as f64;
    (theta, values[k] - (left - right).powi(2) / (8.0 * bend))
}

/// Whether a height beside an end of a step is on its way from above zero there towards it.
fn falls(end: f64, beside: f64) -> bool {
    end > 0.0 && beside < end
}

/// Where along [0, 1] a height falls below zero that falls from above it and rises above it again.
fn dip(height: impl Fn(f64) -> f64) -> Option<f64> {
    let at = |k: usize| height(k as f64 / LOOKS as f64);
    let (theta, least) = lowest(&crate::scalar::filled(at));
    (least < 0.0).then_some(theta)
}

impl<M: Model<N>, const N: usize> SmoothField<M, N> {
    /// Whether a motion `along` [0, 1] enters a layer and leaves it again where neither of its ends shows it.
    ///
    /// A step that does has not felt the friction there.
    #[must_use]
    pub fn dips(&self, along: &dyn Fn(f64) -> [f64; N]) -> bool {
        // A bump holds the motion between 0 and 4; the other layers turn the force where the speed turns.
        let edge = if self.smoothing.kernel.is_bump() {
            4.0
        } else {
            0.0
        };
        let heights = |theta: f64| {
            let mut heights = M::PerContact::from_fn(|_| f64::INFINITY);
            self.speeds(&along(theta), |contact, speed| {
                heights.as_mut()[contact] = speed * self.rule.sharpness;
            });
            heights
        };
        let first = heights(0.0);
        let above = |contact: usize, heights: &M::PerContact<f64>| {
            let side = if edge > 0.0 {
                1.0
            } else {
                first.as_ref()[contact].signum()
            };
            side * heights.as_ref()[contact] - edge
        };
        let contacts = 0..M::INFO.contacts.len();
        let after = heights(NEAR_END);
        let enters = |i: &usize| falls(above(*i, &first), above(*i, &after));
        if !contacts.clone().any(|i| enters(&i)) {
            return false;
        }
        let [before, last] = mapped(&[1.0 - NEAR_END, 1.0], heights);
        let leaves = |i: &usize| falls(above(*i, &last), above(*i, &before));
        contacts
            .filter(|i| enters(i) && leaves(i))
            .any(|i| dip(|theta| above(i, &heights(theta))).is_some())
    }

    /// Where along [0, 1] a motion enters the layer in which a press sets in, if it leaves it again before the end.
    #[must_use]
    pub fn touches(&self, along: &dyn Fn(f64) -> [f64; N]) -> Option<f64> {
        let mut presses = 0..M::INFO.presses.len();
        presses.find_map(|press| {
            let height = |theta: f64| self.height(press, &along(theta)) - 1.0;
            let falls = |end: f64, beside: f64| falls(height(end), height(beside));
            let passes = falls(0.0, NEAR_END) && falls(1.0, 1.0 - NEAR_END);
            passes.then(|| dip(height))?
        })
    }

    /// The gap of a press, in widths of its layer.
    pub(super) fn height(&self, press: usize, y: &[f64; N]) -> f64 {
        let (wanted, mut found) = (M::INFO.contacts.len() + press, f64::INFINITY);
        let mut visit = Gaps(|contact, gap| {
            if contact == wanted {
                found = gap * self.rule.sharpness;
            }
        });
        let _ = M::rhs(&self.values, *y, &mut visit);
        found
    }

    /// The rate of a gap that does not give way, in widths of the layer in which it turns; infinite for one that does.
    pub(super) fn turn(&self, press: usize, y: &[f64; N]) -> f64 {
        let (wanted, mut found) = (M::INFO.contacts.len() + press, f64::INFINITY);
        let mut visit = Turns(|contact, rate| {
            if contact == wanted {
                found = rate * self.rule.sharpness.sqrt();
            }
        });
        let _ = M::rhs(&self.values, *y, &mut visit);
        found
    }
}
