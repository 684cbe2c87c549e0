//! The program `stickslip`.

use std::error::Error;
use std::path::Path;
use std::process::ExitCode;

use stickslip::study::app::App;
use stickslip::study::entry;
use stickslip_models::reproduce::reproduce;
use stickslip_models::{BeltOscillator, BeltPair, DrillString, VanDerPol};

fn main() -> ExitCode {
    App::new(env!("CARGO_PKG_VERSION"))
        .offer(entry::<VanDerPol, _>())
        .offer(entry::<BeltOscillator, _>())
        .offer(entry::<BeltPair, _>())
        .offer(entry::<DrillString, _>())
        .reproduce(report)
        .run()
}

fn report(folder: &Path, quiet: bool) -> Result<(), Box<dyn Error>> {
    let summary = reproduce(folder, quiet)?;
    if !quiet {
        println!("{summary}");
    }
    Ok(())
}
