//! Long questions, asked to their ends without anybody who watches.

use std::ops::ControlFlow;

use super::attractors::{AttractorsRecord, FollowedRecord, Sampling};
use super::branch::BranchRecord;
use super::curve::{CurveScope, Curved};
use super::diagram::{Diagram, DiagramRecord};
use super::equilibria::EquilibriaRecord;
use super::error::StudyError;
use super::map::{Asked, Grid, MapRecord};
use super::needs::NeedsRecord;
use super::question::Case;
use super::system::System;
use super::trade::{Scope, TradeRecord};
use super::work::List;

impl System {
    /// The branch of orbits along the design variable of the case.
    ///
    /// # Errors
    /// There is no orbit to begin with.
    pub fn branch(&self, case: &Case) -> Result<BranchRecord, StudyError> {
        self.branch_watched(case, &mut |_| ControlFlow::Continue(()))
    }

    /// The branch of equilibria along the design variable of the case, from the first that is found.
    ///
    /// # Errors
    /// There is no equilibrium to begin with.
    pub fn equilibria_along(&self, case: &Case) -> Result<EquilibriaRecord, StudyError> {
        self.equilibria_along_watched(case, &mut |_| ControlFlow::Continue(()))
    }

    /// A special point of the branch along the design variable of the case, followed in that variable and another one.
    ///
    /// # Errors
    /// There is no orbit to begin with, or no such point on its branch, or no such point can be followed.
    pub fn curve(&self, case: &Case, scope: &CurveScope) -> Result<Curved, StudyError> {
        self.curve_watched(case, scope, &mut |_| ControlFlow::Continue(()))
    }

    /// A fold or a Hopf point of the branch of equilibria along the design variable of the case, followed in that variable
    /// and another one.
    ///
    /// # Errors
    /// There is no equilibrium to begin with, or no such point on its branch, or no such point can be followed.
    pub fn equilibria_curve(
        &self,
        case: &Case,
        scope: &CurveScope,
    ) -> Result<Curved<EquilibriaRecord>, StudyError> {
        self.equilibria_curve_watched(case, scope, &mut |_| ControlFlow::Continue(()))
    }

    /// Where the motions of the case meet a section, for many values of its design variable.
    ///
    /// # Errors
    /// Nothing is followed, or the case cannot be asked.
    pub fn diagram(&self, case: &Case, diagram: &Diagram) -> Result<DiagramRecord, StudyError> {
        self.diagram_watched(case, diagram, &List::default(), &|_| {
            ControlFlow::Continue(())
        })
    }

    /// All motions on which starts of a sampling settle.
    ///
    /// # Errors
    /// The case cannot be asked.
    pub fn attractors(
        &self,
        case: &Case,
        sampling: &Sampling,
    ) -> Result<AttractorsRecord, StudyError> {
        let list = List::default();
        self.attractors_watched(case, sampling, &list, &|_| ControlFlow::Continue(()))
    }

    /// The branches on which the periodic motions lie that were found along the design variable of the case.
    ///
    /// # Errors
    /// The case cannot be asked, or nothing is followed.
    pub fn followed(
        &self,
        case: &Case,
        record: &AttractorsRecord,
    ) -> Result<FollowedRecord, StudyError> {
        self.followed_watched(case, record, None, &mut |_| ControlFlow::Continue(()))
    }

    /// The answer to a question at each node of a grid of two parameters.
    ///
    /// # Errors
    /// The case cannot be asked at a corner of the grid.
    pub fn map(&self, case: &Case, grid: &Grid, asked: &Asked) -> Result<MapRecord, StudyError> {
        let list = List::default();
        self.map_watched(case, (grid, asked), &list, &|_| ControlFlow::Continue(()))
    }

    /// Error against cost of every smoothing, near the exact orbit of the case; at both ends if a parameter is followed.
    /// On one thread, so that times are measured undisturbed.
    ///
    /// # Errors
    /// There is no friction, or no exact orbit.
    pub fn trade(&self, case: &Case, scope: &Scope) -> Result<TradeRecord, StudyError> {
        let list = List::on_one_thread();
        self.trade_watched(case, scope, &list, &|_| ControlFlow::Continue(()))
    }

    /// The least that answers the question of a case to its accuracy.
    ///
    /// # Errors
    /// There is no orbit.
    pub fn needs(&self, case: &Case) -> Result<NeedsRecord, StudyError> {
        self.needs_watched(case, &|_| ControlFlow::Continue(()))
    }
}
