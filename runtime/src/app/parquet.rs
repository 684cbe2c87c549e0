//! Tables as columns: Parquet, for programs that read many or long ones.
//!
//! The columns are those of the CSV, of numbers, whole numbers, words and truths; an empty cell is null. What was asked, and
//! the units, stand in the metadata of the file under the key `stickslip`, as JSON.

use std::sync::Arc;

use parquet::basic::{LogicalType, Repetition, Type as Physical};
use parquet::data_type::{BoolType, ByteArrayType, DataType, DoubleType, Int64Type};
use parquet::errors::{ParquetError, Result};
use parquet::file::metadata::KeyValue;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
use parquet::schema::types::{Type, TypePtr};
use serde_json::{Map, Value, json};

use super::question::command;
use super::spreadsheet::{Head, Holds, Row, Spreadsheet};

/// The key of what is said of a table.
const KEY: &str = "stickslip";
/// Rows that are held in memory at once.
const GROUP: usize = 1 << 20;

/// A table as a file, for a question with these fields.
pub(super) fn parquet(sheet: &Spreadsheet, subject: &Value) -> Result<Vec<u8>> {
    let program = concat!("stickslip ", env!("CARGO_PKG_VERSION"));
    let said = KeyValue::new(KEY.to_owned(), said(&sheet.head, subject, program));
    let properties = WriterProperties::builder()
        .set_created_by(program.to_owned())
        .set_key_value_metadata(Some(vec![said]))
        .build();
    let schema = schema(&sheet.head)?;
    let mut file = SerializedFileWriter::new(Vec::new(), schema, Arc::new(properties))?;
    for rows in sheet.rows.chunks(GROUP) {
        let mut group = file.next_row_group()?;
        for (j, head) in sheet.head.iter().enumerate() {
            if let Some(column) = group.next_column()? {
                write(column, head, &cells(rows, j))?;
            }
        }
        group.close()?;
    }
    file.into_inner()
}

/// What was asked by which words, and what the columns are.
fn said(head: &[Head], subject: &Value, program: &str) -> String {
    let column = |head: &Head| {
        let parts = head.name.rsplit_once(" (");
        let unit = parts.and_then(|(_, unit)| unit.strip_suffix(')'));
        (head.name.clone(), json!({ "unit": unit }))
    };
    let columns: Map<String, Value> = head.iter().map(column).collect();
    let said = json!({
        "program": program, "command": command(), "question": subject, "columns": columns,
    });
    said.to_string()
}

/// The columns, in any of which a cell may be empty.
fn schema(head: &[Head]) -> Result<TypePtr> {
    let column = |head: &Head| {
        let (physical, logical) = match head.holds {
            Holds::Words => (Physical::BYTE_ARRAY, Some(LogicalType::String)),
            Holds::Numbers => (Physical::DOUBLE, None),
            Holds::Counts => (Physical::INT64, None),
            Holds::Truths => (Physical::BOOLEAN, None),
        };
        Type::primitive_type_builder(&head.name, physical)
            .with_repetition(Repetition::OPTIONAL)
            .with_logical_type(logical)
            .build()
            .map(Arc::new)
    };
    let columns = head.iter().map(column).collect::<Result<Vec<_>>>()?;
    let table = Type::group_type_builder("table").with_fields(columns);
    table.build().map(Arc::new)
}

/// The cells of column number `j`.
fn cells(rows: &[Row], j: usize) -> Vec<&str> {
    rows.iter()
        .map(|row| row.get(j).map_or("", String::as_str))
        .collect()
}

fn write(column: SerializedColumnWriter<'_>, head: &Head, cells: &[&str]) -> Result<()> {
    match head.holds {
        Holds::Words => {
            let word = |cell: &str| Some(cell.into());
            put::<ByteArrayType>(column, head, cells, word)
        }
        Holds::Numbers => put::<DoubleType>(column, head, cells, |cell| cell.parse().ok()),
        Holds::Counts => put::<Int64Type>(column, head, cells, |cell| cell.parse().ok()),
        Holds::Truths => put::<BoolType>(column, head, cells, |cell| cell.parse().ok()),
    }
}

