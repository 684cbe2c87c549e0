//! What the program refuses, and how.

use crate::{stickslip, words};

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
            &["`frobnicate`", "models, laws, simulate, orbit, branch"],
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
            &["`van-der-pol` has no contact"],
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
