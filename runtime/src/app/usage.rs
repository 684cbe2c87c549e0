//! What is wrong with words that clap refuses, said as everything else here is said.

use std::ffi::OsString;

use clap::error::{ContextKind, ContextValue, ErrorKind};
use clap::{Command, Error};

use super::failure::Failure;
use super::print::print;
use super::text::fitted;
use super::words::unknown;

/// Turns a refusal into a message; a request for help or the version is answered.
pub(super) fn explain(error: &Error, command: &Command, words: &[OsString]) -> Result<(), Failure> {
    let named = |kind| context(error, kind);
    let option = named(ContextKind::InvalidArg);
    let bare = option.split_whitespace().next().unwrap_or_default();
    Err(Failure::usage(match error.kind() {
        ErrorKind::DisplayHelp | ErrorKind::DisplayVersion => {
            return print(&fitted(&error.to_string()));
        }
        ErrorKind::InvalidSubcommand => no_command(&named(ContextKind::InvalidSubcommand), command),
        ErrorKind::UnknownArgument if bare.starts_with('-') => no_option(bare, command, words),
        ErrorKind::UnknownArgument => stray(&option, command, words),
        ErrorKind::InvalidValue if named(ContextKind::InvalidValue).is_empty() => {
            format!("`{bare}` needs a value: write `{option}`")
        }
        ErrorKind::ArgumentConflict => format!("`{bare}` is given more than once"),
        ErrorKind::TooManyValues => {
            format!(
                "`{bare}` takes no value `{}`",
                named(ContextKind::InvalidValue)
            )
        }
        ErrorKind::ValueValidation => named(ContextKind::Custom),
        ErrorKind::InvalidUtf8 => "an argument is no text: it is not valid UTF-8".to_owned(),
        _ => plain(error),
    }))
}

fn context(error: &Error, kind: ContextKind) -> String {
    match error.get(kind) {
        Some(ContextValue::String(text)) => text.clone(),
        Some(ContextValue::Strings(texts)) => texts.join(", "),
        _ => String::new(),
    }
}

/// The first line of clap's own message.
fn plain(error: &Error) -> String {
    let text = error.to_string();
    let line = text.lines().next().unwrap_or_default();
    line.trim_start_matches("error: ").to_owned()
}

fn commands(command: &Command) -> Vec<&str> {
    let shown = command.get_subcommands().filter(|one| !one.is_hide_set());
    shown.map(Command::get_name).collect()
}

fn no_command(word: &str, command: &Command) -> String {
    unknown("there is no command", word, &commands(command))
}

/// Says that a command is missing.
pub(super) fn which_command(command: &Command) -> String {
    format!(
        "no command is given: there are {}; `--help` shows more",
        commands(command).join(", ")
    )
}

/// The command that the words call.
fn called<'a>(command: &'a Command, words: &[OsString]) -> &'a Command {
    let mut texts = words.iter().skip(1).filter_map(|word| word.to_str());
    texts
        .find_map(|word| command.find_subcommand(word))
        .unwrap_or(command)
}

fn options(command: &Command) -> Vec<String> {
    let long = command.get_arguments().filter_map(clap::Arg::get_long);
    long.chain(["help"])
        .map(|name| format!("--{name}"))
        .collect()
}

fn no_option(word: &str, command: &Command, words: &[OsString]) -> String {
    let here = called(command, words);
    if options(here).iter().any(|option| option == word) {
        return format!("`{word}` stands after `--`, where only a model can stand");
    }
    let elsewhere = command
        .get_subcommands()
        .find(|other| options(other).iter().any(|option| option == word));
    if let Some(other) = elsewhere {
        let other = other.get_name();
        return if std::ptr::eq(here, command) {
            format!("`{word}` belongs after a command that knows it, such as `{other}`")
        } else {
            format!(
                "`{word}` is an option of `{other}`, not of `{}`",
                here.get_name()
            )
        };
    }
    let names = options(here);
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    unknown(
        &format!("`{}` has no option", here.get_name()),
        word,
        &names,
    )
}

fn stray(word: &str, command: &Command, words: &[OsString]) -> String {
    let here = called(command, words).get_name();
    format!(
        "`{word}` is one word too many: `{here}` takes one model, and its options begin with `--`"
    )
}
