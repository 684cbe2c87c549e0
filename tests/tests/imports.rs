//! The modules of the runtime import one way only: each from those to its left.

use std::collections::BTreeMap;
use std::path::Path;

/// Modules from left to right. `app` and `study` stand on everything.
const ORDER: [&str; 22] = [
    "scalar",
    "math",
    "linear",
    "suggest",
    "serial",
    "model",
    "memory",
    "friction",
    "declared",
    "field",
    "integrate",
    "flow",
    "poincare",
    "lyapunov",
    "continuation",
    "bifurcation",
    "equilibrium",
    "shooting",
    "curve",
    "study",
    "report",
    "app",
];

/// Imports against the order that the runtime still has, and why.
const EXCEPTIONS: [(&str, &str); 4] = [
    // A contact as data names the data of its law, whose parameters have units and bounds.
    ("model", "friction"),
    ("model", "memory"),
    ("memory", "friction"),
    // A field says what errors are measured against, given a tolerance.
    ("field", "integrate"),
];

#[test]
fn modules_import_from_their_left_only() {
    let mut imports = BTreeMap::new();
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../runtime/src");
    scan(&root, &root, &mut imports);
    assert!(
        imports.len() > 10,
        "the scan found next to nothing: {imports:?}"
    );
    let place = |module: &str| ORDER.iter().position(|name| *name == module);
    let mut wrong = Vec::new();
    for ((from, to), file) in &imports {
        let expected = match (place(from), place(to)) {
            (Some(from), Some(to)) => to < from,
            _ => false,
        };
        if !expected && !EXCEPTIONS.contains(&(from.as_str(), to.as_str())) {
            wrong.push(format!("{file}: `{from}` imports from `{to}`"));
        }
    }
    for (from, to) in EXCEPTIONS {
        let used = imports.contains_key(&(from.to_owned(), to.to_owned()));
        assert!(
            used,
            "`{from}` does not import from `{to}` any more: take the exception out"
        );
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Notes each pair of modules of which one imports from the other, with a file that does.
fn scan(root: &Path, folder: &Path, imports: &mut BTreeMap<(String, String), String>) {
    for entry in std::fs::read_dir(folder).expect("a readable folder") {
        let path = entry.expect("a readable entry").path();
        if path.is_dir() {
            scan(root, &path, imports);
            continue;
        }
        let file = path.strip_prefix(root).expect("a file below the root");
        let first = file.iter().next().expect("a name").to_string_lossy();
        let module = first.trim_end_matches(".rs").to_owned();
        let is_test = path.file_stem().is_some_and(|stem| stem == "tests");
        if is_test || ["lib", "examples"].contains(&module.as_str()) {
            continue;
        }
        let text = std::fs::read_to_string(&path).expect("a readable file");
        for target in targets(&text) {
            if target != module {
                let name = file.display().to_string();
                imports.entry((module.clone(), target)).or_insert(name);
            }
        }
    }
}

/// The modules that a file names, its unit tests left out.
fn targets(text: &str) -> Vec<String> {
    let code = text.split("#[cfg(test)]").next().unwrap_or_default();
    let lines = code
        .lines()
        .filter(|line| !line.trim_start().starts_with("//"));
    let code: String = lines.collect::<Vec<_>>().join("\n");
    let named = code.split("crate::").skip(1).map(|rest| {
        let end = rest.find(|c: char| !(c.is_alphanumeric() || c == '_'));
        rest.split_at(end.unwrap_or(rest.len()))
    });
    // A macro belongs to the crate and to no module.
    named
        .filter(|(name, rest)| !name.is_empty() && !rest.starts_with('!'))
        .map(|(name, _)| name.to_owned())
        .collect()
}
