//! What stands in the places of a manuscript.

use crate::report::{Curve, Page, Panel};

/// What stands in a place.
#[derive(Debug, Clone)]
pub(super) enum Filling {
    Sketch(&'static str),
    Curves(Vec<Vec<Curve>>),
    Panels(Vec<Panel>),
    Rows(Vec<Vec<String>>),
    Page(Page),
}

/// Lines as one.
pub(super) fn joined<'a>(lines: impl IntoIterator<Item = &'a str>) -> String {
    lines.into_iter().collect::<Vec<_>>().join(" ")
}
