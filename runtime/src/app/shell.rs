//! What shells and readers of manuals need of a program: completions, man pages, and the form of its documents.

use std::path::PathBuf;

use clap::{Arg, ArgAction, ArgMatches, Command, value_parser};
use clap_complete::Shell;

use super::failure::Failure;
use super::output::prepare;
use super::print::print;

/// Names of hidden commands.
pub(super) const COMPLETIONS: &str = "completions";
pub(super) const MANUAL: &str = "manual";
/// The option for the form of documents.
const SCHEMA: &str = "json-schema";
const FORM: &str = include_str!("schema.json");

/// The same program with these commands, which its help does not list.
pub(super) fn hidden(command: Command) -> Command {
    let shell = Arg::new("shell")
        .required(true)
        .value_parser(value_parser!(Shell));
    let folder = Arg::new("folder")
        .required(true)
        .value_parser(value_parser!(PathBuf));
    let schema = Arg::new(SCHEMA)
        .long(SCHEMA)
        .action(ArgAction::SetTrue)
        .help("Print the JSON schema of all documents that --json prints");
    command
        .arg(schema)
        .subcommand(
            Command::new(COMPLETIONS)
                .about("Print completions for a shell")
                .hide(true)
                .arg(shell),
        )
        .subcommand(
            Command::new(MANUAL)
                .about("Write man pages to a folder")
                .hide(true)
                .arg(folder),
        )
}

/// Prints the form of documents if that is asked.
pub(super) fn form(matches: &ArgMatches) -> Option<Result<(), Failure>> {
    let asked = matches.get_flag(SCHEMA);
    asked.then(|| print(FORM))
}

/// Completions for the shell that is named.
pub(super) fn completions(mut command: Command, matches: &ArgMatches) -> Result<(), Failure> {
    let Some(shell) = matches.get_one::<Shell>("shell") else {
        return Err(Failure::usage("no shell is named"));
    };
    let (name, mut text) = (command.get_name().to_owned(), Vec::new());
    clap_complete::generate(*shell, &mut command, name, &mut text);
    print(&String::from_utf8_lossy(&text))
}

/// Man pages of the program and of each of its commands.
pub(super) fn manual(command: Command, matches: &ArgMatches) -> Result<(), Failure> {
    let Some(folder) = matches.get_one::<PathBuf>("folder") else {
        return Err(Failure::usage("no folder is named"));
    };
    prepare(folder)?;
    clap_mangen::generate_to(command, folder)
        .map_err(|error| Failure::failed(format!("the manual cannot be written: {error}")))
}
