//! Sections written as text, with places for what is computed.

mod figure;
mod filling;

use std::collections::BTreeMap;

use super::{Block, Column, Curve, Page, Panel, ReportError, Section, Table};
use figure::figure;
use filling::{Filling, joined};

/// A section as it is written, and what stands in its places.
///
/// Blocks stand between blank lines. A plain block is a paragraph, and one after `# ` the heading; `$ ` begins a formula.
/// A block that begins with a line in brackets is a place, and has a caption below that line:
///
/// - `[sketch]`: a drawing;
/// - `[figure 3.2: Title]`, or `[figure 3.2, 2 abreast: Title]`: above its caption, `x: label` and `y: label` are the axes
///   of each panel whose curves are given; ` from 0 to 1` gives an axis its ends, and `, logarithmic` its scale; below
///   them `inset: 0 to 0.1, 2 to 3 at 0.6 0.1 0.9 0.4` enlarges a part, see [`super::Inset`];
/// - `[table name]`, or `[table name, folded]`: its heads stand below the caption, between bars, those of numbers after `#`;
///   below them may stand rows;
/// - `[page]`: a link to a page of its own.
///
/// Anywhere `{{name}}` is the place of a value.
#[derive(Debug, Clone)]
#[must_use]
pub struct Manuscript {
    text: String,
    fillings: BTreeMap<String, Filling>,
    faults: Vec<String>,
}

/// Between the cells of a row.
const BAR: &str = " | ";

impl Manuscript {
    /// A manuscript of which no place is filled yet.
    pub fn new(text: &str) -> Self {
        Self {
            text: text.to_owned(),
            fillings: BTreeMap::new(),
            faults: Vec::new(),
        }
    }

    /// Puts a value in its places.
    pub fn value(mut self, name: &str, value: impl AsRef<str>) -> Self {
        let place = format!("{{{{{name}}}}}");
        if !self.text.contains(&place) {
            self.faults.push(format!("it has no place {place}"));
        }
        self.text = self.text.replace(&place, value.as_ref());
        self
    }

    /// Puts a drawing, an SVG element, in its place.
    pub fn sketch(self, svg: &'static str) -> Self {
        self.fill("sketch", Filling::Sketch(svg))
    }

    /// Puts curves in the panels of the figure of this number, back to front.
    pub fn curves<const COUNT: usize>(self, number: &str, panels: [Vec<Curve>; COUNT]) -> Self {
        self.fill(&format!("figure {number}"), Filling::Curves(panels.into()))
    }

    /// Puts whole panels in the figure of this number.
    pub fn panels(self, number: &str, panels: impl IntoIterator<Item = Panel>) -> Self {
        let panels = panels.into_iter().collect();
        self.fill(&format!("figure {number}"), Filling::Panels(panels))
    }

    /// Puts more rows in the table of this name.
    pub fn rows(self, name: &str, rows: impl IntoIterator<Item = Vec<String>>) -> Self {
        let rows = rows.into_iter().collect();
        self.fill(&format!("table {name}"), Filling::Rows(rows))
    }

    /// Puts a link to a page in its place.
    pub fn page(self, page: Page) -> Self {
        self.fill("page", Filling::Page(page))
    }

    fn fill(mut self, place: &str, filling: Filling) -> Self {
        if self.fillings.insert(place.to_owned(), filling).is_some() {
            self.faults.push(format!("[{place}] is filled twice"));
        }
        self
    }

    /// The section with all that stands in its places.
    ///
    /// # Errors
    /// A place is empty, or what was given has none.
    pub fn section(mut self) -> Result<Section, ReportError> {
        let mut section = Section::default();
        let text = std::mem::take(&mut self.text);
        if let Some((_, empty)) = text.split_once("{{") {
            let name = empty.split("}}").next().unwrap_or_default();
            self.faults.push(format!("{{{{{name}}}}} has no value"));
        }
        let blocks = text.split("\n\n").map(str::trim);
        for block in blocks.filter(|block| !block.is_empty()) {
            match block.strip_prefix("# ") {
                Some(title) => title.clone_into(&mut section.title),
                None => section.blocks.extend(self.block(block)),
            }
        }
        let left = self.fillings.keys();
        let left = left.map(|place| format!("it has no [{place}]"));
        self.faults.extend(left);
        match self.faults.is_empty() {
            true => Ok(section),
            false => Err(ReportError::Manuscript {
                title: section.title,
                faults: self.faults.join("; "),
            }),
        }
    }

