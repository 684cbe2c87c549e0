//! The return maps on both sides of a border, and where orbits lie there: the normal forms of its unfolding.
//!
//! The place y from which shooting starts is mapped to the border, past it, and back. What a short event adds to the
//! passage at the border is, to first order, a matrix Ξ of rank one less: where a contact that slides touches w = 0 and
//! force does not drop, the brief stick takes out what was left of w, Ξ = I − d w_y / (w_y d) with d the direction in which
//! its force acts (grazing-sliding). At the other borders both sides have the same derivative (8.2). Orbits lie where the
//! number that decides between the sides, g = g_y δy + g_r δr, has the sign of their side; since both maps differ in rank
//! one, det(I − A) det(I − B) > 0 has one of them on each side of r, and < 0 both on one: a non-smooth fold.
//!
//! Where a contact that does not give way is grazed, the return map of the orbits that are hit has no derivative: its
//! multiplier grows without bound. But these orbits, and r, are smooth functions of the speed v of the impact (Nordmark):
//! they leave the border along (I − A) δy = k v, g = 0, with the kick k of a unit speed.

use nalgebra::{DMatrix, DVector};

use super::candidate::{Border, Condition};
use super::problem::{BorderProblem, Round};
use crate::field::exact::Mode;
use crate::flow::FlowError;
use crate::linear::svd;
use crate::motion::{Derivatives, Family, Flow, Place};

/// Share of the period before the border at which the direction of the contact's force is read.
const BEFORE: f64 = 1e-6;

/// Both sides of a border.
pub(super) struct Sides {
    /// Where shooting starts.
    pub(super) start: Place,
    /// The field there.
    pub(super) velocity: DVector<f64>,
    /// The side on which the event does not happen, and that on which it does.
    maps: [Derivatives; 2],
    /// How the number that decides between the sides depends on the start, and on r.
    number: (DVector<f64>, f64),
    /// Its sign on both sides.
    signs: [f64; 2],
    /// What a unit speed of approach adds to the state once around, where the contact that is grazed does not give way.
    kick: Option<DVector<f64>>,
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
        slopes: &DMatrix<f64>,
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
        };
        let arrival = Arrival::of(&round);
        let leaps = [passing.leap(false)?, passing.leap(true)?];
        let number = match border.condition {
            Condition::Touch => arrival.slope(&passing.guard),
            Condition::Edge => passing.on_surface(&arrival)?.slope(&row(1)),
        };
        let happens = match border.condition {
            Condition::Touch => -1.0,
            Condition::Edge => 1.0,
        };
        let start = round.out.0.clone();
        let kick = match border.condition {
            Condition::Touch if border.before() == Mode::Open => {
                flow.kick(state, border.contact)?
            }
            _ => None,
        };
        Ok(Self {
            kick: kick.map(|kick| &round.out.1.state * DVector::from_vec(kick)),
            velocity: flow.velocity(&start)?.f,
            maps: leaps.map(|leap| arrival.through(&leap, &round)),
            start,
            number,
            signs: [-happens, happens],
        })
    }

    /// The return map on the side where the event happens, or on the other.
    pub(super) fn map(&self, happens: bool) -> &Derivatives {
        &self.maps[usize::from(happens)]
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
        let (map, order) = (self.map(happens), self.velocity.len());
        let kick = self.kick.as_ref().filter(|_| happens);
        let n = order + 1;
        let hit = usize::from(kick.is_some());
        let mut matrix = DMatrix::zeros(n + 1 + hit, n + 1 + hit);
        for i in 0..order {
            for j in 0..order {
                let own = f64::from(i == j);
                matrix[(i, j)] = (map.state[(i, j)] - own) * scale[j] / scale[i];
            }
            matrix[(i, order)] = self.velocity[i] * scale[order] / scale[i];
            matrix[(i, n)] = map.design[i] * r_scale / scale[i];
            matrix[(order, i)] = phase[i] * scale[i];
        }
        if let Some(kick) = kick {
            self.grazing(&mut matrix, kick, scale, r_scale);
        }
        let size = matrix.row(order).norm();
        matrix.row_mut(order).unscale_mut(size);
        let svd = svd(matrix)?;
        let rows = svd.v_t?;
        let direction = rows.row(svd.singular_values.imin()).transpose();
        if kick.is_some() {
            // An impact has a speed of approach, and not one of departure.
            let whole = direction[n + 1].signum();
            let direction = direction.rows(0, n + 1) * whole;
            let length = direction.norm();
            let regular = length > 0.0 && direction.iter().all(|x| x.is_finite());
            return regular.then(|| direction / length);
        }
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
    /// The speed of the impact as one more unknown, and that the border is grazed, to first order.
    fn grazing(
        &self,
        matrix: &mut DMatrix<f64>,
        kick: &DVector<f64>,
        scale: &DVector<f64>,
        r_scale: f64,
    ) {
        let order = self.velocity.len();
        let n = order + 1;
        let (along, by_r) = &self.number;
        let most = (0..order).map(|i| (kick[i] / scale[i]).abs());
        let unit = most.fold(0.0, f64::max).max(f64::MIN_POSITIVE);
        for i in 0..order {
            matrix[(i, n + 1)] = kick[i] / scale[i] / unit;
            matrix[(n, i)] = along[i] * scale[i];
        }
        matrix[(n, n)] = by_r * r_scale;
        let size = matrix.row(n).norm().max(f64::MIN_POSITIVE);
        matrix.row_mut(n).unscale_mut(size);
    }
}

