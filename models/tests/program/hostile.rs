//! Whatever is written on the command line: an answer or a message, soon, and never a panic.

use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

/// How long lines are tried.
const TIME: Duration = Duration::from_secs(12);
/// How long one of them may take, without optimisation and on a busy machine.
const PATIENCE: Duration = Duration::from_secs(600);

const NUMBERS: [&str; 26] = [
    "NaN", "inf", "-inf", "1e308", "-1e308", "5e-324", "1e-310", "-0.0", "0", "1e16", "-1",
    "1e-99", "1e99", "", "x", "1e999", "0x10", "1e-8", "1e8", "1", "0.5", "1e-16", "-1e-20", "3",
    "1e5", "-5",
];

struct Dice(u64);

impl Dice {
    fn below(&mut self, limit: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        (z ^ (z >> 31)) as usize % limit.max(1)
    }

    fn one<'a>(&mut self, of: &[&'a str]) -> &'a str {
        of[self.below(of.len())]
    }

    fn number(&mut self) -> &'static str {
        self.one(&NUMBERS)
    }

    /// A line that may or may not make sense.
    fn line(&mut self) -> Vec<String> {
        type System = (
            &'static str,
            &'static [&'static str],
            &'static [&'static str],
        );
        const SYSTEMS: [System; 4] = [
            ("van-der-pol", &["nu"], &["x", "v"]),
            (
                "belt-oscillator",
                &["m", "k", "v_dr", "F_s", "delta"],
                &["x", "v"],
            ),
            (
                "belt-pair",
                &["alpha", "beta", "gamma", "v_dr"],
                &["x1", "v1", "x2", "v2"],
            ),
            (
                "drill-string",
                &["eta", "theta", "kinetic", "zeta"],
                &["psi", "omega"],
            ),
        ];
        const COMMANDS: [&str; 8] = [
            "orbit",
            "orbit",
            "orbit",
            "simulate",
            "equilibria",
            "branch",
            "models",
            "trade",
        ];
        const KERNELS: [&str; 7] = [
            "arctan",
            "tanh",
            "algebraic",
            "cubic",
            "quintic",
            "quartic",
            "x",
        ];
        let (model, parameters, states) = SYSTEMS[self.below(SYSTEMS.len())];
        let command = self.one(&COMMANDS);
        let mut line = vec![command.to_owned(), model.to_owned(), "--quiet".to_owned()];
        for _ in 0..self.below(3) {
            line.extend([
                "--set".to_owned(),
                format!("{}={}", self.one(parameters), self.number()),
            ]);
        }
        if self.below(3) == 0 {
            line.extend([
                "--smooth".to_owned(),
                format!("{}:{}", self.one(&KERNELS), self.number()),
            ]);
        }
        if self.below(3) == 0 {
            let start = format!(
                "{}={},{}={}",
                self.one(states),
                self.number(),
                self.one(states),
                self.number()
            );
            line.extend(["--start".to_owned(), start]);
        }
        if self.below(6) == 0 {
            line.extend(["--period".to_owned(), self.number().to_owned()]);
        }
        if command == "simulate" {
            line.extend(["--time".to_owned(), self.number().to_owned()]);
        }
        if command == "branch" || self.below(6) == 0 {
            let range = format!(
                "{}={}..{}",
                self.one(parameters),
                self.number(),
                self.number()
            );
            line.extend(["--along".to_owned(), range]);
        }
        if self.below(4) == 0 {
            line.extend([
                "--accuracy".to_owned(),
                self.one(&["1e-3", "1e-12", "NaN", "0", "0.05"]).to_owned(),
            ]);
        }
        line
    }
}

/// Waits for a process for `PATIENCE`; ends it and tells if that was not enough.
fn wait(child: &mut Child, line: &[String]) {
    let clock = Instant::now();
    while child.try_wait().unwrap().is_none() {
        if clock.elapsed() > PATIENCE {
            child.kill().unwrap();
            panic!("no end: {}", line.join(" "));
        }
        std::thread::sleep(Duration::from_millis(2));
    }
}

#[test]
fn any_line_gets_an_answer_or_a_message() {
    let clock = Instant::now();
    let mut dice = Dice(3);
    while clock.elapsed() < TIME {
        let line = dice.line();
        let mut child = Command::new(env!("CARGO_BIN_EXE_stickslip"))
            .args(&line)
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap();
        wait(&mut child, &line);
        let done = child.wait_with_output().unwrap();
        let (code, message) = (done.status.code(), String::from_utf8_lossy(&done.stderr));
        let line = line.join(" ");
        assert!(matches!(code, Some(0..=2)), "{code:?} {line}: {message}");
        assert!(!message.contains("panicked"), "{line}: {message}");
        assert!(
            code == Some(0) || message.starts_with("error: "),
            "{line}: {message}"
        );
    }
}
