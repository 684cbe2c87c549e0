//! Whether special points account for what changes between two points.

use std::collections::BTreeSet;

use super::super::located::Located;
use super::super::path::Watched;

/// Whether the special points, in the order in which they are met, account for the change in the number of unstable
/// directions. Where it may be a marginal one that has only got a sign, they do, and where the branch ends: beyond, it is
/// none or only runs back. Marginal ones that part into as many stable as unstable ones have met. What passes may be marginal at
/// both ends, so that nothing of it shows.
pub(in crate::continuation) fn explains<P: Watched>(
    located: &[Located<P>],
    from: &P,
    to: &P,
) -> bool {
    let change = to.unstable() as i64 - from.unstable() as i64;
    let (Some(marginal), Some(left)) = (from.marginal(), to.marginal()) else {
        return true;
    };
    let lost = marginal as i64 - left as i64;
    let hidden = marginal.min(left) as i64;
    let known = lost == 0 || lost == 2 * change;
    if !known || located.iter().any(|event| event.last) {
        return true;
    }
    let mut events: Vec<&Located<P>> = located.iter().collect();
    events.sort_by(|a, b| a.share.total_cmp(&b.share));
    let before = BTreeSet::from([from.unstable() as i64]);
    let passed = |before: BTreeSet<i64>, event: &Located<P>| {
        let hides = event.kind.jump().is_some_and(|jump| jump <= hidden);
        let unseen = before.clone().into_iter().filter(|_| hides);
        beyond(before, event).into_iter().chain(unseen).collect()
    };
    let after = events.into_iter().fold(before, passed);
    after.contains(&(to.unstable() as i64))
}

/// How many directions may be unstable beyond a special point, if these are the numbers before it: those that do not pass
/// there are as many on both of its sides.
fn beyond<P: Watched>(before: BTreeSet<i64>, event: &Located<P>) -> BTreeSet<i64> {
    let Some(jump) = event.kind.jump() else {
        return before;
    };
    match event.point.growing_beside(event.kind) {
        Some(beside) => {
            let [few, many] = [beside as i64, beside as i64 + jump];
            let across = [(few, many), (many, few)];
            let open = across.into_iter().filter(|(here, _)| before.contains(here));
            open.map(|(_, there)| there).collect()
        }
        None => before.iter().flat_map(|n| [n - jump, n + jump]).collect(),
    }
}
