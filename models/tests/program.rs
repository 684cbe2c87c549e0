//! The program `stickslip`, from outside.

use std::process::{Command, Stdio};

use serde_json::Value;

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

fn json(line: &str) -> Value {
    let answer = stickslip(&words(line));
    assert_eq!(answer.code, Some(0), "{line}: {}", answer.stderr);
    serde_json::from_str(&answer.stdout).unwrap()
}

/// Every line is refused as a usage error, with nothing on stdout and these words in one message.
fn refused(cases: &[(&str, &[&str])]) {
    for (line, parts) in cases {
        refused_words(&words(line), parts);
    }
}

fn refused_words(words: &[&str], parts: &[&str]) {
    let answer = stickslip(words);
    assert_eq!(answer.code, Some(2), "{words:?}: {}", answer.stderr);
    assert_eq!(answer.stdout, "", "{words:?}");
    assert!(
        answer.stderr.starts_with("error: "),
        "{words:?}: {}",
        answer.stderr
    );
    assert_eq!(
        answer.stderr.lines().count(),
        1,
        "{words:?}: {}",
        answer.stderr
    );
    for part in parts {
        assert!(
            answer.stderr.contains(part),
            "{words:?} lacks {part:?}: {}",
            answer.stderr
        );
    }
}

#[test]
fn misspelt_names() {
    refused(&[
        ("orbt van-der-pol", &["`orbt`", "did you mean `orbit`?"]),
        (
            "frobnicate",
            &["`frobnicate`", "models, simulate, orbit, branch"],
        ),
        (
            "orbit belt-oscilator",
            &["`belt-oscilator`", "did you mean `belt-oscillator`?"],
        ),
        (
            "orbit rocket",
            &["`rocket`", "van-der-pol, belt-oscillator"],
        ),
        ("orbit", &["no model is named", "van-der-pol"]),
        ("models rocket", &["`rocket`"]),
        (
            "orbit van-der-pol --acuracy 1e-9",
            &["`--acuracy`", "did you mean `--accuracy`?"],
        ),
        (
            "orbit van-der-pol --along nu=1..2",
            &["`--along` is an option of `branch`"],
        ),
        ("--json", &["`--json` belongs after a command"]),
        ("orbit van-der-pol -x", &["`-x`"]),
        (
            "orbit van-der-pol drill-string",
            &["`drill-string`", "too many"],
        ),
        (
            "orbit belt-oscillator --set v_rd=0.2",
            &["`v_rd`", "did you mean `v_dr`?"],
        ),
        (
            "orbit belt-oscillator --set zz=0.2",
            &["`zz`", "m, k, v_dr, F_s, delta"],
        ),
        (
            "orbit belt-oscillator --set x=0.2",
            &["`x` is a state", "--start x="],
        ),
        (
            "orbit belt-pair --smooth arctan:1e5 --start x3=1",
            &["`x3`", "did you mean `x1`?"],
        ),
        (
            "orbit belt-oscillator --smooth arctn:1e5",
            &["`arctn`", "did you mean `arctan`?"],
        ),
        (
            "branch belt-oscillator --smooth arctan:1e5 --along vdr=0.2..0.1",
            &["`vdr`", "did you mean `v_dr`?"],
        ),
        (
            "branch belt-oscillator --smooth arctan:1e5 --along smoot=1e2..1e3",
            &["did you mean `smooth`?"],
        ),
    ]);
}

#[test]
fn numbers_that_are_none() {
    refused(&[
        (
            "orbit van-der-pol --set nu=one",
            &["`--set nu=one`", "`one` is not a number"],
        ),
        ("orbit van-der-pol --set nu=nan", &["NaN"]),
        ("orbit van-der-pol --set nu=inf", &["infinite"]),
        ("orbit van-der-pol --set nu=1e999", &["infinite"]),
        (
            "orbit van-der-pol --start x=nan",
            &["`--start x=nan`", "NaN"],
        ),
        ("orbit van-der-pol --period nan", &["`--period`", "NaN"]),
        (
            "orbit van-der-pol --accuracy tight",
            &["`tight` is not a number"],
        ),
        (
            "simulate van-der-pol --time -inf",
            &["`--time`", "infinite"],
        ),
        (
            "branch van-der-pol --along nu=1..x",
            &["`x` is not a number"],
        ),
        (
            "orbit belt-oscillator --smooth arctan:big",
            &["`big`", "arctan:1e5"],
        ),
    ]);
}

