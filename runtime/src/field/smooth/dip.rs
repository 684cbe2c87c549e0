//! Whether a step goes through a friction layer and back without feeling it.

use super::SmoothField;
use crate::model::Model;
use crate::scalar::Inline;

/// Where the ends of a step show which way a speed goes.
const NEAR_END: f64 = 0.02;
/// Parts of a step at whose ends it is looked for dips.
const LOOKS: usize = 24;

/// The least of these values, or of the parabola through the least and its neighbours.
fn lowest(values: &[f64; LOOKS + 1]) -> f64 {
    let least = (0..=LOOKS).min_by(|&a, &b| values[a].total_cmp(&values[b]));
    let Some(k) = least.filter(|k| (1..LOOKS).contains(k)) else {
        return values[0].min(values[LOOKS]);
    };
    let (left, right) = (values[k - 1] - values[k], values[k + 1] - values[k]);
    values[k] - (left - right).powi(2) / (8.0 * (left + right).max(f64::MIN_POSITIVE))
}

impl<M: Model<N>, const N: usize> SmoothField<M, N> {
    /// Whether a motion `along` [0, 1] enters a layer and leaves it again where neither of its ends shows it.
    ///
    /// A step that does has not felt the friction there.
    #[must_use]
    pub fn dips(&self, along: impl Fn(f64) -> [f64; N]) -> bool {
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
        let ends = [0.0, NEAR_END, 1.0 - NEAR_END, 1.0].map(heights);
        (0..M::INFO.contacts.len()).any(|contact| {
            let [first, after, before, last] = [0, 1, 2, 3].map(|k| ends[k].as_ref()[contact]);
            let side = if edge > 0.0 { 1.0 } else { first.signum() };
            let height = |value: f64| side * value - edge;
            let outside = height(first) > 0.0 && height(last) > 0.0;
            let turns = height(after) < height(first) && height(before) < height(last);
            outside && turns && {
                let at = |k: usize| height(heights(k as f64 / LOOKS as f64).as_ref()[contact]);
                lowest(&std::array::from_fn(at)) < 0.0
            }
        })
    }
}
