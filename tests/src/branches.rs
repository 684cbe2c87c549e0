//! Branches and curves, asked for in a line.

use stickslip::field::Design;
use stickslip::model::{Model, ParamId};
use stickslip::study::{Along, BranchRecord, Case, CurveScope, Dynamics, System};

use crate::range::range;

/// The exact branch along a parameter, others as given.
pub fn branch<M: Model<N>, const N: usize>(
    given: &[(ParamId<M>, f64)],
    along: ParamId<M>,
    (from, to): (f64, f64),
    adapt: impl Fn(&mut Case),
) -> BranchRecord {
    let system = System::of::<M, N>();
    let mut case = Case::declared(system.info(), Dynamics::Exact);
    for (parameter, value) in given {
        case.parameters[parameter.index] = *value;
    }
    let design = Design::Parameter(along.index);
    case.parameters[along.index] = from;
    case.along = Some(Along { design, from, to });
    adapt(&mut case);
    let found = system.branch(&case);
    found.expect("a branch")
}

/// Its special points: names and values.
pub fn named(branch: &BranchRecord) -> Vec<(&str, f64)> {
    let all = branch.special.iter();
    all.map(|one| (one.label.as_str(), one.r)).collect()
}

/// The case at the beginning of both ranges, and what is followed.
pub fn question(
    model: &System,
    dynamics: Dynamics,
    along: (&str, f64, f64),
    and: (&str, f64, f64),
) -> (Case, CurveScope) {
    let mut case = Case::declared(model.info(), dynamics);
    let second = range(model, and.0, and.1, and.2);
    case.along = Some(second);
    case = case.at(second.from);
    let first = range(model, along.0, along.1, along.2);
    case.along = Some(first);
    let scope = CurveScope {
        and: second,
        of: None,
    };
    (case.at(first.from), scope)
}
