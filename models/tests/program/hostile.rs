//! Whatever is written on the command line: an answer or a message, in the end, and never a panic.

use std::process::Command;

use proptest::collection::vec;
use proptest::option::weighted;
use proptest::prelude::*;
use proptest::sample::select;
use proptest::test_runner::{Config, RngSeed, TestRunner};

/// How many simpler lines are tried if one fails.
const SIMPLER: u32 = 100;

const NUMBERS: [&str; 26] = [
    "1", "0", "3", "0.5", "-1", "-5", "-0.0", "1e-8", "1e8", "1e5", "1e16", "1e-16", "-1e-20",
    "1e-99", "1e99", "1e308", "-1e308", "5e-324", "1e-310", "NaN", "inf", "-inf", "1e999", "", "x",
    "0x10",
];
const KERNELS: [&str; 7] = [
    "arctan",
    "tanh",
    "algebraic",
    "cubic",
    "quintic",
    "quartic",
    "x",
];
/// Without `trade`: where it makes sense, it takes minutes.
const COMMANDS: [&str; 7] = [
    "orbit",
    "orbit",
    "orbit",
    "simulate",
    "equilibria",
    "branch",
    "models",
];

/// A model by name, its parameters and its states.
type System = (
    &'static str,
    &'static [&'static str],
    &'static [&'static str],
);

const SYSTEMS: [System; 4] = [
    ("van-der-pol", &["nu"], &["x", "v"]),
    (
        "belt-oscillator",
        &["m", "k", "v_dr", "F_s", "delta"],
        &["x", "v"],
    ),
    (
        "belt-pair",
        &["alpha", "beta", "gamma", "v_dr"],
        &["x1", "v1", "x2", "v2"],
    ),
    (
        "drill-string",
        &["eta", "theta", "kinetic", "zeta"],
        &["psi", "omega"],
    ),
];

/// Numbers that hurt, and any others.
fn number() -> impl Strategy<Value = String> {
    prop_oneof![
        4 => select(&NUMBERS[..]).prop_map(str::to_owned),
        1 => proptest::num::f64::ANY.prop_map(|number| format!("{number:e}")),
    ]
}

fn assignment(names: &'static [&'static str]) -> impl Strategy<Value = String> {
    (select(names), number()).prop_map(|(name, number)| format!("{name}={number}"))
}

/// A line that may or may not make sense.
fn line() -> impl Strategy<Value = Vec<String>> {
    (select(&SYSTEMS[..]), select(&COMMANDS[..])).prop_flat_map(
        |((model, parameters, states), command)| {
            let set = vec(
                assignment(parameters).prop_map(|one| ["--set".to_owned(), one]),
                0..3,
            );
            let copy = (select(&KERNELS[..]), number());
            let copy = copy.prop_map(|(kernel, size)| format!("{kernel}:{size}"));
            let range = (assignment(parameters), number());
            let range = range.prop_map(|(from, to)| format!("{from}..{to}"));
            let accuracy = select(&["1e-3", "1e-12", "NaN", "0", "0.05"][..]);
            let given = |often: bool, chance, name: &'static str, value: BoxedStrategy<String>| {
                let option = value.prop_map(move |value| [format!("--{name}"), value]);
                if often {
                    option.prop_map(Some).boxed()
                } else {
                    weighted(chance, option).boxed()
                }
            };
            let (follows, moves) = (command == "branch", command == "simulate");
            let options = (
                given(false, 0.33, "smooth", copy.boxed()),
                given(false, 0.33, "start", start(states).boxed()),
                given(false, 0.16, "period", number().boxed()),
                given(moves, 0.02, "time", number().boxed()),
                given(follows, 0.16, "along", range.boxed()),
                given(
                    false,
                    0.25,
                    "accuracy",
                    accuracy.prop_map(str::to_owned).boxed(),
                ),
            );
            (set, options).prop_map(move |(set, (a, b, c, d, e, f))| {
                let words = [command, model, "--quiet"].map(str::to_owned);
                let few = ["--steps", "100000"].map(str::to_owned);
                let few = moves.then_some(few).into_iter().flatten();
                let options = set
                    .into_iter()
                    .chain([a, b, c, d, e, f].into_iter().flatten());
                words
                    .into_iter()
                    .chain(few)
                    .chain(options.flatten())
                    .collect()
            })
        },
    )
}

fn start(states: &'static [&'static str]) -> impl Strategy<Value = String> {
    vec(assignment(states), 1..3).prop_map(|all| all.join(","))
}

/// Asks the program, and judges how it ends.
fn judge(line: &[String]) -> Result<(), TestCaseError> {
    let done = Command::new(env!("CARGO_BIN_EXE_stickslip"))
        .args(line)
        .output()
        .unwrap();
    let (code, message) = (done.status.code(), String::from_utf8_lossy(&done.stderr));
    prop_assert!(matches!(code, Some(0..=2)), "{code:?}: {message}");
    prop_assert!(!message.contains("panicked"), "{message}");
    prop_assert!(
        code == Some(0) || message.starts_with("error: "),
        "{message}"
    );
    Ok(())
}

/// Tries so many lines: the same ones on every machine.
fn try_lines(cases: u32, seed: u64) {
    let config = Config {
        cases,
        rng_seed: RngSeed::Fixed(seed),
        failure_persistence: None,
        max_shrink_iters: SIMPLER,
        ..Config::default()
    };
    let outcome = TestRunner::new(config).run(&line(), |line| judge(&line));
    outcome.unwrap_or_else(|failure| panic!("{failure}"));
}

#[test]
fn a_line_gets_an_answer_or_a_message() {
    try_lines(20, 5);
}

#[test]
#[ignore = "long"]
fn any_line_gets_an_answer_or_a_message() {
    try_lines(100, 5);
}

#[test]
#[ignore = "long"]
fn any_other_line_gets_an_answer_or_a_message() {
    try_lines(100, 6);
}
