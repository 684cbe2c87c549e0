//! What smoothing costs, from outside.

use serde_json::Value;

use crate::{stickslip, words};

fn json(line: &str) -> Value {
    let answer = stickslip(&words(line));
    assert_eq!(answer.code, Some(0), "{line}: {}", answer.stderr);
    serde_json::from_str(&answer.stdout).unwrap()
}

#[test]
fn every_smoothing_is_measured_and_predicted() {
    let trade = json("trade belt-oscillator --json");
    let end = &trade["ends"][0];
    let kinds = end["smoothings"].as_array().unwrap();
    let arctan = kinds.iter().find(|k| k["kernel"] == "arctan").unwrap();
    let point = &arctan["points"][3];
    assert_eq!(point["smoothing"], "arctan:1e5");
    assert!((point["e_f"].as_f64().unwrap() / 4.11e-3 - 1.0).abs() < 2e-3);
    let predicted = &point["predicted"];
    assert_eq!(predicted["asymptotic"], true);
    let ratio = predicted["signed"]["frequency"].as_f64().unwrap()
        / point["signed"]["frequency"].as_f64().unwrap();
    assert!((ratio - 1.0).abs() < 0.05, "{ratio}");
    assert!((arctan["fits"]["frequency"]["a"].as_f64().unwrap() / -0.602 - 1.0).abs() < 0.02);
    let quartic = kinds.iter().find(|k| k["kernel"] == "quartic").unwrap();
    assert!(quartic["refused"].as_str().unwrap().contains("never stick"));
    assert_eq!(end["work_precision"][0]["dynamics"], "exact");
}

#[test]
#[ignore = "long"]
fn an_accuracy_over_a_range_is_judged_at_its_worst_end() {
    let trade = json("trade belt-oscillator --along v_dr=0.1..0.2 --accuracy 1e-3 --json");
    let worst = trade["worst"].as_array().unwrap();
    assert_eq!(worst.len(), 5);
    for need in worst {
        assert_eq!(need["end"], 0, "the slowest belt is the worst: {need}");
        assert!(need["need"]["setting"]["error"].as_f64().unwrap() <= 1e-3);
    }
    let text = stickslip(&words("trade belt-oscillator --accuracy 1e-3")).stdout;
    for part in [
        "for the accuracy 0.001",
        "arctan:2.5",
        "exact  ",
        "e = b size^a",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
}

#[test]
fn what_cannot_be_traded_says_why() {
    for (line, part) in [
        ("trade van-der-pol", "no contact"),
        ("trade belt-oscillator --smooth quartic:0.1", "never stick"),
        (
            "trade belt-oscillator --smooth arctan:1e5 --along smooth=1e2..1e3",
            "takes a parameter",
        ),
    ] {
        let answer = stickslip(&words(line));
        assert_eq!(
            (answer.code, answer.stdout.as_str()),
            (Some(2), ""),
            "{line}"
        );
        assert!(answer.stderr.contains(part), "{line}: {}", answer.stderr);
    }
}

#[test]
fn an_orbit_says_which_method_was_chosen() {
    let method = |line: &str| json(line)["method"].as_str().unwrap().to_owned();
    let exact = method("orbit belt-oscillator --accuracy 1e-6 --json");
    assert!(exact.starts_with("exact dynamics, chosen"), "{exact}");
    let copy = method("orbit belt-oscillator --smooth tanh:1e4 --json");
    assert!(copy.starts_with("a smooth copy, as asked"), "{copy}");
    let smooth = method("orbit van-der-pol --json");
    assert!(smooth.starts_with("smooth dynamics, chosen"), "{smooth}");
}
