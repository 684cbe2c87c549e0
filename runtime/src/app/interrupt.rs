//! Ctrl-C, a closed terminal, or a request to end: a long command ends with what is there, and says so.
//!
//! The first signal asks whoever computes to come to an end; who does not hear it in time is ended, between two rows of
//! whatever is being written. The second signal ends the program at once.

use std::fs::Metadata;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, AtomicU8, Ordering};
use std::sync::{LazyLock, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant, SystemTime};

use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM, SIGUSR1};
use signal_hook::flag;

use super::failure::{CONTINUED, Failure, INTERRUPTED};
use super::print::print;

/// How the names of notes end.
pub(super) const ENDING: &str = "resume";

/// How long a computation has to come to an end by itself.
const GRACE: Duration = Duration::from_secs(2);
/// The same where schedulers ask: they wait longer before they end it.
const LONG_GRACE: Duration = Duration::from_secs(20);
/// How often the signal is looked for.
const GLANCE: Duration = Duration::from_millis(50);

/// Whether an end is wanted.
static ASKED: AtomicBool = AtomicBool::new(false);
/// What is being computed, if anything is.
static AT_WORK: Mutex<Option<Begun>> = Mutex::new(None);
/// Whether it has asked if it shall go on: what has not has nothing yet to come to an end with.
static LISTENS: AtomicBool = AtomicBool::new(false);
/// Files that grow as results are found; held while one of them does.
static GROWING: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());
/// The exit code of what is interrupted.
static CODE: AtomicU8 = AtomicU8::new(INTERRUPTED);
/// The one who listens.
static SENTRY: LazyLock<()> = LazyLock::new(listen);

/// A computation under way.
struct Begun {
    since: SystemTime,
    /// What is printed if it is ended before it has an answer.
    last_words: String,
}

/// A computation that can be interrupted, until it is dropped.
pub(super) struct Work(());

impl Work {
    /// It begins now, and should ask at each finding whether it shall go on: see [`verdict`]. If it is ended before it has
    /// an answer, the last words are printed.
    pub(super) fn begin(last_words: String) -> Self {
        hear();
        LISTENS.store(false, Ordering::Relaxed);
        *held(&AT_WORK) = Some(Begun {
            since: SystemTime::now(),
            last_words,
        });
        Self(())
    }
}

impl Drop for Work {
    fn drop(&mut self) {
        *held(&AT_WORK) = None;
    }
}

/// Whoever interrupts what begins next will have it continued by the same words, as schedulers do; they also ask with
/// SIGUSR1.
pub(super) fn is_continued() {
    CODE.store(CONTINUED, Ordering::Relaxed);
}

/// From now on who asks for an end is heard: before there is a file that shall be whole.
pub(super) fn hear() {
    LazyLock::force(&SENTRY);
}

/// Whether a computation shall go on.
pub(super) fn verdict() -> ControlFlow<()> {
    LISTENS.store(true, Ordering::Relaxed);
    if asked() {
        ControlFlow::Break(())
    } else {
        ControlFlow::Continue(())
    }
}

/// Whether an end is wanted; asking for it is not yet a promise to come to one.
pub(super) fn asked() -> bool {
    ASKED.load(Ordering::Relaxed)
}

/// The files that grow; the program does not end between the beginning and the end of a row while they are held.
pub(super) fn growing() -> MutexGuard<'static, Vec<PathBuf>> {
    held(&GROWING)
}

fn held<T>(mutex: &'static Mutex<T>) -> MutexGuard<'static, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Listens from now on. Where no signal can be heard, the system does with it what it always does; one that whoever
/// called the program wants to be ignored, as `nohup` does, is.
fn listen() {
    let (ignored, code) = (ignored(), CODE.load(Ordering::Relaxed));
    let continued = (code == CONTINUED).then_some(SIGUSR1);
    for signal in [SIGHUP, SIGINT, SIGTERM].into_iter().chain(continued) {
        if ignored & (1 << (signal - 1)) != 0 {
            continue;
        }
        // In this order the first signal finds the flag down, and only the second one ends the program.
        let second = flag::register_conditional_shutdown(signal, code.into(), &ASKED);
        let _ = second.and_then(|_| flag::register(signal, &ASKED));
    }
    let sentry = std::thread::Builder::new().name("sentry".to_owned());
    let _ = sentry.spawn(wait);
}

/// The signals that are ignored, a bit each, where the system tells.
fn ignored() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok())
        .unwrap_or(0)
}

/// Ends the program if a computation does not end by itself.
fn wait() {
    while !ASKED.load(Ordering::Relaxed) {
        std::thread::sleep(GLANCE);
    }
    let asked = Instant::now();
    let continued = CODE.load(Ordering::Relaxed) == CONTINUED;
    let grace = if continued { LONG_GRACE } else { GRACE };
    loop {
        // Held to the end: what has come to its end is not ended any more.
        let at_work = held(&AT_WORK);
        if let Some(begun) = &*at_work
            && (!LISTENS.load(Ordering::Relaxed) || asked.elapsed() >= grace)
        {
            let mut files = growing();
            // What was there before is not what was found now.
            files.retain(|path| path.metadata().is_ok_and(|file| is_new(&file, begun.since)));
            let _ = print(&begun.last_words);
            Failure::interrupted(&told(&files)).report();
            std::process::exit(CODE.load(Ordering::Relaxed).into());
        }
        drop(at_work);
        std::thread::sleep(GLANCE);
    }
}

fn is_new(file: &Metadata, since: SystemTime) -> bool {
    let coarse = since - Duration::from_secs(1);
    file.modified().is_ok_and(|time| time >= coarse)
}

fn told(files: &[PathBuf]) -> String {
    let tables = files.iter().filter(|path| !is_notes(path));
    let names: Vec<String> = tables.map(|path| path.display().to_string()).collect();
    match names.as_slice() {
        [] if LISTENS.load(Ordering::Relaxed) => {
            "it was long at work on what comes next: with `--out DIR` each row is kept as it is found".to_owned()
        }
        [] => "nothing was found yet that could be kept".to_owned(),
        names => format!(
            "what was found is in {}{}",
            names.join(", "),
            way_out(files)
        ),
    }
}

/// How to go on from these files.
pub(super) fn way_out(files: &[PathBuf]) -> &'static str {
    if files.iter().any(|path| is_notes(path)) {
        "; `--resume` goes on from there"
    } else {
        ""
    }
}

fn is_notes(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending == ENDING)
}
