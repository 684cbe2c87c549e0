//! Every cell of the map of the extremes holds what it is to hold.

use stickslip_models::reproduce::extremes::{Cell, Expected, Outcome, map};

/// Why a cell does not hold what it is to hold.
fn fault(cell: &Cell) -> Option<String> {
    match (&cell.expected, &cell.outcome) {
        (Expected::Refused(wanted), Outcome::Refused { kind, .. }) if wanted == kind => None,
        (
            Expected::Digits(wanted),
            Outcome::Found {
                digits,
                claimed,
                honest,
                ..
            },
        ) => {
            let few = *digits < f64::from(*wanted);
            (few || !honest).then(|| format!("{digits:.1} digits, {claimed:.1} claimed"))
        }
        (_, outcome) => Some(format!("{outcome:?}")),
    }
}

#[test]
fn every_cell_holds_what_it_is_to_hold() {
    let mut faults = Vec::new();
    for (range, cells) in map() {
        for cell in &cells {
            if let Some(fault) = fault(cell) {
                let (system, varied) = (range.system.command(), range.varied);
                let (value, expected) = (cell.value, cell.expected);
                faults.push(format!(
                    "{system} {varied} = {value:e}: {expected:?}, but {fault}"
                ));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}
