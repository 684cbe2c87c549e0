//! The border between two neighbouring orbits of different words, and what it is called where no orbit can be brought to it.

use super::around::borders;
use super::candidate::{Border as Candidate, Condition};
use super::crossing::{CLOSE, NOISE, phase};
use super::located::{Edge, edge};
use crate::bifurcation::Kind;
use crate::continuation::{Border, Watched, ZeroProblem};
use crate::flow::FlowError;
use crate::motion::{Family, Flow};
use crate::shooting::Orbit;
use crate::shooting::problem::OrbitProblem;

/// Whether r passes this value from one orbit to the other one, as far as r tells: where it turns between them, it does not.
fn ahead([from, to]: [&Orbit; 2], r: f64, accuracy: f64) -> bool {
    let errors = NOISE * accuracy * from.r_size();
    let (low, high) = (from.r.min(to.r), from.r.max(to.r));
    from.heading.slope * to.heading.slope <= 0.0 || (r >= low - errors && r <= high + errors)
}

/// The border between two neighbouring orbits of different words.
pub(in crate::shooting) fn between(
    problem: &mut OrbitProblem,
    ends: [&Orbit; 2],
    r_scale: f64,
    accuracy: f64,
) -> Option<Border<Orbit>> {
    // Ends that are one but for their errors, which grow along the orbit, need not lie on both sides of it.
    let grown = ends.map(|end| end.floquet.growth()).into_iter();
    let errors = (accuracy * grown.fold(NOISE, f64::max)).min(CLOSE);
    let inside =
        |found: &Edge| found.orbit.is_between(ends, errors) && ahead(ends, found.orbit.r, accuracy);
    let (family, scale) = (problem.family.clone(), problem.scale());
    let found = [0, 1].into_iter().find_map(|i| {
        let [near, other] = [ends[i], ends[1 - i]];
        let parts = |border: &Candidate| border.parts(near, other);
        edge(&family, near, accuracy, &mut problem.work, (parts, inside))
    })?;
    let phase = phase(problem, &found);
    let side = |end: &Orbit, way: f64| {
        let happens = end.has_word_of(&found.orbit, 1) == found.border.happens;
        let direction = found.sides.direction(happens, &phase, &scale, r_scale)?;
        Some(found.seen_from(end, happens, way * direction[direction.len() - 1]))
    };
    let [a, b] = ends.map(|end| found.orbit.away(end));
    Some(Border {
        kind: found.kind,
        points: [side(ends[0], -1.0)?, side(ends[1], 1.0)?],
        share: a / (a + b),
        error: found.error,
        last: found.ends(),
    })
}

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
        own(border, flow.as_ref()).ok()?
    })
}

/// Its name at the orbit beside it; `None` if the force that could hold the contact has no way to its limit there.
fn own(border: &Candidate, flow: &dyn Flow) -> Result<Option<Kind>, FlowError> {
    let rate = match border.condition {
        Condition::Touch => Some(0.0),
        Condition::Edge => {
            let held = flow.touch(&border.stuck(&border.state), border.contact)?;
            held.map(|[_, rate]| rate)
        }
    };
    Ok(rate.map(|rate| border.kind(rate)))
}
