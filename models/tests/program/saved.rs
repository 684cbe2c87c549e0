//! What was found before is where something else begins.

use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::{stickslip, words};

fn folder(name: &str) -> String {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    folder.to_str().unwrap().to_owned()
}

/// The document of a command with this folder.
fn told(line: &str, more: &[&str]) -> Value {
    let answer = stickslip(&[words(line), words("--json --quiet"), more.to_vec()].concat());
    assert_eq!(answer.code, Some(0), "{line} {more:?}: {}", answer.stderr);
    serde_json::from_str(&answer.stdout).unwrap()
}

fn near(a: &Value, b: &Value, tolerance: f64) {
    let [a, b] = [a, b].map(|value| value.as_f64().unwrap());
    assert!((a / b - 1.0).abs() < tolerance, "{a} is not {b}");
}

#[test]
fn an_orbit_begins_where_one_was_found() {
    let out = folder("saved-orbit");
    let first = told("orbit belt-pair --set beta=1.25", &["--out", &out]);
    let file = format!("{out}/orbit.json");
    let again = told("orbit belt-pair", &["--start", &file]);
    assert_eq!(first["parameters"], again["parameters"]);
    near(&first["period"], &again["period"], 1e-8);
    // It begins in the modes that it had; a file that has none can be read all the same.
    assert_eq!(first["modes"]["f2"], "stick");
    let mut old: Value = serde_json::from_str(&fs::read_to_string(&file).unwrap()).unwrap();
    old.as_object_mut().unwrap().remove("modes");
    let without = format!("{out}/old.json");
    fs::write(&without, old.to_string()).unwrap();
    let again = told("orbit belt-pair", &["--start", &without]);
    near(&first["period"], &again["period"], 1e-8);
    // What is set is set.
    let other = told("orbit belt-pair --set beta=1.26", &["--start", &file]);
    assert_eq!(other["parameters"]["beta"], 1.26);
    // From an orbit, a motion goes once around.
    let period = first["period"].to_string();
    let motion = told("simulate belt-pair", &["--start", &file, "--time", &period]);
    for state in ["x1", "v2"] {
        let [from, to] = [&first["state"][state], &motion["state"][state]];
        let gap = from.as_f64().unwrap() - to.as_f64().unwrap();
        assert!(gap.abs() < 1e-6, "{state}: {gap}");
    }
    // A motion goes on where another ended.
    let out = folder("saved-motion");
    let half = told("simulate belt-oscillator --time 3", &["--out", &out]);
    let file = format!("{out}/trajectory.json");
    let rest = told("simulate belt-oscillator --time 4", &["--start", &file]);
    assert_eq!(rest["states"]["x"][0], half["state"]["x"]);
    let whole = told("simulate belt-oscillator --time 7", &[]);
    near(&rest["state"]["x"], &whole["state"]["x"], 1e-7);
}

#[test]
fn a_copy_keeps_its_friction() {
    let out = folder("saved-copy");
    let first = told(
        "orbit belt-oscillator --smooth arctan:1e3",
        &["--out", &out],
    );
    let file = format!("{out}/orbit.json");
    let again = told("orbit belt-oscillator", &["--start", &file]);
    assert_eq!(again["dynamics"], "arctan:1e3");
    near(&first["period"], &again["period"], 1e-8);
    let exact = told("orbit belt-oscillator --exact", &["--start", &file]);
    assert_eq!(exact["dynamics"], "exact");
    let tanh = told(
        "orbit belt-oscillator --smooth tanh:1e3",
        &["--start", &file],
    );
    assert_eq!(tanh["dynamics"], "tanh:1e3");
}

