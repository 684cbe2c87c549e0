//! What the program answers of driven models, and of sections that are not met.

use serde_json::Value;

use crate::{stickslip, words};

fn text(line: &str) -> String {
    let answer = stickslip(&words(line));
    assert_eq!(answer.code, Some(0), "{line}: {}", answer.stderr);
    answer.stdout
}

fn json(line: &str) -> Value {
    serde_json::from_str(&text(&format!("{line} --json"))).unwrap()
}

fn refused(line: &[&str], part: &str) {
    let answer = stickslip(line);
    assert_eq!(
        (answer.code, answer.stdout.as_str()),
        (Some(2), ""),
        "{line:?}"
    );
    assert!(answer.stderr.contains(part), "{line:?}: {}", answer.stderr);
}

#[test]
fn a_frequency_response_is_one_command() {
    let line = "branch forced-belt --along omega=0.6..0.62 --harmonics 1,3 --show x,v";
    let branch = json(line);
    let points = branch["points"].as_array().unwrap();
    for point in points {
        let known = point["harmonics"].as_array().unwrap();
        assert_eq!(
            (&known[0]["order"], &known[1]["order"]),
            (&1.into(), &3.into())
        );
        let omega = point["r"].as_f64().unwrap();
        for (h, harmonic) in [(1.0, &known[0]), (3.0, &known[1])] {
            let value = |kind: &str, state: &str| harmonic[kind][state].as_f64().unwrap();
            let [x, v] = ["x", "v"].map(|state| value("amplitude", state));
            // der(x) = v at each harmonic.
            assert!((v - h * omega * x).abs() <= 1e-8, "{harmonic}");
            assert!(value("error", "x") < 1e-7, "{harmonic}");
            assert!(harmonic["amplitude"].get("phi").is_none());
        }
    }
    let shown = text(line);
    for head in ["amplitude_1 x (m)", "phase_3 v (rad)", "max |v| (m/s)"] {
        assert!(shown.contains(head), "{head}: {shown}");
    }
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("response");
    let out = folder.to_str().unwrap();
    text(&format!("{line} --out {out}"));
    let read = |name: &str| std::fs::read_to_string(folder.join(name)).unwrap();
    let table = read("branch.csv");
    let (head, rows) = table.split_once('\n').unwrap();
    assert!(
        head.contains("amplitude_1 x (m),phase_1 x (rad),error_1 x (m)"),
        "{head}"
    );
    assert!(
        rows.lines()
            .all(|row| row.split(',').count() == head.split(',').count())
    );
    assert!(read("branch.svg").contains("\"amplitude_3 v (m/s) against"));
}

#[test]
fn an_orbit_under_a_drive_has_its_fundamental() {
    let orbit = json("orbit forced-belt");
    assert_eq!(orbit["harmonics"].as_array().unwrap().len(), 1);
    assert!(text("orbit forced-belt").contains("harmonic"));
    assert!(json("orbit belt-oscillator").get("harmonics").is_none());
    let asked = json("orbit belt-oscillator --harmonics 2");
    assert_eq!(asked["harmonics"][0]["order"], 2);
    for wrong in ["0", "1,1", "1,x", "1,"] {
        refused(
            &["orbit", "forced-belt", "--harmonics", wrong],
            "--harmonics",
        );
    }
    refused(
        &words("branch forced-belt --along omega=0.6..0.62 --show speed"),
        "`speed`",
    );
}

#[test]
fn a_diagram_under_a_drive_is_stroboscopic() {
    let line = "diagram forced-belt --along omega=0.6..0.61 --values 2 --settle 60 --points 8";
    let diagram = json(line);
    assert_eq!(diagram["section"], "phi=0 up");
    for value in diagram["sweeps"][0]["values"].as_array().unwrap() {
        assert_eq!(value["motion"], "period-1");
        assert_eq!(value["points"]["phi"][3], 0.0);
    }
    let section = ["orbit", "forced-belt", "--section", "phi=0 down"];
    refused(&section, "only advances");
    refused(
        &["orbit", "forced-belt", "--section", "der(phi)=0"],
        "only advances",
    );
    let orbit = json("orbit forced-belt --section phi=1");
    let points = orbit["section"]["points"].as_array().unwrap();
    assert_eq!((points.len(), &points[0]["state"]["phi"]), (1, &1.0.into()));
}

#[test]
fn what_is_not_met_is_explained() {
    let never = "--section v=9";
    let motion = format!("simulate belt-oscillator --time 20 {never}");
    assert!(
        text(&motion).contains("0 points: v stays between "),
        "{}",
        text(&motion)
    );
    let reason = json(&motion)["section"]["reason"].clone();
    assert!(reason.as_str().unwrap().contains("for 20 s"), "{reason}");
    let line = "diagram belt-oscillator --along v_dr=0.1..0.3 --values 2 --settle 2 --points 4";
    let diagram = format!("{line} {never}");
    let shown = text(&diagram);
    assert!(
        shown.contains("elsewhere: at v_dr = 0.100000, the motion does not meet"),
        "{shown}"
    );
    assert!(shown.contains("keeps to these bounds"), "{shown}");
    let value = json(&diagram)["sweeps"][0]["values"][0].clone();
    assert!(
        value["reason"]
            .as_str()
            .unwrap()
            .contains("v stays between"),
        "{value}"
    );
    let there = json("simulate belt-oscillator --time 20 --section v=0");
    assert!(there["section"].get("reason").is_none());
}
