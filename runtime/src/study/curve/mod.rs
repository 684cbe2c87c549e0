//! Bifurcations followed in two design variables.

mod choice;
mod equilibria;
mod found;
mod reader;
mod record;

pub use record::{
    CurveFinding, CurvePointRecord, CurveRecord, CurveScope, Curved, SpecialCurvePoint,
};
