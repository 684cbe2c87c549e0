//! Whether a branch crawls: many short steps in a row, as Newton's method takes them where errors grow on the way.

use nalgebra::DVector;

/// A step that changes no unknown by more than this share of its usual size is short:
const SHORT: f64 = 5e-3;
/// so many in a row are crawling.
const PATIENCE: usize = 10;

/// The short steps behind the last orbit of a branch.
#[derive(Debug, Clone, Default)]
pub(super) struct Crawl {
    last: Option<DVector<f64>>,
    short: usize,
}

impl Crawl {
    /// Takes one more orbit; whether the branch crawls there, which is said once every so many steps.
    pub(super) fn reaches(&mut self, z: &DVector<f64>, scale: &DVector<f64>) -> bool {
        let short = self.last.as_ref().is_some_and(|last| {
            last.len() == z.len() && (z - last).component_div(scale).amax() <= SHORT
        });
        self.short = if short { self.short + 1 } else { 0 };
        self.last = Some(z.clone());
        let crawls = self.short >= PATIENCE;
        if crawls {
            self.short = 0;
        }
        crawls
    }
}
