use super::{NONE, of_model, of_press};

const MODEL: &str = "
    state y: m = 0.1;
    state v: m/s = 0.0;
    state x: m = 0.0;
    state u: m/s = 0.0;
    param mass: kg = 1.0;
    param k: N/m = 1.0;
    param c: N*s/m = 0.0;
    param mu: 1 = 0.3;
    param wall: m = 0.0;
    press N: N = Compliant { stiffness: k, damping: c } closing y - wall;
    friction F: N = Coulomb { level: mu * N } opposing u;
    der(y) = v;
    der(v) = N / mass;
    der(x) = u;
    der(u) = F / mass;
";

fn with(text: &str, replacement: &str) -> Vec<String> {
    assert!(MODEL.contains(text), "the model has no `{text}`");
    of_model(&MODEL.replacen(text, replacement, 1))
}

#[test]
fn nothing_is_said_about_a_good_press() {
    assert_eq!(of_model(MODEL), NONE);
    let shaken = MODEL.replacen("closing y - wall", "closing y - wall * sin(phi)", 1);
    let rate = "param omega: 1/s = 1.0; drive phi at omega;";
    assert_eq!(of_model(&(shaken + rate)), NONE);
}

#[test]
fn a_press_is_used_and_its_words_are_known() {
    assert_eq!(
        with("{ level: mu * N }", "{ level: mu * k * wall }")
            .into_iter()
            .chain(with("N / mass", "k * wall / mass"))
            .collect::<Vec<_>>(),
        NONE,
        "each use is enough"
    );
    let unused =
        MODEL
            .replacen("mu * N", "mu * k * wall", 1)
            .replacen("N / mass", "k * wall / mass", 1);
    assert_eq!(
        of_model(&unused),
        ["press `N` is never used in this model; use it or remove its line"]
    );
    assert_eq!(
        with("closing", "opposing"),
        ["what `N` depends on follows `closing`, not `opposing`: write `closing y - y_wall`"]
    );
    assert_eq!(
        with("press N", "pres N")[0],
        "`pres` does not begin a line; did you mean `press`?"
    );
    assert_eq!(
        with("mu * N", "mu * NN")[0],
        "unknown name `NN`; did you mean `N`?"
    );
}

#[test]
fn a_gap_is_a_formula_of_positions() {
    assert_eq!(
        with("closing y - wall", "closing mu * wall"),
        ["the gap of `N` reads no state: it would never open or close"]
    );
    let velocity = "press P: N = Compliant { stiffness: k, damping: c } closing wall * u / v; let p = P; friction";
    let told = with("friction", velocity);
    assert_eq!(
        told,
        [
            "the gap of `P` opens at a rate that depends on the force `N`: a gap is a formula of positions, \
             whose equations are velocities, as in `der(x) = v;`"
        ]
    );
    let nested = "press P: N = Compliant { stiffness: k, damping: c } closing y - N / k; let p = P; friction";
    assert_eq!(
        with("friction", nested)[0],
        "`N` is or contains a force, and the law and gap of `P` cannot depend on one: \
         a gap is a formula of positions, and of the phase of a drive"
    );
}

#[test]
fn friction_reads_a_press_in_its_law_only() {
    assert_eq!(
        with("opposing u", "opposing u - N / c"),
        ["`N` is or contains a press, and the speed of `F` cannot depend on one"]
    );
    assert_eq!(
        with("F / mass", "F * N / mass / k / wall"),
        [
            "`F * N`: friction forces must enter linearly, so that the sticking force can be solved for; \
          here one is multiplied by a force, stands in a denominator or inside a function"
        ]
    );
    let above = MODEL.replacen("press N", "let early = N; press N", 1);
    assert_eq!(
        of_model(&above),
        ["`N` is used above the line that declares it; move that line up"]
    );
}

#[test]
fn the_wrong_ways_to_write_a_wall_lead_to_a_press() {
    let line = "`press N = Law { .. } closing gap;`";
    for wrong in [
        "if y < wall { k * (wall - y) / mass } else { 0.0 }",
        "k * max(wall - y, 0.0) / mass",
        "k * abs(wall - y) / mass",
        "k * min(wall - y, 0.0) / mass",
    ] {
        let told = with("der(v) = N / mass", &format!("der(v) = {wrong} + N / mass"));
        assert_eq!(told.len(), 1, "{told:?}");
        assert!(told[0].contains(line), "{told:?}");
    }
    let told = with("der(y) = v;", "der(y) = v; stop y at wall;");
    assert!(told[0].contains(line), "{told:?}");
}

#[test]
fn a_law_of_presses_has_one_force_of_depth_and_rate() {
    let good = "param k: N/m where k > 0.0; param c: N*s/m; force(d, v) = k * d + c * v;";
    assert_eq!(of_press(good), NONE);
    assert_eq!(
        of_press("param k: N/m;"),
        [
            "law `L` has no force: add `force(d, v) = ...;` at the depth d that grows at the rate v, or, where \
             nothing gives way, `rebound(v) = ...;` after an approach at the speed v",
            "parameter `k` is never used in this law; use it or remove its line",
        ]
    );
    assert_eq!(
        of_press("param k: N/m; force(d, v) = k * d; force(d, v) = k * d;"),
        [
            "`d` is declared twice: first as a relative speed, here as a relative speed; rename one",
            "`v` is declared twice: first as a relative speed, here as a relative speed; rename one",
            "second `force` line; keep one",
        ]
    );
    assert_eq!(
        of_press("param k: N/m; force(d, v) = k * v;"),
        ["unit mismatch: `force` is the contact's force, in N, but `k * v` is in N/s"]
    );
    let told = of_press("param k: N/m; force(d, v) = k * max(d, 0.0);");
    assert!(told[0].contains("needs no largest"), "{told:?}");
    let told = of_press("param k: N/m; stick = k; force(d, v) = k * d;");
    assert!(
        told[0].starts_with("`stick` does not begin a line"),
        "{told:?}"
    );
}

#[test]
fn a_rigid_law_rebounds() {
    assert_eq!(
        of_press("param e: 1 where 0.0 <= e <= 1.0; rebound(v) = e * v;"),
        NONE
    );
    assert_eq!(
        of_press("param e: 1; param k: N/m; rebound(v) = e; force(d, w) = k * d;"),
        [
            "`rebound` is for a contact that does not give way, and one with a `force` does; keep one of the two",
            "unit mismatch: `rebound` is a speed, in m/s, but `e` is in 1",
        ]
    );
}
