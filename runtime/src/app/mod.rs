//! The program that `stickslip::app!` makes of declared models.

mod answer;
mod arguments;
mod axis;
mod command;
mod commands;
mod document;
mod failure;
mod finding;
mod harmonics;
mod interrupt;
mod journal;
mod ledger;
mod offer;
mod output;
#[cfg(feature = "parquet")]
mod parquet;
mod passages;
mod print;
mod progress;
mod question;
mod request;
mod resume;
mod saved;
mod seal;
mod section;
mod shard;
mod shares;
mod shell;
mod show;
mod spreadsheet;
mod text;
mod usage;
mod values;
mod width;
mod words;

use std::ffi::OsString;
use std::process::ExitCode;

use failure::Failure;
pub use offer::{App, Reproduction};

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

/// Bytes of stack; what is not used is never touched.
const STACK: usize = 256 << 20;

impl App {
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
        command::again(self, &words)
    }
}
