//! The cheapest setting for an accuracy.

use std::time::Duration;

use stickslip::study::trade::{Setting, Trade};

use super::super::words::{count, duration, evaluations, scientific};

/// The settings at which each system meets the accuracy at least cost.
pub(super) fn rows(trades: &[Trade]) -> Vec<Vec<String>> {
    let exact = trades.first().and_then(|trade| {
        let setting = trade.need.as_ref()?.as_ref().ok()?;
        Some(row("exact", ["–".to_owned(), "–".to_owned()], setting))
    });
    let copies = trades.iter().filter_map(|trade| {
        let curve = trade.curves.first()?;
        let need = curve.need.as_ref()?.as_ref().ok()?;
        let sizes = [need.frequency_size, need.smoothing.size].map(|size| scientific(size, 1));
        Some(row(&curve.kernel.to_string(), sizes, &need.setting))
    });
    exact.into_iter().chain(copies).collect()
}

fn row(name: &str, [by_frequency, by_all]: [String; 2], setting: &Setting) -> Vec<String> {
    vec![
        name.to_owned(),
        by_frequency,
        by_all,
        scientific(setting.tolerance, 0),
        scientific(setting.error, 1),
        count(evaluations(&setting.cost.work)),
        count(setting.cost.work.factorisations),
        duration(Duration::from_secs_f64(setting.cost.seconds)),
    ]
}
