//! The program `stickslip`.

use std::error::Error;
use std::path::Path;
use std::process::ExitCode;

use stickslip::app::App;
use stickslip_models::friction::{library, with_memory};
use stickslip_models::reproduce::{Part, reproduce};
use stickslip_models::{press, systems};

fn main() -> ExitCode {
    App::new(env!("CARGO_PKG_VERSION"))
        .offer(systems::van_der_pol())
        .offer(systems::belt_oscillator())
        .offer(systems::belt_pair())
        .offer(systems::drill_string())
        .offer(systems::bristle_oscillator())
        .offer(systems::forced_belt())
        .laws(library())
        .laws(with_memory())
        .laws(press::library())
        .reproduce(|folder, quiet| report(Part::Whole, folder, quiet))
        .reproduce_part("atlas", |folder, quiet| report(Part::Atlas, folder, quiet))
        .reproduce_part("extremes", |folder, quiet| {
            report(Part::Extremes, folder, quiet)
        })
        .run()
}

fn report(part: Part, folder: &Path, quiet: bool) -> Result<(), Box<dyn Error>> {
    let summary = reproduce(part, folder, quiet)?;
    if !quiet {
        println!("{summary}");
    }
    Ok(())
}
