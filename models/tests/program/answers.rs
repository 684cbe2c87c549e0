//! What the program answers.

use std::process::{Command, Stdio};

use serde_json::Value;

use crate::{stickslip, words};

fn json(line: &str) -> Value {
    let answer = stickslip(&words(line));
    assert_eq!(answer.code, Some(0), "{line}: {}", answer.stderr);
    serde_json::from_str(&answer.stdout).unwrap()
}

#[test]
fn what_cannot_be_found_is_no_usage_error() {
    let answer = stickslip(&words(
        "orbit belt-oscillator --set v_dr=0.05 --smooth arctan:1e2 --json",
    ));
    assert_eq!((answer.code, answer.stdout.as_str()), (Some(1), ""));
    assert!(
        answer
            .stderr
            .contains("only an equilibrium: the motion settles at x = 0.76"),
        "{}",
        answer.stderr
    );
}

#[test]
fn help_is_no_error() {
    for line in [
        "--help",
        "orbit --help",
        "help",
        "help orbit",
        "--version",
        "models",
    ] {
        let answer = stickslip(&words(line));
        assert_eq!(
            (answer.code, answer.stderr.as_str()),
            (Some(0), ""),
            "{line}"
        );
        assert!(!answer.stdout.is_empty(), "{line}");
    }
}

