//! Proofs of equilibria, as text and as JSON.

use crate::app::document::Document;
use crate::app::failure::Failure;
use crate::app::text::{states, table};
use crate::equilibrium::{Proof, Unproven};
use crate::model::ModelInfo;

/// The box of each equilibrium, in the order of the list, or why it has none.
pub(super) fn describe(info: &ModelInfo, proofs: &[Result<Proof, Unproven>]) -> String {
    let mut text = "\n  proofs (interval arithmetic, rounded outwards):".to_owned();
    if proofs.iter().any(Result::is_ok) {
        text.push_str(" one equilibrium, and only one, from min to max\n");
        text.push_str(&table(&boxes(info, proofs)));
    } else {
        text.push_str(" none\n");
    }
    for (i, proof) in proofs.iter().enumerate() {
        if let Err(reason) = proof {
            text.push_str(&format!("  number {} is not proven: {reason}\n", i + 1));
        }
    }
    text
}

fn boxes(info: &ModelInfo, proofs: &[Result<Proof, Unproven>]) -> String {
    let mut lines = "number\t\tmin\tmax\n".to_owned();
    for (i, proof) in proofs.iter().enumerate() {
        let Ok(Proof { low, high }) = proof else {
            continue;
        };
        for (name, (low, high)) in states(info, "").zip(low.iter().zip(high)) {
            // All digits: rounded to fewer, the ends would no longer hold the equilibrium.
            lines += &format!("{}\t{name}\t{low:?}\t{high:?}\n", i + 1);
        }
    }
    lines
}

/// A failure that says how many are not proven, and why the first of them is not.
pub(super) fn verdict(proofs: &[Result<Proof, Unproven>]) -> Result<(), Failure> {
    let mut unproven = proofs.iter().filter_map(|proof| proof.as_ref().err());
    let Some(first) = unproven.next() else {
        return Ok(());
    };
    Err(Failure::failed(format!(
        "{} of {} equilibria are not proven: {first}",
        1 + unproven.count(),
        proofs.len()
    )))
}

/// A box that holds exactly one equilibrium, or why none is proven.
pub(super) fn document<'a>(info: &'a ModelInfo, proof: &Result<Proof, Unproven>) -> Document<'a> {
    let holds = |proof| Document::of(info, proof).by_state(&["min", "max"]);
    Document::new(info)
        .put("kind", "rigorous")
        .put("certified", proof.is_ok())
        .maybe("box", proof.as_ref().ok().map(holds))
        .maybe("reason", proof.as_ref().err().map(ToString::to_string))
}
