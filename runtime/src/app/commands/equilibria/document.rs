//! Equilibria as JSON.

use super::proof;
use crate::app::document::Document;
use crate::equilibrium::{Proof, Unproven};
use crate::model::ModelInfo;
use crate::study::{Case, EquilibriaRecord, EquilibriumRecord, SpecialEquilibrium};

/// A list of equilibria, each with its proof, or why there is none, if proofs were asked for.
pub(super) fn list<'a>(
    info: &'a ModelInfo,
    case: &Case,
    found: &[EquilibriumRecord],
    proofs: &[Result<Proof, Unproven>],
) -> Document<'a> {
    let one = |(i, one)| {
        let proof = proofs.get(i).map(|proof| proof::document(info, proof));
        equilibrium(info, one).maybe("certificate", proof)
    };
    let all = found.iter().enumerate().map(one);
    Document::case(info, case)
        .put("equilibria", all.collect::<Vec<_>>())
        .units()
}

/// A branch of equilibria.
pub(super) fn branch<'a>(
    info: &'a ModelInfo,
    case: &Case,
    branch: &EquilibriaRecord,
) -> Document<'a> {
    let points = branch.points.iter().map(|one| equilibrium(info, one));
    let special = |one: &SpecialEquilibrium| Document::of(info, one).by_state(&["state"]);
    Document::case(info, case)
        .range("along", &branch.along)
        .put("points", points.collect::<Vec<_>>())
        .put(
            "special",
            branch.special.iter().map(special).collect::<Vec<_>>(),
        )
        .ended(&branch.ended)
        .units()
        .put("work", branch.work)
}

fn equilibrium<'a>(info: &'a ModelInfo, one: &EquilibriumRecord) -> Document<'a> {
    let document = Document::of(info, one)
        .parameters(&one.parameters)
        .by_state(&["state"]);
    match &one.set {
        Some(set) => document.put("set", Document::of(info, set).by_state(&["min", "max"])),
        None => document,
    }
}
