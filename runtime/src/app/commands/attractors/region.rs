//! `--box`: where starts lie.

use crate::app::failure::{Failure, refuse};
use crate::app::request::state;
use crate::app::values::Range;
use crate::model::ModelInfo;
use crate::study::{Region, Side};

/// Sides by the names of their states.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::app::commands) struct Sides(Vec<Range>);

impl Sides {
    /// `x=-2..2,v=0..2`.
    pub(in crate::app::commands) fn read(option: &str, word: &str) -> Result<Self, Failure> {
        let sides = word.split(',').map(|side| Range::read(option, side));
        sides.collect::<Result<_, _>>().map(Self)
    }

    /// The region in the states of a model.
    pub(in crate::app::commands) fn of(&self, info: &ModelInfo) -> Result<Region, Failure> {
        let mut sides: Vec<Side> = Vec::new();
        for Range { name, from, to, .. } in &self.0 {
            let state = state(info, name)?;
            if sides.iter().any(|side| side.state == state) {
                return refuse!("`--box` names `{name}` more than once");
            }
            let (low, high) = (from.min(*to), from.max(*to));
            sides.push(Side { state, low, high });
        }
        Ok(Region { sides })
    }
}
