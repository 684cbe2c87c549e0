//! Once around a periodic motion, for the quadratures of its harmonics.

use std::f64::consts::TAU;

use nalgebra::{Complex, DMatrix, DVector};

use crate::flow::{FlowError, Want};
use crate::linear::svd;
use crate::motion::{Flow, Node, Place};

/// Angle of the highest harmonic, and of the motion itself, over a panel of six nodes: their error is far below rounding.
pub(super) const PANEL: f64 = 1.0;
/// Directions in which a disturbance lasts for longer than this many turns say nothing of where an orbit begins.
const LASTING: f64 = 1e7;
/// Rounding error of an integral, relative to the extent of a state.
pub(super) const ROUNDING: f64 = 64.0 * f64::EPSILON;

/// The frequency of which harmonics are multiples.
pub(super) fn rate(flow: &dyn Flow, around: Around<'_>) -> Result<f64, FlowError> {
    Ok(match flow.phase() {
        Some(phase) => flow.velocity(around.place)?.f[phase],
        None => TAU / around.period,
    })
}

/// An orbit whose harmonics are meant.
#[derive(Debug, Clone, Copy)]
pub struct Around<'a> {
    /// Where it begins.
    pub place: &'a Place,
    /// Its period.
    pub period: f64,
    /// What the states gain once around, where it runs on; else nothing.
    pub shift: &'a [f64],
}

impl<'a> Around<'a> {
    /// The same from another place.
    fn begun_at(self, place: &'a Place) -> Self {
        Self { place, ..self }
    }

    /// By how much each state misses where it began, if the motion ends here.
    fn gap(&self, flow: &dyn Flow, end: Vec<f64>) -> DVector<f64> {
        let mut gap = DVector::from_vec(end) - DVector::from_column_slice(&self.place.state);
        for (gap, gain) in gap.iter_mut().zip(self.shift) {
            *gap -= gain;
        }
        if let Some(phase) = flow.phase() {
            gap[phase] = 0.0;
        }
        gap
    }
}

/// A periodic motion at the nodes of a quadrature.
pub(super) struct Motion {
    period: f64,
    pub(super) phase: Option<usize>,
    pub(super) start: Vec<f64>,
    pub(super) nodes: Vec<Node>,
    /// By how much each state misses its start when it comes back.
    pub(super) gap: DVector<f64>,
}

impl Motion {
    /// Once around the orbit of this flow near `place`: under a drive, whose period is certain, from one correction of
    /// that place, if it brings the motion closer to where it began.
    pub(super) fn around(
        flow: &dyn Flow,
        around: Around<'_>,
        panel: f64,
    ) -> Result<Self, FlowError> {
        // Where the derivatives are not known, as where a contact is grazed, it stays where it is.
        if flow.phase().is_some()
            && let Ok((gap, place)) = corrected(flow, around)
        {
            let other = place.map(|place| Self::follow(flow, around.begun_at(&place), panel));
            if let Some(Ok(other)) = other
                && other.gap.norm() < gap.norm()
            {
                return Ok(other);
            }
        }
        Self::follow(flow, around, panel)
    }

    fn follow(flow: &dyn Flow, around: Around<'_>, panel: f64) -> Result<Self, FlowError> {
        let Around {
            place,
            period,
            shift,
        } = around;
        let want = Want {
            panel,
            ..Want::default()
        };
        let mut passage = flow.advance(place, period, want)?;
        for (j, gain) in shift.iter().enumerate() {
            for node in &mut passage.nodes {
                node.state[j] -= gain * node.time / period;
            }
        }
        let gap = around.gap(flow, passage.end.state);
        Ok(Self {
            period,
            phase: flow.phase(),
            start: place.state.clone(),
            nodes: passage.nodes,
            gap,
        })
    }

    /// The complex amplitude A exp(iθ) of each state at this harmonic.
    ///
    /// What a state is at the start has no harmonics, and is left out before it cancels.
    pub(super) fn amplitudes(&self, order: usize) -> Vec<Complex<f64>> {
        let mut sums = vec![Complex::new(0.0, 0.0); self.start.len()];
        for node in &self.nodes {
            let angle = -self.angle(node) * order as f64;
            let turned = Complex::from_polar(2.0 * node.weight / self.period, angle);
            for (j, sum) in sums.iter_mut().enumerate() {
                *sum += turned * (node.state[j] - self.start[j]);
            }
        }
        if let Some(phase) = self.phase {
            sums[phase] = Complex::new(0.0, 0.0);
        }
        sums
    }

    /// That of the first harmonic at a node.
    pub(super) fn angle(&self, node: &Node) -> f64 {
        match self.phase {
            Some(phase) => node.state[phase],
            None => TAU * node.time / self.period,
        }
    }

    /// How far a state goes from its start.
    pub(super) fn extent(&self, j: usize) -> f64 {
        let values = self.nodes.iter().map(|node| node.state[j] - self.start[j]);
        values.fold(0.0, |most, value| most.max(value.abs()))
    }
}

/// By how much a motion misses its start, and the place from which, to first order, it would come back; `None` where that is
/// not known.
fn corrected(
    flow: &dyn Flow,
    around: Around<'_>,
) -> Result<(DVector<f64>, Option<Place>), FlowError> {
    let place = around.place;
    let passage = flow.advance(place, around.period, Want::DERIVATIVES)?;
    let gap = around.gap(flow, passage.end.state);
    let Some(derivatives) = passage.derivatives else {
        return Ok((gap, None));
    };
    let order = gap.len();
    let mut stays = DMatrix::identity(order, order) - derivatives.state;
    // The phase of a drive comes back by itself.
    if let Some(phase) = flow.phase() {
        stays.column_mut(phase).fill(0.0);
    }
    let step = svd(stays).and_then(|svd| svd.solve(&gap, svd.singular_values.max() / LASTING).ok());
    let step = step.filter(|step| step.iter().all(|change| change.is_finite()));
    let place = step.map(|step| Place {
        state: place
            .state
            .iter()
            .zip(&step)
            .map(|(x, change)| x + change)
            .collect(),
        modes: place.modes.clone(),
    });
    Ok((gap, place))
}
