//! The certificate of an orbit, as text and as JSON.

use crate::app::document::Document;
use crate::app::text::{number, states, table, time_unit};
use crate::model::ModelInfo;
use crate::shooting::{Certificate, Constants, Uncertified};

/// Digits of a start, beside its radius.
const DIGITS: usize = 15;

/// The radii and the constants behind them, or why there are none.
pub(super) fn describe(info: &ModelInfo, found: &Result<Certificate, Uncertified>) -> String {
    match found {
        Ok(certificate) => format!(
            "\n  certificate (a posteriori, not rigorous): one true orbit, and only one, within\n{}{}",
            table(&radii(info, certificate)),
            constants(&certificate.constants),
        ),
        Err(reason) => format!("\n  no certificate: {reason}\n"),
    }
}

fn radii(info: &ModelInfo, certificate: &Certificate) -> String {
    let small = |radius: f64| number(radius, 2);
    let mut lines = "\tcomputed\tradius\n".to_owned();
    let starts = certificate.start.iter().zip(&certificate.state_radius);
    for (name, (start, radius)) in states(info, "").zip(starts) {
        lines += &format!(
            "start {name}\t{}\t{}\n",
            number(*start, DIGITS),
            small(*radius)
        );
    }
    let period = number(certificate.period, DIGITS) + time_unit(info);
    lines + &format!("period\t{period}\t{}\n", small(certificate.period_radius))
}

fn constants(constants: &Constants) -> String {
    let small = |value: f64| number(value, 2);
    format!(
        "  h = |DF⁻¹| |DF⁻¹F| Lip(DF) = {} × {} × {} = {}, at most 1/2; |F| = {}, of it {} by the integration\n",
        small(constants.inverse),
        small(constants.step),
        small(constants.lipschitz),
        small(constants.h),
        small(constants.residual),
        small(constants.integration),
    )
}

/// How near a true orbit is to the computed one, or why that is not known.
pub(super) fn document<'a>(
    info: &'a ModelInfo,
    found: &Result<Certificate, Uncertified>,
) -> Document<'a> {
    let document = Document::new(info)
        .put("kind", "a posteriori, not rigorous")
        .put("certified", found.is_ok());
    let document = match found {
        Ok(certificate) => document
            .all(certificate)
            .by_state(&["start", "state_radius"]),
        Err(Uncertified::TooFar(constants)) => document.all(constants),
        Err(_) => document,
    };
    document.maybe("reason", found.as_ref().err().map(ToString::to_string))
}
