//! Whether what vanishes at a border is least there, and not largest.

use super::candidate::Border;
use crate::flow::FlowError;
use crate::motion::Flow;

/// Shares of the period between which that is asked: fast motions bend it anew soon.
const LATEST: f64 = 1e-3;
const EARLIEST: f64 = 1e-6;
/// Over what one look says of its curvature, another one may say if they are alike.
const ALIKE: f64 = 4.0;

impl Border {
    /// Whether it rises next to the border, as the motion comes there: where two looks tell about the same curvature, the later
    /// ones first, as rounding may tell the others.
    ///
    /// # Errors
    /// The motion cannot be followed.
    pub(super) fn rises(
        &self,
        flow: &dyn Flow,
        state: &[f64],
        period: f64,
    ) -> Result<bool, FlowError> {
        let mut share = 0.5 * LATEST;
        let bend = |share: f64| self.bend(flow, state, (share, period));
        let mut looks = [bend(LATEST)?, bend(share)?];
        while share > EARLIEST && !alike(looks) {
            share *= 0.5;
            looks = [looks[1], bend(share)?];
        }
        Ok(looks[1] > 0.0)
    }

    /// The rate of it after a share of the period, over that; 0 where it is not known.
    fn bend(
        &self,
        flow: &dyn Flow,
        state: &[f64],
        (share, period): (f64, f64),
    ) -> Result<f64, FlowError> {
        let (later, _) = flow.glide(&self.coming(state), share * period)?;
        let touch = self.touch(flow, &later)?;
        Ok(touch.map_or(0.0, |[_, rate]| rate / share))
    }
}

/// Whether two curvatures are about the same.
fn alike([first, second]: [f64; 2]) -> bool {
    let ratio = first / second;
    (1.0 / ALIKE..ALIKE).contains(&ratio)
}
