//! What `stickslip equilibria` answers.

use serde_json::Value;

use crate::{stickslip, words};

fn json(line: &str) -> Value {
    let answer = stickslip(&words(line));
    assert_eq!(answer.code, Some(0), "{line}: {}", answer.stderr);
    serde_json::from_str(&answer.stdout).unwrap()
}

#[test]
fn the_shape_of_a_list() {
    let list = json("equilibria belt-oscillator --json");
    let one = &list["equilibria"][0];
    assert!((one["state"]["x"].as_f64().unwrap() - 0.625).abs() < 1e-14);
    assert_eq!(
        (&one["stability"], &one["mode"]),
        (&"unstable".into(), &"slip-(F)".into())
    );
    assert_eq!(one["eigenvalues"].as_array().unwrap().len(), 2);
    assert_eq!(one["artefact"], false);
    assert_eq!(list["equilibria"].as_array().unwrap().len(), 1);
    assert_eq!(list["units"]["x"], "m");
}

#[test]
fn a_resting_belt_holds_an_interval() {
    let list = json("equilibria belt-oscillator --set v_dr=0 --json");
    let one = &list["equilibria"][0];
    assert_eq!(
        (&one["mode"], &one["set"]["dimension"]),
        (&"stick(F)".into(), &1.into())
    );
    let ends = [&one["set"]["min"]["x"], &one["set"]["max"]["x"]].map(|end| end.as_f64().unwrap());
    assert!(
        (ends[0] + 1.0).abs() < 1e-12 && (ends[1] - 1.0).abs() < 1e-12,
        "{ends:?}"
    );
    let text = stickslip(&words("equilibria belt-oscillator --set v_dr=0")).stdout;
    assert!(text.contains("[-1.00000000, 1.00000000]"), "{text}");
}

#[test]
fn a_branch_ends_where_sliding_does() {
    let branch = json("equilibria belt-oscillator --along v_dr=0.2..-0.1 --json --quiet");
    assert_eq!(branch["ended"], "boundary-equilibrium");
    assert_eq!(branch["special"][0]["kind"], "boundary-equilibrium");
    assert_eq!(branch["special"][0]["label"], "BE1");
    assert!(branch["special"][0]["r"].as_f64().unwrap().abs() < 1e-12);
    assert_eq!(branch["points"][0]["r"], 0.2);
    assert_eq!(branch["points"][0]["stability"], "unstable");
}

#[test]
fn where_there_is_one_equilibrium_no_other_is_told_of() {
    let line = "equilibria van-der-pol --along nu=1..0.5";
    assert_eq!(
        json(&format!("{line} --json"))["others"],
        serde_json::json!([])
    );
    let text = stickslip(&words(line)).stdout;
    assert!(!text.contains("more, which"), "{text}");
}

#[test]
fn what_smoothing_made_is_called_so() {
    let line = "equilibria belt-oscillator --smooth arctan:1e2 --along v_dr=0.1..0.03";
    let branch = json(&format!("{line} --json"));
    let hopf = &branch["special"][0];
    assert_eq!(
        (&hopf["kind"], &hopf["artefact"]),
        (&"hopf".into(), &true.into())
    );
    assert!((hopf["period"].as_f64().unwrap() / std::f64::consts::TAU - 1.0).abs() < 1e-9);
    let points = branch["points"].as_array().unwrap();
    let marks: Vec<bool> = points
        .iter()
        .map(|point| point["artefact"] == true)
        .collect();
    let stable: Vec<bool> = points
        .iter()
        .map(|point| point["stability"] == "stable")
        .collect();
    assert_eq!(marks, stable, "only the stable ones are not real");
    let text = stickslip(&words(line)).stdout;
    assert!(
        text.contains("artefact of smoothing, arctan:100 only"),
        "{text}"
    );
}

/// The exact drill string has the same two points of rest, whatever its friction was smoothed by.
#[test]
fn what_is_real_is_not_called_an_artefact() {
    for line in [
        "equilibria drill-string --smooth quartic:0.1 --json",
        "equilibria belt-oscillator --smooth arctan:1e5 --json",
        "equilibria belt-pair --smooth tanh:1e3 --json",
        "equilibria van-der-pol --json",
    ] {
        let list = json(line);
        let all = list["equilibria"].as_array().unwrap();
        assert!(
            !all.is_empty() && all.iter().all(|one| one["artefact"] == false),
            "{line}: {all:?}"
        );
    }
}

#[test]
fn files_hold_every_point() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("equilibria");
    let place = folder.to_str().unwrap();
    for (line, head) in [
        ("equilibria drill-string", "psi,omega,eigenvalue_1_re"),
        (
            "equilibria drill-string --along eta=4..3",
            "eta,psi,omega,eigenvalue_1_re",
        ),
    ] {
        let answer = stickslip(&[words(line), vec!["--out", place]].concat());
        assert_eq!(answer.code, Some(0), "{line}: {}", answer.stderr);
        let sheet = std::fs::read_to_string(folder.join("equilibria.csv")).unwrap();
        assert!(sheet.starts_with(head), "{sheet}");
        let columns: Vec<usize> = sheet.lines().map(|row| row.split(',').count()).collect();
        assert!(
            columns.len() > 1 && columns.iter().all(|&n| n == columns[0]),
            "{line}"
        );
    }
}
