//! Mistakes, each with what is said to it.
//!
//! The `.stderr` files are the specification of the wording and of the place that is underlined;
//! `TRYBUILD=overwrite` writes them anew.

use std::fs;
use std::path::Path;

/// A structure is looked for in the folder of the crate that declares it: of mistakes, that of the crate made for them.
fn lay_out_structure() {
    let target = Path::new(env!("CARGO_TARGET_TMPDIR")).parent();
    let made = target
        .expect("a target directory")
        .join("tests/trybuild/stickslip-language");
    fs::create_dir_all(&made).expect("a folder");
    fs::copy(
        "tests/compile_fail/structures/beam.structure",
        made.join("beam.structure"),
    )
    .expect("a copy");
}

#[test]
fn mistakes_are_explained() {
    lay_out_structure();
    let cases = trybuild::TestCases::new();
    for topic in [
        "arrays",
        "bounds",
        "drive",
        "equations",
        "formulas",
        "law",
        "lines",
        "memory",
        "names",
        "press",
        "structures",
        "units",
    ] {
        cases.compile_fail(format!("tests/compile_fail/{topic}/*.rs"));
    }
}

/// What rustc can say, rustc says; its wording changes from version to version.
#[rustversion::attr(not(stable(1.95)), ignore)]
#[test]
fn the_compiler_explains_the_rest() {
    trybuild::TestCases::new().compile_fail("tests/compile_fail/rustc/*.rs");
}
