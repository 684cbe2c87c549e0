use super::{NONE, of_model};

const CHAIN: &str = "
    state x[4]: m = 0.1;
    state v[4]: m/s = 0.0;
    param mass: kg = 1.0 where mass > 0.0;
    param k: N/m = 1.0 where k > 0.0;
    param level[4]: N = 0.3 where level >= 0.0;
    for i in 0..4 {
        friction F[i]: N = Coulomb { level: level[i] } opposing v[i];
        der(x[i]) = v[i];
    }
    for i in 0..=2 {
        let spring[i] = k * (x[i + 1] - x[i]);
    }
    der(v[0]) = (spring[0] - k * x[0] + F[0]) / mass;
    for i in 1..3 {
        der(v[i]) = (spring[i] - spring[i - 1] + F[i]) / mass;
    }
    der(v[3]) = (F[3] - spring[2]) / mass;
";

fn of_chain(text: &str, replacement: &str) -> Vec<String> {
    assert!(CHAIN.contains(text), "the chain has no `{text}`");
    let told = of_model(&CHAIN.replacen(text, replacement, 1));
    // What a replacement no longer uses is not in question, but in one case.
    let unused =
        |message: &String| message.contains("is never used") && !replacement.contains("level[0] }");
    told.into_iter()
        .filter(|message| !unused(message))
        .collect()
}

#[test]
fn nothing_is_said_about_a_good_chain() {
    assert_eq!(of_model(CHAIN), NONE);
    assert_eq!(
        of_chain("x[i + 1] - x[i]", "x[(i + 1) % 4] - x[2 * i - i]"),
        NONE
    );
}

#[test]
fn indices_lie_within_their_arrays() {
    assert_eq!(
        of_chain("for i in 0..=2", "for i in 0..=3"),
        ["`x[4]` is out of range: `x` has the elements 0 to 3"]
    );
    assert_eq!(
        of_chain("for i in 1..3", "for i in 0..3"),
        [
            "`spring[-1]` is out of range: `spring` has the elements 0 to 2",
            "second equation for `der(v[0])`; keep one"
        ]
    );
    assert_eq!(
        of_chain("for i in 1..3", "for i in 1..2"),
        ["state `v[2]` has no equation: add `der(v[2]) = ...;`",]
    );
    assert_eq!(
        of_chain("(spring[0] -", "(sprig[0] -"),
        ["unknown array `sprig`; did you mean `spring`?"]
    );
    assert_eq!(
        of_chain("- k * x[0]", "- k[0] * x[0]"),
        ["`k` is one parameter, not an array: write it without an index"]
    );
    assert_eq!(
        of_chain("- k * x[0]", "- k * x"),
        ["`x` is an array: write which element, as in `x[0]`"]
    );
    assert_eq!(
        of_chain("- k * x[0]", "- k * x[0.5]"),
        [
            "`0.5` is no whole number that is known here: an index and the ends of a loop are made of counters of `for`, \
             whole numbers, `+ - * %` and parentheses"
        ]
    );
    assert_eq!(
        of_chain("der(v[3])", "der(v[4])"),
        [
            "`v[4]` is out of range: `v` has the elements 0 to 3",
            "state `v[3]` has no equation: add `der(v[3]) = ...;`"
        ]
    );
}

#[test]
fn loops_count_whole_numbers() {
    assert_eq!(
        of_chain("for i in 1..3", "for i in 3..1"),
        ["nothing is repeated: `i` would begin at 3 and end before 1",]
    );
    assert_eq!(
        of_chain("for i in 1..3", "for i = 1..3"),
        ["expected `in` before `=`; a loop has the form `for i in 0..10 { der(x[i]) = v[i]; }`"]
    );
    assert_eq!(
        of_chain(
            "for i in 1..3 {",
            "for j in 0..200 { for l in 0..200 { let big[j * l] = k; } } for i in 1..3 {"
        ),
        ["too many repetitions: 10000 are the most, those of the loops around it counted"]
    );
    assert_eq!(
        of_chain(
            "for i in 1..3 {",
            "for j in 0..9223372036854775807 { } for i in 1..3 {"
        ),
        ["too many repetitions: 10000 are the most, those of the loops around it counted"]
    );
    assert_eq!(
        of_chain("for i in 1..3", "for i in v"),
        [
            "expected a range of whole numbers such as `0..10`, not `v`; \
          a loop has the form `for i in 0..10 { der(x[i]) = v[i]; }`"
        ]
    );
    assert_eq!(
        of_chain("param mass", "param i: N = 2.0; param mass")[..1],
        ["`i` counts in this `for` and is a parameter too; rename one"]
    );
    assert_eq!(
        of_chain("state x[4]", "state x[0]")[..1],
        ["`x` would have 0 elements; an array has 1 to 10000"]
    );
    assert_eq!(
        of_chain("der(x[i]) = v[i];", "der(x[i]) = v[i]; state y = 0.0;"),
        [
            "`state` cannot stand inside `for`: declare an array as `state x[10] = 0.0;` or `param k[10] = 1.0;` outside"
        ]
    );
}

#[test]
fn a_mistake_in_a_loop_is_told_once() {
    assert_eq!(
        of_chain(
            "- spring[i - 1] + F[i]",
            "- spring[i - 1] + F[i] * signum(v[i])"
        ),
        [
            "`signum` is not smooth, and no switch is declared for its jump; \
             write dry friction as `friction F = Law { .. } opposing speed;`, a wall or a gap as \
             `press N = Law { .. } closing gap;`"
        ]
    );
    assert_eq!(
        of_chain("der(x[i]) = v[i];", "der(x[i]) v[i];"),
        ["expected `=` before `v`; the line has the form `der(x) = v;`"]
    );
}

#[test]
fn elements_are_named_as_they_are_written() {
    assert_eq!(
        of_chain(
            "der(v[3]) = (F[3] - spring[2]) / mass",
            "der(v[3]) = (F[3] - spring[2])"
        ),
        ["unit mismatch: `der(v[3])` is in m/s^2, but `(F[3] - spring[2])` is in N"]
    );
    assert_eq!(
        of_chain("level[i] }", "level[0] }"),
        [
            "parameter `level[1]` is never used in this model; use it or remove its line",
            "parameter `level[2]` is never used in this model; use it or remove its line",
            "parameter `level[3]` is never used in this model; use it or remove its line"
        ]
    );
}