/// How the arrival at the border depends on the start and on r.
struct Arrival {
    state: DMatrix<f64>,
    design: DVector<f64>,
}

impl Arrival {
    fn of(Round { back, .. }: &Round) -> Self {
        Self {
            state: back.1.state.clone(),
            design: back.1.design.clone(),
        }
    }

    /// How a number depends on the start and on r that has these slopes at the border.
    fn slope(&self, (along, by_r): &(DVector<f64>, f64)) -> (DVector<f64>, f64) {
        (self.state.tr_mul(along), along.dot(&self.design) + by_r)
    }

    /// Past the border and back to the start.
    fn through(&self, leap: &Self, round: &Round) -> Derivatives {
        let lead = &round.out.1;
        let passed = &leap.state * &self.design + &leap.design;
        Derivatives {
            state: &lead.state * &leap.state * &self.state,
            design: &lead.state * passed + &lead.design,
            time: lead.time.clone(),
            trace: 0.0,
            factors: Vec::new(),
            lost: 0,
        }
    }
}

/// The passage at the border itself.
struct Passing<'a> {
    border: &'a Border,
    flow: &'a dyn Flow,
    state: &'a [f64],
    period: f64,
    /// Slopes of the guard of the mode in which the contact comes.
    guard: (DVector<f64>, f64),
}

impl Passing<'_> {
    /// Ξ, and what r adds: where the event does not happen, or where it does.
    fn leap(&self, happens: bool) -> Result<Arrival, FlowError> {
        let order = self.state.len();
        let nothing = Arrival {
            state: DMatrix::identity(order, order),
            design: DVector::zeros(order),
        };
        match self.border.condition {
            Condition::Edge => {
                let (before, held) = self.fields(self.state)?;
                Ok(self.along(&nothing, &(held - &before), &before))
            }
            Condition::Touch if happens && self.border.is_graze() => {
                let coming = self.border.coming(self.state);
                let velocity = self.flow.velocity(&coming)?.f;
                let earlier: Vec<f64> = self
                    .state
                    .iter()
                    .zip(velocity.iter())
                    .map(|(x, f)| x - BEFORE * self.period * f)
                    .collect();
                let (before, held) = self.fields(&earlier)?;
                let push = held - before;
                Ok(self.along(&nothing, &-&push, &push))
            }
            Condition::Touch => Ok(nothing),
        }
    }

    /// The field in which the motion comes, and the one with the contact held.
    fn fields(&self, state: &[f64]) -> Result<(DVector<f64>, DVector<f64>), FlowError> {
        let coming = self.flow.velocity(&self.border.coming(state))?.f;
        Ok((coming, self.flow.velocity(&self.border.stuck(state))?.f))
    }

    /// What comes, carried by `push` onto the surface to which `towards` leads: y + push g / (g_y towards), times its sign.
    fn along(&self, from: &Arrival, push: &DVector<f64>, towards: &DVector<f64>) -> Arrival {
        let (gradient, by_r) = &self.guard;
        let rate = gradient.dot(towards);
        let (along, by_r) = from.slope(&(gradient.clone(), *by_r));
        Arrival {
            state: &from.state + push * along.transpose() / rate,
            design: &from.design + push * (by_r / rate),
        }
    }

    /// The arrival where the guard has fallen.
    fn on_surface(&self, arrival: &Arrival) -> Result<Arrival, FlowError> {
        let (before, _) = self.fields(self.state)?;
        Ok(self.along(arrival, &-&before, &before))
    }
}
