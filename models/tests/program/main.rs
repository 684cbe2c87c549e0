//! The program `stickslip`, from outside.

mod absences;
mod answers;
mod certificate;
mod curve;
#[cfg(unix)]
mod damaged;
mod diagram;
mod driven;
mod equilibria;
mod hostile;
#[cfg(unix)]
mod interrupted;
mod laws;
mod losses;
mod needs;
#[cfg(feature = "reduce")]
mod reduce;
mod refusals;
#[cfg(unix)]
mod resumed;
mod saved;
mod schema;
#[cfg(unix)]
mod shared;
#[cfg(unix)]
mod streamed;
mod tables;
mod trade;

use std::process::Command;

struct Answer {
    code: Option<i32>,
    stdout: String,
    stderr: String,
}

fn stickslip(words: &[&str]) -> Answer {
    let done = Command::new(env!("CARGO_BIN_EXE_stickslip"))
        .args(words)
        .output()
        .unwrap();
    Answer {
        code: done.status.code(),
        stdout: String::from_utf8(done.stdout).unwrap(),
        stderr: String::from_utf8(done.stderr).unwrap(),
    }
}

fn words(line: &str) -> Vec<&str> {
    line.split_whitespace().collect()
}