    fn block(&mut self, text: &str) -> Option<Block> {
        if let Some(formula) = text.strip_prefix("$ ") {
            return Some(Block::Formula(joined(formula.lines())));
        }
        let (first, rest) = text.split_once('\n').unwrap_or((text, ""));
        let place = first
            .strip_prefix('[')
            .and_then(|one| one.strip_suffix(']'));
        let Some(place) = place else {
            return Some(Block::Text(joined(text.lines())));
        };
        let name = place.split([',', ':']).next().unwrap_or_default();
        let filling = self.fillings.remove(name);
        let block = match (name.split_once(' ').unwrap_or((name, "")), filling) {
            ((_, ""), Some(Filling::Sketch(svg))) => Some(Block::Sketch(svg, joined(rest.lines()))),
            ((_, ""), Some(Filling::Page(page))) => Some(Block::Page(page)),
            (("figure", number), Some(filling)) => {
                figure(place, number, rest, filling).map(Block::Figure)
            }
            (("table", name), filling) => {
                let folded = place.ends_with(", folded");
                let table = table(name, rest, filling);
                table.map(|table| Block::Table(Table { folded, ..table }))
            }
            _ => None,
        };
        if block.is_none() {
            self.faults
                .push(format!("[{name}] is empty, or filled with something else"));
        }
        block
    }
}

/// A table of the rows that are written and those that are given, if all are as long as its head.
fn table(name: &str, text: &str, filling: Option<Filling>) -> Option<Table> {
    let head = text.lines().position(|line| line.contains(BAR))?;
    let row = |line: &str| line.split(BAR).map(str::to_owned).collect::<Vec<_>>();
    let mut rows: Vec<Vec<String>> = text.lines().skip(head + 1).map(row).collect();
    match filling {
        Some(Filling::Rows(more)) => rows.extend(more),
        None if !rows.is_empty() => (),
        _ => return None,
    }
    let heads = text.lines().nth(head)?.split(BAR);
    let columns: Vec<Column> = heads.map(column).collect();
    let whole = rows.iter().all(|row| row.len() == columns.len());
    whole.then(|| Table {
        name: name.to_owned(),
        caption: joined(text.lines().take(head)),
        columns,
        rows,
        folded: false,
    })
}

fn column(head: &str) -> Column {
    let numbers = head.strip_prefix('#');
    Column {
        head: numbers.unwrap_or(head).to_owned(),
        numeric: numbers.is_some(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "# Title\n\nTwo\nlines, {{v}}.\n\n[figure 1.2: *x*]\nx: time from 0 to 2\ny: place, logarithmic\n\
                        Caption.\n\n[table t]\nCaption.\nword | #number\na | {{v}}\n";

    fn filled() -> Manuscript {
        Manuscript::new(TEXT)
            .value("v", "5")
            .curves("1.2", [vec![]])
    }

    #[test]
    fn every_place_is_filled() {
        let section = filled()
            .rows("t", [vec!["b".to_owned(), "6".to_owned()]])
            .section()
            .unwrap();
        assert_eq!(section.title, "Title");
        let [
            Block::Text(text),
            Block::Figure(figure),
            Block::Table(table),
        ] = &section.blocks[..]
        else {
            panic!("{section:?}");
        };
        assert_eq!(text, "Two lines, 5.");
        assert_eq!(
            (figure.number.as_str(), figure.caption.as_str()),
            ("1.2", "Caption.")
        );
        let Panel { x, y, .. } = &figure.panels[0];
        assert_eq!((x.label.as_str(), x.range), ("time", Some([0.0, 2.0])));
        assert!(y.logarithmic && y.label == "place" && y.range.is_none());
        assert_eq!(table.rows, [["a", "5"], ["b", "6"]]);
        assert!(table.columns[1].numeric && table.columns[1].head == "number");
    }

    #[test]
    fn nothing_is_missing_and_nothing_left_over() {
        let fault = |manuscript: Manuscript| manuscript.section().unwrap_err().to_string();
        assert!(filled().section().is_ok());
        assert!(
            fault(Manuscript::new(TEXT).curves("1.2", [vec![]])).contains("{{v}} has no value")
        );
        assert!(fault(Manuscript::new(TEXT).value("v", "5")).contains("[figure 1.2] is empty"));
        assert!(fault(filled().value("w", "")).contains("no place {{w}}"));
        assert!(fault(filled().curves("1.3", [vec![]])).contains("no [figure 1.3]"));
        assert!(fault(filled().rows("t", [vec![]])).contains("[table t]"));
        assert!(fault(filled().curves("1.2", [])).contains("twice"));
    }
}
