//! States on which no rate depends, where a body is or how often an angle has turned: an equilibrium is one wherever they are.

use super::resting::binds;
use crate::motion::{Family, Place};

/// Where beside a place it is looked, in sizes of the states: what is stationary at one of them is not at the others.
const BESIDE: [f64; 3] = [0.0, 0.3, -0.7];

/// Which they are around a place, where states are of these sizes and as far as its modes reach; none where a contact binds what no rate reads then.
pub(super) fn unread(family: &Family, r: f64, place: &Place, sizes: &[f64]) -> Vec<usize> {
    let Ok(flow) = family.at(r) else {
        return Vec::new();
    };
    if binds(&place.modes) {
        return Vec::new();
    }
    let mut unread: Vec<usize> = (0..sizes.len()).collect();
    for share in BESIDE {
        let mut beside = place.clone();
        for (y, size) in beside.state.iter_mut().zip(sizes) {
            *y += share * size;
        }
        let Ok(velocity) = flow.velocity(&beside) else {
            return Vec::new();
        };
        unread.retain(|j| {
            velocity
                .jacobian
                .column(*j)
                .iter()
                .all(|slope| *slope == 0.0)
        });
    }
    unread
}