/// Writes a column of which each cell that is not empty has a value.
fn put<D: DataType>(
    mut column: SerializedColumnWriter<'_>,
    head: &Head,
    cells: &[&str],
    value: impl Fn(&str) -> Option<D::T>,
) -> Result<()> {
    let there = |cell: &&&str| !cell.is_empty();
    let levels: Vec<i16> = cells.iter().map(|cell| i16::from(there(&cell))).collect();
    let values = cells.iter().filter(there).map(|cell| {
        let wrong = || ParquetError::General(format!("`{cell}` is no value of `{}`", head.name));
        value(cell).ok_or_else(wrong)
    });
    let values = values.collect::<Result<Vec<D::T>>>()?;
    column
        .typed::<D>()
        .write_batch(&values, Some(&levels), None)?;
    column.close()
}

#[cfg(test)]
mod tests {
    use std::fs::File;

    use parquet::file::reader::{FileReader, SerializedFileReader};
    use parquet::record::Field;

    use super::*;
    use crate::app::spreadsheet::{full, headed};

    /// Numbers of all kinds that doubles have.
    const NUMBERS: [f64; 7] = [
        0.1,
        -0.0,
        5e-324,
        f64::MAX,
        f64::NEG_INFINITY,
        1.151_292_546_497_023,
        -1.0 / 3.0,
    ];

    /// A table of this name, written and opened.
    fn read(name: &str, sheet: &Spreadsheet) -> SerializedFileReader<File> {
        let file = parquet(sheet, &json!({ "model": "belt" })).unwrap();
        let path = format!("stickslip-{}-{name}.parquet", std::process::id());
        let path = std::env::temp_dir().join(path);
        std::fs::write(&path, file).unwrap();
        let reader = SerializedFileReader::new(File::open(&path).unwrap());
        std::fs::remove_file(path).unwrap();
        reader.unwrap()
    }

    #[test]
    fn what_is_written_is_read_bit_for_bit() {
        let head = vec![
            Holds::Numbers.under("x (m)"),
            Holds::Words.under("kind"),
            Holds::Counts.under("count"),
            Holds::Truths.under("sharp"),
        ];
        let row = |(i, x): (usize, &f64)| {
            let word = if i == 3 { "" } else { "orbit, stable" };
            vec![full(x), word.to_owned(), i.to_string(), (i > 2).to_string()]
        };
        let rows = NUMBERS
            .iter()
            .enumerate()
            .map(row)
            .chain([vec![String::new(); 4]]);
        let file = read("bits", &headed(head, rows));
        let rows: Vec<_> = file
            .get_row_iter(None)
            .unwrap()
            .map(Result::unwrap)
            .collect();
        assert_eq!(rows.len(), 8);
        for (i, (row, x)) in rows.iter().zip(NUMBERS).enumerate() {
            let cells: Vec<(&String, &Field)> = row.get_column_iter().collect();
            let Field::Double(number) = cells[0].1 else {
                panic!("{cells:?}");
            };
            assert_eq!(
                (cells[0].0.as_str(), number.to_bits()),
                ("x (m)", x.to_bits())
            );
            let word = Field::Str("orbit, stable".to_owned());
            assert_eq!(cells[1].1, if i == 3 { &Field::Null } else { &word });
            assert_eq!(cells[2].1, &Field::Long(i as i64));
            assert_eq!(cells[3].1, &Field::Bool(i > 2));
        }
        let last = rows[7].get_column_iter();
        assert!(last.into_iter().all(|(_, cell)| *cell == Field::Null));
    }

    #[test]
    fn units_and_what_was_asked_stand_in_the_file() {
        let head = vec![Holds::Numbers.under("x (m)"), Holds::Words.under("kind")];
        let file = read("units", &headed(head, []));
        let said = file.metadata().file_metadata();
        let pairs = said.key_value_metadata().unwrap();
        let pair = pairs.iter().find(|pair| pair.key == KEY).unwrap();
        let said: Value = serde_json::from_str(pair.value.as_deref().unwrap()).unwrap();
        assert_eq!(said["columns"]["x (m)"]["unit"], "m");
        assert_eq!(said["columns"]["kind"]["unit"], Value::Null);
        assert_eq!(said["question"]["model"], "belt");
        assert!(said["program"].as_str().unwrap().starts_with("stickslip "));
    }

    #[test]
    fn what_is_no_number_is_not_written_as_one() {
        let head = vec![Holds::Numbers.under("x")];
        let sheet = headed(head, [vec!["none".to_owned()]]);
        assert!(parquet(&sheet, &Value::Null).is_err());
    }
}
