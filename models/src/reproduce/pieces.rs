//! Curves cut where their stability changes.

use stickslip::report::Curve;

/// A point of a curve with the direction of that there, NaN where it is not known.
pub(super) type Directed = ([f64; 2], [f64; 2]);

/// The direction of a curve where that is not known.
pub(super) const UNKNOWN: [f64; 2] = [f64::NAN; 2];

/// Pieces of one stability each, every one up to the first point of the next.
pub(super) fn pieces(curve: &[(bool, Directed)]) -> Vec<(bool, Vec<Directed>)> {
    let mut pieces: Vec<(bool, Vec<Directed>)> = Vec::new();
    for &(stable, here) in curve {
        if let Some((kind, points)) = pieces.last_mut() {
            points.push(here);
            if *kind == stable {
                continue;
            }
        }
        pieces.push((stable, vec![here]));
    }
    pieces
}

/// A smooth line along these directions.
pub(super) fn directed(label: &str, series: usize, points: Vec<Directed>) -> Curve {
    let (points, directions) = points.into_iter().unzip();
    Curve::smooth(label, series, points).directed(directions)
}
