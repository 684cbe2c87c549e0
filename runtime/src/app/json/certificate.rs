//! Certificates as JSON.

use super::{Named, states};
use crate::equilibrium::{Proof, Unproven};
use crate::model::ModelInfo;
use crate::shooting::{Certificate, Constants, Uncertified};

/// How near a true orbit is to the computed one, or why that is not known.
#[derive(serde::Serialize)]
pub(super) struct OrbitCertificate<'a> {
    /// What it is worth.
    kind: &'static str,
    certified: bool,
    #[serde(flatten)]
    radii: Option<Radii<'a>>,
    #[serde(flatten)]
    constants: Option<Numbers>,
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<String>,
}

#[derive(serde::Serialize)]
struct Radii<'a> {
    start: Named<'a, f64>,
    state_radius: Named<'a, f64>,
    period_radius: f64,
}

/// The constants of Newton and Kantorovich's theorem, in scaled units.
#[derive(serde::Serialize)]
struct Numbers {
    residual: f64,
    integration_error: f64,
    inverse_norm: f64,
    newton_step: f64,
    lipschitz: f64,
    h: f64,
}

/// A box that holds exactly one equilibrium, or why none is proven.
#[derive(serde::Serialize)]
pub(super) struct EquilibriumCertificate<'a> {
    /// What it is worth.
    kind: &'static str,
    certified: bool,
    #[serde(rename = "box", skip_serializing_if = "Option::is_none")]
    holds: Option<Holds<'a>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    reason: Option<String>,
}

#[derive(serde::Serialize)]
struct Holds<'a> {
    min: Named<'a, f64>,
    max: Named<'a, f64>,
}

impl<'a> EquilibriumCertificate<'a> {
    pub(super) fn new(info: &'a ModelInfo, proof: &'a Result<Proof, Unproven>) -> Self {
        Self {
            kind: "rigorous",
            certified: proof.is_ok(),
            holds: proof.as_ref().ok().map(|proof| Holds {
                min: states(info, proof.low.iter().copied()),
                max: states(info, proof.high.iter().copied()),
            }),
            reason: proof.as_ref().err().map(ToString::to_string),
        }
    }
}

impl<'a> OrbitCertificate<'a> {
    pub(super) fn new(info: &'a ModelInfo, found: &'a Result<Certificate, Uncertified>) -> Self {
        let constants = match found {
            Ok(certificate) => Some(&certificate.constants),
            Err(Uncertified::TooFar(constants)) => Some(constants),
            Err(_) => None,
        };
        Self {
            kind: "a posteriori, not rigorous",
            certified: found.is_ok(),
            radii: found.as_ref().ok().map(|certificate| Radii {
                start: states(info, certificate.start.iter().copied()),
                state_radius: states(info, certificate.state_radius.iter().copied()),
                period_radius: certificate.period_radius,
            }),
            constants: constants.map(Numbers::from),
            reason: found.as_ref().err().map(ToString::to_string),
        }
    }
}

impl From<&Constants> for Numbers {
    fn from(constants: &Constants) -> Self {
        Self {
            residual: constants.residual,
            integration_error: constants.integration,
            inverse_norm: constants.inverse,
            newton_step: constants.step,
            lipschitz: constants.lipschitz,
            h: constants.h,
        }
    }
}
