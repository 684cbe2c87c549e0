//! Values of the belt oscillator.

use stickslip::report::{Column, Table};

use super::super::ReproduceError;
use super::super::follow::End;
use super::super::words::{decimals, ending, power, stability};
use super::Copy;
use super::equilibrium::hopf;

pub(super) fn ends(copies: &[Copy]) -> Result<Table, ReproduceError> {
    let columns = [
        Column::numbers("*ε* (s/m)"),
        Column::numbers("*f* at 0.2 (Hz)"),
        Column::numbers("max |*x*| at 0.2 (m)"),
        Column::numbers("*v*_{bif} (m/s)"),
        Column::words("the branch ends at"),
        Column::numbers("*f* there"),
        Column::numbers("max |*x*| there"),
    ];
    let caption = "The copies at *v*_{dr} = 0.2 m/s, and where their branches end. Below *v*_{bif} the equilibrium of the copy is stable and there is no cycle: an \
                   artefact of smoothing, for the real equilibrium is unstable at all speeds. The thesis gives \
                   *v*_{bif} ≈ 0.052 m/s for *ε* = 10^{2}; its branches ended when steps became too small.";
    let speeds: Vec<f64> = copies
        .iter()
        .map(|copy| hopf(10f64.powi(copy.exponent)))
        .collect::<Result<_, _>>()?;
    let table = Table::new("belt-oscillator-ends", caption, columns);
    Ok(table.rows(copies.iter().zip(speeds).map(|(copy, v_bif)| {
        let first = &copy.cycle.orbit;
        let last = copy.branch.orbits.last().unwrap_or(first);
        vec![
            power(copy.exponent),
            decimals(1.0 / first.period, 7),
            decimals(first.max_abs()[0], 6),
            decimals(v_bif, 7),
            ending(&copy.branch.end, "*v*_{dr}"),
            decimals(1.0 / last.period, 5),
            decimals(last.max_abs()[0], 4),
        ]
    })))
}

pub(super) fn values(copies: &[Copy]) -> Table {
    let columns = [
        Column::words("quantity"),
        Column::numbers("thesis"),
        Column::numbers("here"),
        Column::words("remark"),
    ];
    let mut table = Table::new(
        "belt-oscillator",
        "One mass on a belt: values of the thesis beside ours.",
        columns,
    )
    .row([
        "equilibrium at *v*_{dr} = 0.2 (m)",
        "0.625",
        "0.625",
        "*F*_{s}/*k*/(1 + *δ* *v*_{dr}), exactly",
    ]);
    if let Some(copy) = copies.first() {
        let measured = match copy.branch.end {
            End::Vanishes(r) => decimals(r, 5),
            _ => "–".to_owned(),
        };
        table = table.row([
            "*v*_{bif} for *ε* = 10^{2} (m/s)".into(),
            "0.052".into(),
            measured,
            "where the followed cycle has shrunk to nothing".to_owned(),
        ]);
    }
    let all = copies.iter().flat_map(|copy| &copy.branch.orbits);
    table.row([
        "stability of all branches".into(),
        "stable".into(),
        stability(all),
        "DIANA called some unstable: it took the multiplier 1 for one outside".to_owned(),
    ])
}