#[test]
fn values_out_of_bounds() {
    refused(&[
        ("orbit van-der-pol --set nu=-1", &["nu = -1", "nu >= 0"]),
        (
            "orbit drill-string --smooth quartic:1e-2 --set eta=0",
            &["eta > 0"],
        ),
        ("branch van-der-pol --along nu=1..-1", &["nu >= 0"]),
        ("branch van-der-pol --along nu=-1..1", &["nu >= 0"]),
        ("orbit belt-oscillator --smooth arctan:0", &["above 0"]),
        (
            "orbit belt-oscillator --smooth arctan:-1e5",
            &["above 0", "`-1e5`"],
        ),
        (
            "branch belt-oscillator --smooth arctan:1e2 --along smooth=0..1e5",
            &["not above 0"],
        ),
        (
            "orbit van-der-pol --period 0",
            &["`--period 0`", "not above 0"],
        ),
        (
            "orbit van-der-pol --period -3",
            &["`--period -3`", "not above 0"],
        ),
        ("simulate van-der-pol --time 0", &["`--time 0`"]),
        ("orbit van-der-pol --accuracy 0.5", &["1e-13 and 1e-1"]),
        ("orbit van-der-pol --accuracy 1e-15", &["1e-13 and 1e-1"]),
        (
            "orbit van-der-pol --accuracy -1e-9",
            &["`--accuracy -1e-9`"],
        ),
    ]);
}

#[test]
fn words_that_are_missing_or_too_many() {
    refused(&[
        ("", &["no command is given", "models, simulate"]),
        (
            "orbit van-der-pol --set",
            &["`--set` needs a value", "NAME=VALUE"],
        ),
        ("orbit van-der-pol --set nu", &["`--set nu`", "name=value"]),
        ("orbit van-der-pol --set =1", &["no name"]),
        ("orbit van-der-pol --set nu=", &["no value"]),
        ("orbit van-der-pol --start x=1,", &["empty word"]),
        ("orbit van-der-pol --start x=1,x=2", &["`x` more than once"]),
        (
            "orbit van-der-pol --set nu=1 --set nu=2",
            &["nu", "more than once"],
        ),
        (
            "orbit van-der-pol --period 6 --period 7",
            &["`--period` is given more than once"],
        ),
        (
            "orbit van-der-pol --json=yes",
            &["`--json` takes no value `yes`"],
        ),
        ("branch van-der-pol", &["--along"]),
        ("branch van-der-pol --along nu=1", &["no range"]),
        ("branch van-der-pol --along nu=1...2", &["no range"]),
        ("branch van-der-pol --along nu=1..", &["empty word"]),
        ("branch van-der-pol --along 1..2", &["no assignment"]),
        ("branch van-der-pol --along nu=1..1", &["nothing to follow"]),
    ]);
    for option in ["--set", "--start", "--period", "--accuracy"] {
        refused_words(
            &["orbit", "van-der-pol", option, ""],
            &[option, "empty word"],
        );
    }
    refused_words(&["orbit", ""], &["no model ``"]);
    refused_words(&["orbit", "van-der-pol", "--out", ""], &["`--out`"]);
}

#[test]
fn words_that_contradict() {
    refused(&[
        (
            "orbit van-der-pol --smooth arctan:1e5",
            &["`van-der-pol` has no friction"],
        ),
        (
            "orbit belt-oscillator --exact --smooth arctan:1e5",
            &["exclude each other"],
        ),
        (
            "orbit belt-oscillator --smooth quartic:0.01",
            &["`quartic`", "never stick"],
        ),
        (
            "orbit drill-string --smooth arctan:1e5",
            &["static peak", "use `quartic`"],
        ),
        (
            "branch drill-string --smooth quartic:0.01 --along theta=4.2..0",
            &["`quartic`", "`T_b`"],
        ),
        (
            "branch van-der-pol --set nu=2 --along nu=1..3",
            &["`--set nu=2` contradicts", "begins at nu = 1"],
        ),
        (
            "branch belt-oscillator --along smooth=1e2..1e3",
            &["--smooth arctan:1e2"],
        ),
        (
            "branch van-der-pol --along smooth=1e2..1e3",
            &["follows the size"],
        ),
        (
            "orbit van-der-pol --out Cargo.toml/report",
            &["`--out Cargo.toml/report`"],
        ),
        (
            "orbit van-der-pol --out Cargo.toml",
            &["`--out Cargo.toml`"],
        ),
    ]);
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
            .contains("settles on an equilibrium, x = 0.76"),
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
            "drill-string"
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
    assert_eq!(
        ends.map(|point| point["parameters"]["nu"].as_f64().unwrap()),
        [1.0, 0.5]
    );
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
        assert_eq!(
            ends.map(|point| point["dynamics"].as_str().unwrap()),
            ["arctan:100", "arctan:1e4"]
        );
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
            ["trajectory.csv", "trajectory.json"],
        ),
        (
            "orbit belt-oscillator --smooth tanh:1e2",
            ["orbit.csv", "orbit.json"],
        ),
        (
            "branch van-der-pol --along nu=1..0.9",
            ["branch.csv", "branch.json"],
        ),
    ] {
        let answer = stickslip(&[words(line), vec!["--out", place]].concat());
        assert_eq!(answer.code, Some(0), "{line}: {}", answer.stderr);
        let [sheet, document] =
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
    }
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
