//! The thesis's results again, with smoothed friction as it had it and with exact friction: what is drawn and said.
//!
//! The words stand in the `.md` file beside each section, the curves, rows and values that fill their places here.

mod ask;
mod atlas;
mod belt_oscillator;
mod belt_pair;
mod branch;
mod copies;
mod drill_string;
mod equilibrium;
mod errors;
pub mod extremes;
mod pieces;
mod smoothing;
mod van_der_pol;

use std::fmt;
use std::path::Path;
use std::time::{Duration, Instant};

use stickslip::report::numerals::duration;
use stickslip::report::{Manuscript, Report, ReportError, Section, Written};
use stickslip::study::StudyError;

/// What was reproduced.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Summary {
    /// The files.
    pub written: Written,
    /// Branches followed.
    pub branches: usize,
    /// Time taken by everything.
    pub time: Duration,
}

/// Why the report could not be made.
#[derive(Debug, thiserror::Error)]
pub enum ReproduceError {
    /// An answer is missing.
    #[error("{what}: {source}")]
    Missing {
        /// Which.
        what: String,
        /// Why.
        source: Box<StudyError>,
    },
    /// A file could not be written.
    #[error(transparent)]
    Report(#[from] ReportError),
}

/// What of the report is made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// Everything.
    Whole,
    /// Everything but what can be had alone, and takes most of the time.
    Rest,
    /// The branches of the belt pair.
    Atlas,
    /// The map of the extremes.
    Extremes,
}

/// What is counted on the way.
#[derive(Default)]
struct Ledger {
    /// Rows of the table of costs, one for each branch.
    costs: Vec<Vec<String>>,
    branches: usize,
}

/// A section: what is said while it is made, if anything is, the part that it is alone, and how it is made.
struct Chapter(
    &'static str,
    Option<Part>,
    fn(&mut Ledger) -> Result<Section, ReproduceError>,
);

const CHAPTERS: [Chapter; 9] = [
    Chapter("", None, |_| {
        Ok(Manuscript::new(include_str!("introduction.md")).section()?)
    }),
    Chapter("Van der Pol oscillator", None, |ledger| {
        van_der_pol::section(&mut ledger.costs)
    }),
    Chapter("Mass on a belt", None, |ledger| {
        belt_oscillator::section(&mut ledger.costs)
    }),
    Chapter("Two masses on a belt", None, |_| belt_pair::section()),
    Chapter(
        "The branches of two masses on a belt",
        Some(Part::Atlas),
        |ledger| {
            let (section, branches) = atlas::section()?;
            ledger.branches += branches;
            Ok(section)
        },
    ),
    Chapter("Drill string", None, |ledger| {
        drill_string::section(&mut ledger.costs)
    }),
    Chapter("What smoothing costs", None, |_| smoothing::section()),
    Chapter("The extremes", Some(Part::Extremes), |_| {
        Ok(extremes::section(&extremes::map())?)
    }),
    Chapter("", None, |ledger| {
        ledger.branches += ledger.costs.len();
        let manuscript = Manuscript::new(include_str!("cost.md"));
        Ok(manuscript
            .rows("cost", std::mem::take(&mut ledger.costs))
            .section()?)
    }),
];

impl Part {
    fn holds(self, alone: Option<Self>) -> bool {
        match self {
            Self::Whole => true,
            Self::Rest => alone.is_none(),
            part => alone == Some(part),
        }
    }

    const fn titles(self) -> [&'static str; 2] {
        match self {
            Self::Whole | Self::Rest => [
                "Stick-slip vibrations, thirty years later",
                "The periodic motions of B. L. van de Vrande's *Modeling Dry Friction in DIANA* (Eindhoven, 1996), \
                 computed again from declared models",
            ],
            Self::Atlas => [
                "Two masses on a belt: all branches",
                "The bifurcations of section 3.3.2 of B. L. van de Vrande's *Modeling Dry Friction in DIANA* \
                 (Eindhoven, 1996), smoothed and exact",
            ],
            Self::Extremes => [
                "At the extremes",
                "How far answers keep their digits, and what stops them",
            ],
        }
    }

    /// The report in the folder `out`, still without sections.
    fn begin(self, out: &Path) -> Result<Report, ReportError> {
        let [title, subtitle] = self.titles();
        Report::begin(title, subtitle, out)
    }
}

/// Computes a part of the report and writes `index.html`, `figures/` and `data/` into the folder `out`.
///
/// Says on standard error what it is at, unless `quiet`.
///
/// # Errors
/// An orbit cannot be found or followed, or a file cannot be written.
pub fn reproduce(part: Part, out: &Path, quiet: bool) -> Result<Summary, ReproduceError> {
    let clock = Instant::now();
    let mut ledger = Ledger::default();
    // Written section by section: what is finished stays, whatever ends the program.
    let mut report = part.begin(out)?;
    for Chapter(said, alone, section) in CHAPTERS {
        if part.holds(alone) {
            if !quiet && !said.is_empty() {
                eprintln!("{said} ...");
            }
            report.add(section(&mut ledger)?)?;
        }
    }
    Ok(Summary {
        written: report.written(),
        branches: ledger.branches,
        time: clock.elapsed(),
    })
}

impl fmt::Display for Summary {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            written,
            branches,
            time,
        } = self;
        if *branches > 0 {
            writeln!(
                f,
                "{branches} branches followed, {} figures drawn, {} data files written in {}",
                written.figures,
                written.data,
                duration(*time)
            )?;
        }
        write!(f, "open {} in a browser", written.page.display())
    }
}
