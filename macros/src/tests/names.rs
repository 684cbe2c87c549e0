use super::{BELT, NONE, of_belt, of_law, of_model};

#[test]
fn unknown_names_get_a_proposal() {
    let told = |written| of_belt("/ mass;", &format!("/ mass / {written};"));
    assert_eq!(told("mas"), ["unknown name `mas`; did you mean `mass`?"]);
    assert_eq!(told("f_s"), ["unknown name `f_s`; did you mean `F_s`?"]);
    assert_eq!(
        told("zeta"),
        ["unknown name `zeta`; declare it with `state`, `param` or `let`"]
    );
    assert_eq!(
        told("PI"),
        ["unknown name `PI`; the constant is `std::f64::consts::PI`"]
    );
    assert_eq!(
        of_law("stick = limit; slip(s) = 1.0;"),
        ["unknown name `limit`; declare it with `param`"]
    );
}

#[test]
fn time_does_not_occur() {
    assert_eq!(
        of_belt("k * x;", "k * x * sin(t);"),
        [
            "`t` is not declared: equations are autonomous and cannot depend on time; \
          a harmonic force is `cos(phi)` with the line `drive phi at omega;`"
        ]
    );
}

#[test]
fn nothing_is_declared_twice() {
    assert_eq!(
        of_belt("param k", "param x: m = 1.0; param k"),
        ["`x` is declared twice: first as a state, here as a parameter; rename one"]
    );
    assert_eq!(
        of_law("param s: N; stick = s; slip(s) = s;"),
        ["`s` is declared twice: first as a parameter, here as a sliding speed; rename one"]
    );
}

#[test]
fn lines_are_computed_from_top_to_bottom() {
    assert_eq!(
        of_belt("opposing v -", "opposing 0.0 * stretched + v -"),
        ["`stretched` is used above the line that declares it; move that line up"]
    );
    assert_eq!(
        of_belt("= k * x;", "= k * stretched;"),
        ["`stretched` is defined by itself; lines are computed from top to bottom"]
    );
}

#[test]
fn what_an_unknown_name_was_meant_for_is_not_accused_as_well() {
    let told = |written: &str| of_belt("/ mass;", &format!("/ {written};"));
    assert_eq!(told("mas").len(), 1);
    assert_eq!(told("kilograms").len(), 1);
    let independent = of_belt("param k", "param spare: N = 1.0; param k").len()
        + of_belt("k * x", "kk * x").len();
    let both = BELT.replacen("param k", "param spare: N = 1.0; param k", 1);
    assert_eq!(
        of_model(&both.replacen("k * x", "kk * x", 1)).len(),
        independent
    );
}

#[test]
fn what_is_declared_is_used() {
    assert_eq!(
        of_belt("param k", "param mu: 1 = 1.0; param k"),
        ["parameter `mu` is never used in this model; use it or remove its line"]
    );
    assert_eq!(
        of_belt("(F - stretched)", "(-stretched)"),
        ["friction force `F` is never used in this model; use it or remove its line"]
    );
    assert_eq!(
        of_law("param a: N; param b: N; stick = a; slip(s) = a;"),
        ["parameter `b` is never used in this law; use it or remove its line"]
    );
    assert_eq!(of_belt("(F - stretched)", "(F - k * x)"), NONE);
}

#[test]
fn unused_names_are_not_reported_beside_misspelt_uses() {
    assert_eq!(
        of_belt("/ mass;", "/ mas;"),
        ["unknown name `mas`; did you mean `mass`?"]
    );
}

#[test]
fn reserved_names_are_refused() {
    let told = |name: &str| {
        let line = format!("param {name} = 1.0; let unused = {name}; param k");
        of_belt("param k", &line)
    };
    assert_eq!(
        told("default"),
        ["`default` cannot be a name here: every model has an item of this name; choose another"]
    );
    assert_eq!(
        told("smooth"),
        ["`smooth` cannot be a name here: it stands for the size of the smoothing; choose another"]
    );
    assert_eq!(
        told("param"),
        ["`param` cannot be a name here: it is a word of this language; choose another"]
    );
    assert_eq!(
        told("__k"),
        [
            "`__k` cannot be a name here: two leading underscores mark the names of generated code; choose another"
        ]
    );
    assert_eq!(
        of_belt("param k", "param type = 0.0; param k")[0],
        "`type` cannot be a name here: it is a word of Rust; choose another"
    );
    assert_eq!(
        of_belt("= Weakening", "= D"),
        [
            "`D` cannot be the name of a type here: formulas use it for their numbers; choose another"
        ]
    );
    for name in ["D", "A", "N", "T", "params", "state_", "g", "q", "M"] {
        assert_eq!(told(name), NONE, "{name}");
    }
}
