//! Values of the drill string.

use stickslip::report::{Column, Table};

use stickslip::study::EquilibriaRecord;

use super::super::copies::Copies;
use super::super::equilibrium::hopf;
use super::super::words::{beside, decimals, ending, power, stability};

pub(super) fn ends(copies: &Copies) -> Table {
    let columns = [
        Column::numbers("*ε*"),
        Column::numbers("*f* at 4"),
        Column::numbers("max |*ψ*| at 4"),
        Column::words("downwards it ends at"),
        Column::numbers("max |*ψ*| there"),
        Column::words("upwards it ends at"),
    ];
    let exact = copies.exact.branches.last();
    let caption = format!(
        "The copies at *η* = 4, and where their branches end. The exact cycle exists from *η* = 0 to {}, where its slip phase just fails to reach the \
         table's speed again; a copy loses it in a fold.",
        decimals(exact.map_or(f64::NAN, |branch| branch.end.r), 4)
    );
    let table = Table::new("drill-string-ends", caption, columns);
    table.rows(copies.copies.iter().filter_map(|(exponent, copy)| {
        let [down, up] = copy.branches.as_slice() else {
            return None;
        };
        let first = &copy.cycle.orbit;
        let last = down.points.last()?;
        Some(vec![
            power(*exponent),
            decimals(1.0 / first.period, 7),
            decimals(first.max_abs[0], 6),
            ending(down.end, "*η*"),
            decimals(last.max_abs[0], 4),
            ending(up.end, "*η*"),
        ])
    }))
}

pub(super) fn values(copies: &Copies, rest: &EquilibriaRecord) -> Table {
    let [first, second] = hopf(rest);
    let all = copies.copies.iter().flat_map(|(_, copy)| copy.points());
    beside(
        "drill-string",
        "Drill string: values of the thesis beside ours.",
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
    ])
}
