//! The report of the thesis's results is complete, and stands alone.

use std::fs;
use std::path::{Path, PathBuf};

use stickslip_models::reproduce::{Part, reproduce};

const FIGURES: [&str; 20] = [
    "3.1", "3.2", "3.3", "3.5", "3.6", "3.7", "3.8", "3.9", "3.10", "3.11", "3.13", "3.14", "4.3",
    "4.4", "4.5", "4.6", "4.7", "4.8", "4.9", "A.1",
];
/// Panels that show the exact system among the copies.
const EXACT: [&str; 10] = [
    "3-5a", "3-5b", "3-6", "3-9", "3-10", "4-3", "4-4", "4-7", "4-8", "A-1",
];

const SKETCHES: usize = 3;
const TABLES: usize = 11;

#[test]
#[ignore = "long"]
fn the_report_is_complete_and_stands_alone() {
    let out = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join("report");
    let _ = fs::remove_dir_all(&out);
    let summary = reproduce(Part::Rest, &out, true).expect("a report");
    assert_eq!(summary.written.figures, FIGURES.len());
    let page = fs::read_to_string(&summary.written.page).expect("the page");
    every_figure_is_there(&out, &page);
    the_page_loads_nothing(&page);
    every_link_leads_somewhere(&out, &page);
    the_data_are_numbers(&out.join("data"));
    the_exact_system_is_there(&out.join("data"));
    the_thesis_is_met(&out.join("data"));
}

/// Every bifurcation that section 3.3.2 names, to 4 % on the copy, and its counterpart in the exact system.
#[test]
#[ignore = "long"]
fn the_atlas_is_complete() {
    let out = &Path::new(env!("CARGO_TARGET_TMPDIR")).join("atlas");
    let run = std::process::Command::new(env!("CARGO_BIN_EXE_stickslip"))
        .args(["reproduce", "atlas", "--quiet", "--out"])
        .arg(out)
        .status();
    assert!(run.expect("the program runs").success());
    let table = read(&out.join("data/atlas-bifurcations.csv"));
    assert_eq!(table.len(), 18);
    for row in &table {
        let number = |i: usize| row[i].parse::<f64>().unwrap_or_else(|_| panic!("{row:?}"));
        assert!((number(4) / number(3) - 1.0).abs() < 0.04, "{row:?}");
        assert!((number(5) - number(4)).abs() < 0.01, "{row:?}");
    }
    let page = fs::read_to_string(out.join("atlas.html")).expect("the page of all branches");
    for sin in [
        "http:", "https:", "src=", "@import", "<link", "NaN", "/*DATA*/",
    ] {
        assert!(!page.contains(sin), "{sin}");
    }
    assert!(page.contains("\"ended\":\"closed\""));
    // A doubled branch that falls back on its own passes that one's flips as branch points.
    assert!(!page.contains("branch-point"));
}

fn every_figure_is_there(out: &Path, page: &str) {
    for number in FIGURES {
        assert!(page.contains(&format!("Figure {number}.")), "{number}");
        let file = format!("figures/figure-{}.svg", number.replace('.', "-"));
        let svg = fs::read_to_string(out.join(&file)).expect(&file);
        assert!(
            svg.starts_with("<svg ") && svg.ends_with("</svg>"),
            "{file}"
        );
        assert!(!svg.contains("NaN") && !svg.contains("inf"), "{file}");
    }
    assert_eq!(
        page.matches("<figcaption>").count(),
        FIGURES.len() + SKETCHES + TABLES
    );
}

fn the_page_loads_nothing(page: &str) {
    for sin in [
        "http:", "https:", "src=", "@import", "<link", "<script", "url(h",
    ] {
        assert!(!page.contains(sin), "{sin}");
    }
    let mut ids: Vec<&str> = page.split(" id=\"").skip(1).map(upto_quote).collect();
    let all = ids.len();
    ids.sort_unstable();
    ids.dedup();
    assert_eq!(ids.len(), all, "an identifier is used twice");
}

fn every_link_leads_somewhere(out: &Path, page: &str) {
    for link in page.split(" href=\"").skip(1).map(upto_quote) {
        let found = match link.strip_prefix('#') {
            Some(id) => page.contains(&format!(" id=\"{id}\"")),
            None => out.join(link).is_file(),
        };
        assert!(found, "{link}");
    }
}

fn the_data_are_numbers(folder: &Path) {
    let mut files = 0;
    for file in fs::read_dir(folder).expect("data") {
        let path = file.expect("a file").path();
        let name = path
            .file_name()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned();
        let records = read(&path);
        assert!(!records.is_empty(), "{name} is empty");
        if name.starts_with("figure") {
            let numbers = records
                .iter()
                .flat_map(|record| record.iter().skip(record.len() - 2));
            let finite = |text: &str| text.parse().is_ok_and(f64::is_finite);
            assert!(numbers.clone().all(finite), "{name}");
        }
        no_column_mixes(&records, &name);
        files += 1;
    }
    assert_eq!(files, 40);
}

/// What is a number in one row is one, or nothing, in all; no column is empty, and all is plain letters.
fn no_column_mixes(records: &[csv::StringRecord], name: &str) {
    let number = |cell: &str| cell.parse::<f64>().is_ok();
    for column in 0..records[0].len() {
        let cells = || records.iter().map(|row| &row[column]);
        assert!(cells().all(str::is_ascii), "{name}: column {column}");
        assert!(
            cells().any(|cell| !cell.is_empty()),
            "{name}: column {column}"
        );
        let mut given = cells().filter(|cell| !cell.is_empty());
        let numeric = cells().any(number);
        assert!(!numeric || given.all(number), "{name}: column {column}");
    }
}

fn the_exact_system_is_there(folder: &Path) {
    for panel in EXACT {
        let records = read(&folder.join(format!("figure-{panel}.csv")));
        let exact = records.iter().filter(|row| row[0].starts_with("exact"));
        assert!(exact.count() > 3, "{panel}");
    }
}

/// The multiplier of the thesis's first orbit, and where the belt's first copy loses its cycle.
fn the_thesis_is_met(folder: &Path) {
    let table = read(&folder.join("van-der-pol.csv"));
    let multiplier = table.iter().find(|row| row[0].starts_with("lambda_2"));
    let here = &multiplier.expect("the multiplier")[3];
    assert_eq!(here, "0.859695e-3");
    let table = read(&folder.join("belt-oscillator-ends.csv"));
    assert_eq!(
        [&table[0][4], &table[0][7]],
        ["0.051871", "shrinks to the equilibrium"]
    );
    for (file, row, fits) in [
        ("belt-oscillator-fits", 3, ["-0.591", "3.37"]),
        ("belt-oscillator-fits", 7, ["-0.602", "3.99"]),
        ("drill-string-fits", 3, ["0.587", "0.297"]),
        ("drill-string-fits", 7, ["0.621", "0.0860"]),
    ] {
        let table = read(&folder.join(format!("{file}.csv")));
        assert_eq!([&table[row][3], &table[row][5]], fits, "{file}");
    }
}

fn read(path: &Path) -> Vec<csv::StringRecord> {
    let mut reader = csv::Reader::from_path(path).expect("a file of data");
    reader
        .records()
        .map(|record| record.expect("a record"))
        .collect()
}

fn upto_quote(text: &str) -> &str {
    text.split('"').next().unwrap_or_default()
}
