//! The thesis's results again, with smoothed friction as it had it and with exact friction: what is drawn and said.

mod ask;
mod atlas;
mod belt_oscillator;
mod belt_pair;
mod branch;
mod copies;
mod cost;
mod drill_string;
mod equilibrium;
mod errors;
pub mod extremes;
mod pieces;
mod smoothing;
mod van_der_pol;
mod words;

use std::fmt;
use std::path::Path;
use std::time::{Duration, Instant};

use stickslip::report::{Edition, Manuscript, Report, ReportError, Written};
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
        source: StudyError,
    },
    /// A file could not be written.
    #[error(transparent)]
    Report(#[from] ReportError),
}

/// Follows the branches of the belt pair and writes only what shows them into the folder `out`.
///
/// # Errors
/// A branch cannot be begun, or a file cannot be written.
pub fn reproduce_atlas(out: &Path, quiet: bool) -> Result<Summary, ReproduceError> {
    let clock = Instant::now();
    if !quiet {
        eprintln!("The branches of two masses on a belt ...");
    }
    let (section, branches) = atlas::section()?;
    let report = Report {
        title: "Two masses on a belt: all branches".to_owned(),
        subtitle: "The bifurcations of section 3.3.2 of B. L. van de Vrande's *Modeling Dry Friction in DIANA* \
                   (Eindhoven, 1996), smoothed and exact"
            .to_owned(),
        sections: vec![section],
    };
    let written = report.write(out)?;
    Ok(Summary {
        written,
        branches,
        time: clock.elapsed(),
    })
}

/// Computes everything and writes `index.html`, `figures/` and `data/` into the folder `out`.
///
/// Says on standard error what it is at, unless `quiet`.
///
/// # Errors
/// An orbit cannot be found or followed, or a file cannot be written.
pub fn reproduce(out: &Path, quiet: bool) -> Result<Summary, ReproduceError> {
    write(out, quiet, true)
}

/// The same without what can be had alone, and takes most of the time: the branches of the belt pair ([`reproduce_atlas`])
/// and the map of the extremes ([`extremes::reproduce`]).
///
/// # Errors
/// See [`reproduce`].
pub fn reproduce_the_rest(out: &Path, quiet: bool) -> Result<Summary, ReproduceError> {
    write(out, quiet, false)
}

fn write(out: &Path, quiet: bool, whole: bool) -> Result<Summary, ReproduceError> {
    let clock = Instant::now();
    let say = |what: &str| {
        if !quiet {
            eprintln!("{what} ...");
        }
    };
    let report = Report {
        title: "Stick-slip vibrations, thirty years later".to_owned(),
        subtitle: "The periodic motions of B. L. van de Vrande's *Modeling Dry Friction in DIANA* (Eindhoven, 1996), \
                   computed again from declared models"
            .to_owned(),
        sections: vec![Manuscript::new(include_str!("introduction.md")).section()?],
    };
    // Written section by section: what is finished stays, whatever ends the program.
    let mut edition = Edition::begin(report, out)?;
    let mut costs = Vec::new();
    let mut branches = 0;
    say("Van der Pol oscillator");
    edition.add(van_der_pol::section(&mut costs)?)?;
    say("Mass on a belt");
    edition.add(belt_oscillator::section(&mut costs)?)?;
    say("Two masses on a belt");
    edition.add(belt_pair::section()?)?;
    if whole {
        say("The branches of two masses on a belt");
        let (atlas, followed) = atlas::section()?;
        edition.add(atlas)?;
        branches += followed;
    }
    say("Drill string");
    edition.add(drill_string::section(&mut costs)?)?;
    say("What smoothing costs");
    edition.add(smoothing::section()?)?;
    if whole {
        say("The extremes");
        edition.add(extremes::section(&extremes::map())?)?;
    }
    branches += costs.len();
    edition.add(cost::section(costs)?)?;
    let written = edition.written();
    Ok(Summary {
        written,
        branches,
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
        writeln!(
            f,
            "{branches} branches followed, {} figures drawn, {} data files written in {}",
            written.figures,
            written.data,
            words::duration(*time)
        )?;
        write!(f, "open {} in a browser", written.page.display())
    }
}
