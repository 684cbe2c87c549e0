//! Tables are data: what programs that read them make of each.

use std::fs;
use std::path::Path;

use crate::{stickslip, words};

/// Columns that hold words.
const WORDS: [&str; 13] = [
    "kind",
    "reason",
    "word",
    "direction",
    "stability",
    "mode",
    "sweep",
    "motion",
    "kernel",
    "dynamics",
    "artefact",
    "asymptotic",
    "cancelling",
];

const LINES: [&str; 17] = [
    "map belt-oscillator --along v_dr=0.1..0.4:2 --and delta=2..3:2 motion",
    "map belt-oscillator --along v_dr=0.1..0.4:2 --and delta=2..3:2 multiplier",
    "attractors belt-oscillator --box x=-2..2,v=-1..1 --starts 20",
    "attractors belt-oscillator --box x=-2..2,v=-1..1 --starts 5 --along v_dr=0.2..0.4 --values 2",
    "simulate forced-belt --time 20 --smooth arctan:1e3",
    "laws",
    "laws belt-pair",
    "simulate belt-pair --time 5",
    "simulate belt-oscillator --time 20 --section v=0",
    "orbit belt-oscillator",
    "orbit forced-belt --harmonics 1,3",
    "branch belt-pair --along v_dr=0.3..0.24 --start x1=-0.03,x2=0.678,v2=0.3 --period 4.3 --switch flips",
    "branch forced-belt --along omega=1.2..1.1",
    "equilibria belt-pair",
    "equilibria belt-oscillator --smooth arctan:100 --along v_dr=0.2..0.01",
    "diagram belt-oscillator --along v_dr=0.1..0.2 --values 3 --lyapunov 20",
    "trade belt-oscillator --accuracy 1e-2",
];

#[test]
fn every_table_is_read_as_numbers() {
    let mut tables = 0;
    for (i, line) in LINES.iter().enumerate() {
        let out = format!("{}/tables-{i}", env!("CARGO_TARGET_TMPDIR"));
        let _ = fs::remove_dir_all(&out);
        let answer = stickslip(&[&words(line)[..], &["--quiet", "--out", &out]].concat());
        assert_eq!(answer.code, Some(0), "{line}: {}", answer.stderr);
        for file in fs::read_dir(&out).unwrap() {
            let path = file.unwrap().path();
            // What was written is said.
            let name = path.file_name().unwrap().to_str().unwrap();
            assert!(
                answer.stdout.contains(name),
                "{line}: {name}: {}",
                answer.stdout
            );
            if path.extension().is_some_and(|ending| ending == "csv") {
                numbers(&path);
                #[cfg(feature = "parquet")]
                columns(&path);
                tables += 1;
            }
        }
    }
    assert!(tables > 30, "{tables}");
}

/// Columns have names of their own, and hold floating-point numbers, or words.
fn numbers(path: &Path) {
    let mut reader = csv::Reader::from_path(path).unwrap();
    let heads: Vec<String> = reader
        .headers()
        .unwrap()
        .iter()
        .map(str::to_owned)
        .collect();
    for (j, head) in heads.iter().enumerate() {
        assert!(
            !heads[j + 1..].contains(head),
            "{path:?}: two columns `{head}`"
        );
    }
    for row in reader.records() {
        for (head, cell) in heads.iter().zip(&row.unwrap()) {
            let number = cell.is_empty() || cell.parse::<f64>().is_ok();
            let plain = cell.is_ascii();
            assert!(
                plain && (number || WORDS.contains(&head.as_str())),
                "{path:?}: {head}: {cell}"
            );
        }
    }
}

/// The file of columns beside a table holds the same, numbers bit for bit; empty cells are null.
#[cfg(feature = "parquet")]
fn columns(path: &Path) {
    use parquet::file::reader::{FileReader, SerializedFileReader};
    use parquet::record::Field;

    let file = fs::File::open(path.with_extension("parquet")).unwrap();
    let file = SerializedFileReader::new(file).unwrap();
    let mut rows = file.get_row_iter(None).unwrap();
    let mut reader = csv::Reader::from_path(path).unwrap();
    let heads: Vec<String> = reader
        .headers()
        .unwrap()
        .iter()
        .map(str::to_owned)
        .collect();
    let schema = file.metadata().file_metadata().schema_descr();
    let names = schema.columns().iter().map(|column| column.name());
    assert!(names.eq(heads.iter().map(String::as_str)), "{path:?}");
    for cells in reader.records() {
        let (cells, row) = (cells.unwrap(), rows.next().unwrap().unwrap());
        for ((head, cell), (name, value)) in heads.iter().zip(&cells).zip(row.get_column_iter()) {
            let same = match value {
                Field::Null => cell.is_empty(),
                Field::Double(x) => cell.parse::<f64>().unwrap().to_bits() == x.to_bits(),
                Field::Long(n) => cell == n.to_string(),
                Field::Bool(truth) => cell == truth.to_string(),
                Field::Str(word) => WORDS.contains(&head.as_str()) && word == cell,
                _ => false,
            };
            assert!(same && name == head, "{path:?}: {head}: {cell}: {value:?}");
        }
    }
    assert!(rows.next().is_none(), "{path:?}");
}
