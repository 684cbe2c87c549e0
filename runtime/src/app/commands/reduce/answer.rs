//! A reduced structure in words.

use std::path::Path;

use crate::app::text::{line, number, table};
use crate::reduce::Structure;

/// A damping between modes from which on it is told.
const TOLD: f64 = 1e-6;

pub(super) fn describe(structure: &Structure, out: Option<&Path>) -> String {
    let mut text = format!(
        "{} unknowns reduced to {} modes at {} points, by the method {}\n",
        structure.unknowns,
        structure.modes.len(),
        structure.points.len(),
        structure.method
    );
    text += &modes(structure);
    text += "flexibility that is left out, of that at the point\n";
    text += &flexibility(structure);
    if structure.coupling > TOLD {
        text += &format!(
            "note: the damping couples modes; left out is up to {} of what two modes have themselves\n",
            number(structure.coupling, 3)
        );
    }
    match out {
        Some(path) => text += &format!("written: {}\n", path.display()),
        None => text += "nothing is written: `--out beam.structure` names the file\n",
    }
    text
}

fn modes(structure: &Structure) -> String {
    let unit = |word: &str| match structure.scale {
        Some(_) => format!("{word} (1/s)"),
        None => word.to_owned(),
    };
    let names = structure.points.iter().map(|point| point.name.clone());
    let head = [
        "  mode".to_owned(),
        unit("omega"),
        unit("frequency"),
        "damping".to_owned(),
    ];
    let rows = structure.modes.iter().enumerate().map(|(k, mode)| {
        let cells = [
            format!("  {}", k + 1),
            number(mode.frequency, 9),
            number(mode.frequency / std::f64::consts::TAU, 9),
            number(mode.damping, 3),
        ];
        line(
            cells
                .into_iter()
                .chain(mode.shape.iter().map(|one| number(*one, 6))),
        )
    });
    table(&(line(head.into_iter().chain(names)) + &rows.collect::<String>()))
}

/// What truncation to some numbers of modes would leave out.
fn flexibility(structure: &Structure) -> String {
    let whole = structure.flexibility_beyond(0);
    let count = structure.modes.len();
    let names = structure.points.iter().map(|point| point.name.clone());
    let head = line(["  keeping".to_owned()].into_iter().chain(names));
    let mut kept: Vec<usize> = [count / 8, count / 4, count / 2, count]
        .into_iter()
        .filter(|kept| *kept > 0)
        .collect();
    kept.dedup();
    let rows = kept.into_iter().map(|kept| {
        let left = structure.flexibility_beyond(kept);
        let shares = left.iter().zip(&whole).map(|(left, whole)| match whole {
            0.0 => "-".to_owned(),
            whole => number(left / whole, 3),
        });
        line([format!("  {kept}")].into_iter().chain(shares))
    });
    table(&(head + &rows.collect::<String>()))
}
