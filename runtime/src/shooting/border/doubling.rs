//! Borders on which orbits double: a multiplier jumps past −1 there (Feigin 1970).

use super::located::{Edge, edge};
use crate::bifurcation::test_function::flip;
use crate::continuation::Located;
use crate::field::Work;
use crate::motion::Family;
use crate::shooting::orbit::Orbit;

/// The border near to which an orbit is that has an odd number of multipliers below −1 on one of its sides, and an even one
/// on the other: orbits that go around twice end there, as they do in a flip.
pub(crate) fn doubles(family: &Family, orbit: &Orbit, accuracy: f64) -> Option<Located<Orbit>> {
    let mut work = Work::default();
    let side = |found: &Edge, happens: bool| {
        let seen = found.seen_from(orbit, happens, 1.0);
        flip(&seen.floquet.multipliers)
    };
    let jumps = |found: &Edge| !found.jumps() && side(found, true) * side(found, false) < 0.0;
    let found = edge(family, orbit, accuracy, &mut work, (|_: &_| true, jumps))?;
    let mut located = Located::at(found.kind, found.orbit.r, found.orbit.clone());
    (located.error, located.last) = (found.error, true);
    Some(located)
}
