//! The tutorial tells what this program does: its model, its answers and its pictures are compared.
//!
//! `BLESS=1` writes the pictures anew.

use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::{Mutex, PoisonError};

const TUTORIAL: &str = include_str!("../../../docs/tutorial.md");
const PROMPT: &str = "$ cargo run --release -- ";

/// The contents of the code blocks that are marked so.
fn blocks(mark: &str) -> Vec<&'static str> {
    let fence = format!("```{mark}\n");
    let opened: Vec<&str> = TUTORIAL.split(&fence).skip(1).collect();
    let opened = opened.into_iter();
    opened
        .map(|rest| rest.split("```").next().unwrap())
        .collect()
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join("tutorial")
}

/// Both tests write to one folder: one at a time.
static FOLDER: Mutex<()> = Mutex::new(());

fn program(words: &str) -> String {
    let _alone = FOLDER.lock().unwrap_or_else(PoisonError::into_inner);
    std::fs::create_dir_all(folder()).unwrap();
    let done = Command::new(env!("CARGO_BIN_EXE_brake-pad"))
        .args(words.split_whitespace())
        .current_dir(folder())
        .output()
        .unwrap();
    let errors = String::from_utf8_lossy(&done.stderr);
    assert!(done.status.success(), "{words}: {errors}");
    String::from_utf8(done.stdout).unwrap()
}

/// A text cut into numbers and what stands between them.
fn pieces(text: &str) -> Vec<Result<f64, String>> {
    let numeric = |c: char| c.is_ascii_digit() || c == '.';
    let mut pieces: Vec<(bool, String)> = Vec::new();
    for word in text.split_whitespace() {
        for (i, c) in word.chars().enumerate() {
            match pieces.last_mut() {
                Some((kind, piece)) if i > 0 && *kind == numeric(c) => piece.push(c),
                _ => pieces.push((numeric(c), c.to_string())),
            }
        }
    }
    pieces
        .into_iter()
        .map(|(_, piece)| piece.parse().map_err(|_| piece))
        .collect()
}

/// Whether two texts differ by no more than the last digits of their numbers.
fn alike(told: &str, found: &str, within: impl Fn(f64) -> f64) -> bool {
    let (told, found) = (pieces(told), pieces(found));
    let near = |pair| match pair {
        (&Ok(a), &Ok(b)) => a == b || f64::abs(a - b) <= within(b),
        (a, b) => a == b,
    };
    told.len() == found.len() && told.iter().zip(&found).all(near)
}

#[test]
fn the_model_is_that_of_the_tutorial() {
    let program = include_str!("../src/main.rs");
    assert_eq!(blocks("rust"), [program]);
    let model = program.split("pub struct").nth(1).unwrap();
    let lines = model.lines().take_while(|line| *line != "}").count();
    assert!(lines <= 12, "the tutorial says twelve lines: {lines}");
}

#[test]
fn the_answers_are_those_of_the_tutorial() {
    let blocks = blocks("text");
    let asked: Vec<&str> = blocks
        .into_iter()
        .filter(|block| block.starts_with(PROMPT))
        .collect();
    assert!(asked.len() >= 4, "{} commands", asked.len());
    for block in asked {
        let mut lines = block.lines();
        let words = lines.next().unwrap().strip_prefix(PROMPT).unwrap();
        let answer = program(words);
        let mut given = answer.lines();
        for told in lines.filter(|line| !["", "..."].contains(&line.trim())) {
            let found = given.any(|line| alike(told, line, |value| 1e-6 * value.abs()));
            assert!(found, "{words}: no line\n{told}\nin\n{answer}");
        }
    }
}

#[test]
fn the_pictures_are_those_of_the_tutorial() {
    for block in blocks("text") {
        let command = block
            .lines()
            .next()
            .and_then(|line| line.strip_prefix(PROMPT));
        command
            .filter(|words| words.contains("--out pictures"))
            .map(program);
    }
    let shown: Vec<&str> = TUTORIAL
        .split("](tutorial/")
        .skip(1)
        .map(|rest| rest.split(')').next().unwrap())
        .collect();
    assert!(shown.len() >= 3, "{shown:?}");
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/tutorial");
    for name in shown {
        let made = std::fs::read_to_string(folder().join("pictures").join(name)).unwrap();
        if std::env::var_os("BLESS").is_some() {
            std::fs::create_dir_all(&docs).unwrap();
            std::fs::write(docs.join(name), &made).unwrap();
        }
        let kept = std::fs::read_to_string(docs.join(name)).unwrap();
        // A tenth of a pixel cannot be seen.
        assert!(
            alike(&kept, &made, |_| 0.1),
            "{name} is not what the program draws"
        );
    }
}
