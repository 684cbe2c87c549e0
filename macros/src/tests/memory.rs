use super::{NONE, of_law, of_model};

const LUGRE: &str = "
    state z: m;
    param stiffness: N/m where stiffness > 0.0;
    param damping: N*s/m where damping >= 0.0;
    param level: N where level > 0.0;
    let rate = w - stiffness * abs(w) * z / level;
    der(z) = rate;
    force(w) = stiffness * z + damping * rate;
";

const BELT: &str = "
    state x: m = 1.0;
    state v: m/s = 0.0;
    state z: m = 0.0;
    param k: N/kg/m = 1.0;
    param v_dr: m/s = 0.2;
    friction F: N/kg = Dahl { level: 1.0 } opposing v - v_dr with z;
    der(x) = v;
    der(v) = F - k * x;
";

fn of_lugre(text: &str, replacement: &str) -> Vec<String> {
    assert!(LUGRE.contains(text), "the law has no `{text}`");
    of_law(&LUGRE.replacen(text, replacement, 1))
}

fn of_belt(text: &str, replacement: &str) -> Vec<String> {
    assert!(BELT.contains(text), "the model has no `{text}`");
    of_model(&BELT.replacen(text, replacement, 1))
}

#[test]
fn nothing_is_said_about_good_declarations() {
    assert_eq!(of_law(LUGRE), NONE);
    let belt = BELT.replace("N/kg/m", "1/s^2").replace("N/kg", "m/s^2");
    assert_eq!(of_model(&belt), NONE);
}

#[test]
fn a_law_with_memory_has_a_force_and_an_equation_for_each_state() {
    assert_eq!(
        of_lugre("der(z) = rate;", ""),
        ["state `z` has no equation: add `der(z) = ...;`"]
    );
    assert_eq!(
        of_lugre("der(z)", "der(y)"),
        [
            "`y` is not a state; declare it with `state y;`",
            "state `z` has no equation: add `der(z) = ...;`"
        ]
    );
    assert_eq!(
        of_law("state z; param a; der(z) = a * z;"),
        ["law `L` has internal state but no force: add `force(w) = ...;`"]
    );
    assert_eq!(
        of_law("param a; force(w) = a * w;"),
        [
            "`force` is for laws with internal state, and none is declared: add `state z;` and `der(z) = ...;`, \
             or write `stick = ...;` and `slip(s) = ...;`"
        ]
    );
    assert_eq!(
        of_lugre("der(z) = rate;", "der(z) = rate; force(w) = level;"),
        [
            "`w` is declared twice: first as a relative speed, here as a relative speed; rename one",
            "second `force` line; keep one"
        ]
    );
    assert_eq!(
        of_lugre("der(z) = rate;", "der(z) = rate; stick = level;"),
        [
            "`stick` is for laws without internal state; a law with `state` and `der` has one line `force(w) = ...;` \
             for every relative speed `w`"
        ]
    );
    assert_eq!(
        of_lugre("state z: m;", "state z: m = 0.0;"),
        ["a law's state has no start: the state of the model that carries `z` has one"]
    );
}

#[test]
fn kinks_belong_to_laws_with_memory() {
    assert_eq!(
        of_lugre("abs(w)", "max(w, -w)"),
        [
            "`max` is not known here; write it with `abs`, whose kinks are found: \
             the larger of x and y is `(x + y + abs(x - y)) / 2`, the sign of the speed `w` is `sign(w)`"
        ]
    );
    assert_eq!(
        of_law("param a; let b = abs(a); stick = b; slip(s) = b;"),
        [
            "`abs` is not smooth; a law needs neither magnitude nor sign: \
             the sliding speed is positive, and the force opposes it"
        ]
    );
    assert_eq!(
        of_lugre("abs(w) * z", "w * sign(w + w) * z"),
        [
            "`sign` is taken of the relative speed or of an internal state alone, not of `w + w`; \
             `abs` takes any formula"
        ]
    );
}

#[test]
fn formulas_do_not_jump() {
    let told = |line| {
        [format!(
            "`{line}` jumps where `w` changes its sign: `sign(w)` must be multiplied by something \
             that vanishes there; a force that jumps is described by `stick` and `slip`"
        )]
    };
    assert_eq!(
        of_lugre("= stiffness * z +", "= level * sign(w) +"),
        told("force(w)")
    );
    assert_eq!(of_lugre("abs(w) * z", "w * sign(w) * z"), NONE);
    assert_eq!(
        of_lugre("let rate = w -", "let rate = w + 3.0 * sign(w) -"),
        [told("der(z)"), told("force(w)")].concat()
    );
}

