//! What a scene needs, from outside.

use serde_json::Value;

use crate::{stickslip, words};

#[test]
fn the_least_is_told_in_words_and_in_numbers() {
    let text = stickslip(&words("needs belt-oscillator --accuracy 1e-2"));
    assert_eq!(text.code, Some(0), "{}", text.stderr);
    for part in [
        "the least that answers to 0.01",
        "F        switches",
        "fewest steps: exact",
        "5 of 5 parameters matter",
    ] {
        assert!(text.stdout.contains(part), "{part}: {}", text.stdout);
    }
    let answer = stickslip(&words("needs belt-oscillator --accuracy 1e-2 --json"));
    let needs: Value = serde_json::from_str(&answer.stdout).unwrap();
    assert_eq!(needs["contacts"][0]["role"], "switches");
    assert_eq!(needs["cheapest"], "exact");
    for copy in needs["computed"]["copies"].as_array().unwrap() {
        if let Some(error) = copy["setting"]["error"].as_f64() {
            assert!(error <= 1e-2, "{copy}");
        }
    }
}

#[test]
fn what_makes_no_sense_is_refused() {
    for (line, part) in [
        (
            "needs belt-oscillator --smooth arctan:1e5",
            "leave out `--smooth`",
        ),
        (
            "needs belt-oscillator --along v_d=0.1..0.2",
            "did you mean `v_dr`",
        ),
        ("needs belt-oscillator --resume", "leave it out"),
        ("needs", "no model is named"),
    ] {
        let answer = stickslip(&words(line));
        assert_eq!(answer.code, Some(2), "{line}");
        assert!(answer.stderr.contains(part), "{line}: {}", answer.stderr);
    }
}
