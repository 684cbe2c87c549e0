//! Ctrl-C ends a long command with what is there.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::Duration;

use serde_json::Value;

use crate::{Answer, words};

/// How often a command is begun that may come to its end before it can be interrupted.
pub(crate) const TRIALS: usize = 20;

/// A folder in which nothing is left of an earlier test.
pub(crate) fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    folder
}

/// The program, which heeds signals even if whoever runs the tests ignores them, as a shell in the background does.
fn heeding() -> Command {
    let program = env!("CARGO_BIN_EXE_stickslip");
    if cfg!(target_os = "linux") {
        let mut heeding = Command::new("env");
        heeding.args(["--default-signal=INT,HUP,TERM", program]);
        heeding
    } else {
        Command::new(program)
    }
}

pub(crate) fn start(line: &str, out: &Path) -> Child {
    heeding()
        .args(words(line))
        .arg("--out")
        .arg(out)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

pub(crate) fn lines(file: &Path) -> usize {
    fs::read_to_string(file).unwrap_or_default().lines().count()
}

/// Waits until a file has so many lines, or the program has ended; however long that takes.
pub(crate) fn wait_for(child: &mut Child, file: &Path, count: usize) {
    while lines(file) < count && child.try_wait().unwrap().is_none() {
        std::thread::sleep(Duration::from_millis(1));
    }
}

/// Sends a signal to a program that has not ended.
fn send(signal: &str, child: &mut Child) {
    if child.try_wait().unwrap().is_none() {
        let id = child.id().to_string();
        let sent = Command::new("kill").args([signal, &id]).status();
        assert!(sent.unwrap().success());
    }
}

pub(crate) fn end(child: Child) -> Answer {
    let done = child.wait_with_output().unwrap();
    Answer {
        code: done.status.code(),
        stdout: String::from_utf8(done.stdout).unwrap(),
        stderr: String::from_utf8(done.stderr).unwrap(),
    }
}

/// Interrupts a command as soon as a file of its folder has so many lines.
pub(crate) fn interrupted(line: &str, out: &Path, ready: (&str, usize), signal: &str) -> Answer {
    interrupted_before("none", line, out, ready, signal)
}

/// Interrupts a command as soon as a file of its folder has so many lines, and before there is another file.
///
/// A command that has come further or to its end before is begun anew: no machine is too fast or too busy.
pub(crate) fn interrupted_before(
    later: &str,
    line: &str,
    out: &Path,
    (file, count): (&str, usize),
    signal: &str,
) -> Answer {
    let trial = |_| {
        let _ = fs::remove_dir_all(out);
        let mut child = start(line, out);
        wait_for(&mut child, &out.join(file), count);
        send(signal, &mut child);
        Some(end(child)).filter(|answer| answer.code != Some(0) && !out.join(later).exists())
    };
    let answer = (0..TRIALS).find_map(trial);
    let answer = answer.unwrap_or_else(|| panic!("{line}: done before it can be interrupted"));
    assert_eq!(answer.code, Some(130), "{line}: {}", answer.stderr);
    assert!(answer.stderr.contains("interrupted"), "{}", answer.stderr);
    for (name, content) in files(out) {
        assert!(!name.ends_with(".part"), "{line}: {name}");
        if name.ends_with(".csv") {
            let whole = csv::Reader::from_reader(content.as_bytes())
                .into_records()
                .all(|row| row.is_ok());
            assert!(whole && content.ends_with('\n'), "{line}: {name}");
        }
    }
    answer
}

/// All files of a folder by name.
pub(crate) fn files(folder: &Path) -> BTreeMap<String, String> {
    let entries = fs::read_dir(folder).unwrap().map(Result::unwrap);
    let files = entries.filter(|entry| entry.file_type().unwrap().is_file());
    files
        .map(|entry| {
            let name = entry.file_name().into_string().unwrap();
            // Pictures are written as PDF, too, which is no text.
            let content = fs::read(entry.path()).unwrap();
            (name, String::from_utf8_lossy(&content).into_owned())
        })
        .collect()
}

#[test]
fn a_branch_ends_with_what_is_there() {
    let out = folder("interrupted-branch");
    let line = "branch belt-oscillator --along v_dr=0.2..0.05 --accuracy 1e-11 --json --quiet";
    let answer = interrupted(line, &out, ("branch.csv", 4), "-INT");
    let branch: Value = serde_json::from_str(&answer.stdout).unwrap();
    assert_eq!(branch["ended"], "interrupted");
    let points = branch["points"].as_array().unwrap().len();
    assert!(points >= 3 && answer.stderr.contains(&format!("{points} orbits")));
    assert_eq!(lines(&out.join("branch.csv")), 1 + points);
    assert_eq!(files(&out)["branch.json"], answer.stdout);
}

#[test]
#[ignore = "long"]
fn a_trade_ends_with_what_is_there() {
    let out = folder("interrupted-trade");
    let line = "trade belt-oscillator --json --quiet";
    let answer = interrupted(line, &out, ("trade.csv", 3), "-TERM");
    let trade: Value = serde_json::from_str(&answer.stdout).unwrap();
    assert!(trade["interrupted"]["missing"].as_u64().unwrap() > 0);
    assert!(lines(&out.join("trade.csv")) >= 3);
    assert!(lines(&out.join("work-precision.csv")) >= 2);
}

#[test]
fn what_does_not_hear_is_ended() {
    // Years of work: that it comes to an end at all is the answer.
    let deaf = "diagram belt-pair --along v_dr=0.1..0.3 --values 2 --settle 100000000";
    let notes = ("diagram.resume", 1);
    let out = folder("interrupted-deaf");
    let answer = interrupted(deaf, &out, notes, "-INT");
    assert!(
        answer.stderr.contains("nothing was found"),
        "{}",
        answer.stderr
    );
    // A second signal waits for nothing: whatever the first one has begun.
    let out = folder("interrupted-twice");
    let mut child = start(deaf, &out);
    wait_for(&mut child, &out.join(notes.0), notes.1);
    while child.try_wait().unwrap().is_none() {
        send("-INT", &mut child);
        std::thread::sleep(Duration::from_millis(20));
    }
    assert_eq!(end(child).code, Some(130));
}

#[test]
#[ignore = "long"]
fn a_report_keeps_its_finished_sections() {
    let out = folder("interrupted-report");
    // The page of its first section alone is shorter.
    let answer = interrupted("reproduce --quiet", &out, ("index.html", 110), "-INT");
    assert!(answer.stderr.contains("index.html"), "{}", answer.stderr);
    let page = &files(&out)["index.html"];
    assert!(page.ends_with("</html>\n"));
    assert!(page.contains("id=\"section-2\"") && !page.contains("id=\"section-9\""));
}
