//! Counts the right digits of the built program against trusted values, from outside.

mod case;
mod judge;

use std::process::{Command, Stdio};
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

use case::{Case, Expected};
use judge::Answer;

#[test]
fn the_program_has_the_digits_of_the_trusted_values() {
    let cases = case::all();
    assert!(
        cases.len() >= 50,
        "only {} trusted values are left",
        cases.len()
    );
    let (next, short) = (AtomicUsize::new(0), Mutex::new(Vec::new()));
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, usize::from) {
            scope.spawn(|| {
                while let Some(case) = cases.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let lines = run(case);
                    if !lines.is_empty() {
                        let text = format!("{}: {}", case.name, lines.join("; "));
                        short.lock().expect("no thread has panicked").push(text);
                    }
                }
            });
        }
    });
    let mut short = short.into_inner().expect("no thread has panicked");
    short.sort();
    let (failed, all) = (short.len(), cases.len());
    assert!(
        failed == 0,
        "{failed} of {all} cases fall short:\n{}",
        short.join("\n")
    );
}

fn run(case: &Case) -> Vec<String> {
    let output = Command::new(env!("CARGO_BIN_EXE_stickslip"))
        .args(case.arguments())
        .stdin(Stdio::null())
        .output()
        .expect("the program can be started");
    let answer = Answer {
        exit: output.status.code(),
        stdout: &output.stdout,
        stderr: &String::from_utf8_lossy(&output.stderr),
    };
    judge::shortcomings(case, &answer)
}

/// The judge itself must be able to say no.
#[test]
fn a_wrong_digit_is_noticed() {
    let document =
        r#"{"period": 6.6632868593, "word": null, "special": [{"kind": "flip", "r": 0.5}]}"#;
    let answer = Answer {
        exit: Some(0),
        stdout: document.as_bytes(),
        stderr: "broken",
    };
    let number = |value, tolerance| Expected::Number {
        value,
        tolerance,
        scale: value,
    };
    let verdict = |expected: Expected, path: &str, kind: &str, exit: i32| {
        let case = Case {
            name: String::new(),
            args: Vec::new(),
            exit,
            stderr: "bro".to_owned(),
            expect: vec![(path.to_owned(), expected)],
            special: vec![(kind.to_owned(), 0.5 + 1e-9, 1e-8)],
        };
        judge::shortcomings(&case, &answer).len()
    };
    assert_eq!(
        verdict(number(6.66328685932313, 1e-10), "period", "flip", 0),
        0
    );
    assert_eq!(
        verdict(number(6.66328685932313, 1e-13), "period", "flip", 0),
        1
    );
    assert_eq!(verdict(number(0.0, 1.0), "word", "flip", 0), 1);
    assert_eq!(
        verdict(Expected::Same(serde_json::Value::Null), "word", "flip", 0),
        0
    );
    assert_eq!(
        verdict(
            Expected::Same(serde_json::Value::Null),
            "missing",
            "fold",
            0
        ),
        2
    );
    assert_eq!(verdict(number(1.0, 1.0), "period", "flip", 1), 1);
}
