//! What generated code calls; nothing here is for use by hand.

use crate::friction::{FrictionLaw, LawInfo, LawParameter};
use crate::memory::{MemoryLaw, MemoryLawInfo, same};
use crate::model::Unit;
use crate::press::{PressLaw, PressLawInfo};

/// The data of the law that a function builds.
///
/// The generated code names each law in one function only, so that a misspelt law is one error.
#[must_use]
pub const fn info_of<L: FrictionLaw<f64>, const FIELDS: usize>(
    _law: fn([f64; FIELDS]) -> L,
) -> &'static LawInfo {
    L::INFO
}

/// The data of the law with internal state that a function builds.
#[must_use]
pub const fn memory_info_of<L: MemoryLaw<f64, S>, const FIELDS: usize, const S: usize>(
    _law: fn([f64; FIELDS]) -> L,
) -> &'static MemoryLawInfo {
    L::INFO
}

/// The data of the law of presses that a function builds.
#[must_use]
pub const fn press_info_of<L: PressLaw<f64>, const FIELDS: usize>(
    _law: fn([f64; FIELDS]) -> L,
) -> &'static PressLawInfo {
    L::INFO
}

/// Which columns of each row are named.
#[must_use]
pub const fn pattern<const N: usize>(rows: [&[usize]; N]) -> [[bool; N]; N] {
    let mut pattern = [[false; N]; N];
    let mut row = 0;
    while row < N {
        let mut next = 0;
        while next < rows[row].len() {
            pattern[row][rows[row][next]] = true;
            next += 1;
        }
        row += 1;
    }
    pattern
}

/// Exponents of m, kg, s, A, K, mol, cd, in twelfths.
type Dimension = [i16; 7];

/// The dimensions of a contact, each where it is known.
///
/// They are what N, m and s stand for in the units of a law: m is the dimension of speed times time.
pub struct Contact {
    /// Dimension of the friction force.
    pub force: Option<Dimension>,
    /// Dimension of the relative speed.
    pub speed: Option<Dimension>,
    /// Dimension of time.
    pub time: Dimension,
}

impl Contact {
    /// Whether a law's field may hold a quantity of this dimension; yes where nothing is stated.
    #[must_use]
    pub const fn accepts(&self, law: &[LawParameter], field: &str, found: Dimension) -> bool {
        let mut i = 0;
        while i < law.len() {
            let parameter = &law[i];
            if same(parameter.name, field) {
                return self.agrees_if_stated(&parameter.unit, found);
            }
            i += 1;
        }
        true
    }

    /// Whether a state of this dimension may carry internal state number `index` of a law.
    #[must_use]
    pub const fn carries(&self, law: &MemoryLawInfo, index: usize, found: Dimension) -> bool {
        index >= law.states.len() || self.agrees_if_stated(&law.states[index].unit, found)
    }

    const fn agrees_if_stated(&self, stated: &Option<Unit>, found: Dimension) -> bool {
        match stated {
            Some(unit) => self.agrees(unit.dimension, found),
            None => true,
        }
    }

    /// Whether a dimension of a law, written with N, m and s, is the one found in the model.
    const fn agrees(&self, stated: Dimension, found: Dimension) -> bool {
        let forces = stated[1];
        let lengths = stated[0] - forces;
        let times = stated[2] + 2 * forces;
        let mut wanted = [0, 0, 0, stated[3], stated[4], stated[5], stated[6]];
        match &self.force {
            Some(force) => wanted = times_power(wanted, force, forces),
            None if forces != 0 => return true,
            None => {}
        }
        match &self.speed {
            Some(speed) => wanted = times_power(wanted, speed, lengths),
            None if lengths != 0 => return true,
            None => {}
        }
        wanted = times_power(wanted, &self.time, lengths + times);
        let mut i = 0;
        while i < wanted.len() {
            if wanted[i] != found[i] {
                return false;
            }
            i += 1;
        }
        true
    }
}

const fn times_power(mut product: Dimension, factor: &Dimension, power: i16) -> Dimension {
    let mut i = 0;
    while i < product.len() {
        product[i] += power * factor[i] / 12;
        i += 1;
    }
    product
}

#[cfg(test)]
mod tests {
    use super::{Contact, Dimension};

    const NEWTON: Dimension = [12, 12, -24, 0, 0, 0, 0];
    const TORQUE: Dimension = [24, 12, -24, 0, 0, 0, 0];
    const NEWTON_SECOND_PER_METRE: Dimension = [0, 12, -12, 0, 0, 0, 0];
    const PER_SECOND: Dimension = [0, 0, -12, 0, 0, 0, 0];
    const SECOND: Dimension = [0, 0, 12, 0, 0, 0, 0];
    const SECOND_PER_METRE: Dimension = [-12, 0, 12, 0, 0, 0, 0];
    const ONE: Dimension = [0; 7];

    #[test]
    fn a_law_in_newtons_serves_torques() {
        let bit = Contact {
            force: Some(TORQUE),
            speed: Some(PER_SECOND),
            time: SECOND,
        };
        assert!(bit.agrees(NEWTON, TORQUE));
        assert!(!bit.agrees(NEWTON, NEWTON));
        assert!(bit.agrees(SECOND_PER_METRE, SECOND));
        assert!(bit.agrees(NEWTON_SECOND_PER_METRE, [24, 12, -12, 0, 0, 0, 0]));
    }

    #[test]
    fn a_law_in_newtons_serves_nondimensional_models() {
        let contact = Contact {
            force: Some(ONE),
            speed: Some(ONE),
            time: ONE,
        };
        assert!(contact.agrees(NEWTON, ONE));
        assert!(contact.agrees(SECOND_PER_METRE, ONE));
        assert!(!contact.agrees(SECOND_PER_METRE, SECOND));
    }

    #[test]
    fn roots_of_units_agree() {
        let root = [6, 6, -12, 0, 0, 0, 0];
        let contact = Contact {
            force: Some(NEWTON),
            speed: Some(root),
            time: SECOND,
        };
        assert!(contact.agrees(SECOND_PER_METRE, [-6, -6, 12, 0, 0, 0, 0]));
        assert!(!contact.agrees(SECOND_PER_METRE, SECOND));
    }

    #[test]
    fn what_is_not_stated_is_not_compared() {
        let contact = Contact {
            force: None,
            speed: Some([12, 0, -12, 0, 0, 0, 0]),
            time: SECOND,
        };
        assert!(contact.agrees(NEWTON, SECOND));
        assert!(contact.agrees(SECOND_PER_METRE, SECOND_PER_METRE));
        assert!(!contact.agrees(SECOND_PER_METRE, SECOND));
    }
}
