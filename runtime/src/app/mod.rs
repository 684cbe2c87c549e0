//! The program that `stickslip::app!` makes of declared models.

mod arguments;
mod chart;
mod command;
mod commands;
mod document;
mod failure;
mod interrupt;
mod journal;
mod output;
mod passages;
mod progress;
mod request;
mod resume;
mod section;
mod spreadsheet;
mod text;
mod trail;
mod usage;
mod values;
mod words;

use std::ffi::OsString;
use std::process::ExitCode;

use crate::study::{Shown, System};
pub use commands::reproduce::Reproduction;
use failure::Failure;

/// Defines the `main` of a program that studies the given models: `stickslip::app!(ModelA, ModelB);`.
///
/// The laws of their contacts can be drawn; so can others, given with typical values of their parameters:
/// `stickslip::app!(ModelA, ModelB; laws Weakening { limit: 1.0, decay: 3.0 });`. A law with internal state also needs
/// the amplitude and the speed of a swing: `laws Dahl { stiffness: 1e4, level: 1.0 } swinging 5e-4 at 1e-3`.
#[macro_export]
macro_rules! app {
    (
        $($model:ty),+ $(,)?
        $(; laws $($law:ident { $($field:ident: $value:expr),* $(,)? }
            $(swinging $amplitude:literal at $speed:literal)?),+ $(,)?)?
    ) => {
        fn main() -> ::std::process::ExitCode {
            $crate::app::App::new(env!("CARGO_PKG_VERSION"))
                $(.offer($crate::study::System::of::<$model, _>()))+
                $($(.laws([$crate::specimen!(
                    $law { $($field: $value),* } $(swinging $amplitude at $speed)?
                )]))+)?
                .run()
        }
    };
}

/// A program that studies models from the command line.
pub struct App {
    version: &'static str,
    entries: Vec<System>,
    laws: Vec<Shown>,
    reproduction: Option<Reproduction>,
    parts: Vec<(&'static str, Reproduction)>,
}

/// Bytes of stack; what is not used is never touched.
const STACK: usize = 256 << 20;

impl App {
    /// A program of this version, still without models.
    #[must_use]
    pub fn new(version: &'static str) -> Self {
        Self {
            version,
            entries: Vec::new(),
            laws: Vec::new(),
            reproduction: None,
            parts: Vec::new(),
        }
    }

    /// Offers one more model.
    #[must_use]
    pub fn offer(mut self, entry: System) -> Self {
        self.entries.push(entry);
        self
    }

    /// Lists more friction laws.
    #[must_use]
    pub fn laws<L: Into<Shown>>(mut self, laws: impl IntoIterator<Item = L>) -> Self {
        self.laws.extend(laws.into_iter().map(Into::into));
        self
    }

    /// Adds the command `reproduce`, which is also what happens without a command.
    #[must_use]
    pub fn reproduce(mut self, reproduction: Reproduction) -> Self {
        self.reproduction = Some(reproduction);
        self
    }

    /// Lets `reproduce` make one part of all alone, by this name.
    #[must_use]
    pub fn reproduce_part(mut self, name: &'static str, reproduction: Reproduction) -> Self {
        self.parts.push((name, reproduction));
        self
    }

    /// Does what the arguments of the process say; 0 if all went well, 2 if they make no sense, 130 if a long command was
    /// interrupted, 1 otherwise.
    #[must_use]
    pub fn run(self) -> ExitCode {
        // A chain of a hundred masses carries matrices of 200 × 200 through each stage of a step.
        let roomy = std::thread::Builder::new().stack_size(STACK);
        std::thread::scope(|scope| {
            let worker = roomy.spawn_scoped(scope, || self.finish());
            worker.map_or_else(
                |_| self.finish(),
                |worker| worker.join().unwrap_or(ExitCode::FAILURE),
            )
        })
    }

    fn finish(&self) -> ExitCode {
        match self.answer(std::env::args_os().collect()) {
            Ok(()) => ExitCode::SUCCESS,
            Err(failure) => {
                failure.report();
                ExitCode::from(failure.code())
            }
        }
    }

    fn answer(&self, words: Vec<OsString>) -> Result<(), Failure> {
        let command = command::command(self, words.first());
        match command.clone().try_get_matches_from(&words) {
            Ok(matches) => command::perform(self, &matches),
            Err(error) => usage::explain(&error, &command, &words),
        }
    }

    /// The model of this name on the command line.
    fn entry(&self, name: &str) -> Result<&System, Failure> {
        let place = words::place("there is no model", name, &self.names())?;
        Ok(&self.entries[place])
    }

    fn names(&self) -> Vec<&'static str> {
        self.entries
            .iter()
            .map(|entry| entry.info().command)
            .collect()
    }
}
