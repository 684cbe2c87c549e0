//! A report that is there as far as it has come.

use std::fs;
use std::path::{Path, PathBuf};

use super::figure::Panel;
use super::page::{page, section};
use super::table::Table;
use super::{Block, Report, ReportError, Section, Written, text};
use crate::report::whole;

/// A report in a folder, to which sections are added: after each of them, the page is whole.
pub struct Edition {
    report: Report,
    out: PathBuf,
    /// The sections as they stand on the page.
    bodies: Vec<String>,
    written: Written,
}

impl Edition {
    /// Makes the folders for `report`, of which no section is written yet.
    ///
    /// # Errors
    /// A folder cannot be made.
    pub fn begin(report: Report, out: &Path) -> Result<Self, ReportError> {
        for name in ["figures", "data"] {
            let folder = out.join(name);
            fs::create_dir_all(&folder).map_err(|source| ReportError::Write {
                path: folder,
                source,
            })?;
        }
        let mut edition = Self {
            report: Report {
                sections: Vec::new(),
                ..report
            },
            out: out.to_owned(),
            bodies: Vec::new(),
            written: Written {
                page: out.join("index.html"),
                figures: 0,
                data: 0,
            },
        };
        report
            .sections
            .into_iter()
            .try_for_each(|section| edition.take(section))?;
        Ok(edition)
    }

    /// Adds a section, and writes it with its figures and its data.
    ///
    /// # Errors
    /// A file cannot be written.
    pub fn add(&mut self, section: Section) -> Result<(), ReportError> {
        self.take(section)?;
        self.save_page()
    }

    /// What was written.
    #[must_use]
    pub fn written(self) -> Written {
        self.written
    }

    pub(super) fn save_page(&self) -> Result<(), ReportError> {
        save(&self.written.page, &page(&self.report, &self.bodies))
    }

    fn take(&mut self, part: Section) -> Result<(), ReportError> {
        for block in &part.blocks {
            self.save_block(block)?;
        }
        self.bodies.push(section(self.bodies.len() + 1, &part));
        self.report.sections.push(part);
        Ok(())
    }

    fn save_block(&mut self, block: &Block) -> Result<(), ReportError> {
        let (figures, data) = (self.out.join("figures"), self.out.join("data"));
        match block {
            Block::Figure(figure) => {
                save(&figures.join(figure.name() + ".svg"), &figure.svg())?;
                for (i, panel) in figure.panels.iter().enumerate() {
                    save_panel(&data.join(figure.panel_name(i) + ".csv"), panel)?;
                    self.written.data += 1;
                }
                self.written.figures += 1;
            }
            Block::Table(table) => {
                save_table(&data.join(format!("{}.csv", table.name)), table)?;
                self.written.data += 1;
            }
            Block::Page(page) => {
                save(&self.out.join(format!("{}.html", page.name)), &page.html)?;
                let (head, rows) = page.data.clone();
                let path = data.join(format!("{}.csv", page.name));
                save_rows(&path, head, rows.into_iter())?;
                self.written.data += 1;
            }
            Block::Text(_) | Block::Formula(_) | Block::Sketch(..) => {}
        }
        Ok(())
    }
}

fn save(path: &Path, content: &str) -> Result<(), ReportError> {
    whole::write(path, content).map_err(|source| ReportError::Write {
        path: path.to_owned(),
        source,
    })
}

/// One row for each point: its curve, x and y.
fn save_panel(path: &Path, panel: &Panel) -> Result<(), ReportError> {
    let head = [
        "curve".to_owned(),
        text::plain(&panel.x.label),
        text::plain(&panel.y.label),
    ];
    let rows = panel.curves.iter().flat_map(|curve| {
        let label = text::plain(&curve.label);
        curve
            .points
            .iter()
            .map(move |[x, y]| vec![label.clone(), x.to_string(), y.to_string()])
    });
    save_rows(path, head, rows)
}

fn save_table(path: &Path, table: &Table) -> Result<(), ReportError> {
    let head = table.columns.iter().map(|column| text::plain(&column.head));
    let rows = table
        .rows
        .iter()
        .map(|row| row.iter().map(|cell| text::plain(cell)).collect());
    save_rows(path, head, rows)
}

fn save_rows(
    path: &Path,
    head: impl IntoIterator<Item = String>,
    rows: impl Iterator<Item = Vec<String>>,
) -> Result<(), ReportError> {
    let failed = |source| ReportError::Data {
        path: path.to_owned(),
        source,
    };
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(head).map_err(failed)?;
    for row in rows {
        writer.write_record(row).map_err(failed)?;
    }
    let bytes = writer
        .into_inner()
        .map_err(|error| failed(error.into_error().into()))?;
    save(path, &String::from_utf8_lossy(&bytes))
}
