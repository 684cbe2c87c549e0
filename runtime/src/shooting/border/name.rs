//! What a border is called to which no orbit can be brought.

use super::around::borders;
use super::candidate::{Border, Condition};
use crate::bifurcation::Kind;
use crate::flow::FlowError;
use crate::motion::{Family, Flow};
use crate::shooting::Orbit;

/// The border that parts two orbits next to it, by what holds at the short stretch that only one of them has; `None` where
/// there is none, as where two events exchange their order.
///
/// Where multipliers are so large that Newton's method does not see the border for its errors, its name is the same.
pub(in crate::shooting) fn name(family: &Family, ends: [&Orbit; 2]) -> Option<Kind> {
    let [a, b] = ends;
    [[a, b], [b, a]].into_iter().find_map(|[near, other]| {
        let flow = family.at(near.r).ok()?;
        let near_by = borders(flow.as_ref(), near).ok()?;
        let border = near_by.iter().find(|border| border.parts(near, other))?;
        own(border, flow.as_ref()).ok()
    })
}

/// Its name at the orbit beside it.
fn own(border: &Border, flow: &dyn Flow) -> Result<Kind, FlowError> {
    let rate = match border.condition {
        Condition::Touch => 0.0,
        Condition::Edge => {
            let held = flow.touch(&border.stuck(&border.state), border.contact)?;
            held.map_or(f64::NAN, |[_, rate]| rate)
        }
    };
    Ok(border.kind(rate))
}
