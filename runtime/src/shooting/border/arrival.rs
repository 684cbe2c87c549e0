//! How the arrival at a border depends on where an orbit starts, and what a passage across a surface adds.

use nalgebra::{DMatrix, DVector};

use super::round::Round;
use crate::flow::Determinant;
use crate::motion::Derivatives;

/// How the arrival at the border depends on the start and on r.
pub(super) struct Arrival {
    pub(super) state: DMatrix<f64>,
    pub(super) design: DVector<f64>,
}

impl Arrival {
    pub(super) fn of(Round { back, .. }: &Round) -> Self {
        Self {
            state: back.1.state.clone(),
            design: back.1.design.clone(),
        }
    }

    /// How a number depends on the start and on r that has these slopes at the border.
    pub(super) fn slope(&self, (along, by_r): &(DVector<f64>, f64)) -> (DVector<f64>, f64) {
        (self.state.tr_mul(along), along.dot(&self.design) + by_r)
    }

    /// Past the border and back to the start.
    pub(super) fn through(&self, leap: &Self, round: &Round) -> Derivatives {
        let lead = &round.out.1;
        let passed = &leap.state * &self.design + &leap.design;
        Derivatives {
            state: &lead.state * &leap.state * &self.state,
            design: &lead.state * passed + &lead.design,
            time: lead.time.clone(),
            determinant: Determinant::ONE,
            factors: Vec::new(),
            lost: 0,
        }
    }
}

/// What comes, carried by `push` onto the surface g = 0 to which `towards` leads: y + push g / (g_y towards), times its sign.
pub(super) fn along(
    guard: &(DVector<f64>, f64),
    from: &Arrival,
    push: &DVector<f64>,
    towards: &DVector<f64>,
) -> Arrival {
    carried(guard, from, &(push / guard.0.dot(towards)))
}

/// What comes, carried by `push` for each unit of the number g: y + push g.
pub(super) fn carried(guard: &(DVector<f64>, f64), from: &Arrival, push: &DVector<f64>) -> Arrival {
    let (along, by_r) = from.slope(guard);
    Arrival {
        state: &from.state + push * along.transpose(),
        design: &from.design + push * by_r,
    }
}
