//! What `stickslip branch --and` answers.

use serde_json::Value;

use crate::{stickslip, words};

const GRAZE: &str = "branch drill-string --along eta=4..6 --and zeta=0.05..0.06";

#[test]
fn the_shape_of_a_curve() {
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR")).join("curve");
    let place = folder.to_str().unwrap();
    let line = [words(GRAZE), vec!["--json", "--out", place]].concat();
    let answer = stickslip(&line);
    assert_eq!(answer.code, Some(0), "{}", answer.stderr);
    let curve: Value = serde_json::from_str(&answer.stdout).unwrap();
    assert_eq!(
        (&curve["kind"], &curve["of"], &curve["ended"]),
        (
            &"grazing-sliding".into(),
            &"GS1".into(),
            &"reached-end".into()
        )
    );
    assert_eq!(
        (&curve["along"]["name"], &curve["and"]["name"]),
        (&"eta".into(), &"zeta".into())
    );
    let points = curve["points"].as_array().unwrap();
    let first = &points[0]["at"];
    assert!((first["eta"].as_f64().unwrap() / 4.611_989_021_286_665 - 1.0).abs() < 1e-9);
    assert_eq!(points[points.len() - 1]["at"]["zeta"], 0.06);
    let sheet = std::fs::read_to_string(folder.join("curve.csv")).unwrap();
    assert!(sheet.starts_with("eta,zeta,period,psi,omega,"), "{sheet}");
    assert_eq!(sheet.lines().count(), points.len() + 1);
    let picture = std::fs::read_to_string(folder.join("curve.svg")).unwrap();
    assert!(picture.contains('ζ') && picture.contains('η'));
    let text = stickslip(&words(GRAZE)).stdout;
    assert!(
        text.contains("grazing-sliding points (GS1) in eta and zeta"),
        "{text}"
    );
}

#[test]
fn wrong_words_are_named() {
    let with = |line: &str, code: i32, parts: &[&str]| {
        let answer = stickslip(&words(line));
        assert_eq!(answer.code, Some(code), "{line}: {}", answer.stderr);
        for part in parts {
            assert!(
                answer.stderr.contains(part),
                "{line} lacks {part}: {}",
                answer.stderr
            );
        }
    };
    let drill = "branch drill-string --along eta=4..6";
    with(
        &format!("{drill} --and zetaa=0.05..0.06"),
        2,
        &["`zetaa`", "did you mean `zeta`?"],
    );
    with(
        &format!("{drill} --and eta=4..5"),
        2,
        &["`--along` follows already"],
    );
    with(&format!("{drill} --and zeta=0.05..-1"), 2, &["bound"]);
    with(&format!("{drill} --and zeta=0.05"), 2, &["no range"]);
    with(&format!("{drill} --and smooth=1..2"), 2, &["--smooth"]);
    with(
        &format!("{drill} --and zeta=0.05..0.06 --set zeta=0.1"),
        2,
        &["contradicts", "0.05"],
    );
    with(
        &format!("{drill} --and zeta=0.05..0.06 --switch flips"),
        2,
        &["--switch flips"],
    );
    with(&format!("{drill} --of PD1"), 2, &["--of PD1", "add `--and"]);
    with(
        &format!("{GRAZE} --of PD1 --quiet"),
        1,
        &["no special point PD1", "GS1"],
    );
    with("branch drill-string --and zeta=0.05..0.06", 2, &["--along"]);
}

/// The layer of a copy has a Hopf point; where it lies depends on neither mass nor spring, and its period is that of both.
#[test]
fn the_shape_of_a_curve_of_equilibria() {
    let copy = "belt-oscillator --smooth arctan:1e2 --along v_dr=0.1..0.03 --and m=1..4";
    let answer = stickslip(&words(&format!("equilibria {copy} --json --quiet")));
    assert_eq!(answer.code, Some(0), "{}", answer.stderr);
    let curve: Value = serde_json::from_str(&answer.stdout).unwrap();
    assert_eq!(
        (&curve["kind"], &curve["of"]),
        (&"hopf".into(), &"HB1".into())
    );
    let points = curve["points"].as_array().unwrap();
    let number = |point: &Value, of: [&str; 2]| point[of[0]][of[1]].as_f64().unwrap();
    let begin = number(&points[0], ["at", "v_dr"]);
    for point in points {
        let period = std::f64::consts::TAU * number(point, ["at", "m"]).sqrt();
        assert!((number(point, ["at", "v_dr"]) / begin - 1.0).abs() < 1e-9);
        assert!((point["period"].as_f64().unwrap() / period - 1.0).abs() < 1e-9);
        assert_eq!(point["eigenvalues"].as_array().unwrap().len(), 2);
        assert_eq!(point["onset"], "soft");
    }
    // Along its orbits the same point is their end: from there none can be followed.
    let orbits = stickslip(&words(&format!("branch {copy} --quiet")));
    assert_eq!(orbits.code, Some(1));
    assert!(
        orbits.stderr.contains("HB1") && orbits.stderr.contains("two parameters"),
        "{}",
        orbits.stderr
    );
}