#[test]
fn units_reach_into_kinks() {
    assert_eq!(
        of_lugre("= stiffness * z +", "= stiffness * abs(w) +"),
        ["unit mismatch: `stiffness * abs(w)` is in N/s, but `damping * rate` is in N"]
    );
    assert_eq!(
        of_lugre("der(z) = rate;", "der(z) = z;"),
        ["unit mismatch: `der(z)` is in m/s, but `z` is in m"]
    );
}

#[test]
fn what_carries_the_memory_is_a_state_of_its_own() {
    let belt = |text, replacement| {
        let told = of_belt(text, replacement);
        told.into_iter()
            .filter(|message| !message.starts_with("unit"))
            .collect::<Vec<_>>()
    };
    assert_eq!(
        belt("with z", "with y"),
        ["`y` is not a state; declare it with `state y = 0.0;`"]
    );
    assert_eq!(
        belt("with z", "with k"),
        ["`k` is a parameter, and only a state can carry the internal state of a law"]
    );
    assert_eq!(
        belt(
            "der(x) = v;",
            "friction G: N/kg = Dahl { level: 1.0 } opposing v with z; let both = F + G; der(x) = v;"
        ),
        ["`z` already carries an internal state of `F`; declare another state for this one"]
    );
    assert_eq!(
        belt("der(x) = v;", "der(x) = v; der(z) = v;"),
        ["the law of `F` already moves `z`: remove this equation, or `z` after `with`"]
    );
    assert_eq!(
        belt(" with z", ""),
        ["state `z` has no equation: add `der(z) = ...;`"]
    );
}

#[test]
fn laws_may_abbreviate() {
    assert_eq!(
        of_law("param a; let b = 2 * a; stick = b; slip(s) = b / (1 + s);"),
        NONE
    );
    assert_eq!(
        of_law("param a; let b = a * s; stick = b; slip(s) = b;"),
        [
            "`b` is made of the sliding speed, and at rest there is none: `stick` is a formula of the parameters"
        ]
    );
    assert_eq!(
        of_law("param a; let c = b; let b = a; stick = c; slip(s) = b;"),
        ["`b` is used above the line that declares it; move that line up"]
    );
}

const JENKINS: &str = "
    state z: N;
    param stiffness: N/m where stiffness > 0.0;
    param level: N where level > 0.0;
    der(z) = stiffness * w;
    stop z at level;
    force(w) = z;
";

fn of_jenkins(text: &str, replacement: &str) -> Vec<String> {
    assert!(JENKINS.contains(text), "the law has no `{text}`");
    of_law(&JENKINS.replacen(text, replacement, 1))
}

#[test]
fn stops_are_of_states() {
    assert_eq!(of_law(JENKINS), NONE);
    assert_eq!(
        of_jenkins("stop z", "stop level"),
        ["`level` is a parameter, not a state; only states stop"]
    );
    assert_eq!(
        of_jenkins("stop z", "stop q"),
        ["`q` is not a state; declare it with `state q;`"]
    );
    assert_eq!(
        of_jenkins("stop z at level;", "stop z at level; stop z at 2 * level;"),
        ["second stop of `z`; keep one: it stands on both sides of zero"]
    );
    assert_eq!(
        of_jenkins("stop z at level;", "stop z = level;"),
        ["expected `at` before `=`; the line has the form `stop z at limit;`"]
    );
    let bare = of_law("param a; stop z at a; stick = a; slip(s) = a;");
    let wanted = "`z` is not a state; declare it with `state z;`";
    assert!(bare.iter().any(|message| message == wanted), "{bare:?}");
}

#[test]
fn stops_stand_still() {
    let told = |name: &str| {
        [format!(
            "`{name}` changes along a motion, and the stops of `z` stand still: \
             write a formula of the parameters, as in `stop z at limit;`"
        )]
    };
    assert_eq!(of_jenkins("at level", "at level + z"), told("z"));
    assert_eq!(
        of_jenkins("at level", "at level * w / w"),
        [told("w"), told("w")].concat()
    );
    assert_eq!(
        of_jenkins("stop z at level", "let most = level - z; stop z at most"),
        told("most")
    );
    assert_eq!(
        of_jenkins("stop z at level", "let most = 2 * level; stop z at most"),
        NONE
    );
}

#[test]
fn stops_are_in_the_unit_of_what_they_stop() {
    assert_eq!(
        of_jenkins("at level", "at level / stiffness"),
        ["unit mismatch: `z` is in N, but it is to stop at `level / stiffness`, which is in m"]
    );
}
