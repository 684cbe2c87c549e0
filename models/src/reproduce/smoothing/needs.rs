//! The cheapest setting for an accuracy.

use std::time::Duration;

use stickslip::report::{Column, Table};
use stickslip::study::trade::{Setting, Trade};

use super::super::words::{count, duration, evaluations, scientific};

/// The settings at which each system meets the accuracy at least cost.
pub(super) fn table(trades: &[Trade]) -> Table {
    let columns = [
        Column::words("friction"),
        Column::numbers("*ε* by frequency alone (s/m)"),
        Column::numbers("*ε* by all"),
        Column::numbers("tolerance"),
        Column::numbers("error"),
        Column::numbers("evaluations"),
        Column::numbers("LU"),
        Column::numbers("time"),
    ];
    let caption = "What a relative accuracy of 10^{−3} in frequency and extrema takes, for one period with its \
                   derivatives: what every iteration of shooting pays. The thesis asks for *ε* ≥ 9.7 × 10^{5} with \
                   arctan, by its fit of the frequency's error. LU: factorisations, which only implicit steps need. The \
                   tolerance is the loosest that does. The velocity of the mass is the most demanding extremum. The \
                   time is that of this run, with all cores busy.";
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
    Table::new("needs", caption, columns).rows(exact.into_iter().chain(copies))
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
