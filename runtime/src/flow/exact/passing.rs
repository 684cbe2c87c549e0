//! How derivatives pass an event, and stay on the surfaces on which contacts stick.

use super::ExactFlow;
use super::guard::Guard;
use super::run::Run;
use super::switch::Strike;
use crate::field::exact::{Closed, ExactField, Modes};
use crate::flow::saltation::Saltation;
use crate::flow::{Determinant, FlowError, SensitivityUndefined};
use crate::integrate::{Carried, Motion, Tracked};
use crate::model::Model;
use crate::scalar::{Inline, Lanes};

/// Relative difference up to which two orders of events have the same derivative.
const SAME_DERIVATIVE: f64 = 1e-8;

impl<M: Model<N>, const N: usize> Run<'_, M, N> {
    /// Makes w = 0 exactly where contacts stick, and w_y Φ = 0, w_y p + w_r = 0 with it.
    pub(super) fn put_on_surface(&mut self) -> Result<(), FlowError> {
        match &mut self.carried {
            Tracked::State(state) => self.flow.put_state_on_surface(state, &self.modes),
            Tracked::Motion(motion) => self.flow.put_on_surface(motion, &self.modes),
        }
    }

    /// Carries Φ and p through the events of one instant.
    pub(super) fn pass_derivatives(
        &mut self,
        strike: &Strike<M, N>,
        after: &Modes<M, N>,
    ) -> Result<(), FlowError> {
        let (before, time) = (self.modes, self.time);
        let Some(motion) = self.carried.motion() else {
            return Ok(());
        };
        let passing = Passing {
            flow: self.flow,
            state: motion.state,
            time,
            before,
            after: *after,
            strike,
        };
        let (volumes, rounding) = passing.carry(motion)?;
        self.jumps = self.jumps.times(volumes);
        self.rounding = self.rounding.max(rounding);
        Ok(())
    }
}

impl<M: Model<N>, const N: usize> ExactFlow<M, N> {
    /// Makes w = 0 exactly where contacts stick, and w_y Φ = 0, w_y p + w_r = 0 with it.
    pub(super) fn put_on_surface(
        &self,
        motion: &mut Motion<N>,
        modes: &Modes<M, N>,
    ) -> Result<(), FlowError> {
        if modes.bound().next().is_none() {
            return Ok(());
        }
        let (system, state) = (&self.system, motion.state);
        let field = ExactField::new(system, *modes, &state)?;
        motion.state.add(-1.0, &field.drift(&state));
        if const { Modes::<M, N>::PRESSED } {
            let rests = modes.rests().then_some(modes);
            if let Some(closed) = rests.and_then(|rests| Closed::new(system, &state, rests)) {
                let gaps = system.linear_speeds(&state);
                project::<M, N>(motion, &|off| closed.correction(off), gaps.as_ref());
            }
        }
        let lanes = system.linear_rates(&state, modes);
        project::<M, N>(motion, &|off| field.correction(&state, off), lanes.as_ref());
        Ok(())
    }

    /// Makes w = 0 exactly where contacts stick.
    fn put_state_on_surface(
        &self,
        state: &mut [f64; N],
        modes: &Modes<M, N>,
    ) -> Result<(), FlowError> {
        if modes.bound().next().is_some() {
            let drift = ExactField::new(&self.system, *modes, state)?.drift(state);
            state.add(-1.0, &drift);
        }
        Ok(())
    }
}

/// Removes from Φ and p what leaves the surfaces on which contacts stick.
fn project<M: Model<N>, const N: usize>(
    motion: &mut Motion<N>,
    correction: &dyn Fn(&M::PerContact<f64>) -> [f64; N],
    speeds: &[M::Lanes],
) {
    let rates = |along: &[f64; N], design: f64| {
        Inline::from_fn(|i| {
            let (gradient, own): ([f64; N], f64) = speeds[i].slopes();
            let sum: f64 = gradient.iter().zip(along).map(|(g, y)| g * y).sum();
            sum + own * design
        })
    };
    let off = correction(&rates(&motion.design, 1.0));
    motion.design.add(-1.0, &off);
    for column in 0..N {
        let along = crate::scalar::filled(|row| motion.tangent[row][column]);
        let off = correction(&rates(&along, 0.0));
        for (row, change) in motion.tangent.iter_mut().zip(off) {
            row[column] -= change;
        }
    }
}

/// Derivatives on their way through an event.
struct Passing<'a, M: Model<N>, const N: usize> {
    flow: &'a ExactFlow<M, N>,
    state: [f64; N],
    time: f64,
    before: Modes<M, N>,
    after: Modes<M, N>,
    strike: &'a Strike<M, N>,
}

impl<M: Model<N>, const N: usize> Passing<'_, M, N> {
    /// Carries Φ and p to the other side, in any order of simultaneous events if all agree; what that makes of volumes, and how
    /// far off rounding may put the state.
    fn carry(&self, motion: &mut Motion<N>) -> Result<(Determinant, f64), FlowError> {
        let mut order = Vec::new();
        for guard in self.strike.fallen.as_ref() {
            order.extend(*guard);
        }
        let start = *motion;
        let found = self.chain(motion, &order)?;
        if order.len() > 1 {
            let (mut other, mut back) = (start, order.clone());
            back.reverse();
            self.chain(&mut other, &back)?;
            if !agree(motion, &other) {
                return Err(SensitivityUndefined::Simultaneous {
                    contacts: order
                        .iter()
                        .map(|guard| M::INFO.contact_id(guard.contact))
                        .collect(),
                    time: self.time,
                }
                .into());
            }
        }
        Ok(found)
    }

    /// One saltation for each guard; with the last of them everything is in its new mode.
    fn chain(
        &self,
        motion: &mut Motion<N>,
        order: &[Guard],
    ) -> Result<(Determinant, f64), FlowError> {
        let system = &self.flow.system;
        let linear = system.linear(&self.state, &self.before)?;
        let mut modes = self.before;
        let mut field = system.snapshot(&self.state, &modes)?.field;
        let mut left = order.len();
        let (mut volumes, mut rounding) = (Determinant::ONE, 0.0_f64);
        for guard in order {
            let contact = guard.contact;
            left -= 1;
            if left == 0 {
                modes = self.after;
            } else {
                modes.set(contact, self.after.as_slice()[contact]);
                for (i, rubs) in M::INFO.contacts.iter().enumerate() {
                    if rubs.presses.contains(&contact) {
                        modes.set(i, self.after.as_slice()[i]);
                    }
                }
            }
            let after = system.snapshot(&self.state, &modes)?.field;
            let (gradient, design) = guard.value(&self.before, &linear).slopes();
            let saltation = Saltation {
                before: field,
                after,
                gradient,
                design,
                magnitude: system.magnitude,
            };
            let time = self.time;
            let passed = saltation.apply(motion, self.strike.grazes);
            let passed = passed.map_err(|rate| SensitivityUndefined::Grazing {
                contact: M::INFO.contact_id(contact),
                time,
                rate,
            })?;
            volumes = volumes.times(passed.volumes);
            rounding = rounding.max(self.strike.rounding(contact) * passed.leap);
            field = after;
        }
        Ok((volumes, rounding))
    }
}

fn agree<const N: usize>(a: &Motion<N>, b: &Motion<N>) -> bool {
    let rows = |m: &Motion<N>| {
        m.tangent
            .into_iter()
            .flatten()
            .chain(m.design)
            .collect::<Vec<_>>()
    };
    let (a, b) = (rows(a), rows(b));
    let size = a.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    a.iter()
        .zip(&b)
        .all(|(a, b)| (a - b).abs() <= SAME_DERIVATIVE * size)
}
