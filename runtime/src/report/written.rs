//! A report that is there as far as it has come.

use std::path::{Path, PathBuf};
use std::{fs, io};

use super::figure::Panel;
use super::page::{page, section};
use super::whole::{self, csv};
use super::{Block, ReportError, Section, Table, data, text};

/// A report in a folder, `index.html` with `figures/*.svg`, `figures/*.pdf` and `data/*.csv`: after each section that is added, it is whole.
#[derive(Debug)]
pub struct Report {
    title: String,
    subtitle: String,
    out: PathBuf,
    sections: Vec<Section>,
    /// The sections as they stand on the page.
    bodies: Vec<String>,
    written: Written,
}

/// What was written.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Written {
    /// The page.
    pub page: PathBuf,
    /// Figures drawn.
    pub figures: usize,
    /// Files of data.
    pub data: usize,
}

impl Report {
    /// Makes the folders of a report that has no section yet; the subtitle says in a sentence what it is about.
    ///
    /// # Errors
    /// A folder cannot be made.
    pub fn begin(title: &str, subtitle: &str, out: &Path) -> Result<Self, ReportError> {
        for name in ["figures", "data"] {
            let folder = out.join(name);
            fs::create_dir_all(&folder).map_err(failed(&folder))?;
        }
        Ok(Self {
            title: title.to_owned(),
            subtitle: subtitle.to_owned(),
            out: out.to_owned(),
            sections: Vec::new(),
            bodies: Vec::new(),
            written: Written {
                page: out.join("index.html"),
                figures: 0,
                data: 0,
            },
        })
    }

    /// Adds a section, and writes it with its figures and its data.
    ///
    /// # Errors
    /// A file cannot be written.
    pub fn add(&mut self, part: Section) -> Result<(), ReportError> {
        for block in &part.blocks {
            self.save_block(block)?;
        }
        self.bodies.push(section(self.bodies.len() + 1, &part));
        self.sections.push(part);
        let page = page(&self.title, &self.subtitle, &self.sections, &self.bodies);
        save(&self.written.page, &page)
    }

    /// What was written.
    #[must_use]
    pub fn written(self) -> Written {
        self.written
    }

    fn save_block(&mut self, block: &Block) -> Result<(), ReportError> {
        let (figures, data) = (self.out.join("figures"), self.out.join("data"));
        match block {
            Block::Figure(figure) => {
                save(&figures.join(figure.name() + ".svg"), figure.svg())?;
                let path = figures.join(figure.name() + ".pdf");
                save(&path, figure.pdf().map_err(failed(&path))?)?;
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
                let (head, rows) = &page.data;
                let rows = std::iter::once(head).chain(rows);
                save_rows(&data.join(format!("{}.csv", page.name)), rows)?;
                self.written.data += 1;
            }
            Block::Text(_) | Block::Formula(_) | Block::Sketch(..) => {}
        }
        Ok(())
    }
}

fn failed(path: &Path) -> impl Fn(io::Error) -> ReportError {
    move |source| ReportError::Write {
        path: path.to_owned(),
        source,
    }
}

fn save(path: &Path, content: impl AsRef<[u8]>) -> Result<(), ReportError> {
    whole::write(path, content).map_err(failed(path))
}

/// One row for each point: its curve, if any has a name, x and y. What a corner says twice is one row.
fn save_panel(path: &Path, panel: &Panel) -> Result<(), ReportError> {
    let axes = [&panel.x, &panel.y].map(|axis| data::ascii(&text::plain(&axis.label)));
    let named = panel.curves.iter().any(|curve| !curve.label.is_empty());
    let row = |label: &str, cells: [String; 2]| {
        let label = named.then(|| label.to_owned());
        label.into_iter().chain(cells).collect::<Vec<_>>()
    };
    let rows = panel.curves.iter().flat_map(|curve| {
        let label = data::ascii(&text::plain(&curve.label));
        let mut points = curve.points.clone();
        points.dedup();
        let cells = points
            .into_iter()
            .map(|point| point.map(|value| value.to_string()));
        cells.map(|cells| row(&label, cells)).collect::<Vec<_>>()
    });
    save_rows(path, std::iter::once(row("curve", axes)).chain(rows))
}

fn save_table(path: &Path, table: &Table) -> Result<(), ReportError> {
    save_rows(path, data::rows(table).into_iter())
}

fn save_rows<R>(path: &Path, rows: impl Iterator<Item = R>) -> Result<(), ReportError>
where
    R: IntoIterator<Item: AsRef<[u8]>>,
{
    save(path, &csv(rows).map_err(failed(path))?)
}
