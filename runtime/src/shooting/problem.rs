//! The zero problem of a periodic orbit: (2.3) with a phase condition, over any number of segments.

use nalgebra::DVector;

use super::crawl::Crawl;
use super::division::{Division, Measure};
use super::phase::Phase;
use super::pin::Pin;
use super::shot::Shot;
use super::size::Size;
use crate::continuation::{Linearisation, ZeroProblem};
use crate::field::Work;
use crate::flow::{FlowError, Want};
use crate::motion::{Family, Flow, Modes, Place};

/// Unknowns are the starts x₁ … xₘ of `m` segments and the period T; the equations are
/// φ(xᵢ, sᵢ T) − xᵢ₊₁ = 0, cyclically, sᵢ being the share of segment i, and a phase condition on x₁.
#[derive(Debug, Clone)]
pub struct OrbitProblem {
    /// The flows.
    pub family: Family,
    /// The phase condition.
    pub phase: Phase,
    /// Usual magnitudes of the states: half their extent along the orbit.
    pub magnitude: Vec<f64>,
    /// Usual magnitude of the period.
    pub period: f64,
    /// What the passages shall report besides derivatives.
    pub want: Want,
    /// What is held in neutral directions.
    pub pins: Vec<Pin>,
    /// What the states gain once around a motion that runs on.
    pub shift: Option<Vec<f64>>,
    /// The internal states of laws that swing about the middle of their stops where they meet neither.
    pub(super) centred: Vec<usize>,
    /// Work of all evaluations.
    pub work: Work,
    pub(super) modes: Vec<Modes>,
    pub(super) shares: Vec<f64>,
    pub(super) largest: Vec<f64>,
    /// States and modes of the last accepted orbit in which it could begin as well.
    others: Vec<(Vec<f64>, Modes)>,
    crawl: Crawl,
    /// How large the last accepted orbit was.
    pub(super) size: Option<Size>,
    /// The contacts that stuck all along it.
    pub(super) held: Vec<usize>,
    /// To what share of their values orbits are known.
    pub(super) accuracy: f64,
}

impl OrbitProblem {
    /// The problem of an orbit near the one that is divided like this, of about this period.
    pub fn new(
        family: Family,
        phase: Phase,
        division: &Division,
        period: f64,
        magnitude: Vec<f64>,
    ) -> Self {
        Self {
            family,
            phase,
            largest: magnitude.clone(),
            magnitude,
            period,
            want: Want::SHOT,
            pins: Vec::new(),
            shift: None,
            centred: Vec::new(),
            work: Work::default(),
            modes: division.modes(),
            shares: division.shares.clone(),
            others: Vec::new(),
            crawl: Crawl::default(),
            size: None,
            held: Vec::new(),
            accuracy: 0.0,
        }
    }

    /// The unknowns for these starts and this period.
    #[must_use]
    pub fn unknowns(starts: &[Place], period: f64) -> DVector<f64> {
        let states = starts.iter().flat_map(|place| &place.state).copied();
        DVector::from_vec(states.chain([period]).collect())
    }

    /// Lets the start float along the orbit, orthogonally to the field, from `place` at r.
    ///
    /// # Errors
    /// The field is not finite there.
    pub fn float(&mut self, place: &Place, r: f64) -> Result<(), FlowError> {
        let velocity = self.family.at(r)?.velocity(place)?.f;
        let (drive, state) = (self.family.phase(), place.state.clone());
        self.phase = Phase::floating(drive, state, &velocity, &self.magnitude);
        Ok(())
    }

    /// Where segment i begins.
    pub(super) fn start(&self, z: &DVector<f64>, i: usize) -> Place {
        let order = self.order();
        Place {
            state: z.rows(i * order, order).iter().copied().collect(),
            modes: self.modes[i].clone(),
        }
    }

    pub(super) fn order(&self) -> usize {
        self.magnitude.len()
    }

    /// Divides the orbit like this from now on; the unknowns for it.
    pub(super) fn divide(&mut self, division: &Division) -> DVector<f64> {
        self.modes = division.modes();
        self.shares.clone_from(&division.shares);
        self.pins.retain(|pin| !pin.holds_state());
        Self::unknowns(&division.starts, self.period)
    }

    /// Holds what changes along the orbit where it is in another place of that.
    fn hold_at(&mut self, state: &[f64]) {
        let runs = self.shift.is_some();
        for pin in self.pins.iter_mut().filter(|pin| runs || pin.driven) {
            *pin = pin.clone().through(state);
        }
    }

    /// How an orbit is divided at present.
    pub(super) fn division(&self, z: &DVector<f64>, shot: &Shot) -> Division {
        let whole = || Division::whole(self.start(z, 0));
        shot.division(z).unwrap_or_else(whole)
    }

