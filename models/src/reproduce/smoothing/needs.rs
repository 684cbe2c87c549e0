//! The cheapest setting for an accuracy.

use std::time::Duration;

use stickslip::study::report::{Column, Table};
use stickslip::study::trade::{Setting, Trade};

use super::super::words::{count, duration, evaluations, scientific};

/// The settings at which each system meets the accuracy at least cost.
pub(super) fn table(trades: &[Trade]) -> Table {
    let columns = [
        Column::words("friction"),
        Column::numbers("least *ε* (s/m)"),
        Column::numbers("loosest tolerance"),
        Column::numbers("error"),
        Column::numbers("evaluations"),
        Column::numbers("LU"),
        Column::numbers("time"),
    ];
    let caption = "What a relative accuracy of 10^{−3} in frequency and extrema takes, for one period with its \
                   derivatives: what every iteration of shooting pays. The thesis asks for *ε* ≥ 9.7 × 10^{5} with \
                   arctan, by its fit of the frequency's error. LU: factorisations, which only implicit steps need. The \
                   time is that of this run, with all cores busy.";
    let exact = trades.first().and_then(|trade| {
        let setting = trade.need.as_ref()?.as_ref().ok()?;
        Some(row("exact", "–".to_owned(), setting))
    });
    let copies = trades.iter().filter_map(|trade| {
        let curve = trade.curves.first()?;
        let need = curve.need.as_ref()?.as_ref().ok()?;
        let size = scientific(need.smoothing.size, 1);
        Some(row(&curve.kernel.to_string(), size, &need.setting))
    });
    Table::new("needs", caption, columns).rows(exact.into_iter().chain(copies))
}

fn row(name: &str, size: String, setting: &Setting) -> Vec<String> {
    vec![
        name.to_owned(),
        size,
        scientific(setting.tolerance, 1),
        scientific(setting.error, 1),
        count(evaluations(&setting.cost.work)),
        count(setting.cost.work.factorisations),
        duration(Duration::from_secs_f64(setting.cost.seconds)),
    ]
}
