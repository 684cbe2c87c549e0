//! Special points of branches, as they are marked.

use super::{Curve, Marker};
use crate::bifurcation::Kind;

/// A special point to be drawn.
#[derive(Debug, Clone, PartialEq)]
pub struct Mark {
    /// What changes there.
    pub kind: Kind,
    /// What stands beside it.
    pub label: String,
    /// How many points of its branch precede it.
    pub after: usize,
    /// Where it is drawn.
    pub at: [f64; 2],
    /// Whether there is a marker; the branch passes it all the same.
    pub shown: bool,
}

/// Special points with their labels, a legend entry for each kind.
#[must_use]
pub fn special_points(marks: impl IntoIterator<Item = Mark>) -> Vec<Curve> {
    let mut curves: Vec<(Kind, Curve)> = Vec::new();
    for mark in marks {
        let found = curves.iter().position(|(kind, _)| *kind == mark.kind);
        let place = found.unwrap_or_else(|| {
            let (marker, series) = look(mark.kind);
            let name = format!("{} ({})", mark.kind, mark.kind.letters());
            curves.push((mark.kind, Curve::points(name, series, marker, Vec::new())));
            curves.len() - 1
        });
        let (_, curve) = &mut curves[place];
        curve.points.push(mark.at);
        curve.labels.push(mark.label);
    }
    curves.into_iter().map(|(_, curve)| curve).collect()
}

/// The marker of a kind, and the number of its colour.
const fn look(kind: Kind) -> (Marker, usize) {
    match kind {
        Kind::Fold => (Marker::Circle, 2),
        Kind::Flip => (Marker::Cross, 2),
        Kind::Torus => (Marker::Square, 2),
        Kind::BranchPoint => (Marker::Plus, 2),
        Kind::SymmetryBreaking => (Marker::Triangle, 2),
        Kind::CrossingSliding => (Marker::Circle, 4),
        Kind::GrazingSliding => (Marker::Diamond, 4),
        Kind::Grazing => (Marker::Triangle, 4),
        Kind::SwitchingSliding => (Marker::Square, 4),
        Kind::AddingSliding => (Marker::Plus, 4),
        Kind::VanishingSegment => (Marker::Cross, 4),
        Kind::Hopf => (Marker::Square, 3),
        Kind::Flutter => (Marker::Diamond, 3),
        Kind::Krein => (Marker::Circle, 3),
        Kind::BoundaryEquilibrium => (Marker::Cross, 3),
        Kind::Cusp => (Marker::Triangle, 3),
        Kind::IsolaCentre => (Marker::Circle, 5),
        Kind::Exchange => (Marker::Cross, 5),
        Kind::FoldFlip => (Marker::Plus, 3),
        Kind::Resonance1 => (Marker::Circle, 6),
        Kind::Resonance2 => (Marker::Cross, 6),
        Kind::Resonance3 => (Marker::Triangle, 6),
        Kind::Resonance4 => (Marker::Square, 6),
        Kind::GeneralizedHopf => (Marker::Diamond, 5),
        Kind::BogdanovTakens => (Marker::Square, 5),
        Kind::ZeroHopf => (Marker::Triangle, 5),
        Kind::DoubleHopf => (Marker::Plus, 5),
        Kind::Window => (Marker::Plus, 6),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_kinds_look_the_same() {
        for (i, kind) in Kind::ALL.iter().enumerate() {
            assert!(
                Kind::ALL[i + 1..]
                    .iter()
                    .all(|other| look(*other) != look(*kind))
            );
        }
    }
}
