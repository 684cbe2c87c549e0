//! The report of the program: nothing of the thesis is missing from it, and nothing in it is empty.

use std::fs;
use std::path::{Path, PathBuf};

use stickslip_models::reproduce::reproduce;

/// Figures of the thesis with results in them, and ours.
const FIGURES: [&str; 20] = [
    "3.1", "3.2", "3.3", "3.5", "3.6", "3.7", "3.8", "3.9", "3.10", "3.11", "3.13", "3.14", "4.3",
    "4.4", "4.5", "4.6", "4.7", "4.8", "4.9", "A.1",
];
const TABLES: [&str; 11] = [
    "van-der-pol",
    "belt-oscillator",
    "belt-oscillator-ends",
    "belt-oscillator-fits",
    "belt-pair",
    "drill-string",
    "drill-string-ends",
    "drill-string-fits",
    "needs",
    "predictions",
    "cost",
];

fn read(path: PathBuf) -> String {
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The data of a figure, all panels together.
fn data(folder: &Path, name: &str) -> String {
    let panels =
        ["", "a", "b", "c", "d"].map(|letter| folder.join(format!("data/{name}{letter}.csv")));
    let there = panels.into_iter().filter(|path| path.exists());
    there.map(read).collect()
}

#[test]
fn nothing_is_missing() {
    let folder = std::env::temp_dir().join(format!("stickslip-report-{}", std::process::id()));
    fs::create_dir_all(&folder).unwrap();
    let summary = reproduce(&folder, true).unwrap();
    assert_eq!(summary.written.figures, FIGURES.len());
    let page = read(folder.join("index.html"));
    for number in FIGURES {
        let name = format!("figure-{}", number.replace('.', "-"));
        assert!(page.contains(&format!("Figure {number}. ")), "{number}");
        let svg = read(folder.join(format!("figures/{name}.svg")));
        assert!(svg.contains("<path"), "{number}");
        let data = data(&folder, &name);
        assert!(data.lines().count() > 5, "{number}: {data}");
        assert!(!data.contains("NaN"), "{number}: {data}");
    }
    for name in TABLES {
        let table = read(folder.join(format!("data/{name}.csv")));
        assert!(table.lines().count() > 2, "{name}: {table}");
        assert!(!table.contains("NaN"), "{name}: {table}");
    }
    for exact in ["3-6", "3-9", "3-10", "4-4", "4-7", "4-8", "A-1"] {
        let data = data(&folder, &format!("figure-{exact}"));
        let points = data.lines().filter(|line| line.starts_with("exact,"));
        assert!(points.count() > 5, "{exact}");
    }
    fs::remove_dir_all(folder).unwrap();
}
