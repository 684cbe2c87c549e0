//! What is followed in two design variables: an orbit, or an equilibrium.

use nalgebra::{DMatrix, DVector};

use crate::continuation::ZeroProblem;
use crate::equilibrium::EquilibriumProblem;
use crate::flow::{FlowError, Want};
use crate::motion::{Family, Place, Velocity};
use crate::shooting::{OrbitProblem, Shot};

/// The equations of what may be special.
pub trait Subject: ZeroProblem<Error = FlowError> {
    /// Takes these flows instead.
    fn steer(&mut self, family: Family);

    /// Usual magnitudes of the states.
    fn magnitude(&self) -> &[f64];

    /// What an evaluation says of motions beside it.
    fn beside(&self, extra: &Self::Extra) -> Beside;

    /// The same at unknowns next to those of an evaluation, without the derivatives of the equations.
    ///
    /// # Errors
    /// The motion cannot be followed from there.
    fn beside_at(
        &mut self,
        z: &DVector<f64>,
        r: f64,
        near: &Self::Extra,
    ) -> Result<Beside, FlowError>;
}

/// How motions beside an orbit or an equilibrium come nearer or leave.
#[derive(Debug, Clone)]
pub enum Beside {
    /// Φ of an orbit, and the velocity at its start.
    Orbit(DMatrix<f64>, DVector<f64>),
    /// The Jacobian of an equilibrium.
    Equilibrium(DMatrix<f64>),
}

impl Subject for OrbitProblem {
    fn steer(&mut self, family: Family) {
        self.family = family;
    }

    fn magnitude(&self) -> &[f64] {
        &self.magnitude
    }

    fn beside(&self, shot: &Shot) -> Beside {
        Beside::Orbit(shot.monodromy().0, shot.velocity.f.clone())
    }

    fn beside_at(&mut self, z: &DVector<f64>, r: f64, near: &Shot) -> Result<Beside, FlowError> {
        let n = z.len() - 1;
        let flow = self.family.at(r)?;
        let place = Place {
            state: z.as_slice()[..n].to_vec(),
            modes: near.start.modes.clone(),
        };
        let passage = flow.advance(&place, z[n], Want::DERIVATIVES)?;
        self.work += passage.work;
        let velocity = flow.velocity(&place)?.f;
        let identity = || DMatrix::identity(n, n);
        let phi = passage.derivatives.map_or_else(identity, |d| d.state);
        Ok(Beside::Orbit(phi, velocity))
    }
}

impl Subject for EquilibriumProblem {
    fn steer(&mut self, family: Family) {
        self.family = family;
    }

    fn magnitude(&self) -> &[f64] {
        Self::magnitude(self)
    }

    fn beside(&self, velocity: &Velocity) -> Beside {
        Beside::Equilibrium(velocity.jacobian.clone())
    }

    fn beside_at(
        &mut self,
        z: &DVector<f64>,
        r: f64,
        _near: &Velocity,
    ) -> Result<Beside, FlowError> {
        self.work.linearisations += 1;
        let velocity = self.family.at(r)?.velocity(&self.place(z))?;
        Ok(Beside::Equilibrium(velocity.jacobian))
    }
}
