//! Special points of a branch of equilibria, numbered in their order.

use super::record::SpecialEquilibrium;
use crate::continuation::{Kind, Located};
use crate::equilibrium::{EquilibriumPoint, Onset};
use crate::motion::{Family, Modes, Place};
use crate::study::label::labels;
use crate::study::question::Along;

type Here = Located<EquilibriumPoint>;

/// The special points as they are reported, of a branch on which contacts have these modes.
pub(super) fn numbered(
    along: Along,
    (family, modes): (&Family, &Modes),
    located: &[Here],
) -> Vec<SpecialEquilibrium> {
    let labels = labels(located.iter().map(|found| found.kind));
    let special = |(found, label): (&Here, String)| {
        let (point, onset) = (&found.point, begins(family, modes, found));
        SpecialEquilibrium {
            kind: found.kind,
            label,
            after: found.after,
            r: along.value(found.r),
            error: along.error(found),
            state: point.state.clone(),
            eigenvalues: point.spectrum.eigenvalues.clone(),
            period: point.frequency().map(|omega| std::f64::consts::TAU / omega),
            l1: onset.map(|onset| onset.coefficient),
            l1_error: onset.map(|onset| onset.error),
            onset: onset.and_then(|onset| onset.name()),
            artefact: false,
        }
    };
    located.iter().zip(labels).map(special).collect()
}

/// How periodic motions begin at a Hopf point.
fn begins(family: &Family, modes: &Modes, found: &Here) -> Option<Onset> {
    let frequency = found
        .point
        .frequency()
        .filter(|_| found.kind == Kind::Hopf)?;
    let place = Place {
        state: found.point.state.clone(),
        modes: modes.clone(),
    };
    Onset::of(family.at(found.r).ok()?.as_ref(), &place, frequency)
}
