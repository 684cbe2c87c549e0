//! `reproduce`: what a program may do of its own, and does without a command.

use std::path::PathBuf;

use clap::Args;

use crate::app::failure::Failure;
use crate::app::interrupt::{Work, growing};
use crate::app::offer::{App, Reproduction};
use crate::app::output::prepare;
use crate::app::words::place;

/// Its name on the command line.
pub(in crate::app) const NAME: &str = "reproduce";

#[derive(Debug, Clone, Args)]
pub(in crate::app) struct Report {
    /// Write files to this folder, long tables row by row
    #[arg(long, value_name = "DIR", default_value = "report")]
    out: PathBuf,
    /// Show no progress and no notes
    #[arg(long)]
    quiet: bool,
}

/// Reproduce all tables and figures; also what happens without a command
#[derive(Debug, Clone, Args)]
pub(in crate::app) struct Arguments {
    /// Only this part of it
    part: Option<String>,
    #[command(flatten)]
    report: Report,
}

impl From<Report> for Arguments {
    fn from(report: Report) -> Self {
        Self { part: None, report }
    }
}

pub(in crate::app) fn perform(app: &App, arguments: &Arguments) -> Result<(), Failure> {
    let reproduction = match &arguments.part {
        Some(name) => part(app, name)?,
        None => app.reproduction.ok_or_else(|| {
            Failure::usage("there is no report that this program could reproduce".to_owned())
        })?,
    };
    let folder = &arguments.report.out;
    prepare(folder)?;
    growing().push(folder.join("index.html"));
    let _work = Work::begin(String::new());
    reproduction(folder, arguments.report.quiet).map_err(|error| Failure::failed(error.to_string()))
}

/// The part of this name.
fn part(app: &App, name: &str) -> Result<Reproduction, Failure> {
    let names: Vec<&str> = app.parts.iter().map(|(known, _)| *known).collect();
    let what = "there is nothing to reproduce by the name";
    Ok(app.parts[place(what, name, &names)?].1)
}

#[cfg(test)]
mod tests {
    use std::error::Error;
    use std::path::Path;

    use super::*;

    fn leave_a_mark(folder: &Path, quiet: bool) -> Result<(), Box<dyn Error>> {
        std::fs::write(folder.join("mark"), format!("{quiet}"))?;
        if quiet {
            Ok(())
        } else {
            Err("not quiet".into())
        }
    }

    fn leave_another(folder: &Path, _: bool) -> Result<(), Box<dyn Error>> {
        Ok(std::fs::write(folder.join("mark"), "a part")?)
    }

    #[test]
    fn happens_with_and_without_its_name() {
        let folder = std::env::temp_dir().join(format!("stickslip-{}", std::process::id()));
        let place = folder.to_string_lossy().into_owned();
        let ask = |words: &[&str]| {
            let app = App::new("0").reproduce(leave_a_mark);
            let app = app.reproduce_part("one", leave_another);
            app.answer(words.iter().map(Into::into).collect())
        };
        for (name, mark) in [
            (&["program"][..], "true"),
            (&["program", "reproduce"], "true"),
            (&["program", "reproduce", "one"], "a part"),
        ] {
            let words = [name, &["--out", &place, "--quiet"]].concat();
            assert_eq!(ask(&words), Ok(()));
            let found = std::fs::read_to_string(folder.join("mark")).unwrap();
            assert_eq!(found, mark);
            std::fs::remove_file(folder.join("mark")).unwrap();
        }
        assert_eq!(
            ask(&["program", "--out", &place]),
            Err(Failure::failed("not quiet"))
        );
        let failure = ask(&["program", "reproduce", "two"]).unwrap_err();
        assert_eq!(failure.code(), 2);
        std::fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn without_it_a_command_is_needed() {
        let failure = App::new("0").answer(vec!["program".into()]).unwrap_err();
        assert_eq!(failure.code(), 2);
    }
}