#[test]
fn models_are_shown_as_declared() {
    let all = json("models --json");
    let names: Vec<&str> = all["models"]
        .as_array()
        .unwrap()
        .iter()
        .map(|m| m["model"].as_str().unwrap())
        .collect();
    assert_eq!(
        names,
        [
            "van-der-pol",
            "belt-oscillator",
            "belt-pair",
            "drill-string",
            "bristle-oscillator",
            "forced-belt"
        ]
    );
    let belt = json("models belt-oscillator --json");
    assert_eq!(belt["parameters"][0]["bounds"], "m > 0");
    assert_eq!(belt["parameters"][0]["lower"]["inclusive"], false);
    assert_eq!(belt["states"][1]["unit"], "m/s");
    assert_eq!(belt["contacts"][0]["law"], "Weakening");
    let text = stickslip(&["models", "belt-oscillator"]).stdout;
    for part in [
        "v_dr = 0.2 m/s",
        "delta >= 0",
        "opposing v - v_dr",
        "der(v) = (F - k * x) / m",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
}

#[test]
fn the_shape_of_an_orbit() {
    let orbit = json("orbit belt-oscillator --smooth arctan:1e3 --set v_dr=0.1 --json");
    assert_eq!(orbit["model"], "belt-oscillator");
    assert_eq!(orbit["dynamics"], "arctan:1e3");
    assert_eq!(orbit["parameters"]["v_dr"], 0.1);
    assert!((orbit["period"].as_f64().unwrap() / 16.097_947_843_187_12 - 1.0).abs() < 1e-8);
    assert_eq!(
        orbit["frequency"].as_f64().unwrap(),
        1.0 / orbit["period"].as_f64().unwrap()
    );
    for key in ["state", "max", "min", "max_abs"] {
        assert!(
            orbit[key]["x"].is_f64() && orbit[key]["v"].is_number(),
            "{key}"
        );
    }
    assert_eq!(orbit["period_count"], 1);
    assert_eq!(orbit["multipliers"].as_array().unwrap().len(), 1);
    assert_eq!(orbit["multipliers"][0].as_array().unwrap().len(), 2);
    assert!(orbit["log_abs_multipliers"][0].as_f64().unwrap() < -4000.0);
    assert_eq!(orbit["stability"], "stable");
    assert!(orbit["word"].is_null() && orbit.as_object().unwrap().contains_key("word"));
    assert_eq!(orbit["units"]["v_dr"], "m/s");
    for key in ["trivial_multiplier_error", "residual", "error_estimate"] {
        assert!(orbit[key].as_f64().unwrap() < 1e-6, "{key}");
    }
    assert!(orbit["work"]["steps"].as_u64().unwrap() > 0);
    assert!(orbit.get("r").is_none());
}

/// A law with internal state is integrated as it is, and still friction.
#[test]
fn friction_with_memory_is_called_so() {
    for (model, how) in [
        ("bristle-oscillator", "friction with memory"),
        ("van-der-pol", "smooth"),
        ("drill-string", "exact"),
    ] {
        let answer = stickslip(&words(&format!("simulate {model} --time 1 --quiet")));
        let begins = answer.stdout.starts_with(&format!("{model}, {how}: "));
        assert!(begins, "{}{}", answer.stdout, answer.stderr);
    }
}

#[test]
fn exact_friction_is_the_default() {
    let orbit = json("orbit belt-oscillator --json");
    assert_eq!(
        (&orbit["dynamics"], &orbit["word"]),
        (&"exact".into(), &"stick(F) slip-(F)".into())
    );
    assert!((orbit["period"].as_f64().unwrap() / 12.001_031_294_830_58 - 1.0).abs() < 1e-8);
    assert_eq!(orbit["multipliers"][0][0], 0.0);
    assert_eq!(orbit["log_abs_multipliers"][0], "-inf");
    assert_eq!(orbit, json("orbit belt-oscillator --exact --json"));
}

#[test]
fn sticking_forces_balance_the_spring() {
    let motion = json("simulate belt-oscillator --start x=0,v=0.2 --time 0.5 --json");
    let column = |group: &str, name: &str| -> Vec<f64> {
        let column = motion[group][name].as_array().unwrap();
        column.iter().map(|value| value.as_f64().unwrap()).collect()
    };
    let pairs = column("forces", "F").into_iter().zip(column("states", "x"));
    assert!(pairs.clone().count() > 1);
    for (force, x) in pairs {
        assert!((force - x).abs() < 1e-12, "F = {force} at x = {x}");
    }
}

#[test]
fn friction_that_is_not_there_may_be_exact() {
    let orbit = json("orbit van-der-pol --exact --start x=2.0,v=0 --period 6.6 --json --quiet");
    assert_eq!(orbit["dynamics"], "smooth");
    assert!((orbit["period"].as_f64().unwrap() - 6.663_286_859_323).abs() < 1e-7);
}

#[test]
fn a_period_without_a_start_is_only_a_guess() {
    let orbit = json("orbit van-der-pol --period 50 --json");
    assert!((orbit["period"].as_f64().unwrap() - 6.663_286_859_323).abs() < 1e-7);
}

#[test]
fn the_shape_of_a_branch() {
    let branch = json("branch van-der-pol --along nu=1..0.5 --json");
    assert_eq!(branch["ended"], "reached-end");
    assert_eq!(branch["special"].as_array().unwrap().len(), 0);
    assert_eq!(
        (
            branch["along"]["name"].as_str(),
            branch["along"]["to"].as_f64()
        ),
        (Some("nu"), Some(0.5))
    );
    let points = branch["points"].as_array().unwrap();
    let ends = [&points[0], &points[points.len() - 1]];
    assert_eq!(ends.map(|point| point["r"].as_f64().unwrap()), [1.0, 0.5]);
    assert_eq!(branch["parameters"]["nu"], 1.0);
    assert!(points.iter().all(|point| point["parameters"].is_null()));
    assert!((ends[0]["period"].as_f64().unwrap() - 6.663_286_859_323).abs() < 1e-7);
}

#[test]
fn a_smoothing_is_followed_in_its_size() {
    for smooth in ["arctan", "arctan:1e2"] {
        let line =
            format!("branch belt-oscillator --smooth {smooth} --along smooth=1e2..1e4 --json");
        let branch = json(&line);
        let points = branch["points"].as_array().unwrap();
        let ends = [&points[0], &points[points.len() - 1]];
        assert_eq!(ends.map(|point| point["r"].as_f64().unwrap()), [1e2, 1e4]);
    }
}

#[test]
fn a_motion_shows_states_observables_and_forces() {
    let motion = json("simulate drill-string --smooth quartic:0.1 --time 5 --json");
    let length = motion["time"].as_array().unwrap().len();
    for column in [
        &motion["states"]["psi"],
        &motion["observables"]["T_c"],
        &motion["forces"]["T_b"],
    ] {
        assert_eq!(column.as_array().unwrap().len(), length);
    }
    assert_eq!(motion["time"][length - 1], 5.0);
    assert_eq!(motion["states"]["psi"][0], 6.0);
}

#[test]
fn files_are_written_where_asked() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("written/below");
    let place = folder.to_str().unwrap();
    for (line, files) in [
        (
            "simulate belt-oscillator --smooth tanh:1e2 --time 3",
            ["trajectory.csv", "trajectory.json", "trajectory.svg"],
        ),
        (
            "orbit belt-oscillator --smooth tanh:1e2",
            ["orbit.csv", "orbit.json", "orbit.svg"],
        ),
        (
            "branch van-der-pol --along nu=1..0.9",
            ["branch.csv", "branch.json", "branch.svg"],
        ),
    ] {
        let answer = stickslip(&[words(line), vec!["--out", place]].concat());
        assert_eq!(answer.code, Some(0), "{line}: {}", answer.stderr);
        let [sheet, document, picture] =
            files.map(|file| std::fs::read_to_string(folder.join(file)).unwrap());
        let columns: Vec<usize> = sheet.lines().map(|row| row.split(',').count()).collect();
        assert!(
            columns.len() > 2 && columns.iter().all(|&n| n == columns[0]),
            "{line}"
        );
        assert!(
            serde_json::from_str::<Value>(&document)
                .unwrap()
                .is_object()
        );
        assert!(
            picture.starts_with("<svg") && !picture.contains("NaN"),
            "{line}"
        );
    }
}

#[test]
fn an_accuracy_that_is_missed_is_admitted() {
    let answer = stickslip(&words("orbit van-der-pol --set nu=1e-8"));
    assert_eq!(answer.code, Some(0), "{}", answer.stderr);
    assert!(
        answer
            .stderr
            .contains("larger than the accuracy asked for, 1e-9"),
        "{}",
        answer.stderr
    );
    assert_eq!(stickslip(&words("orbit van-der-pol")).stderr, "");
}

#[test]
fn a_reader_may_leave() {
    let mut child = Command::new(env!("CARGO_BIN_EXE_stickslip"))
        .args(["simulate", "van-der-pol", "--time", "1000", "--json"])
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    drop(child.stdout.take());
    let done = child.wait_with_output().unwrap();
    assert_eq!((done.status.code(), done.stderr.len()), (Some(0), 0));
}
