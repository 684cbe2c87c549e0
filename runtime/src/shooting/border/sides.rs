//! The return maps on both sides of a border, and where orbits lie there: the normal forms of its unfolding.
//!
//! The place y from which shooting starts is mapped to the border, past it, and back. What a short event adds to the
//! passage at the border is, to first order, a matrix Ξ of rank one less: where a contact that slides touches w = 0 and
//! force does not drop, the brief stick takes out what was left of w, Ξ = I − d w_y / (w_y d) with d the direction in which
//! its force acts (grazing-sliding). At the other borders both sides have the same derivative (8.2), but for a brief stick
//! with a drop of friction, which has the saltation of its release besides, and for a press with a damper. Orbits lie where the
//! number that decides between the sides, g = g_y δy + g_r δr, has the sign of their side; since both maps differ in rank one,
//! det(I − A) det(I − B) > 0 has one of them on each side of r, and < 0 both on one: a non-smooth fold.
//!
//! Where a contact that does not give way is grazed, the return map of the orbits that are hit has no derivative: its
//! multiplier grows without bound; `hit` says how they leave it.

use nalgebra::{DMatrix, DVector};

use super::arrival::Arrival;
use super::candidate::Condition;
use super::passing::Passing;
use super::problem::BorderProblem;
use super::round::chain;
use super::runs::Runs;
use crate::continuation::Linearisation;
use crate::flow::FlowError;
use crate::linear::svd;
use crate::motion::{Derivatives, Family, Flow, Place};

/// Both sides of a border.
pub(super) struct Sides {
    /// Where shooting starts.
    pub(super) start: Place,
    /// The field there.
    pub(super) velocity: DVector<f64>,
    /// Share of the period that the maps take: half of it where they lead to a mirror image.
    turn: f64,
    /// The side on which the event does not happen, and that on which it does.
    maps: [Derivatives; 2],
    /// What is neutral.
    pub(super) runs: Runs,
    /// How the number that decides between the sides depends on the start, and on r.
    pub(super) number: (DVector<f64>, f64),
    /// Its sign on both sides.
    signs: [f64; 2],
    /// What a unit speed of approach adds to the start, where the contact that is grazed does not give way, and how fast the
    /// rate of its gap grows there.
    pub(super) kick: Option<(DVector<f64>, f64)>,
}

impl Sides {
    /// The sides of a border that was found.
    ///
    /// # Errors
    /// The motion cannot be followed.
    pub(super) fn of(
        problem: &mut BorderProblem<Family>,
        flow: &dyn Flow,
        (state, period): (&[f64], f64),
        (slopes, runs): (&DMatrix<f64>, &Runs),
    ) -> Result<Self, FlowError> {
        let round = problem.round(flow, state, period)?;
        let border = &problem.border;
        let order = state.len();
        let row = |i: usize| {
            let along = slopes.view((i, 0), (1, order)).transpose();
            (
                DVector::from_column_slice(along.as_slice()),
                slopes[(i, order + 1)],
            )
        };
        let passing = Passing {
            border,
            flow,
            state,
            period,
            guard: row(0),
            limit: row(1),
        };
        let arrival = Arrival::of(&round);
        let leaps = [passing.leap(false)?, passing.leap(true)?];
        let number = match border.condition {
            Condition::Touch => arrival.slope(&passing.guard),
            Condition::Edge => passing.on_surface(&arrival)?.slope(&passing.limit),
        };
        let happens = match border.condition {
            Condition::Touch => -1.0,
            Condition::Edge => 1.0,
        };
        let start = round.out.0.clone();
        let kick = match passing.kick()? {
            Some((kick, bend)) => Some((&round.out.1.state * kick, bend)),
            None => None,
        };
        Ok(Self {
            kick,
            turn: border.turn(),
            velocity: flow.velocity(&start)?.f,
            maps: leaps.map(|leap| arrival.through(&leap, &round)),
            runs: runs.through(&start.state),
            start,
            number,
            signs: [-happens, happens],
        })
    }

    /// The return map on the side where the event happens, or on the other.
    pub(super) fn map(&self, happens: bool) -> Derivatives {
        let map = self.map_once(happens);
        match self.is_half() {
            true => chain(map, map),
            false => map.clone(),
        }
    }

    /// The map from the border to it, or to its image.
    pub(super) fn map_once(&self, happens: bool) -> &Derivatives {
        &self.maps[usize::from(happens)]
    }

    /// Whether that is half of the way around.
    pub(super) fn is_half(&self) -> bool {
        self.turn < 1.0
    }

    /// Whether the return map on this side has no derivative.
    pub(super) fn is_unbounded(&self, happens: bool) -> bool {
        happens && self.kick.is_some()
    }

    /// The direction (start, period, r), in these units with r last, in which orbits leave the border on this side.
    pub(super) fn direction(
        &self,
        happens: bool,
        phase: &DVector<f64>,
        scale: &DVector<f64>,
        r_scale: f64,
    ) -> Option<DVector<f64>> {
        if self.is_unbounded(happens) {
            let hit = self.hit(phase, scale, r_scale)?;
            return Some(hit.direction);
        }
        let order = self.velocity.len();
        let n = order + 1;
        let matrix = self.matrix(happens, phase, scale, r_scale);
        let svd = svd(matrix)?;
        let rows = svd.v_t?;
        let direction = rows.row(svd.singular_values.imin()).transpose();
        let (along, by_r) = &self.number;
        let moved = direction
            .rows(0, order)
            .component_mul(&scale.rows(0, order));
        let number = along.dot(&moved) + by_r * direction[n] * r_scale;
        let sign = (number * self.signs[usize::from(happens)]).signum();
        direction
            .iter()
            .all(|x| x.is_finite())
            .then(|| direction * sign)
    }
}

impl Sides {
    /// What closes an orbit on this side and fixes its start, to first order in (start, period, r); a last row of zeros.
    pub(super) fn matrix(
        &self,
        happens: bool,
        phase: &DVector<f64>,
        scale: &DVector<f64>,
        r_scale: f64,
    ) -> DMatrix<f64> {
        let (map, order) = (self.map_once(happens), self.velocity.len());
        let n = order + 1;
        let slope = |i: usize, j: usize| match j {
            j if j < order => map.state[(i, j)] - f64::from(i == j),
            _ => self.turn * self.velocity[i],
        };
        let mut closing = Linearisation {
            residual: DVector::zeros(order),
            jacobian: DMatrix::from_fn(order, n, |i, j| slope(i, j) / scale[i]),
            design: DVector::from_fn(order, |i, _| map.design[i] / scale[i]),
            extra: (),
        };
        let magnitude = &scale.as_slice()[..order];
        self.runs.hold(&mut closing, &self.start.state, magnitude);
        let mut matrix = DMatrix::zeros(n + 1, n + 1);
        for i in 0..order {
            for j in 0..n {
                matrix[(i, j)] = closing.jacobian[(i, j)] * scale[j];
            }
            matrix[(i, n)] = closing.design[i] * r_scale;
            matrix[(order, i)] = phase[i] * scale[i];
        }
        let size = matrix.row(order).norm();
        matrix.row_mut(order).unscale_mut(size);
        matrix
    }
}
