//! A trade: what its items find, and what they make together.

use super::accuracy::cheapest;
use super::copy::Copies;
use super::fit::Fit;
use super::precision;
use super::record::{Curve, Scope, Trade, Truth};
use super::shoot::{Effort, cost};
use super::task::{Copied, Exact, Part, Task};
use crate::field::Kernel;
use crate::study::error::TradeError;

impl Copies<'_> {
    /// The exact orbit and what it costs.
    ///
    /// # Errors
    /// It cannot be followed.
    pub(super) fn measured(&self) -> Result<Truth, TradeError> {
        Ok(Truth {
            period: self.truth.period,
            max_abs: self.truth.max_abs(),
            period_count: self.truth.count,
            cost: cost(&self.system.family(&self.case), &self.truth)?,
        })
    }

    /// What an item finds.
    pub(super) fn part(&self, task: Task, truth: &Truth) -> Part {
        match task {
            Task::Exact => Part::Exact(Box::new(self.exact(truth))),
            Task::Copy { kernel, place } => {
                self.accepted(kernel, || match self.copied(kernel, place) {
                    Ok(copied) => Part::Copy(Box::new(copied)),
                    Err(reason) => Part::Lost(reason),
                })
            }
            Task::Need { kernel, accuracy } => self.accepted(kernel, || {
                let need = self.need(kernel, accuracy);
                Part::Need(Box::new(need.map_err(|reason| reason.to_string())))
            }),
        }
    }

    fn exact(&self, truth: &Truth) -> Exact {
        let family = self.system.family(&self.case);
        let need = self.scope.accuracy.map(|accuracy| {
            let found = cheapest(&family, &self.truth, &self.truth, accuracy);
            found.map_err(|reason| reason.to_string())
        });
        Exact {
            precision: precision::of(None, &family, &self.truth, &self.truth, self.scope),
            truth: truth.clone(),
            need,
        }
    }

    /// What is found of a kernel that the model's laws accept.
    fn accepted(&self, kernel: usize, part: impl Fn() -> Part) -> Part {
        match self.refusal(self.scope.kernels[kernel]) {
            Some(reason) => Part::Refused(reason.to_string()),
            None => part(),
        }
    }

    fn copied(&self, kernel: usize, place: usize) -> Result<Copied, String> {
        let found = self.copy(kernel, place).as_ref();
        let (point, shooting) = found.map_err(ToString::to_string)?;
        let smoothing = self.scope.smoothing(kernel, place);
        let family = self.family(smoothing, Effort::TIGHT.tolerance);
        let smoothed = Some(smoothing);
        Ok(Copied {
            smoothing,
            point: point.clone(),
            precision: precision::of(smoothed, &family, shooting, &self.truth, self.scope),
        })
    }
}

/// What these parts make, as far as they are there; without its own part, the exact orbit is this one.
pub(super) fn gathered(
    scope: &Scope,
    truth: &Truth,
    parts: impl Iterator<Item = (Task, Part)>,
) -> Trade {
    let mut trade = Trade {
        exact: truth.clone(),
        curves: Vec::new(),
        precision: Vec::new(),
        need: None,
    };
    let mut curves: Vec<Gathered> = scope.kernels.iter().map(|one| Gathered::of(*one)).collect();
    for (task, part) in parts {
        match (task, part) {
            (_, Part::Exact(exact)) => {
                trade.exact = exact.truth;
                trade.precision.push(exact.precision);
                trade.need = exact.need;
            }
            (Task::Copy { kernel, place }, part) => {
                curves[kernel].take(part, Some(scope.smoothing(kernel, place).size));
            }
            (Task::Need { kernel, .. }, part) => curves[kernel].take(part, None),
            (Task::Exact, _) => {}
        }
    }
    for gathered in curves.into_iter().filter(|curve| curve.begun) {
        let (curve, precision) = gathered.fitted(truth.max_abs.len());
        trade.precision.extend(precision);
        trade.curves.push(curve);
    }
    trade
}

/// The copies of a kernel, the finest first.
struct Gathered {
    curve: Curve,
    precision: Vec<super::Precision>,
    /// Whether anything of it is there.
    begun: bool,
}

impl Gathered {
    fn of(kernel: Kernel) -> Self {
        let curve = Curve {
            kernel,
            refused: None,
            points: Vec::new(),
            lost: Vec::new(),
            frequency: None,
            max_abs: Vec::new(),
            need: None,
        };
        Self {
            curve,
            precision: Vec::new(),
            begun: false,
        }
    }

    /// Takes what was found; of a copy, at this size.
    fn take(&mut self, part: Part, size: Option<f64>) {
        self.begun = true;
        match part {
            Part::Copy(copied) => {
                self.curve.points.push(copied.point);
                self.precision.push(copied.precision);
            }
            Part::Lost(reason) => self.curve.lost.extend(size.map(|size| (size, reason))),
            Part::Need(need) => self.curve.need = Some(*need),
            Part::Refused(reason) => self.curve.refused = Some(reason),
            Part::Exact(_) => {}
        }
    }

    /// The curve towards the exact law, with lines through the errors of so many states.
    fn fitted(self, states: usize) -> (Curve, Vec<super::Precision>) {
        let Self {
            mut curve,
            mut precision,
            ..
        } = self;
        curve.points.reverse();
        curve.lost.reverse();
        precision.reverse();
        if curve.refused.is_none() {
            let points = curve.points.iter();
            let fit = |of: &dyn Fn(&super::Point) -> f64| {
                Fit::through(points.clone().map(|point| (point.size, of(point))))
            };
            curve.frequency = fit(&|point| point.frequency);
            curve.max_abs = (0..states)
                .map(|j| fit(&|point| point.max_abs[j]))
                .collect();
        }
        (curve, precision)
    }
}
