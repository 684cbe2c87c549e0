//! Mistakes, each with what the compiler says to it.
//!
//! The `.stderr` files are the specification of the wording and of the place that is underlined;
//! `TRYBUILD=overwrite` writes them anew.

#[test]
fn mistakes_are_explained() {
    trybuild::TestCases::new().compile_fail("tests/compile_fail/*/*.rs");
}