#[test]
fn special_points_and_rows_are_starts() {
    let out = folder("saved-branch");
    let branch = told("branch belt-pair --along v_dr=0.09..0.08", &["--out", &out]);
    let file = format!("{out}/branch.json");
    let special = &branch["special"][0];
    let label = special["label"].as_str().unwrap();
    let at = |part: &str| format!("{file}#{part}");
    let there = told("orbit belt-pair", &["--start", &at(label)]);
    assert_eq!(there["parameters"]["v_dr"], special["r"]);
    near(&there["period"], &special["period"], 1e-7);
    let row = &branch["points"][2];
    let there = told("orbit belt-pair", &["--start", &at("3")]);
    assert_eq!(there["parameters"]["v_dr"], row["r"]);
    assert_eq!(there["parameters"]["beta"], branch["parameters"]["beta"]);
    near(&there["period"], &row["period"], 1e-8);
    let along = format!("v_dr={}..0.08", row["r"]);
    let rest = told(
        "branch belt-pair",
        &["--along", &along, "--start", &at("3")],
    );
    near(&rest["points"][0]["period"], &row["period"], 1e-8);
}

#[test]
fn what_is_no_start_is_refused_by_name() {
    let out = folder("no-start");
    told("branch van-der-pol --along nu=1..0.9", &["--out", &out]);
    let file = format!("{out}/branch.json");
    let broken = format!("{out}/broken.json");
    fs::write(&broken, &fs::read_to_string(&file).unwrap()[..100]).unwrap();
    let empty = format!("{out}/empty.json");
    fs::write(&empty, "[1, {}]").unwrap();
    let odd = format!("{out}/odd.json");
    let text = r#"{"model": "van-der-pol", "state": {"x": "one"}, "period": -1}"#;
    fs::write(&odd, text).unwrap();
    for (line, start, part) in [
        (
            "orbit van-der-pol",
            format!("{out}/none.json"),
            "cannot be read",
        ),
        ("orbit van-der-pol", broken, "it is no JSON"),
        ("orbit van-der-pol", empty, "names no model"),
        ("orbit van-der-pol", odd, "no value of `x`"),
        ("orbit van-der-pol", file.clone(), "say which one"),
        ("orbit van-der-pol", format!("{file}#PD1"), "has no `PD1`"),
        ("orbit van-der-pol", format!("{file}#0"), "has no `0`"),
        (
            "orbit van-der-pol",
            format!("{file}#branch-1/1"),
            "has no `branch-1/1`",
        ),
        (
            "orbit drill-string",
            format!("{file}#1"),
            "belongs to `van-der-pol`",
        ),
    ] {
        let answer = stickslip(&[words(line), vec!["--start", &start]].concat());
        assert_eq!(answer.code, Some(2), "{start}: {}", answer.stderr);
        assert!(answer.stderr.contains(part), "{start}: {}", answer.stderr);
    }
}

#[test]
fn pictures_show_what_is_asked_for() {
    let out = folder("shown");
    let picture = |line: &str, more: &str, name: &str| {
        let all = [words(line), words(more), vec!["--quiet", "--out", &out]].concat();
        let answer = stickslip(&all);
        assert_eq!(answer.code, Some(0), "{line} {more}: {}", answer.stderr);
        fs::read_to_string(format!("{out}/{name}.svg")).unwrap()
    };
    let line = "simulate belt-pair --time 20";
    let all = picture(line, "", "trajectory");
    let few = picture(line, "--show v2,f1", "trajectory");
    let shows = |picture: &str, name: &str| picture.contains(&format!("\"{name} against"));
    assert!(shows(&all, "x_1") && !shows(&few, "x_1"));
    assert!(shows(&few, "v_2") && shows(&few, "f_1"));
    let few = picture("orbit belt-pair", "--show x2", "orbit");
    assert!(shows(&few, "x_2") && !shows(&few, "f_1"));
    let line = "diagram belt-pair --along v_dr=0.13..0.14 --values 2 --settle 5 --points 4";
    let two = picture(line, "--show x2,v2", "diagram");
    assert!(shows(&two, "x_2") && shows(&two, "v_2"));
    for (line, part) in [
        ("simulate belt-pair --show x3", "x1"),
        ("simulate belt-pair --show x1,x1", "more than once"),
        ("orbit belt-pair --show f9", "f1"),
        (
            "branch belt-pair --along v_dr=0.14..0.13 --show f1",
            "no state `f1`",
        ),
    ] {
        let answer = stickslip(&words(line));
        assert_eq!(answer.code, Some(2), "{line}: {}", answer.stderr);
        assert!(answer.stderr.contains(part), "{line}: {}", answer.stderr);
    }
}
