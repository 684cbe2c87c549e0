//! What derivatives, flows, branches and digits cost: `cargo bench`, or `cargo bench --features diffsol` to have the
//! same flows by that library beside them; `tests/cvode` has them by CVODES.
//!
//! Times are the best of many runs. On a busy machine the ratios decide.

mod branches;
mod chains;
mod clock;
mod closed;
mod contender;
mod derivatives;
mod exact;
mod flows;
#[cfg(feature = "diffsol")]
mod rival;
mod round;
mod work_precision;

fn main() {
    // Cargo passes `--bench`; a word besides picks the tables whose name holds it.
    let wanted = std::env::args().skip(1).find(|word| !word.starts_with('-'));
    let asked = |name: &str| {
        wanted
            .as_ref()
            .is_none_or(|word| name.contains(word.as_str()))
    };
    if asked("derivatives") {
        derivatives::table();
    }
    if asked("chains") {
        chains::table();
    }
    if asked("flows") {
        flows::table();
    }
    if asked("growth") {
        flows::growth();
    }
    if asked("exact") {
        exact::table();
    }
    if asked("closed") {
        closed::table();
    }
    if asked("work-precision") {
        work_precision::table();
    }
    if asked("branches") {
        branches::table();
    }
}
