//! Bifurcations followed in two design variables.

mod found;
mod record;

pub use record::{
    CurveFinding, CurvePointRecord, CurveRecord, CurveScope, Curved, SpecialCurvePoint,
};
