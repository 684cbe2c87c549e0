//! The commands that there are.

use std::ffi::OsString;
use std::path::Path;

use clap::{ArgMatches, Args, Command, FromArgMatches, Subcommand};

#[cfg(feature = "reduce")]
use super::commands::reduce;
use super::commands::{
    attractors, branch, curve, diagram, equilibria, laws, map, merge, models, needs, orbit,
    reproduce, simulate, status, trade,
};
use super::failure::Failure;
use super::offer::App;
use super::{question, shell, usage};

/// A command that every program has.
#[derive(Debug, Subcommand)]
enum Study {
    Models(models::Arguments),
    Laws(laws::Arguments),
    Simulate(simulate::Arguments),
    Orbit(orbit::Arguments),
    Branch(branch::Arguments),
    Trade(trade::Arguments),
    Needs(needs::Arguments),
    Equilibria(equilibria::Arguments),
    Diagram(diagram::Arguments),
    Attractors(attractors::Arguments),
    Map(map::Arguments),
    Merge(merge::Arguments),
    Status(status::Arguments),
    #[cfg(feature = "reduce")]
    Reduce(reduce::Arguments),
}

/// The command line of a program.
pub(super) fn command(app: &App, called: Option<&OsString>) -> Command {
    let name = called
        .and_then(|path| Path::new(path).file_stem())
        .map_or_else(
            || "stickslip".to_owned(),
            |stem| stem.to_string_lossy().into_owned(),
        );
    let mut command = Study::augment_subcommands(Command::new(name))
        .subcommand_required(false)
        .arg_required_else_help(false)
        .version(app.version)
        .about("Periodic motions of systems with dry friction, exact or smoothed");
    if app.reproduction.is_some() {
        let named = reproduce::Arguments::augment_args(Command::new(reproduce::NAME))
            .mut_arg("part", |part| part.hide(app.parts.is_empty()));
        command = reproduce::Report::augment_args(command).subcommand(named);
    }
    // A wrong number may begin with a minus sign, and shall be named as such.
    let valued = |arg: clap::Arg| match arg.get_long() {
        Some(_) if arg.get_action().takes_values() => arg.allow_hyphen_values(true),
        _ => arg,
    };
    let command = command
        .mut_args(valued)
        .mut_subcommands(|one| one.mut_args(valued));
    shell::hidden(command)
}

/// Does what the command line says.
pub(super) fn perform(
    app: &App,
    called: Option<&OsString>,
    matches: &ArgMatches,
) -> Result<(), Failure> {
    if let Some(done) = shell::form(matches) {
        return done;
    }
    match matches.subcommand() {
        Some((shell::COMPLETIONS, options)) => shell::completions(command(app, called), options),
        Some((shell::MANUAL, options)) => shell::manual(command(app, called), options),
        Some((reproduce::NAME, options)) => reproduce::perform(app, &read(options)?),
        Some(_) => study(app, read(matches)?),
        None if app.reproduction.is_none() => {
            Err(Failure::usage(usage::which_command(&command(app, None))))
        }
        None => reproduce::perform(app, &read::<reproduce::Report>(matches)?.into()),
    }
}

/// Does what other words of a command line say.
pub(super) fn again(app: &App, words: &[OsString]) -> Result<(), Failure> {
    question::ask(words);
    let command = command(app, words.first());
    match command.clone().try_get_matches_from(words) {
        Ok(matches) => perform(app, words.first(), &matches),
        Err(error) => usage::explain(&error, &command, words),
    }
}

fn read<A: FromArgMatches>(matches: &ArgMatches) -> Result<A, Failure> {
    A::from_arg_matches(matches).map_err(|error| Failure::usage(error.to_string()))
}

fn study(app: &App, study: Study) -> Result<(), Failure> {
    match study {
        Study::Models(arguments) => models::perform(app, &arguments),
        Study::Laws(arguments) => laws::perform(app, &arguments),
        Study::Simulate(arguments) => simulate::perform(app, &arguments),
        Study::Orbit(arguments) => orbit::perform(app, &arguments),
        Study::Branch(arguments) => {
            arguments.range()?;
            match curve::wanted(&arguments)? {
                Some(and) => curve::perform(app, &arguments, and),
                None => branch::perform(app, &arguments),
            }
        }
        Study::Trade(arguments) => trade::perform(app, &arguments),
        Study::Needs(arguments) => needs::perform(app, &arguments),
        Study::Equilibria(arguments) => match curve::wanted_of_equilibria(&arguments)? {
            Some(and) => curve::of_equilibria(app, &arguments, and),
            None => equilibria::perform(app, &arguments),
        },
        Study::Diagram(arguments) => diagram::perform(app, &arguments),
        Study::Attractors(arguments) => attractors::perform(app, &arguments),
        Study::Map(arguments) => map::perform(app, &arguments),
        Study::Merge(arguments) => again(app, &merge::words(&arguments)?),
        Study::Status(arguments) => status::perform(app, &arguments),
        #[cfg(feature = "reduce")]
        Study::Reduce(arguments) => reduce::perform(app, &arguments),
    }
}
