use super::{NONE, of_belt, of_law};

#[test]
fn each_state_has_one_equation() {
    assert_eq!(
        of_belt("der(x) = v;", ""),
        ["state `x` has no equation: add `der(x) = ...;`"]
    );
    assert_eq!(
        of_belt("der(x) = v;", "der(x) = v; der(x) = -v;"),
        ["second equation for `der(x)`; keep one"]
    );
}

#[test]
fn only_states_have_derivatives() {
    assert_eq!(
        of_belt("der(x) = v;", "der(x) = v; der(xx) = v;"),
        ["`xx` is not a state; did you mean `x`?"]
    );
    assert_eq!(
        of_belt("der(x) = v;", "der(x) = v; der(k) = v;"),
        ["`k` is a parameter, not a state; only states have equations"]
    );
}

const NONLINEAR: &str = "friction forces must enter linearly, so that the sticking force can be solved for; \
     here one is multiplied by a force, stands in a denominator or inside a function";

#[test]
fn forces_enter_linearly() {
    let told = |right_side| of_belt("(F - stretched) / mass", right_side);
    let refused = |place| [format!("`{place}`: {NONLINEAR}")];
    assert_eq!(told("F * F / mass / F_s"), refused("F * F"));
    assert_eq!(told("F_s / F * F_s / mass"), refused("F_s / F"));
    assert_eq!(told("powi(F, 2) / F_s / mass"), refused("powi(F, 2)"));
    assert_eq!(told("tanh(F / F_s) * F_s / mass"), refused("tanh(F / F_s)"));
    assert_eq!(
        told("-(F + (F - stretched) * 2.0) / mass - F * x / mass / x"),
        NONE
    );
}

#[test]
fn forces_enter_linearly_through_abbreviations() {
    assert_eq!(
        of_belt(
            "let stretched = k * x;",
            "let net = F - k * x; let stretched = net * net / F_s;"
        ),
        [format!("`net * net`: {NONLINEAR}")]
    );
    assert_eq!(
        of_belt(
            "let stretched = k * x;",
            "let net = F / k; let stretched = k * (x - net);"
        ),
        NONE
    );
}

#[test]
fn laws_read_no_force() {
    let second = "friction G = Coulomb { level: F_s * (1.0 + F) } opposing v; let stretched = G +";
    assert_eq!(
        of_belt("let stretched =", second),
        [
            "`F` is or contains a friction force, and the law and speed of `G` cannot depend on one: \
          a normal force is a formula of states and parameters, or a `press`"
        ]
    );
}

#[test]
fn a_law_has_both_lines_once() {
    assert_eq!(
        of_law("param a; stick = a;"),
        ["law `L` has no force while sliding: add `slip(s) = ...;`"]
    );
    assert_eq!(
        of_law("param a; slip(s) = a;"),
        ["law `L` has no force at rest: add `stick = ...;`"]
    );
    assert_eq!(
        of_law("param a; stick = a; stick = a; slip(s) = a;"),
        ["second `stick` line; keep one"]
    );
}

#[test]
fn at_rest_there_is_no_speed() {
    assert_eq!(
        of_law("param a; stick = a * s; slip(s) = a;"),
        [
            "`s` is the sliding speed, and at rest there is none: `stick` is a formula of the parameters"
        ]
    );
}
