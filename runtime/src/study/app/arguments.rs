//! The commands and options that there are.

use std::ffi::OsString;
use std::path::Path;

use clap::{Arg, ArgAction, Command};

use super::App;

/// The command line of a program.
pub(super) fn command(app: &App, called: Option<&OsString>) -> Command {
    let name = called
        .and_then(|path| Path::new(path).file_stem())
        .map_or_else(
            || "stickslip".to_owned(),
            |stem| stem.to_string_lossy().into_owned(),
        );
    let mut command = Command::new(name)
        .version(app.version)
        .about("Periodic motions of systems with dry friction, exact or smoothed")
        .subcommand(models())
        .subcommand(simulate())
        .subcommand(orbit())
        .subcommand(branch())
        .subcommand(trade())
        .subcommand(equilibria());
    if app.reproduction.is_some() {
        command = command.args(to_reproduce()).subcommand(
            Command::new("reproduce")
                .about(REPRODUCE)
                .args(to_reproduce()),
        );
    }
    command
}

const REPRODUCE: &str = "Reproduce all tables and figures; also what happens without a command";

fn to_reproduce() -> [Arg; 2] {
    [out().default_value("report"), quiet()]
}

fn models() -> Command {
    Command::new("models")
        .about("Show the models, or all that is declared of one")
        .arg(word("MODEL", "Which one"))
        .args([json(), quiet()])
}

fn simulate() -> Command {
    Command::new("simulate")
        .about("Follow one motion from its start")
        .args(shared())
        .arg(valued("time", "T", "How long").default_value("100"))
}

fn orbit() -> Command {
    Command::new("orbit")
        .about("Find a periodic orbit and judge its stability")
        .args(shared())
        .arg(period())
}

fn branch() -> Command {
    Command::new("branch")
        .about("Follow a periodic orbit along a parameter, or along the size of the smoothing")
        .args(shared())
        .arg(period())
        .arg(along())
}

fn equilibria() -> Command {
    Command::new("equilibria")
        .about("List equilibria with their eigenvalues; with --along, follow one and find its Hopf points and folds")
        .args(shared())
        .arg(along())
}

fn along() -> Arg {
    valued(
        "along",
        "NAME=A..B",
        "What to follow, from A to B; `smooth=A..B` follows the smoothing",
    )
}

fn trade() -> Command {
    Command::new("trade")
        .about("Measure what each smoothing gets wrong, and what it costs, against the exact system")
        .after_help(
            "--smooth restricts this to one copy; with --accuracy the cheapest settings that meet it are sought",
        )
        .args(shared())
        .arg(period())
        .arg(valued(
            "along",
            "NAME=A..B",
            "A parameter, to be judged at both A and B: the worst end counts",
        ))
}

fn shared() -> [Arg; 9] {
    [
        word("MODEL", "A model, as `models` names it"),
        valued(
            "set",
            "NAME=VALUE",
            "Set a parameter; may be given several times",
        )
        .action(ArgAction::Append),
        flag("exact", "Friction by its set-valued law: the default"),
        valued(
            "smooth",
            "KERNEL:SIZE",
            "Friction by a smooth copy, for instance arctan:1e5",
        ),
        valued(
            "start",
            "NAME=VALUE,...",
            "Where to start; states left out keep their declared start",
        ),
        valued("accuracy", "REL", "Relative accuracy of period and extrema").default_value("1e-9"),
        out(),
        json(),
        quiet(),
    ]
}

fn period() -> Arg {
    valued(
        "period",
        "T",
        "A guess of the period; with --start, Newton begins at once",
    )
}

fn out() -> Arg {
    valued("out", "DIR", "Write files to this folder")
        .value_parser(clap::value_parser!(std::path::PathBuf))
}

fn json() -> Arg {
    flag("json", "Print one JSON document and nothing else")
}

fn quiet() -> Arg {
    flag("quiet", "Show no progress and no notes")
}

fn word(name: &'static str, help: &'static str) -> Arg {
    Arg::new(name).value_name(name).help(help)
}

fn flag(name: &'static str, help: &'static str) -> Arg {
    Arg::new(name)
        .long(name)
        .help(help)
        .action(ArgAction::SetTrue)
}

/// An option with one value, which may begin with a minus sign: a wrong number shall be named as such.
fn valued(name: &'static str, value: &'static str, help: &'static str) -> Arg {
    Arg::new(name)
        .long(name)
        .value_name(value)
        .help(help)
        .allow_hyphen_values(true)
}
