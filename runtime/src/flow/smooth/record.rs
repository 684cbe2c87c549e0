//! What a passage gathers on its way.

use super::inside::{Explicit, Implicit};
use crate::field::{Field, Stops, Work};
use crate::flow::extrema::Turning;
use crate::flow::{
    Calm, Derivatives, Determinant, Factor, FlowError, Node, Passage, Place, Sample, Segment, Want,
    nodes,
};
use crate::integrate::explicit::Stepper;
use crate::integrate::{Accepted, Carried, IntegrationError, Look, Motion, Radau};
use crate::scalar::mapped;

/// Points of a step that a drawing gets.
const DRAWN: usize = 6;

/// What a passage gathers on its way.
pub(super) struct Record<const N: usize> {
    pub(super) want: Want,
    pub(super) phase: Option<usize>,
    pub(super) time: f64,
    /// When the explicit integrator set out.
    pub(super) since: f64,
    /// Steps of the implicit integrator.
    pub(super) implicit: u64,
    pub(super) motion: Motion<N>,
    pub(super) stops: Stops<N>,
    /// The most states that rested at once.
    pub(super) lost: usize,
    pub(super) extrema: Turning<N>,
    pub(super) factors: Vec<Factor<N>>,
    pub(super) path: Vec<Sample<N>>,
    pub(super) nodes: Vec<Node<N>>,
    pub(super) calm: Calm<N, ()>,
    pub(super) work: Work,
}

impl<const N: usize> Record<N> {
    pub(super) fn new(state: [f64; N], want: Want, phase: Option<usize>) -> Self {
        let path = if want.path {
            vec![Sample { time: 0.0, state }]
        } else {
            Vec::new()
        };
        Self {
            want,
            phase,
            time: 0.0,
            since: 0.0,
            implicit: 0,
            motion: Motion::from(state),
            stops: Stops::NONE,
            lost: 0,
            extrema: Turning::new(),
            factors: Vec::new(),
            path,
            nodes: Vec::new(),
            calm: Calm::at(Place { state, mode: () }),
            work: Work::default(),
        }
    }

    pub(super) fn explicit_step<F: Field<N>, V>(
        &mut self,
        field: &F,
        step: &mut Stepper<'_, F, V, N>,
    ) where
        V: Carried<N>,
    {
        let (time, length) = (self.since + step.time(), step.length());
        self.time = time + length;
        self.stay(length);
        nodes(self.want, (time, length), &mut self.nodes, |theta| {
            step.step_map(theta * length)
        });
        if !(self.want.notes_turns() || self.want.path) {
            return;
        }
        let dense = step.dense();
        if self.want.notes_turns() {
            let ends = (*step.from().state(), *step.end().state());
            let mut inside = Explicit {
                field,
                step,
                dense,
                time,
            };
            if self.want.looks_for_extrema() {
                let looks = mapped(&[0.0, 0.25, 0.5, 0.75, 1.0], |theta| Look {
                    theta,
                    linear: field.linearise(&dense.state(theta)),
                    state: dense.state(theta),
                });
                self.extrema.step(&mut looks.into_iter(), &mut inside);
            }
            self.extrema
                .strobes(self.phase, (&ends.0, &ends.1), &mut inside);
        }
        self.draw(time, length, |theta| dense.state(theta));
    }

    pub(super) fn implicit_step<F: Field<N>, const S: usize>(
        &mut self,
        radau: &mut Radau<'_, F, N, S>,
        step: &Accepted<N, S>,
        offset: f64,
    ) {
        self.time = offset + radau.time();
        self.motion.state = step.end;
        self.stay(step.step);
        if self.want.derivatives {
            let propagator = radau.propagator();
            self.motion = self.motion.through(&propagator);
            if self.want.factors {
                let growth = Some(radau.growth());
                self.factors.push(Factor {
                    state: propagator.state,
                    growth,
                });
            }
        }
        let (time, length) = (offset + step.time, step.step);
        if self.want.notes_turns() {
            let mut looks = self.want.looks_for_extrema().then(|| radau.looks(step));
            let mut inside = Implicit::new(radau, step, time);
            if let Some(looks) = &mut looks {
                self.extrema.step(looks, &mut inside);
            }
            self.extrema
                .strobes(self.phase, (&step.start, &step.end), &mut inside);
        }
        nodes(self.want, (time, length), &mut self.nodes, |theta| {
            let probed = radau.probe(step, theta);
            probed.map_or_else(|| step.inside(theta), |(state, _)| state)
        });
        self.draw(time, length, |theta| step.inside(theta));
    }

    pub(super) fn stay(&mut self, length: f64) {
        let place = Place {
            state: self.motion.state,
            mode: (),
        };
        self.calm.offer(self.time, length, place);
    }

    pub(super) fn draw(&mut self, time: f64, length: f64, at: impl Fn(f64) -> [f64; N]) {
        if self.want.path {
            self.path.extend((1..=DRAWN).map(|k| {
                let theta = k as f64 / DRAWN as f64;
                Sample {
                    time: time + theta * length,
                    state: at(theta),
                }
            }));
        }
    }

    /// Whether the motion is followed no further.
    pub(super) fn suffices(&self) -> bool {
        self.want.suffices(self.path.len())
    }

    pub(super) fn passage(self, velocity: [f64; N]) -> Result<Passage<N, ()>, FlowError> {
        let (motion, time) = (self.motion, self.time);
        let finite = motion
            .state
            .iter()
            .chain(&velocity)
            .all(|number| number.is_finite());
        if !finite || (self.want.derivatives && !Carried::is_finite(&motion)) {
            return Err(IntegrationError::NotFinite {
                time,
                state: motion.state.to_vec().into(),
            }
            .into());
        }
        let derivatives = self.want.derivatives.then_some(Derivatives {
            state: motion.tangent,
            design: motion.design,
            time: velocity,
            determinant: match self.lost {
                0 => Determinant::grown(motion.trace),
                _ => Determinant::ZERO,
            },
            factors: self.factors,
            lost: self.lost,
        });
        Ok(Passage {
            end: Place {
                state: motion.state,
                mode: (),
            },
            time,
            derivatives,
            extrema: self.extrema.finish(),
            segments: vec![Segment {
                impact: None,
                mode: (),
                duration: time,
            }],
            path: self.path,
            nodes: self.nodes,
            calm: self.calm,
            events: Vec::new(),
            rounding: 0.0,
            work: self.work,
        })
    }
}
