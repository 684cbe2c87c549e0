//! A trade as a list: what its items ask, and what they find.

use serde::{Deserialize, Serialize};

use super::record::{Cost, Need, Point, Precision, Scope, Setting, Truth};
use crate::field::{Kernel, Smoothing};
use crate::study::question::{Along, Case};
use crate::study::work::Rows;

/// What an item asks at one end.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Task {
    /// The exact orbit.
    Exact,
    /// The copy by a kernel, of this place among those of the scope, of a size of this place among its sizes.
    Copy { kernel: usize, place: usize },
    /// What such a kernel needs for an accuracy.
    Need { kernel: usize, accuracy: f64 },
}

/// What an item finds.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum Part {
    /// The exact orbit.
    Exact(Box<Exact>),
    /// A copy.
    Copy(Box<Copied>),
    /// That there is no copy, and why.
    Lost(String),
    /// The cheapest setting of a kernel for the accuracy asked for, or why there is none.
    Need(Box<Result<Need, String>>),
    /// Why the model's laws do not accept the kernel.
    Refused(String),
}

/// What is found of the exact orbit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Exact {
    /// The orbit.
    pub truth: Truth,
    /// Its work-precision curve.
    pub precision: Precision,
    /// The cheapest setting for the accuracy asked for.
    pub need: Option<Result<Setting, String>>,
}

/// What is found of a copy.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Copied {
    /// Which it is.
    pub smoothing: Smoothing,
    /// The copy.
    pub point: Point,
    /// Its work-precision curve.
    pub precision: Precision,
}

/// The range whose ends are judged, if the case has one.
pub(super) fn range(case: &Case) -> Option<Along> {
    case.along
        .filter(|along| along.design.parameter().is_some())
}

impl Scope {
    /// The items of a trade of a case, as many at each of its ends; none builds on another.
    #[must_use]
    pub fn rows(&self, case: &Case) -> Rows {
        let ends = if range(case).is_some() { 2 } else { 1 };
        Rows::of(self.tasks().len().saturating_mul(ends))
    }

    /// The end to which an item belongs.
    #[must_use]
    pub fn end_of(&self, item: usize) -> usize {
        item / self.tasks().len()
    }

    /// The sizes of a kernel, towards the exact law.
    pub(super) fn sizes(&self, kernel: Kernel) -> &[f64] {
        if kernel.is_bump() {
            &self.bump_sizes
        } else {
            &self.sign_sizes
        }
    }

    /// The copy at a place of each.
    pub(super) fn smoothing(&self, kernel: usize, place: usize) -> Smoothing {
        let kernel = self.kernels[kernel];
        let size = self.sizes(kernel)[place];
        Smoothing { kernel, size }
    }

    /// The items of one end: of each kernel the copies that are nearest to the exact law come first.
    pub(super) fn tasks(&self) -> Vec<Task> {
        let mut tasks = vec![Task::Exact];
        for (kernel, one) in self.kernels.iter().enumerate() {
            let places = (0..self.sizes(*one).len()).rev();
            tasks.extend(places.map(|place| Task::Copy { kernel, place }));
            let need = |accuracy| Task::Need { kernel, accuracy };
            tasks.extend(self.accuracy.map(need));
        }
        tasks
    }
}

impl Part {
    /// Whether it can belong to a system with so many states.
    #[must_use]
    pub fn is_of(&self, order: usize) -> bool {
        match self {
            Self::Exact(exact) => exact.truth.max_abs.len() == order,
            Self::Copy(copied) => copied.point.max_abs.len() == order,
            Self::Lost(_) | Self::Need(_) | Self::Refused(_) => true,
        }
    }

    /// The same without times, which are measured and differ each time.
    #[must_use]
    pub fn timeless(&self) -> Self {
        let mut part = self.clone();
        match &mut part {
            Self::Exact(exact) => {
                exact.truth.cost.forget();
                exact.precision.forget();
                if let Some(Ok(setting)) = &mut exact.need {
                    setting.cost.forget();
                }
            }
            Self::Copy(copied) => {
                copied.point.cost.forget();
                copied.precision.forget();
            }
            Self::Need(need) => {
                if let Ok(need) = need.as_mut() {
                    need.setting.cost.forget();
                }
            }
            Self::Lost(_) | Self::Refused(_) => {}
        }
        part
    }
}

impl Cost {
    const fn forget(&mut self) {
        self.seconds = 0.0;
    }
}

impl Precision {
    fn forget(&mut self) {
        self.points.iter_mut().for_each(|point| point.cost.forget());
    }
}
