use super::{NONE, of_belt, of_law};

fn told(formula: &str) -> Vec<String> {
    of_belt("= k * x;", &format!("= {formula};"))
}

#[test]
fn smooth_formulas_are_accepted() {
    for formula in [
        "k * x + 0.0 * (sin(x) + powi(v, 3) - powf(2.0, 0.5))",
        "k * x * std::f64::consts::PI",
        "-k * -x",
        "k * x * 2 * 1e-3 * 1_000.0f64",
        "k * x * exp(-powi(x, -2))",
    ] {
        let free: Vec<String> = told(formula)
            .into_iter()
            .filter(|message| !message.starts_with("unit mismatch"))
            .collect();
        assert_eq!(free, NONE, "{formula}");
    }
}

#[test]
fn kinks_are_shown_the_way_out() {
    let friction = "is not smooth, and no switch is declared for its jump; \
         write dry friction as `friction F = Law { .. } opposing speed;`, a wall or a gap as \
             `press N = Law { .. } closing gap;`";
    assert_eq!(told("x.signum()"), [format!("`signum` {friction}")]);
    let wall = |name: &str, near: &str| {
        [format!(
            "`{name}` is not smooth, and no switch is declared for its kink; dry friction is a `friction` line, \
             a wall or a gap is a `press` line: `press N = Law {{ .. }} closing gap;`; elsewhere {near} for a small e"
        )]
    };
    let smaller = "`(x - sqrt(powi(x, 2) + powi(e, 2))) / 2` comes near the smaller of x and 0";
    assert_eq!(told("min(x, v)"), wall("min", smaller));
    let size = "`sqrt(powi(x, 2) + powi(e, 2))` comes near |x|";
    assert_eq!(told("abs(x)"), wall("abs", size));
    let other = format!("write what comes near it smoothly, as {size}");
    assert_eq!(told("x % k"), wall("%", &other));
    assert_eq!(
        of_law("param a; stick = a; slip(s) = a * abs(s);"),
        [
            "`abs` is not smooth; a law needs neither magnitude nor sign: \
          the sliding speed is positive, and the force opposes it"
        ]
    );
}

#[test]
fn branches_are_shown_the_way_out() {
    let way_out = "equations must be smooth: a branch has a jump that no switch declares; \
         a jump of dry friction is a `friction` line, a wall or a gap is a `press` line: \
         `press N = Law { .. } closing gap;`";
    assert_eq!(told("if x > 0.0 { k } else { 0.0 }"), [way_out]);
    assert_eq!(told("match x { _ => k }"), [way_out]);
    assert_eq!(told("(x > 0.0) * k"), [way_out]);
}

#[test]
fn powers_are_functions() {
    let advice = |power| {
        [format!(
            "`^` is exclusive-or in Rust; write a power as `{power}`"
        )]
    };
    assert_eq!(told("x^2"), advice("powi(x, 2)"));
    assert_eq!(told("k * x^2"), advice("powi(x, 2)"));
    assert_eq!(told("k + x^v"), advice("powf(x, v)"));
    assert_eq!(told("(x + v)^2 / k"), advice("powi(x + v, 2)"));
    assert_eq!(
        told("x ** 2"),
        ["write a power as `powi(x, 2)`, not with `**`"]
    );
    assert_eq!(
        told("powi(x, 0.5)"),
        [
            "the exponent of `powi` is a whole number such as 2; other powers are written `powf(x, 1.5)`"
        ]
    );
}

#[test]
fn functions_are_written_as_in_a_formula() {
    assert_eq!(
        told("x.sin()"),
        ["write functions as in a formula: `sin(x)`, not `x.sin()`"]
    );
    assert_eq!(
        told("(k * x).powi(2)"),
        ["write functions as in a formula: `powi(k * x, 2)`, not `(k * x).powi(2)`"]
    );
    assert_eq!(
        told("f64::sin(x)"),
        ["functions have no path in a formula: write `sin(x)`"]
    );
    assert_eq!(
        told("sinn(x)"),
        ["unknown function `sinn`; did you mean `sin`?"]
    );
    assert_eq!(
        told("arctan(x)"),
        ["unknown function `arctan`; write `atan(x)`"]
    );
    assert_eq!(told("sin(x, v)"), ["`sin` takes one argument: `sin(x)`"]);
    assert_eq!(
        told("k * der(x)"),
        ["`der` stands only on the left of an equation; \
          use what stands on the right of that equation, or give it a name with `let`"]
    );
}

#[test]
fn products_have_a_sign() {
    assert_eq!(
        told("2x"),
        ["`2x` is no number; a product is written `2 * x`"]
    );
    assert_eq!(told("2(x + v)"), ["a product is written with `*`"]);
    assert_eq!(
        told("k(x)"),
        [
            "unknown function `k`; a product is written with `*`, and the functions are acos, acosh, asin, \
          asinh, atan, atanh, cos, cosh, exp, ln, sin, sinh, sqrt, tan, tanh, powi, powf"
        ]
    );
    assert_eq!(
        told("2f32 * x"),
        ["every number is an `f64` here: write `2`"]
    );
    assert_eq!(
        told("1e999 * x"),
        ["`1e999` is too large for an `f64`, of which the largest is 1.8e308"]
    );
}

#[test]
fn other_expressions_are_no_formulas() {
    for (formula, said) in [
        ("x as f64", "every number is an `f64`, so write `x`"),
        ("{ x }", "write `( .. )`, not `{ .. }`"),
        ("[x]", "write `( .. )`, not `[ .. ]`"),
        ("self.x", "write `x`, not `self.x`"),
        ("&x", "write `x`, without `&`"),
        ("\"x\"", "is no formula: that is made of"),
        ("(x, v)", "`(x, v)` is no formula: that is made of"),
        ("|x| x", "comes near |x| for a small e"),
        ("x << 2", "`x << 2` is no formula: that is made of"),
    ] {
        let told = told(formula);
        assert!(
            told.len() == 1 && told[0].contains(said),
            "{formula}: {told:?}"
        );
    }
}
