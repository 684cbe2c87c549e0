//! Whether a prediction is to be trusted: whether what is taken as small is small.

use super::history::History;
use super::layer::edge;
use super::prediction::{Prediction, ReleaseLoss};
use crate::field::Kernel;

/// A layer that takes more than this share of the shorter of stick and slip is not small.
const SLOW_LAYER: f64 = 0.1;
/// Factor between leading term and refined prediction above which more terms would matter.
const APART: f64 = 1.6;
/// A relative error above this is not small.
const LARGE: f64 = 0.03;

/// Whether the releases alone give the leading order: with compact sign types creep is of the same order.
fn leads(kernel: Kernel) -> bool {
    kernel.is_bump() || edge(kernel).is_none()
}

/// Every reason why `prediction` is outside its asymptotic range.
pub(super) fn doubts(history: &History, prediction: &Prediction) -> Vec<String> {
    let slow = |r: &&ReleaseLoss| r.layer > SLOW_LAYER * r.room;
    let layers = prediction.releases.iter().filter(slow).map(layer);
    crossings(history)
        .into_iter()
        .chain(layers)
        .chain(apart(prediction))
        .chain(large(prediction))
        .collect()
}

fn layer(release: &ReleaseLoss) -> String {
    format!(
        "the layer of contact {} takes {:.2e} at its release, which is not small against {:.2e}, the shorter of its stick \
         and slip",
        release.contact, release.layer, release.room
    )
}

/// Crossings that no copy makes, and those of which the layer is not small.
fn crossings(history: &History) -> Vec<String> {
    let crossings = history
        .switches
        .iter()
        .filter_map(|s| s.crossing.map(|crossing| (crossing, s.passing)));
    let doubt = crossings.filter_map(|(crossing, passing)| {
        let contact = crossing.local.contact;
        let Some(passing) = passing else {
            return Some(format!(
                "contact {contact} crosses without sticking, which a copy with a static peak is not made for"
            ));
        };
        let room = crossing.room[0].min(crossing.room[1]);
        (passing.layer > SLOW_LAYER * room).then(|| {
            format!(
                "the layer of contact {contact} takes {:.2e} as it crosses, which is not small against {room:.2e}, the time \
                 from the switch before or to the next",
                passing.layer
            )
        })
    });
    doubt.collect()
}

fn apart(prediction: &Prediction) -> Option<String> {
    let (kernel, frequency) = (prediction.smoothing.kernel, prediction.frequency);
    let leading = prediction.leading.filter(|_| leads(kernel))?;
    parts(leading, frequency).then(|| {
        format!(
            "the leading term alone gives {leading:.2e}, the refined prediction {frequency:.2e}"
        )
    })
}

/// Whether two predictions of one error differ in more than a small correction; that nothing is wrong may be what both say.
fn parts(leading: f64, refined: f64) -> bool {
    leading != refined && !(1.0 / APART..=APART).contains(&(leading / refined))
}

/// Per state, whether the leading terms alone say something else of its error, because contributions cancel.
pub(super) fn cancelling(
    kernel: Kernel,
    leading: &[Option<f64>],
    refined: &[Option<f64>],
) -> Vec<bool> {
    let both = leading.iter().zip(refined);
    let differ = |(leading, refined): (&Option<f64>, &Option<f64>)| {
        let known = leading.zip(*refined).filter(|_| leads(kernel));
        known.is_some_and(|(leading, refined)| parts(leading, refined))
    };
    both.map(differ).collect()
}

fn large(prediction: &Prediction) -> Option<String> {
    let all = prediction.max_abs.iter().flatten();
    let largest = all.fold(prediction.frequency.abs(), |most, e| most.max(e.abs()));
    (largest > LARGE).then(|| format!("an error of {largest:.2e} is not small"))
}
