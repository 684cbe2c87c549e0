//! Every cell of the map of the extremes holds what it is to hold.

use std::path::Path;

use stickslip::study::parallel_on;
use stickslip_models::reproduce::extremes::{Cell, Expected, Outcome, draw, map, ranges};

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
#[ignore = "long"]
fn every_cell_holds_what_it_is_to_hold() {
    let mut faults = Vec::new();
    let map = map();
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("extremes");
    assert_eq!(draw(&map, &out).expect("a page").figures, 4);
    for (range, cells) in map {
        for cell in &cells {
            if let Some(fault) = fault(cell) {
                let (system, varied) = (range.system(), range.varied());
                let (value, expected) = (cell.value, cell.expected);
                faults.push(format!(
                    "{system} {varied} = {value:e}: {expected:?}, but {fault}"
                ));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// Bit for bit: also the digits that nobody would print.
#[test]
#[ignore = "long"]
fn the_number_of_cores_changes_nothing() {
    let ranges = ranges();
    let some: Vec<(usize, f64)> = (ranges.iter().enumerate())
        .flat_map(|(i, range)| {
            let found = range.cells.iter();
            let found = found.filter(|(_, expected)| matches!(expected, Expected::Digits(_)));
            found.step_by(9).map(move |&(value, _)| (i, value))
        })
        .collect();
    let ask = |cores| parallel_on(Some(cores), &some, |&(i, value)| ranges[i].outcome(value));
    let one = ask(1);
    assert!(some.len() > 20 && one == ask(2) && one == ask(3));
}
