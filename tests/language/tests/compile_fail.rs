//! Mistakes, each with what is said to it.
//!
//! The `.stderr` files are the specification of the wording and of the place that is underlined;
//! `TRYBUILD=overwrite` writes them anew.

#[test]
fn mistakes_are_explained() {
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
