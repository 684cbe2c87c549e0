use super::{NONE, of_model};

const DRIVEN: &str = "
    state x: m = 0.0;
    state v: m/s = 0.0;
    param omega: rad/s = 2.0 where omega > 0.0;
    param load: m/s^2 = 1.0;
    param lag: rad = 0.1;
    drive phi at 2 * omega;
    let force = load * cos(2 * phi - lag);
    der(x) = v;
    der(v) = force - sin(-phi) * load;
";

fn of_driven(text: &str, replacement: &str) -> Vec<String> {
    assert!(DRIVEN.contains(text), "the model has no `{text}`");
    let told = of_model(&DRIVEN.replacen(text, replacement, 1));
    // What a replacement no longer uses is not in question.
    let unused = |message: &String| message.contains("is never used");
    told.into_iter()
        .filter(|message| !unused(message))
        .collect()
}

#[test]
fn nothing_is_said_about_a_good_drive() {
    assert_eq!(of_model(DRIVEN), NONE);
    assert_eq!(of_driven("2 * phi - lag", "3 * (phi + lag) - phi"), NONE);
}

#[test]
fn the_phase_stands_in_periodic_functions_only() {
    let told = [
        "the phase `phi` may stand only inside `cos` and `sin`, times a whole number, as in `cos(phi)` or \
         `sin(2 * phi + lag)`: the force must be the same when it has turned by 2 pi",
    ];
    assert_eq!(of_driven("cos(2 * phi - lag)", "(lag + phi)"), told);
    assert_eq!(of_driven("cos(2 * phi - lag)", "lag * exp(phi)"), told);
    assert_eq!(
        of_driven("cos(2 * phi - lag)", "lag * cos(0.5 * phi)"),
        told
    );
    assert_eq!(of_driven("cos(2 * phi - lag)", "lag * cos(phi / 2)"), told);
    assert_eq!(of_driven("cos(2 * phi - lag)", "cos(lag * phi)"), told);
    assert_eq!(of_driven("cos(2 * phi - lag)", "cos(sin(phi) + lag)"), NONE);
    assert_eq!(of_driven("cos(2 * phi - lag)", "exp(cos(phi) + lag)"), NONE);
}

#[test]
fn one_drive_advances_as_its_parameters_say() {
    assert_eq!(
        of_driven(
            "der(x) = v;",
            "der(x) = v; drive psi at omega; let other = cos(psi);"
        ),
        [
            "second drive; motions under two of them have no common period unless one is a multiple of the other: \
             write that one as `cos(2 * phi)`"
        ]
    );
    assert_eq!(
        of_driven("at 2 * omega", "at omega + x / x * omega"),
        [
            "`x` is a state, and the rate of `phi` is a formula of parameters only",
            "`x` is a state, and the rate of `phi` is a formula of parameters only"
        ]
    );
    assert_eq!(
        of_driven("at 2 * omega", "at omega * load"),
        ["unit mismatch: the rate of `phi` is in rad/s, but this is in m*s^-3"]
    );
    assert_eq!(
        of_driven("der(x) = v;", "der(x) = v; der(phi) = omega;"),
        ["`phi` is a phase of the drive, not a state; only states have equations"]
    );
    assert_eq!(
        of_driven("drive phi at", "drive phi ="),
        ["expected `at` before `=`; the line has the form `drive phi at omega;`"]
    );
    assert_eq!(
        of_driven("drive phi", "drive psi"),
        [
            "unknown name `phi`; did you mean `psi`?",
            "unknown name `phi`; did you mean `psi`?"
        ]
    );
}
