//! What a scene needs of its model, as it is reported.

use std::ops::ControlFlow;

use super::contacts::ContactNeed;
use super::lacks::{Lack, lack};
use super::modes::ModesNeed;
use super::parameters::ParameterNeed;
use super::stage::{Placed, Stage};
use super::topic::{Topic, Watch};
use crate::field::Kernel;
use crate::study::ended::Ended;
use crate::study::error::StudyError;
use crate::study::question::{Along, Case};
use crate::study::system::System;
use crate::study::trade::{Part, Scope, TradeRecord};
use crate::study::work::{Item, List};

/// The least that answers a question to an accuracy.
#[derive(Debug, Clone, PartialEq)]
pub struct NeedsRecord {
    /// The accuracy: the largest relative error of the answer.
    pub accuracy: f64,
    /// The range over which it was asked, if there was one.
    pub along: Option<Along>,
    /// Why the branch over that range ended.
    pub ended: Option<Ended>,
    /// Where it was judged; nowhere if there is no orbit because the model lacks something.
    pub places: Vec<Placed>,
    /// What each structure needs.
    pub modes: Vec<ModesNeed>,
    /// Whether all structures, reduced to that at once, answered as accurately: the largest error of that run.
    pub together: Option<f64>,
    /// What each contact does.
    pub contacts: Vec<ContactNeed>,
    /// What each parameter matters.
    pub parameters: Vec<ParameterNeed>,
    /// The exact system and its copies at each place; `None` where nothing can be smoothed.
    pub copies: Option<TradeRecord>,
    /// What the scene asks for that the model lacks.
    pub lacks: Vec<Lack>,
    /// Whether it was ended before all of this was there.
    pub interrupted: bool,
}

impl NeedsRecord {
    fn of(case: &Case) -> Self {
        Self {
            accuracy: case.accuracy,
            along: case.along,
            ended: None,
            places: Vec::new(),
            modes: Vec::new(),
            together: None,
            contacts: Vec::new(),
            parameters: Vec::new(),
            copies: None,
            lacks: Vec::new(),
            interrupted: false,
        }
    }

    /// What meets the accuracy everywhere in the fewest accepted steps once around: `exact`, or the name of a copy.
    #[must_use]
    pub fn cheapest(&self) -> Option<String> {
        let copies = self.copies.as_ref()?;
        let exact = copies
            .ends
            .iter()
            .map(|end| end.trade.need.as_ref()?.as_ref().ok());
        let exact = exact.collect::<Option<Vec<_>>>();
        let exact = exact.and_then(|all| all.iter().map(|one| one.cost.work.steps).max());
        let exact = exact.map(|steps| (steps, "exact".to_owned()));
        let smooth = Kernel::ALL.into_iter().filter_map(|kernel| {
            let need = copies.need(kernel)?.1.ok()?;
            Some((need.setting.cost.work.steps, need.smoothing.to_string()))
        });
        let all = exact.into_iter().chain(smooth);
        all.min_by_key(|(steps, _)| *steps).map(|(_, name)| name)
    }
}

impl System {
    /// The least that answers the question of a case to its accuracy; `watch` is told on what it works, and may end it.
    ///
    /// Friction acts exactly, whatever the case says: copies are part of the answer.
    ///
    /// # Errors
    /// There is no orbit. Where that is so because the model lacks something, it is no error but the answer.
    pub fn needs_watched(&self, case: &Case, watch: Watch<'_>) -> Result<NeedsRecord, StudyError> {
        let mut record = NeedsRecord::of(case);
        let stage = match self.stage(case, watch) {
            Ok(stage) => stage,
            Err(error) => {
                record.lacks.push(lack(&error).ok_or(error)?);
                return Ok(record);
            }
        };
        record.ended.clone_from(&stage.ended);
        record.places = stage.placed();
        record.interrupted = self.judge(&stage, &mut record, watch)?.is_break();
        Ok(record)
    }

    fn judge(
        &self,
        stage: &Stage,
        record: &mut NeedsRecord,
        watch: Watch<'_>,
    ) -> Result<ControlFlow<()>, StudyError> {
        for topic in [
            Topic::Modes,
            Topic::Contacts,
            Topic::Parameters,
            Topic::Copies,
        ] {
            if watch(topic).is_break() {
                return Ok(ControlFlow::Break(()));
            }
            match topic {
                Topic::Orbits => {}
                Topic::Modes => {
                    (record.modes, record.together) = self.modes(stage);
                    let lacking = record.modes.iter().filter_map(ModesNeed::lack);
                    record.lacks.extend(lacking);
                }
                Topic::Contacts => record.contacts = self.roles(stage),
                Topic::Parameters => {
                    let mut go_on = || watch(Topic::Parameters);
                    record.parameters = self.matters(stage, &mut go_on);
                }
                Topic::Copies => record.copies = self.copies(stage, watch)?,
            }
        }
        Ok(watch(Topic::Copies))
    }

    /// The exact system and its copies at each place, as `trade` measures them.
    fn copies(&self, stage: &Stage, watch: Watch<'_>) -> Result<Option<TradeRecord>, StudyError> {
        let info = self.info();
        if !info.touches() || info.only_form().is_some() {
            return Ok(None);
        }
        let scope = Scope {
            tolerances: Vec::new(),
            accuracy: Some(stage.accuracy),
            ..Scope::default()
        };
        // Times are measured.
        let list = List::on_one_thread();
        let along = stage.along;
        let mut all = TradeRecord {
            along,
            ends: Vec::new(),
            missing: 0,
        };
        for scene in &stage.scenes {
            let go_on = |_: Item<'_, Part>| watch(Topic::Copies);
            let here = self.trade_watched(&scene.case, &scope, &list, &go_on)?;
            all.ends.extend(here.ends);
            all.missing += here.missing;
        }
        Ok(Some(all))
    }
}
