//! What `stickslip diagram` and `--section` answer.

use serde_json::Value;

use crate::{stickslip, words};

fn json(line: &[&str]) -> Value {
    let answer = stickslip(line);
    assert_eq!(answer.code, Some(0), "{line:?}: {}", answer.stderr);
    serde_json::from_str(&answer.stdout).unwrap()
}

fn refused(line: &[&str], parts: &[&str]) {
    let answer = stickslip(line);
    assert_eq!(answer.code, Some(2), "{line:?}: {}", answer.stderr);
    assert_eq!(answer.stdout, "", "{line:?}");
    for part in parts {
        assert!(
            answer.stderr.contains(part),
            "{line:?} lacks {part:?}: {}",
            answer.stderr
        );
    }
}

const SHORT: &str =
    "diagram belt-oscillator --along v_dr=0.1..0.3 --values 3 --settle 4 --points 6";

#[test]
fn the_shape_of_a_diagram() {
    let line = format!("{SHORT} --lyapunov 4 --json");
    let diagram = json(&words(&line));
    assert_eq!(diagram["section"], "der(x)=0 up");
    assert_eq!(
        (&diagram["along"]["from"], &diagram["units"]["x"]),
        (&0.1.into(), &"m".into())
    );
    let sweeps = diagram["sweeps"].as_array().unwrap();
    assert_eq!(
        (&sweeps[0]["sweep"], &sweeps[1]["sweep"]),
        (&"up".into(), &"down".into())
    );
    let values = sweeps[1]["values"].as_array().unwrap();
    let r: Vec<f64> = values.iter().map(|v| v["r"].as_f64().unwrap()).collect();
    assert_eq!(r, [0.3, 0.2, 0.1]);
    let one = &values[1];
    assert_eq!(
        (&one["motion"], &one["period_count"]),
        (&"period-1".into(), &1.into())
    );
    assert_eq!(one["lyapunov"]["exponent"], "-inf", "superstable");
    let least = one["points"]["x"][5].as_f64().unwrap();
    assert!((least + 0.555432690).abs() < 1e-8, "{least}");
    assert_eq!(one["points"]["v"].as_array().unwrap().len(), 6);
}

#[test]
fn a_diagram_fills_its_folder() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("diagram");
    let answer = stickslip(&[words(SHORT), vec!["--out", folder.to_str().unwrap()]].concat());
    assert_eq!(answer.code, Some(0), "{}", answer.stderr);
    assert!(answer.stdout.contains("period-1"), "{}", answer.stdout);
    let read = |name: &str| std::fs::read_to_string(folder.join(name)).unwrap();
    let points = read("points.csv");
    assert!(
        points.starts_with("sweep,v_dr (m/s),x (m),v (m/s)\nup,0.1,"),
        "{points}"
    );
    assert_eq!(points.lines().count(), 1 + 2 * 3 * 6);
    let values = read("values.csv");
    assert!(
        values.starts_with("sweep,v_dr (m/s),motion,lyapunov (1/s),lyapunov_error (1/s),min_x (m)"),
        "{values}"
    );
    assert_eq!(values.lines().count(), 1 + 2 * 3);
    assert!(read("diagram.json").contains("\"sweeps\""));
    let picture = read("diagram.svg");
    assert!(
        picture.contains("aria-label=\"x (m) against v_dr (m/s)\""),
        "{picture}"
    );
}

#[test]
fn points_of_a_motion_and_of_an_orbit() {
    let orbit = json(&[
        "orbit",
        "belt-oscillator",
        "--section",
        "v=0.1 both",
        "--json",
    ]);
    let section = &orbit["section"];
    assert_eq!(section["surface"], "v=0.1 both");
    let points = section["points"].as_array().unwrap();
    assert_eq!(points.len(), 2);
    for point in points {
        assert!((point["state"]["v"].as_f64().unwrap() - 0.1).abs() < 1e-12);
    }
    let motion = json(&words(
        "simulate van-der-pol --section der(v)=0 --time 30 --json",
    ));
    let times: Vec<f64> = motion["section"]["points"]
        .as_array()
        .unwrap()
        .iter()
        .map(|point| point["time"].as_f64().unwrap())
        .collect();
    assert!(times.len() > 3 && times.is_sorted(), "{times:?}");
    let plain = json(&words("orbit belt-oscillator --json"));
    assert!(plain.get("section").is_none());
}

#[test]
fn wrong_words_are_named() {
    let with = |more: &'static str| [words(SHORT), words(more)].concat();
    refused(&words("diagram belt-oscillator"), &["--along"]);
    refused(&with("--sweep upp"), &["`upp`", "did you mean `up`?"]);
    refused(&with("--lyapunov 1"), &["--lyapunov 1", "from 2"]);
    refused(&with("--threads 0"), &["--threads 0", "from 1"]);
    refused(&with("--show speed"), &["`speed`", "x, v"]);
    refused(&with("--sectoin v=0"), &["did you mean `--section`?"]);
    refused(
        &words("diagram belt-oscillator --along v_dr=0.1..0.3 --values 2.5"),
        &["--values 2.5", "whole number"],
    );
    for (section, parts) in [
        ("speed=0.1", ["`speed`", "x, v"]),
        ("v=0.1 dwon", ["`dwon`", "did you mean `down`?"]),
        ("v=0.1 up up", ["too many", "`both`"]),
        ("v", ["no assignment", "name=value"]),
        ("v=zero", ["`zero`", "not a number"]),
        ("der(x)=1", ["vanishes", "`der(x)=0`"]),
        ("der(place)=0", ["`place`", "x, v"]),
    ] {
        refused(&["orbit", "belt-oscillator", "--section", section], &parts);
    }
}
