//! Values of the belt oscillator.

use stickslip::report::{Column, Table};
use stickslip::study::EquilibriaRecord;

use super::super::branch::{End, Why};
use super::super::copies::Copies;
use super::super::equilibrium::hopf;
use super::super::words::{beside, decimals, ending, power, stability};

pub(super) fn ends(copies: &Copies, rests: &[EquilibriaRecord]) -> Table {
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
    let table = Table::new("belt-oscillator-ends", caption, columns);
    let rows = copies.copies.iter().zip(rests);
    table.rows(rows.filter_map(|((exponent, copy), rest)| {
        let ([v_bif], [branch]) = (hopf(rest), copy.branches.as_slice()) else {
            return None;
        };
        let first = &copy.cycle.orbit;
        let last = branch.points.last()?;
        Some(vec![
            power(*exponent),
            decimals(1.0 / first.period, 7),
            decimals(first.max_abs[0], 6),
            decimals(v_bif, 7),
            ending(branch.end, "*v*_{dr}"),
            decimals(1.0 / last.period, 5),
            decimals(last.max_abs[0], 4),
        ])
    }))
}

pub(super) fn values(copies: &Copies) -> Table {
    let first = copies.copies.first().map(|(_, copy)| copy.branches[0].end);
    let measured = match first {
        Some(End {
            r,
            why: Why::Vanishes,
        }) => decimals(r, 5),
        _ => "–".to_owned(),
    };
    let all = copies.copies.iter().flat_map(|(_, copy)| copy.points());
    beside(
        "belt-oscillator",
        "One mass on a belt: values of the thesis beside ours.",
    )
    .row([
        "equilibrium at *v*_{dr} = 0.2 (m)",
        "0.625",
        "0.625",
        "*F*_{s}/*k*/(1 + *δ* *v*_{dr}), exactly",
    ])
    .row([
        "*v*_{bif} for *ε* = 10^{2} (m/s)".into(),
        "0.052".into(),
        measured,
        "where the followed cycle has shrunk to nothing".to_owned(),
    ])
    .row([
        "stability of all branches".into(),
        "stable".into(),
        stability(all),
        "DIANA called some unstable: it took the multiplier 1 for one outside".to_owned(),
    ])
}
