//! The program `stickslip`.

use std::error::Error;
use std::path::Path;
use std::process::ExitCode;

use stickslip::app::App;
use stickslip::study::System;
use stickslip_models::friction::{library, with_memory};
use stickslip_models::press;
use stickslip_models::reproduce::{Part, reproduce};
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
