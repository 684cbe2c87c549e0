//! Values of the drill string.

use stickslip::report::{Column, Table};

use super::super::ReproduceError;
use super::super::words::{decimals, ending, power, stability};
use super::Copy;
use super::equilibrium::hopf;

/// Speed at which the exact cycle ends: its slip just fails to reach the table's speed again.
const EXACT_END: f64 = 4.611_989_021;

pub(super) fn ends(copies: &[Copy]) -> Table {
    let columns = [
        Column::numbers("*ε*"),
        Column::numbers("*f* at 4"),
        Column::numbers("max |*ψ*| at 4"),
        Column::words("downwards it ends at"),
        Column::numbers("max |*ψ*| there"),
        Column::words("upwards it ends at"),
    ];
    let caption = format!(
        "The copies at *η* = 4, and where their branches end. The exact cycle exists from *η* = 0 to {}, where its slip phase just fails to reach the \
         table's speed again; a copy loses it in a fold.",
        decimals(EXACT_END, 4)
    );
    Table::new("drill-string-ends", caption, columns).rows(copies.iter().map(|copy| {
        let first = &copy.cycle.orbit;
        let last = copy.down.orbits.last().unwrap_or(first);
        vec![
            power(copy.exponent),
            decimals(1.0 / first.period, 7),
            decimals(first.max_abs()[0], 6),
            ending(&copy.down.end, "*η*"),
            decimals(last.max_abs()[0], 4),
            ending(&copy.up.end, "*η*"),
        ]
    }))
}

pub(super) fn values(copies: &[Copy]) -> Result<Table, ReproduceError> {
    let columns = [
        Column::words("quantity"),
        Column::numbers("thesis"),
        Column::numbers("here"),
        Column::words("remark"),
    ];
    let [first, second] = hopf(1.0)?;
    let all = copies
        .iter()
        .flat_map(|copy| copy.down.orbits.iter().chain(&copy.up.orbits));
    Ok(Table::new(
        "drill-string",
        "Drill string: values of the thesis beside ours.",
        columns,
    )
    .row([
        "*η*_{bif,1} for *ε* = 1".into(),
        "3.759".into(),
        decimals(first, 6),
        "below it the copy's equilibrium is unstable".to_owned(),
    ])
    .row([
        "*η*_{bif,2} for *ε* = 1".into(),
        "1.018".into(),
        decimals(second, 6),
        "below it the equilibrium is stable again and the copy has no cycle".to_owned(),
    ])
    .row([
        "stability of all branches".into(),
        "stable".into(),
        stability(all),
        "the others lie at the tip of a fold, or where the cycle vanishes".to_owned(),
    ])
    .row([
        "end of sticking".into(),
        "2*ζθ* + *ψ* = *T*_{c}".into(),
        "2*ζη* + *ψ* = *T*_{c}".into(),
        "a misprint in (4.10): the release at *ψ* = *θ* − 2*ζη* needs *η*".to_owned(),
    ]))
}
