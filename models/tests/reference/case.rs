//! Cases as written in `tests/reference/*.json`.

use std::path::PathBuf;

use serde_json::Value;

/// One call of the program and what must come of it.
pub(crate) struct Case {
    pub(crate) name: String,
    pub(crate) args: Vec<String>,
    pub(crate) exit: i32,
    pub(crate) stderr: String,
    /// Paths into the JSON document, and what stands there.
    pub(crate) expect: Vec<(String, Expected)>,
    /// Special points of a branch: kind, r, relative tolerance.
    pub(crate) special: Vec<(String, f64, f64)>,
}

/// What a place of a document must hold.
pub(crate) enum Expected {
    /// Exactly this.
    Same(Value),
    /// This number, to a tolerance relative to the larger of itself and a scale.
    Number {
        value: f64,
        tolerance: f64,
        scale: f64,
    },
}

impl Case {
    /// A case that succeeds answers with one JSON document.
    pub(crate) fn arguments(&self) -> Vec<String> {
        let mut arguments = self.args.clone();
        if self.exit == 0 && !arguments.iter().any(|argument| argument == "--json") {
            arguments.push("--json".to_owned());
        }
        arguments
    }
}

/// All cases of every file, in the order of the files' names.
pub(crate) fn all() -> Vec<Case> {
    let folder = PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../tests/reference"));
    let mut files: Vec<PathBuf> = std::fs::read_dir(&folder)
        .unwrap_or_else(|error| panic!("{}: {error}", folder.display()))
        .map(|entry| entry.expect("a readable folder").path())
        .filter(|path| {
            path.extension()
                .is_some_and(|extension| extension == "json")
        })
        .collect();
    files.sort();
    files.iter().flat_map(read).collect()
}

fn read(file: &PathBuf) -> Vec<Case> {
    let text = std::fs::read_to_string(file).expect("a readable file");
    let document: Value =
        serde_json::from_str(&text).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    document
        .as_array()
        .expect("a list of cases")
        .iter()
        .map(case)
        .collect()
}

fn case(document: &Value) -> Case {
    let list = |key: &str| document[key].as_array().cloned().unwrap_or_default();
    let fields = document["expect"].as_object().cloned().unwrap_or_default();
    Case {
        name: text(&document["name"]),
        args: list("args").iter().map(text).collect(),
        exit: document["exit"].as_i64().unwrap_or(0) as i32,
        stderr: document["stderr"].as_str().unwrap_or("").to_owned(),
        expect: fields
            .into_iter()
            .map(|(path, value)| (path, expected(value)))
            .collect(),
        special: list("special")
            .iter()
            .map(|point| (text(&point[0]), number(&point[1]), number(&point[2])))
            .collect(),
    }
}

fn expected(value: Value) -> Expected {
    let Some(parts) = value.as_array() else {
        return Expected::Same(value);
    };
    let exact = number(&parts[0]);
    Expected::Number {
        value: exact,
        tolerance: number(&parts[1]),
        scale: parts
            .get(2)
            .map_or(exact.abs(), |scale| number(scale).max(exact.abs())),
    }
}

fn text(value: &Value) -> String {
    value.as_str().expect("a text").to_owned()
}

/// Trusted numbers stand as text, with more digits than a double holds.
fn number(value: &Value) -> f64 {
    match value {
        Value::String(text) => text.parse().expect("a number"),
        other => other.as_f64().expect("a number"),
    }
}
