use super::{NONE, of_belt};

fn told(bounds: &str) -> Vec<String> {
    of_belt("where k > 0.0", bounds)
}

#[test]
fn every_form_is_accepted() {
    for bounds in [
        "where k > 0",
        "where k >= -1.0",
        "where k < 2",
        "where k <= 1.0",
        "where 0.0 < k",
        "where 0 < k <= 1.0",
        "where -1e3 <= k < 1e3",
        "where 1.0 <= k <= 1.0",
        "",
    ] {
        assert_eq!(told(bounds), NONE, "{bounds}");
    }
}

#[test]
fn defaults_keep_their_bounds() {
    assert_eq!(
        told("where 0 <= k < 1"),
        ["default 1.0 of `k` breaks its own bound `0 <= k < 1`"]
    );
    assert_eq!(
        told("where k < -2.5"),
        ["default 1.0 of `k` breaks its own bound `k < -2.5`"]
    );
}

#[test]
fn intervals_are_not_empty() {
    assert_eq!(
        told("where 2.0 < k < 1.0"),
        ["no value of `k` can keep the bound `2.0 < k < 1.0`"]
    );
    assert_eq!(
        told("where 1.0 < k <= 1.0"),
        ["no value of `k` can keep the bound `1.0 < k <= 1.0`"]
    );
}

#[test]
fn bounds_are_about_their_own_parameter() {
    assert_eq!(
        told("where F_s > 0.0"),
        ["the bounds of `k` are on `F_s`; write them on `k`"]
    );
}

#[test]
fn other_forms_are_shown_the_right_one() {
    assert_eq!(
        told("where k > 0.0 && k < 2.0"),
        ["`&&` joins no bounds: write both ends of an interval as `0.0 <= k < 1.0`"]
    );
    assert_eq!(
        told("where 2.0 > k > 0.0"),
        ["write the smaller end first, as in `0.0 <= x < 1.0`"]
    );
    assert_eq!(
        told("where k > 0.0 < 2.0"),
        ["write an interval as `0.0 < k < 1.0`"]
    );
    assert_eq!(
        told("where k = 1.0"),
        [
            "expected one of `>`, `>=`, `<`, `<=` before `=`; the line has the form `param k: N/m = 1.0 where k > 0.0;`"
        ]
    );
    assert_eq!(
        told("where k > 1e999"),
        ["`1e999` is too large for an `f64`, of which the largest is 1.8e308"]
    );
}
