//! The library of dry friction laws, one a file.
//!
//! Each names its formula, its symbols and its source; units stand at the parameters, where N is the contact's force and
//! m its speed times time. Where the force at rest equals the limit of the force at slow sliding, a law can be smoothed by
//! every sign type; [`CoulombStatic`] has a static peak and takes a bump.

mod bit_torque;
mod bouc_wen;
mod coulomb;
mod coulomb_static;
mod coulomb_viscous;
mod dahl;
mod drill_curve;
mod elasto_plastic;
mod gaussian;
mod jenkins;
mod lorentzian;
mod lugre;
mod popp_stelter;
mod stribeck;
mod thomsen_fidlin;
mod tustin;
mod weakening;

pub use bit_torque::BitTorque;
pub use bouc_wen::{BoucWen, BoucWenPower};
pub use coulomb::Coulomb;
pub use coulomb_static::CoulombStatic;
pub use coulomb_viscous::CoulombViscous;
pub use dahl::Dahl;
pub use drill_curve::DrillCurve;
pub use elasto_plastic::ElastoPlastic;
pub use gaussian::Gaussian;
pub use jenkins::Jenkins;
pub use lorentzian::Lorentzian;
pub use lugre::LuGre;
pub use popp_stelter::PoppStelter;
pub use stribeck::Stribeck;
pub use thomsen_fidlin::ThomsenFidlin;
pub use tustin::Tustin;
pub use weakening::Weakening;

use stickslip::specimen;
use stickslip::study::{Hysteresis, Specimen};

/// Every law of the library without internal state, with typical values of its parameters.
#[must_use]
pub fn library() -> Vec<Specimen> {
    vec![
        specimen!(Coulomb { level: 1.0 }),
        specimen!(CoulombViscous {
            level: 1.0,
            viscous: 0.05,
        }),
        specimen!(CoulombStatic {
            static_level: 1.5,
            kinetic_level: 1.0,
        }),
        specimen!(Weakening {
            limit: 1.0,
            decay: 3.0,
        }),
        specimen!(PoppStelter {
            static_level: 1.0,
            kinetic_level: 0.4,
            decay: 3.0,
            growth: 0.01,
        }),
        specimen!(Stribeck {
            static_level: 1.0,
            kinetic_level: 0.6,
            speed: 0.2,
            exponent: 1.5,
            viscous: 0.05,
        }),
        specimen!(Tustin {
            static_level: 1.0,
            kinetic_level: 0.6,
            speed: 0.2,
            viscous: 0.05,
        }),
        specimen!(Gaussian {
            static_level: 1.0,
            kinetic_level: 0.6,
            speed: 0.2,
            viscous: 0.05,
        }),
        specimen!(Lorentzian {
            static_level: 1.0,
            kinetic_level: 0.6,
            speed: 0.2,
            viscous: 0.05,
        }),
        specimen!(ThomsenFidlin {
            static_level: 1.0,
            minimum: 0.5,
            speed: 0.5,
        }),
        specimen!(DrillCurve {
            limit: 1.0,
            decay: 3.0,
            viscous: 0.1,
        }),
        specimen!(BitTorque {
            reach: 1.0,
            static_coefficient: 0.8,
            kinetic_coefficient: 0.5,
            decay: 0.9,
            speed: 1.0,
        }),
    ]
}

/// Every law of the library with internal state, with typical values of its parameters and a swing.
#[must_use]
pub fn with_memory() -> Vec<Specimen<dyn Hysteresis>> {
    vec![
        specimen!(Dahl {
            stiffness: 1e4,
            level: 1.0,
        } swinging 3e-4 at 1e-3),
        specimen!(Jenkins {
            stiffness: 1e4,
            level: 1.0,
        } swinging 3e-4 at 1e-3),
        specimen!(LuGre {
            stiffness: 1e5,
            damping: 316.2,
            viscous: 0.4,
            kinetic: 1.0,
            peak: 1.5,
            stribeck: 1e-3,
        } swinging 5e-5 at 1e-4),
        specimen!(ElastoPlastic {
            stiffness: 1e5,
            damping: 316.2,
            viscous: 0.4,
            kinetic: 1.0,
            peak: 1.5,
            stribeck: 1e-3,
            elastic: 7e-6,
        } swinging 5e-5 at 1e-4),
        specimen!(BoucWen {
            stiffness: 1.0,
            left: 0.1,
            slope: 1.0,
            beta: 0.6,
            gamma: 0.4,
        } swinging 3.0 at 1.0),
        specimen!(BoucWenPower {
            scale: 1.0,
            stiffness: 1.0,
            left: 0.1,
            slope: 1.0,
            beta: 0.6,
            gamma: 0.4,
            exponent: 2.0,
        } swinging 3.0 at 1.0),
    ]
}
