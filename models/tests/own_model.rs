//! A program of somebody's own model, in one line.
//!
//! The test is its own program: called with words it answers them, called without it asks itself.

mod program {
    use stickslip_models::friction::{Coulomb, Jenkins};

    stickslip::model! {
        /// A pendulum that is kept swinging.
        pub struct KeptPendulum {
            /// Angle.
            state angle = 0.5;
            /// Rate of the angle.
            state rate = 0.0;
            /// Strength of what keeps it swinging.
            param gain = 0.2 where 0.0 < gain < 1.0;
            der(angle) = rate;
            der(rate) = gain * (0.25 - powi(angle, 2)) * rate - sin(angle);
        }
    }

    stickslip::model! {
        /// Mode coupling beyond flutter: what presses the mass to the belt depends on where it is.
        pub struct Squeal {
            state x = 0.0;
            state y = 0.0;
            state u = 0.0;
            state v = 0.0;
            param mu = 0.8 where mu >= 0.0;
            param belt = 1.0;
            friction F = Coulomb { level: mu * (1.0 + 4.0 / 3.0 * y) } opposing u - belt;
            der(x) = u;
            der(y) = v;
            der(u) = F - 2.0 * x - y;
            der(v) = -x - 2.0 * y;
        }
    }

    stickslip::model! {
        /// A spring in series with a slider, and a state that grows.
        pub struct Damped {
            state x: m = 0.0;
            state v: m/s = 1.0;
            state z: N = 0.0;
            state w: m = 1.0;
            param growth: 1/s = 0.0;
            param loss: m/s = 0.0;
            param m0: m = 1.0;
            param mass: kg = 1.0;
            friction F: N = Jenkins { stiffness: 0.5, level: 0.2 } opposing v with z;
            der(x) = v;
            der(v) = F / mass;
            der(w) = growth * w - loss * ln(w / m0);
        }
    }

    stickslip::app!(KeptPendulum, Squeal, Damped);

    pub(super) fn answer() -> std::process::ExitCode {
        main()
    }
}

use std::process::{Command, ExitCode};

const ASKED: &str = "STICKSLIP_TEST_ASKED";

fn main() -> ExitCode {
    if std::env::var_os(ASKED).is_some() {
        return program::answer();
    }
    let ask = |line: &str| {
        let done = Command::new(std::env::current_exe().unwrap())
            .args(line.split_whitespace())
            .env(ASKED, "")
            .output()
            .unwrap();
        let text = |bytes| String::from_utf8(bytes).unwrap();
        (done.status.code(), text(done.stdout), text(done.stderr))
    };
    let (code, stdout, stderr) = ask("orbit kept-pendulum --json");
    assert_eq!((code, stderr.as_str()), (Some(0), ""));
    let orbit: serde_json::Value = serde_json::from_str(&stdout).unwrap();
    assert_eq!(
        (&orbit["model"], &orbit["stability"]),
        (&"kept-pendulum".into(), &"stable".into())
    );
    // Small swings last 2π, larger ones longer.
    let period = orbit["period"].as_f64().unwrap();
    assert!((6.4..7.0).contains(&period), "{period}");
    let (code, _, stderr) = ask("orbit kept-pendulum --set gain=2");
    assert_eq!(code, Some(2));
    assert!(stderr.contains("0 < gain < 1"), "{stderr}");
    tells(ask);
    ExitCode::SUCCESS
}

/// What is said where a motion goes on no more, and of laws that remember.
fn tells(ask: impl Fn(&str) -> (Option<i32>, String, String)) {
    let (code, _, stderr) = ask("orbit squeal");
    assert_eq!(code, Some(1), "{stderr}");
    assert!(
        stderr.contains("`F` has no law at t = ") && stderr.contains("`Coulomb` wants level >= 0"),
        "{stderr}"
    );
    let (code, _, stderr) = ask("simulate squeal --start y=-5 --time 1");
    assert_eq!(code, Some(1), "{stderr}");
    assert!(
        stderr.contains(
            "at t = 0: `Coulomb` wants level >= 0, and there it is -4.533333, where x = 0, y = -5"
        ),
        "{stderr}"
    );
    let (code, _, stderr) = ask("simulate damped --set growth=1 --time 1000");
    assert_eq!(code, Some(1), "{stderr}");
    assert!(
        stderr.contains("the motion grows without bound: `w` passed "),
        "{stderr}"
    );
    let (code, _, stderr) = ask("simulate damped --start w=-2 --time 1");
    assert_eq!(code, Some(1), "{stderr}");
    assert!(
        stderr.contains(
            "at t = 0, where x = 0, v = 1, z = 0, w = -2, `ln(w / m0)` in `der(w)` is NaN at -2"
        ),
        "{stderr}"
    );
    let (_, _, stderr) = ask("trade squeal");
    assert!(!stderr.contains(['{', '[']), "{stderr}");
    let (code, stdout, stderr) = ask("laws damped");
    assert_eq!((code, stderr.as_str()), (Some(0), ""));
    assert!(
        stdout.contains("F = Jenkins { stiffness: 0.5, level: 0.2 } opposing v with z"),
        "{stdout}"
    );
    let row: Vec<&str> = stdout.lines().last().unwrap().split_whitespace().collect();
    assert_eq!(row[1..], ["0.200000", "0.200000"], "{stdout}");
}
