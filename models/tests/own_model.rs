//! A program of somebody's own model, in one line.
//!
//! The test is its own program: called with words it answers them, called without it asks itself.

mod program {
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

    stickslip::app!(KeptPendulum);

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
    ExitCode::SUCCESS
}
