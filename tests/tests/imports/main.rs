//! The modules of the runtime stand on each other in one order, at every level, and no file needs itself in a circle.

mod files;
mod paths;

use std::path::Path;

use files::{Files, Graph, beside, circle};

/// Modules from the ground up.
const ORDER: [&str; 26] = [
    "scalar",
    "math",
    "linear",
    "words",
    "suggest",
    "model",
    "memory",
    "press",
    "friction",
    "declared",
    "field",
    "integrate",
    "flow",
    "motion",
    "continuation",
    "bifurcation",
    "poincare",
    "lyapunov",
    "harmonics",
    "equilibrium",
    "shooting",
    "curve",
    "study",
    "reduce",
    "report",
    "app",
];

/// A file that needs another against the order.
type Need = (&'static str, &'static str);

/// What files need against the order or in a circle, and why.
const EXCEPTIONS: [(&str, &[Need]); 5] = [
    (
        "a contact as data names the data of its law, whose parameters have units and bounds",
        &[
            ("model", "friction"),
            ("model/info", "friction"),
            ("model/info", "memory"),
            ("model/info", "press"),
            ("memory", "friction"),
            ("press", "friction"),
        ],
    ),
    (
        "a field says what errors are measured against, given a tolerance",
        &[
            ("field", "integrate"),
            ("field/exact", "integrate"),
            ("field/smooth", "integrate"),
        ],
    ),
    (
        "one type, too long for one file: its parts know it, and it calls them",
        &[
            ("field/exact/constants", "field/exact/affine"),
            ("flow/exact/press", "flow/exact"),
            ("flow/exact/run", "flow/exact"),
            ("flow/exact/switch", "flow/exact/run"),
            ("integrate/radau/control", "integrate/radau"),
            ("integrate/radau/kink", "integrate/radau"),
            ("integrate/radau/stages", "integrate/radau"),
            ("integrate/stepper", "integrate/explicit"),
            ("report/draw", "report/figure"),
            ("shooting/certificate/equations", "shooting/certificate"),
        ],
    ),
    (
        "a family gives one that keeps a tape",
        &[
            ("motion/family", "motion/tape"),
            ("motion/modes", "motion/passage"),
        ],
    ),
    (
        "what a prediction asks of a model is put in terms of what is known of its orbit already",
        &[
            ("study/predict/rubbing", "study/predict/history"),
            ("study/predict/rubbing", "study/predict/response"),
        ],
    ),
];

/// What each file needs, the exceptions left out.
fn needs() -> Graph {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../runtime/src");
    let mut needs = Files::below(&root).needs();
    assert!(needs.len() > 100, "the scan found next to nothing");
    let known = EXCEPTIONS.iter().flat_map(|(_, known)| *known);
    let unused: Vec<String> = known
        .filter(|(from, to)| !needs.get_mut(*from).is_some_and(|needs| needs.remove(*to)))
        .map(|(from, to)| format!("{from} -> {to}"))
        .collect();
    assert!(
        unused.is_empty(),
        "take out these exceptions, they are needed no more:\n{}",
        unused.join("\n")
    );
    needs
}

#[test]
fn modules_import_downwards_only() {
    let place = |module: &str| ORDER.iter().position(|name| *name == module);
    let first = |file: &str| file.split('/').next().unwrap_or_default().to_owned();
    let mut wrong = Vec::new();
    for (from, all) in needs() {
        let here = first(&from);
        assert!(place(&here).is_some(), "`{here}` has no place in the order");
        let upwards = |to: &&String| first(to) != here && place(&first(to)) > place(&here);
        wrong.extend(
            all.iter()
                .filter(upwards)
                .map(|to| format!("{from} -> {to}")),
        );
    }
    assert!(wrong.is_empty(), "imports upwards:\n{}", wrong.join("\n"));
}

#[test]
fn no_file_needs_itself() {
    if let Some(circle) = circle(&needs()) {
        panic!("a circle of files: {}", circle.join(" -> "));
    }
}

/// Not only files: in each folder, no module with all below it needs itself through the others.
#[test]
fn no_module_needs_itself() {
    let needs = needs();
    let folders = needs.keys().filter_map(|file| file.rsplit_once('/'));
    let mut folders: Vec<&str> = folders.map(|(folder, _)| folder).collect();
    folders.sort_unstable();
    folders.dedup();
    let circles: Vec<String> = (folders.into_iter())
        .filter_map(|folder| {
            let circle = circle(&beside(&needs, folder))?;
            Some(format!("in {folder}: {}", circle.join(" -> ")))
        })
        .collect();
    assert!(
        circles.is_empty(),
        "circles of modules:\n{}",
        circles.join("\n")
    );
}
