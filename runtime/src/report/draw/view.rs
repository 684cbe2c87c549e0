//! Where the points of a panel are drawn.

use super::scale::Scale;

/// No renderer draws what is further away, px.
const FAR: f64 = 1e5;

/// The scales of a panel, and the ends of its frame, px.
pub(super) struct View {
    pub(super) x: Scale,
    pub(super) y: Scale,
    pub(super) left: f64,
    pub(super) right: f64,
    pub(super) top: f64,
    pub(super) bottom: f64,
}

/// A place as far away as renderers can draw at most; what has none keeps none.
const fn near(at: f64) -> f64 {
    if at.is_finite() {
        at.clamp(-FAR, FAR)
    } else {
        at
    }
}

impl View {
    /// Where a point is drawn, px; not finite if nowhere.
    pub(super) fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.across(x), self.up(y)]
    }

    /// A direction at a point as it is drawn.
    pub(super) fn direction(&self, [x, y]: [f64; 2], [along, up]: [f64; 2]) -> [f64; 2] {
        let [width, height] = [self.right - self.left, self.bottom - self.top];
        [
            along * self.x.rate(x) * width,
            -up * self.y.rate(y) * height,
        ]
    }

    pub(super) fn across(&self, x: f64) -> f64 {
        near(self.left + self.x.share(x) * (self.right - self.left))
    }

    pub(super) fn up(&self, y: f64) -> f64 {
        near(self.bottom - self.y.share(y) * (self.bottom - self.top))
    }

    /// Its width and height, px.
    pub(super) fn size(&self) -> [f64; 2] {
        [self.right - self.left, self.bottom - self.top]
    }

    /// Whether a place is inside, or less than a pixel outside.
    pub(super) fn holds(&self, [x, y]: [f64; 2]) -> bool {
        (self.left - 1.0..self.right + 1.0).contains(&x)
            && (self.top - 1.0..self.bottom + 1.0).contains(&y)
    }
}