    /// The segments of the last accepted orbit, followed in one so far, if errors grow on its way: no step from it succeeds
    /// then, though none need last.
    fn growing(&self, flow: &dyn Flow) -> Option<Division> {
        let Phase::Orthogonal { at, .. } = &self.phase else {
            return None;
        };
        let measure = Measure {
            flow,
            period: self.period,
            magnitude: &self.magnitude,
        };
        let start = Place {
            state: at.clone(),
            modes: self.modes.first()?.clone(),
        };
        let whole = self.shares.len() == 1 && self.pins.is_empty();
        let division = whole.then(|| Division::on_the_way(&measure, start).ok())?;
        division.flatten()
    }

    /// The segments that an orbit needs which is divided like this, if it needs others. Where its branch crawls, how errors
    /// grow on the way is looked at, too.
    ///
    /// # Errors
    /// The motion cannot be followed.
    pub(super) fn divided(
        &self,
        division: &Division,
        r: f64,
        shot: &Shot,
        crawls: bool,
    ) -> Result<Option<Division>, FlowError> {
        // What is held in neutral directions is said over the equations of one segment.
        if !shot.pins.is_empty() {
            return Ok(None);
        }
        let flow = self.family.at(r)?;
        let measure = Measure {
            flow: flow.as_ref(),
            period: shot.period,
            magnitude: &self.magnitude,
        };
        let refined = division.refined(&measure, &shot.passages)?;
        match refined {
            None if crawls && division.is_whole() => {
                Division::on_the_way(&measure, division.starts[0].clone())
            }
            refined => Ok(refined),
        }
    }
}

impl ZeroProblem for OrbitProblem {
    type Error = FlowError;
    type Extra = Shot;

    fn evaluate(
        &mut self,
        z: &DVector<f64>,
        r: f64,
    ) -> Result<Linearisation<Self::Extra>, FlowError> {
        let flow = self.family.at(r)?;
        let at = self.once_around(flow.as_ref(), z);
        let at = at.map_err(|why| self.lets_go(why))?;
        self.held(flow.as_ref(), z, at)
    }

    fn same_piece(one: &Shot, other: &Shot) -> bool {
        one.passes_like(other)
    }

    fn as_eventful(one: &Shot, other: &Shot) -> bool {
        one.changes() == other.changes()
    }

    fn continuous(one: &Shot, other: &Shot) -> bool {
        one.pins.is_empty() && other.pins.is_empty()
    }

    fn scale(&self) -> DVector<f64> {
        let states = self.modes.iter().flat_map(|_| &self.magnitude).copied();
        DVector::from_vec(states.chain([self.period]).collect())
    }

    fn accept(
        &mut self,
        z: &DVector<f64>,
        r: f64,
        shot: &Self::Extra,
    ) -> Result<Option<DVector<f64>>, FlowError> {
        self.keep_pinned(r, shot)?;
        self.leave_centres(r, shot)?;
        self.period = shot.period;
        self.measure(z, r, shot)?;
        if matches!(self.phase, Phase::Section(_)) {
            return Ok(None);
        }
        let crawls = self.crawl.reaches(z, &self.scale());
        self.others = shot.turns();
        let start = self.start(z, 0);
        let calmer = self.calmer(r, shot)?;
        if let Some(place) = &calmer {
            self.hold_at(&place.state);
        }
        let moved = calmer.map(Division::whole);
        let present = moved.clone().unwrap_or_else(|| self.division(z, shot));
        // Another division is easier to shoot from: where none can be followed, that is no reason to refuse the orbit.
        let divided = self.divided(&present, r, shot, crawls);
        let division = divided.ok().flatten().or(moved);
        self.float(
            division
                .as_ref()
                .map_or(&start, |division| &division.starts[0]),
            r,
        )?;
        Ok(division.map(|division| self.divide(&division)))
    }

    fn ends(why: &FlowError) -> bool {
        !matches!(why, FlowError::LetsGo | FlowError::Unpinned { .. })
    }

    fn elsewhere(&mut self, r: f64, trial: usize) -> Option<DVector<f64>> {
        let flow = self.family.at(r).ok()?;
        if trial == 0
            && let Some(division) = self.growing(flow.as_ref())
        {
            return Some(self.divide(&division));
        }
        let (state, modes) = self.others.get(trial)?;
        let place = Place::known(flow.as_ref(), state, Some(modes)).ok()?;
        let velocity = flow.velocity(&place).ok()?.f;
        self.phase = Phase::floating(flow.phase(), state.clone(), &velocity, &self.magnitude);
        self.hold_at(&place.state);
        Some(self.divide(&Division::whole(place)))
    }

    /// What depends on where along the orbit its segments start is left out: only the period and r stay.
    fn lasting(&self, tangent: &DVector<f64>) -> DVector<f64> {
        let unknowns = self.modes.len() * self.order() + 1;
        let mut lasting = DVector::zeros(unknowns + 1);
        let last = tangent.rows(tangent.len() - 2, 2);
        lasting.rows_mut(unknowns - 1, 2).copy_from(&last);
        lasting
    }
}
