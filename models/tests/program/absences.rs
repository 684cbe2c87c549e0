//! Asked for what does not exist, the program says plainly what there is instead.

use crate::{stickslip, words};

/// Every line fails with exit code 1, nothing on stdout, and these words in one message.
fn absent(cases: &[(&str, &[&str])]) {
    for (line, parts) in cases {
        let answer = stickslip(&words(line));
        assert_eq!(answer.code, Some(1), "{line}: {}", answer.stderr);
        assert_eq!(answer.stdout, "", "{line}");
        assert!(
            answer.stderr.starts_with("error: "),
            "{line}: {}",
            answer.stderr
        );
        assert_eq!(
            answer.stderr.lines().count(),
            1,
            "{line}: {}",
            answer.stderr
        );
        for part in *parts {
            assert!(
                answer.stderr.contains(part),
                "{line} lacks {part:?}: {}",
                answer.stderr
            );
        }
    }
}

#[test]
fn only_an_equilibrium() {
    const ONLY: &str = "no periodic orbit was found, only an equilibrium";
    absent(&[
        (
            "orbit drill-string --set eta=6 --quiet",
            &[ONLY, "psi = 0, omega = 0"],
        ),
        (
            "orbit drill-string --set eta=1e3 --quiet",
            &[ONLY, "psi = 0, omega = 0"],
        ),
        (
            "orbit drill-string --set theta=0 --quiet",
            &[ONLY, "psi = 0"],
        ),
        (
            "orbit drill-string --set zeta=0.9 --quiet",
            &[ONLY, "psi = 0"],
        ),
        (
            "orbit drill-string --set zeta=2 --quiet",
            &[ONLY, "psi = 0"],
        ),
        (
            "orbit drill-string --smooth quartic:10 --quiet",
            &[ONLY, "psi ="],
        ),
        (
            "orbit belt-oscillator --set v_dr=0 --quiet",
            &[ONLY, "x = 1", "v = 0"],
        ),
        (
            "orbit belt-oscillator --smooth arctan:1 --quiet",
            &[ONLY, "x = 0.0785"],
        ),
        ("orbit belt-pair --set v_dr=0 --quiet", &[ONLY, "x1 ="]),
        (
            "orbit belt-pair --smooth arctan:10 --quiet",
            &[ONLY, "x1 ="],
        ),
    ]);
}

#[test]
fn no_orbit_is_singled_out() {
    const FAMILY: &str = "but so are those beside it: the orbits form a family";
    absent(&[
        (
            "orbit van-der-pol --set nu=0 --quiet",
            &[FAMILY, "period 6.28318531"],
        ),
        (
            "orbit belt-oscillator --set F_s=0 --quiet",
            &[FAMILY, "period 6.28318531"],
        ),
        ("orbit belt-oscillator --set delta=0 --quiet", &[FAMILY]),
        (
            "orbit drill-string --set theta=0 --set zeta=0 --quiet",
            &[FAMILY, "period 6.28318531"],
        ),
    ]);
}

/// Two independent oscillators of different periods.
#[test]
#[ignore = "long"]
fn no_common_period() {
    absent(&[(
        "orbit belt-pair --set alpha=0 --quiet",
        &["has not settled on a periodic orbit", "where it came back"],
    )]);
}

/// Two modes of an undamped linear system.
#[test]
#[ignore = "long"]
fn nothing_that_repeats() {
    absent(&[(
        "orbit belt-pair --set gamma=0 --quiet",
        &[
            "has not settled on a periodic orbit",
            "its largest Lyapunov exponent is ",
        ],
    )]);
}

#[test]
fn no_branch_and_no_trade_without_an_orbit() {
    absent(&[
        (
            "branch drill-string --along eta=6..7 --quiet",
            &["equilibrium", "psi"],
        ),
        (
            "branch van-der-pol --along nu=0..1 --quiet",
            &["the orbits form a family"],
        ),
        (
            "trade drill-string --set eta=6 --quiet",
            &["equilibrium", "psi"],
        ),
    ]);
}

#[test]
fn a_motion_that_overflows() {
    absent(&[(
        "simulate van-der-pol --set nu=1e100 --start x=1e100,v=1e100 --quiet",
        &["not finite", "t = "],
    )]);
}
