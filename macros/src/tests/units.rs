use super::{NONE, of_belt, of_law, of_model};

#[test]
fn equations_agree_with_their_states() {
    assert_eq!(
        of_belt(
            "(F - stretched) / mass",
            "F - stretched / 1.0 * mass / mass"
        ),
        ["unit mismatch: `der(v)` is in m/s^2, but `F - stretched / 1.0 * mass / mass` is in N"]
    );
    assert_eq!(
        of_belt("der(x) = v", "der(x) = x"),
        ["unit mismatch: `der(x)` is in m/s, but `x` is in m"]
    );
}

#[test]
fn sums_agree() {
    assert_eq!(
        of_belt("(F - stretched)", "(F - k * v)"),
        ["unit mismatch: `F` is in N, but `k * v` is in N/s"]
    );
    assert_eq!(
        of_belt("opposing v - v_dr", "opposing x - v_dr"),
        ["unit mismatch: `x` is in m, but `v_dr` is in m/s"]
    );
}

#[test]
fn arguments_and_exponents_are_plain_numbers() {
    assert_eq!(
        of_belt("= k * x;", "= k * x * cos(v);"),
        ["unit mismatch: the argument of `cos` must be a plain number, but `v` is in m/s"]
    );
    assert_eq!(
        of_belt("= k * x;", "= k * x * powf(2.0, v);"),
        ["unit mismatch: an exponent must be a plain number, but `v` is in m/s"]
    );
    assert_eq!(
        of_belt("= k * x;", "= k * x * powf(v, x / x);"),
        ["unit mismatch: what is raised to `x / x` must be a plain number, but `v` is in m/s"]
    );
}

#[test]
fn powers_and_roots_carry_units() {
    assert_eq!(of_belt("= k * x;", "= k * powi(x, 2) / x;"), NONE);
    assert_eq!(of_belt("= k * x;", "= k * sqrt(x) * sqrt(x);"), NONE);
    assert_eq!(
        of_belt("= k * x;", "= k * powf(x, 1.5) / powf(x, 0.5);"),
        NONE
    );
    assert_eq!(of_belt("= k * x;", "= mass * v * sqrt(k / mass);"), NONE);
    assert_eq!(
        of_belt("= k * x;", "= k * sqrt(x);"),
        ["unit mismatch: `F` is in N, but `stretched` is in m^(1/2)*kg*s^-2"]
    );
}

#[test]
fn what_has_no_unit_is_not_checked() {
    assert_eq!(of_belt("param k: N/m", "param k"), NONE);
    assert_eq!(of_belt("= k * x;", "= 3.0 * k / k;"), NONE);
    assert_eq!(of_belt("= k * x;", "= 9.81 * mass + k * x;"), NONE);
}

#[test]
fn a_nondimensional_model_has_a_nondimensional_time() {
    let lines = "state x: 1 = 1.0; state v: 1 = 0.0; der(x) = v; der(v) = -x;";
    assert_eq!(of_model(lines), NONE);
    assert_eq!(
        of_model(&lines.replace("v: 1", "v: s")),
        ["unit mismatch: `der(x)` is in 1/s, but `v` is in s",]
    );
}

#[test]
fn a_law_gives_forces() {
    assert_eq!(
        of_law("param a: N; param b: s/m; stick = a; slip(v) = a * b;"),
        ["unit mismatch: `slip` is the contact's force, in N, but `a * b` is in N*s/m"]
    );
    assert_eq!(
        of_law("param a: N; param b: s; stick = a; slip(v) = a / (1.0 + b * v);"),
        ["unit mismatch: `slip` is the contact's force, in N, but `a / (1.0 + b * v)` is in N/m"]
    );
    assert_eq!(
        of_law("param a: N; param b: s; stick = a; slip(v) = a * exp(-b * v);"),
        ["unit mismatch: the argument of `exp` must be a plain number, but `-b * v` is in m"]
    );
    assert_eq!(
        of_law("param a; param b; stick = a; slip(s) = a * exp(-b * s);"),
        NONE
    );
    assert_eq!(
        of_law("param a: 1; param b; stick = a; slip(s) = a * exp(-b * s);"),
        NONE
    );
}

#[test]
fn scaled_units_are_refused() {
    let told = |unit: &str| of_belt("mass: kg", &format!("mass: {unit}"));
    let scaled = |scaled, plain| {
        [format!(
            "`{scaled}` is a scaled unit, and nothing here is scaled silently; \
             write `{plain}` and give the values in it"
        )]
    };
    assert_eq!(told("mm"), scaled("mm", "m"));
    assert_eq!(told("kN"), scaled("kN", "N"));
    assert_eq!(told("mg"), scaled("mg", "kg"));
    assert_eq!(told("MPa"), scaled("MPa", "Pa"));
    assert_eq!(
        told("rpm"),
        ["`rpm` is not an SI unit without a factor; write `rad/s` (multiply the values by pi/30)"]
    );
    assert_eq!(told("Kg"), ["unknown unit `Kg`; did you mean `kg`?"]);
}

#[test]
fn units_have_one_form() {
    let told = |unit: &str| of_belt("mass: kg", &format!("mass: {unit}"));
    assert_eq!(told("N*s^2/m"), NONE);
    assert_eq!(told("J*s^2*m^-2"), NONE);
    assert_eq!(told("rad*kg"), NONE);
    assert_eq!(told("N^(1/2)*kg^(3/6)*s/m^(1/2)"), NONE);
    assert_eq!(told("kg^(-1/2)*kg^(3/2)"), NONE);
    assert_eq!(
        told("N s"),
        ["join the symbol `s` to a unit with `*` or `/`, as in `N*m`"]
    );
    assert_eq!(
        told("N/(m*s)"),
        ["units have no parentheses: write `N/m/s` for N/(m s)"]
    );
    assert_eq!(
        told("1000*kg"),
        ["a unit is `1`, or symbols such as `kg*m/s^2`; its factor is not part of it"]
    );
    assert_eq!(
        told("m^100*m^100"),
        ["the exponents of this unit are too large"]
    );
    assert_eq!(
        told("Pa^(1/5)"),
        [
            "the power of a unit is a whole number, as in `m^2`, or a fraction of twelfths, as in `Pa^(1/2)`"
        ]
    );
}

#[test]
fn friction_opposes_a_speed() {
    let said = |why: &str, instead: &str| {
        [format!(
            "friction opposes a speed, but `x` is a displacement, {why}: write the relative speed of the contact, such as \
             `opposing {instead}`"
        )]
    };
    let opposed = of_belt("opposing v - v_dr", "opposing x");
    assert!(opposed.contains(&said("in m", "v")[0]), "{opposed:?}");
    let plain = "
        state x = 1.0;
        state v = 0.0;
        friction F = Dry { level: 1.0 } opposing OPPOSED;
        der(x) = v;
        der(v) = F - x;
    ";
    let opposing = |speed| of_model(&plain.replace("OPPOSED", speed));
    assert_eq!(
        opposing("x"),
        said("for `der(x) = v`, on which `F` acts", "v")
    );
    assert_eq!(opposing("v"), NONE);
    // The speed of a contact may well depend on where it is.
    assert_eq!(opposing("v + 0.1 * x"), NONE);
}
