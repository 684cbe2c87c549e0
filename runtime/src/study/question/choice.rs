//! Which method a question deserves when only an accuracy is asked for.

use super::dynamics::Dynamics;
use crate::flow::exact::in_closed_form;
use crate::integrate::Tolerance;
use crate::model::ModelInfo;

/// A method, its tolerance, and why.
#[derive(Debug, Clone, PartialEq)]
pub struct Choice {
    /// How friction acts.
    pub dynamics: Dynamics,
    /// Local tolerance of the integration.
    pub tolerance: Tolerance,
    /// The choice and its reasons in a sentence.
    pub reason: String,
}

/// Chooses for `accuracy`, the relative error allowed in period and extrema, unless `dynamics` are given.
#[must_use]
pub fn choose(info: &ModelInfo, dynamics: Option<Dynamics>, accuracy: f64) -> Choice {
    let tolerance = Tolerance::for_accuracy(accuracy);
    let asked = dynamics.is_some();
    let dynamics = dynamics.unwrap_or(if info.touches() {
        Dynamics::Exact
    } else {
        Dynamics::Smooth
    });
    let names: Vec<&str> = info.forces().map(|(name, _)| name).collect();
    let (method, local, why) = match dynamics {
        Dynamics::Smooth => (
            "smooth dynamics",
            tolerance,
            format!(
                "{}; explicit steps until the motion turns out to be stiff",
                info.only_form().unwrap_or_else(|| {
                    "the model has no friction, so that nothing switches".to_owned()
                })
            ),
        ),
        Dynamics::Exact => (
            "exact dynamics",
            tolerance.explicit(),
            format!(
                "the law of {} is switched, not smoothed: without a layer nothing is stiff, and no smoothing error enters{}",
                names.join(", "),
                if in_closed_form(info) {
                    "; between events the model is linear, and moves in closed form, without an integrator"
                } else {
                    ""
                }
            ),
        ),
        Dynamics::Smoothed(_) => (
            "a smooth copy",
            tolerance,
            "the accuracy bounds the integration only; `trade` tells what the smoothing itself costs".to_owned(),
        ),
    };
    let who = if asked { "as asked" } else { "chosen" };
    Choice {
        dynamics,
        tolerance: local,
        reason: format!(
            "{method}, {who}: {why}; local tolerance {:.1e} for a relative accuracy of {accuracy:.1e} of period and extrema",
            local.relative
        ),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examples::Belt;
    use crate::field::{Kernel, Smoothing};
    use crate::model::{Model, ModelInfo};

    #[test]
    fn friction_is_switched_unless_a_copy_is_asked_for() {
        let chosen = choose(Belt::INFO, None, 1e-6);
        assert_eq!(chosen.dynamics, Dynamics::Exact);
        assert!(chosen.reason.contains("chosen") && chosen.reason.contains("the law of F"));
        assert!(!chosen.reason.contains("closed form") && !Belt::INFO.is_linear());
        let copy = Dynamics::Smoothed(Smoothing {
            kernel: Kernel::Tanh,
            size: 1e5,
        });
        let asked = choose(Belt::INFO, Some(copy), 1e-6);
        assert_eq!(asked.dynamics, copy);
        assert!(asked.reason.contains("as asked"));
        assert!(asked.tolerance.relative > chosen.tolerance.relative);
    }

    #[test]
    fn without_friction_nothing_switches() {
        let frictionless = ModelInfo {
            contacts: &[],
            ..*Belt::INFO
        };
        assert_eq!(choose(&frictionless, None, 1e-9).dynamics, Dynamics::Smooth);
    }
}
