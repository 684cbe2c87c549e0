//! What comes out of a study: figures and tables, and the report that holds them.

mod draw;
mod figure;
mod page;
mod report;
mod table;
mod text;

pub use figure::{Axis, Curve, Figure, Marker, Panel, Shape};
pub use report::{Block, Report, ReportError, Section, Written};
pub use table::{Column, Table};
