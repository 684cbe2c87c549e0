//! `mpirun -n 64 stickslip-mpi stickslip map ... --out DIR`: each rank does its share of the list, and when all are done the
//! first one puts the shares together, to the same bytes as one run.
//!
//! The shares are processes of the program that is named, so that any program of `stickslip` can be run so, and what is
//! on the wire is one number: the exit code. A rank that is asked to end leaves that to its process, which gets the
//! signal from `mpirun`, too, finishes its item and says "to be continued".

use std::path::Path;
use std::process::{Command, ExitCode};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use mpi::collective::SystemOperation;
use mpi::traits::{Communicator, CommunicatorCollectives, Root};
use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM, SIGUSR1};

/// The exit code of what cannot be started at all.
const NOT_STARTED: i32 = 127;

fn main() -> ExitCode {
    for signal in [SIGHUP, SIGINT, SIGTERM, SIGUSR1] {
        if let Err(error) = signal_hook::flag::register(signal, Arc::new(AtomicBool::new(false))) {
            eprintln!("error: signal {signal} cannot be left to the program: {error}");
            return ExitCode::FAILURE;
        }
    }
    let Some(universe) = mpi::initialize() else {
        eprintln!("error: MPI is initialised already");
        return ExitCode::FAILURE;
    };
    let world = universe.world();
    let words: Vec<String> = std::env::args().skip(1).collect();
    let (rank, size) = (world.rank(), world.size());
    let (code, mut worst) = (share(&words, rank + 1, size), 0);
    world.all_reduce_into(&code, &mut worst, SystemOperation::max());
    if worst == 0 {
        if rank == 0 {
            worst = merge(&words);
        }
        world.process_at_rank(0).broadcast_into(&mut worst);
    }
    ExitCode::from(u8::try_from(worst).unwrap_or(1))
}

/// Does one share; the exit code.
fn share(words: &[String], number: i32, of: i32) -> i32 {
    let Some((program, question)) = words.split_first() else {
        eprintln!(
            "usage: mpirun -n N stickslip-mpi PROGRAM map|attractors|diagram|trade ... --out DIR"
        );
        return 2;
    };
    let mut command = Command::new(program);
    command.args(question);
    command.args(["--shard", &format!("{number}/{of}"), "--quiet", "--resume"]);
    if !question.iter().any(|word| word.starts_with("--threads")) {
        command.args(["--threads", "1"]);
    }
    run(command)
}

/// Puts the shares together.
fn merge(words: &[String]) -> i32 {
    let Some(folder) = folder(words) else {
        eprintln!("error: `--out DIR` names the folder in which the shares meet");
        return 2;
    };
    let mut command = Command::new(&words[0]);
    command.arg("merge").arg(folder);
    run(command)
}

/// What `--out` names.
fn folder(words: &[String]) -> Option<&Path> {
    let at = |at: usize| words.get(at + 1).map(String::as_str);
    let given = words
        .iter()
        .enumerate()
        .find_map(|(k, word)| match word.as_str() {
            "--out" => at(k),
            word => word.strip_prefix("--out="),
        });
    given.map(Path::new)
}

fn run(mut command: Command) -> i32 {
    match command.status() {
        Ok(status) => status.code().unwrap_or(1),
        Err(error) => {
            eprintln!(
                "error: {} cannot be run: {error}",
                command.get_program().display()
            );
            NOT_STARTED
        }
    }
}
