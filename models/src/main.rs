//! The program `stickslip`.

use std::error::Error;
use std::fmt::Display;
use std::path::Path;
use std::process::ExitCode;

use stickslip::app::App;
use stickslip::study::System;
use stickslip_models::friction::{library, with_memory};
use stickslip_models::reproduce::{extremes, reproduce, reproduce_atlas};
use stickslip_models::{
    BeltOscillator, BeltPair, BristleOscillator, DrillString, ForcedBelt, VanDerPol,
};

fn main() -> ExitCode {
    App::new(env!("CARGO_PKG_VERSION"))
        .offer(System::of::<VanDerPol, _>())
        .offer(System::of::<BeltOscillator, _>())
        .offer(System::of::<BeltPair, _>())
        .offer(System::of::<DrillString, _>())
        .offer(System::of::<BristleOscillator, _>())
        .offer(System::of::<ForcedBelt, _>())
        .laws(library())
        .laws(with_memory())
        .reproduce(report)
        .reproduce_part("atlas", the_atlas)
        .reproduce_part("extremes", the_extremes)
        .run()
}

fn report(folder: &Path, quiet: bool) -> Result<(), Box<dyn Error>> {
    tell(&reproduce(folder, quiet)?, quiet)
}

fn the_atlas(folder: &Path, quiet: bool) -> Result<(), Box<dyn Error>> {
    tell(&reproduce_atlas(folder, quiet)?, quiet)
}

fn the_extremes(folder: &Path, quiet: bool) -> Result<(), Box<dyn Error>> {
    tell(&extremes::reproduce(folder)?, quiet)
}

fn tell(summary: &impl Display, quiet: bool) -> Result<(), Box<dyn Error>> {
    if !quiet {
        println!("{summary}");
    }
    Ok(())
}
