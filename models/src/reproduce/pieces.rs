//! Curves cut where their stability changes.

/// Pieces of one stability each, every one up to the first point of the next.
pub(super) fn pieces(curve: &[(bool, [f64; 2])]) -> Vec<(bool, Vec<[f64; 2]>)> {
    let mut pieces: Vec<(bool, Vec<[f64; 2]>)> = Vec::new();
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
