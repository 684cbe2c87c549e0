//! The program `stickslip`.

use std::path::Path;
use std::process::ExitCode;

fn main() -> ExitCode {
    match stickslip_models::reproduce::reproduce(Path::new("report"), false) {
        Ok(summary) => {
            println!("{summary}");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}
