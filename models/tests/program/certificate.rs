//! What `--certify` answers.

use serde_json::Value;

use crate::{stickslip, words};

/// The document that is printed in any case, and the exit code.
fn json(line: &str) -> (Value, Option<i32>, String) {
    let answer = stickslip(&words(line));
    let document = serde_json::from_str(&answer.stdout);
    (document.expect(line), answer.code, answer.stderr)
}

#[test]
fn an_orbit_with_its_radii() {
    let (orbit, code, stderr) = json("orbit drill-string --certify --json");
    assert_eq!((code, stderr.as_str()), (Some(0), ""));
    let certificate = &orbit["certificate"];
    assert_eq!(certificate["kind"], "a posteriori, not rigorous");
    assert_eq!(certificate["certified"], true);
    let number = |value: &Value| value.as_f64().unwrap();
    let off = (number(&orbit["period"]) - 6.530_582_884_211_251).abs();
    let radius = number(&certificate["period_radius"]);
    assert!(off <= radius && radius < 1e-8, "{off:e} {radius:e}");
    assert!(number(&certificate["state_radius"]["psi"]) < 1e-8);
    assert!(number(&certificate["residual"]) >= number(&certificate["integration_error"]));
    let product = ["inverse_norm", "newton_step", "lipschitz"]
        .iter()
        .map(|key| number(&certificate[key]))
        .product::<f64>();
    assert!((product / number(&certificate["h"]) - 1.0).abs() < 1e-12);
    let text = stickslip(&words("orbit belt-pair --smooth cubic:1e4 --certify")).stdout;
    assert!(
        text.contains("certificate (a posteriori, not rigorous): one true orbit"),
        "{text}"
    );
    assert!(text.contains("start v2"), "{text}");
    let plain = stickslip(&words("orbit drill-string --json")).stdout;
    assert!(!plain.contains("certificate"), "{plain}");
}

/// An orbit that hardly attracts: a small residual may be a large error.
#[test]
fn an_orbit_without_a_certificate_is_not_hidden() {
    let line = "orbit van-der-pol --set nu=1e-6 --certify";
    let (orbit, code, stderr) = json(&format!("{line} --json --quiet"));
    assert_eq!(code, Some(1), "{stderr}");
    let begin = "error: the orbit is not certified: h = |DF⁻¹| |DF⁻¹F| Lip(DF) = ";
    assert!(stderr.starts_with(begin), "{stderr}");
    let certificate = &orbit["certificate"];
    assert_eq!(certificate["certified"], false);
    assert!(certificate["h"].as_f64().unwrap() > 0.5);
    assert!(certificate["reason"].is_string() && certificate["period_radius"].is_null());
    assert!((orbit["period"].as_f64().unwrap() / std::f64::consts::TAU - 1.0).abs() < 1e-8);
    let answer = stickslip(&words(line));
    assert_eq!(answer.code, Some(1));
    assert!(answer.stdout.contains("period") && answer.stdout.contains("no certificate: "));
}

#[test]
fn equilibria_with_their_boxes() {
    for line in [
        "equilibria belt-oscillator",
        "equilibria belt-oscillator --smooth arctan:1e5",
        "equilibria drill-string",
        "equilibria drill-string --smooth quartic:0.1",
        "equilibria belt-pair",
        "equilibria van-der-pol",
        "equilibria bristle-oscillator",
    ] {
        let (list, code, stderr) = json(&format!("{line} --certify --json"));
        assert_eq!((code, stderr.as_str()), (Some(0), ""), "{line}");
        for one in list["equilibria"].as_array().unwrap() {
            let certificate = &one["certificate"];
            assert_eq!(certificate["kind"], "rigorous");
            for (name, value) in one["state"].as_object().unwrap() {
                let [low, high] =
                    ["min", "max"].map(|end| certificate["box"][end][name].as_f64().unwrap());
                let value = value.as_f64().unwrap();
                let spare = 1e-12;
                assert!(
                    low <= high && high - low < 1e-9,
                    "{line}: {name} from {low} to {high}"
                );
                assert!(
                    low - spare <= value && value <= high + spare,
                    "{line}: {name} = {value}"
                );
            }
        }
    }
    let text = stickslip(&words("equilibria belt-oscillator --certify")).stdout;
    assert!(
        text.contains("one equilibrium, and only one") && text.contains("0.62"),
        "{text}"
    );
}

#[test]
fn equilibria_that_are_not_proven_are_listed() {
    let (list, code, stderr) = json("equilibria belt-oscillator --set v_dr=0 --certify --json");
    assert_eq!(code, Some(1));
    assert!(
        stderr.contains(
            "1 of 1 equilibria are not proven: the relative speed of `F` may vanish there"
        ),
        "{stderr}"
    );
    assert_eq!(list["equilibria"][0]["certificate"]["certified"], false);
    assert_eq!(list["equilibria"][0]["set"]["dimension"], 1);
    let text = stickslip(&words("equilibria belt-oscillator --set v_dr=0 --certify")).stdout;
    assert!(text.contains("number 1 is not proven: "), "{text}");
}

#[test]
fn a_branch_has_no_proofs() {
    let answer = stickslip(&words(
        "equilibria belt-oscillator --along v_dr=0.2..0.1 --certify",
    ));
    assert_eq!((answer.code, answer.stdout.as_str()), (Some(2), ""));
    assert!(
        answer.stderr.contains("leave `--along` out"),
        "{}",
        answer.stderr
    );
    let answer = stickslip(&words(
        "branch belt-oscillator --along v_dr=0.2..0.1 --certify",
    ));
    assert_eq!(answer.code, Some(2));
    assert!(
        answer
            .stderr
            .contains("`--certify` is an option of `orbit`"),
        "{}",
        answer.stderr
    );
}
