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
        .subcommand(laws())
        .subcommand(simulate())
        .subcommand(orbit())
        .subcommand(branch())
        .subcommand(trade())
        .subcommand(equilibria())
        .subcommand(diagram());
    if app.reproduction.is_some() {
        command = command.args(to_reproduce()).subcommand(
            Command::new("reproduce")
                .about(REPRODUCE)
                .arg(word("PART", "Only this part of it").hide(app.parts.is_empty()))
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

fn laws() -> Command {
    Command::new("laws")
        .about("Show friction laws: their formulas, and force against sliding speed")
        .after_help(
            "Of a model, the laws of its contacts are shown at its parameters and its start",
        )
        .arg(word("LAW", "A law or a model; all laws without it"))
        .args([
            setting(),
            valued(
                "smooth",
                "KERNEL:SIZE",
                "The copy beside it, for instance tanh:50",
            ),
            valued(
                "speed",
                "V",
                "The largest sliding speed, or that of a swing",
            ),
            valued(
                "amplitude",
                "X",
                "Of a swing that shows what a law remembers",
            ),
            out(),
            json(),
            quiet(),
        ])
}

fn simulate() -> Command {
    Command::new("simulate")
        .about("Follow one motion from its start")
        .args(shared())
        .arg(valued("time", "T", "How long").default_value("100"))
        .arg(section())
}

fn orbit() -> Command {
    Command::new("orbit")
        .about("Find a periodic orbit and judge its stability")
        .after_help(
            "A certificate says within which radius of the start a true orbit begins; the orbit is printed without one, \
             too, and the exit code is 1 then",
        )
        .args(shared())
        .arg(period())
        .arg(section())
        .arg(flag(
            "certify",
            "How near a true orbit is, by Newton and Kantorovich: a posteriori, not rigorous",
        ))
}

fn branch() -> Command {
    Command::new("branch")
        .about("Follow a periodic orbit along a parameter, or along the size of the smoothing")
        .args(shared())
        .arg(period())
        .arg(along())
        .arg(valued(
            "from",
            "VALUE",
            "Begin at this value between A and B and follow both ways, or begin at the equilibrium's first `hopf` point",
        ))
        .arg(valued(
            "switch",
            "WHERE",
            "Follow the branches that leave it, too: at flips, branch-points, or all",
        ))
        .arg(valued(
            "depth",
            "N",
            "How many switches deep: 1 without --depth",
        ))
        .arg(valued(
            "and",
            "NAME=C..D",
            "Follow a fold, flip, torus or grazing point of the branch in this parameter too, from C to D",
        ))
        .arg(valued(
            "of",
            "LABEL",
            "Which one, for instance PD1; the first without --of",
        ))
        .arg(resume())
}

fn equilibria() -> Command {
    Command::new("equilibria")
        .about("List equilibria with their eigenvalues; with --along, follow one and find its Hopf points and folds")
        .after_help(
            "With --certify, those that cannot be proven are listed with the reason, and the exit code is 1 then",
        )
        .args(shared())
        .arg(along())
        .arg(flag(
            "certify",
            "Prove each with interval arithmetic: a box that holds one equilibrium, and only one",
        ))
        .arg(resume().hide(true))
}

fn diagram() -> Command {
    Command::new("diagram")
        .about("Draw a Poincaré diagram: let the motion settle at many values of a parameter, and note where it meets a section")
        .after_help(
            "A sweep begins each value where the one before ended, and so stays with its attractor; \
             `--sweep fresh` begins each at the start. Nothing depends on the number of threads",
        )
        .args(shared())
        .arg(along())
        .arg(section())
        .arg(valued("sweep", "WAY", "`up`, `down`, `both` or `fresh`").default_value("both"))
        .arg(valued("values", "N", "How many values of the parameter").default_value("200"))
        .arg(valued("settle", "N", "Points left out while the motion settles").default_value("300"))
        .arg(valued("points", "N", "Points noted at each value").default_value("64"))
        .arg(valued("lyapunov", "N", "The largest Lyapunov exponent too, averaged over N laps"))
        .arg(valued("show", "NAME", "The state on the vertical axis of the drawing"))
        .arg(valued("threads", "N", "How many threads; all cores if nothing is said"))
        .arg(resume())
}

fn resume() -> Arg {
    flag(
        "resume",
        "Go on from what an interrupted run of the same command has left in --out DIR",
    )
}

fn section() -> Arg {
    valued(
        "section",
        "NAME=VALUE",
        "Points where a state has this value: `v=0.1`, `'v=0.1 down'`, `der(x)=0`; counted `up` unless `down` or `both`",
    )
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
        .arg(resume().hide(true))
}

fn shared() -> [Arg; 9] {
    [
        word("MODEL", "A model, as `models` names it"),
        setting(),
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

fn setting() -> Arg {
    valued(
        "set",
        "NAME=VALUE",
        "Set a parameter; may be given several times",
    )
    .action(ArgAction::Append)
}

fn period() -> Arg {
    valued(
        "period",
        "T",
        "A guess of the period; with --start, Newton begins at once",
    )
}

fn out() -> Arg {
    valued(
        "out",
        "DIR",
        "Write files to this folder, long tables row by row",
    )
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
