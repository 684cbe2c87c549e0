//! Ctrl-C ends a long command with what is there, and a diagram goes on from there to the same bytes.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::Value;

use crate::{Answer, stickslip, words};

/// How long the first findings may take on a busy machine.
const PATIENCE: Duration = Duration::from_secs(100);

const DIAGRAM: &str =
    "diagram belt-pair --along v_dr=0.1..0.3 --values 5 --settle 60 --points 12 --lyapunov 4";

/// It settles for longer than any test lasts.
const ENDLESS: &str = "diagram belt-pair --along v_dr=0.1..0.3 --values 2 --settle 100000000";

/// Both ways, and onto the branches that leave it.
const BRANCH: &str = "branch belt-pair --along v_dr=0.0826..0.088 --from 0.086 --switch flips --depth 2 --accuracy 1e-6";

/// The flip of the orbit in phase.
const CURVE: &str =
    "branch belt-pair --along v_dr=0.142..0.147 --and gamma=3..3.02 --accuracy 1e-6";

/// A folder in which nothing is left of an earlier test.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    folder
}

fn start(line: &str, out: &Path) -> Child {
    Command::new(env!("CARGO_BIN_EXE_stickslip"))
        .args(words(line))
        .arg("--out")
        .arg(out)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

fn lines(file: &Path) -> usize {
    fs::read_to_string(file).unwrap_or_default().lines().count()
}

/// Waits until a file has so many lines, or the program has ended.
fn wait_for(child: &mut Child, file: &Path, count: usize) {
    let clock = Instant::now();
    while lines(file) < count && child.try_wait().unwrap().is_none() {
        assert!(
            clock.elapsed() < PATIENCE,
            "{} is not there",
            file.display()
        );
        std::thread::sleep(Duration::from_millis(1));
    }
}

fn send(signal: &str, child: &Child) {
    let sent = Command::new("kill")
        .args([signal, &child.id().to_string()])
        .status();
    assert!(sent.unwrap().success());
}

fn end(child: Child) -> Answer {
    let done = child.wait_with_output().unwrap();
    Answer {
        code: done.status.code(),
        stdout: String::from_utf8(done.stdout).unwrap(),
        stderr: String::from_utf8(done.stderr).unwrap(),
    }
}

/// Interrupts a command as soon as a file of its folder has so many lines.
fn interrupted(line: &str, out: &Path, (file, count): (&str, usize), signal: &str) -> Answer {
    let mut child = start(line, out);
    wait_for(&mut child, &out.join(file), count);
    send(signal, &child);
    let answer = end(child);
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
fn files(folder: &Path) -> BTreeMap<String, String> {
    let entries = fs::read_dir(folder).unwrap().map(Result::unwrap);
    let files = entries.filter(|entry| entry.file_type().unwrap().is_file());
    files
        .map(|entry| {
            let name = entry.file_name().into_string().unwrap();
            (name, fs::read_to_string(entry.path()).unwrap())
        })
        .collect()
}

#[cfg(unix)]
#[test]
fn a_branch_ends_with_what_is_there() {
    let out = folder("interrupted-branch");
    let line = "branch belt-pair --along v_dr=0.14..0.02 --accuracy 1e-11 --json --quiet";
    let answer = interrupted(line, &out, ("branch.csv", 4), "-INT");
    let branch: Value = serde_json::from_str(&answer.stdout).unwrap();
    assert_eq!(branch["ended"], "interrupted");
    let points = branch["points"].as_array().unwrap().len();
    assert!(points >= 3 && answer.stderr.contains(&format!("{points} orbits")));
    assert_eq!(lines(&out.join("branch.csv")), 1 + points);
    assert_eq!(files(&out)["branch.json"], answer.stdout);
}

#[cfg(unix)]
#[test]
fn the_way_to_a_curve_ends_with_what_is_there() {
    let line = format!("{CURVE} --json --quiet");
    let partial = goes_on("curve", &line, ("branch.csv", 3), "curve.resume", "");
    assert!(!partial.contains_key("curve.csv"));
    let branch: Value = serde_json::from_str(&partial["branch.json"]).unwrap();
    assert_eq!(branch["ended"], "interrupted");
    let points = branch["points"].as_array().unwrap().len();
    assert_eq!(partial["branch.csv"].lines().count(), 1 + points);
}

#[cfg(unix)]
#[test]
fn a_trade_ends_with_what_is_there() {
    let out = folder("interrupted-trade");
    let line = "trade belt-oscillator --json --quiet";
    let answer = interrupted(line, &out, ("trade.csv", 3), "-TERM");
    let trade: Value = serde_json::from_str(&answer.stdout).unwrap();
    assert_eq!(trade["interrupted"], true);
    assert!(lines(&out.join("trade.csv")) >= 3);
    assert!(lines(&out.join("work-precision.csv")) >= 2);
}

#[cfg(unix)]
#[test]
fn what_does_not_hear_is_ended() {
    let notes = ("diagram.resume", 1);
    let out = folder("interrupted-deaf");
    let clock = Instant::now();
    let answer = interrupted(ENDLESS, &out, notes, "-INT");
    assert!(
        answer.stderr.contains("nothing was found"),
        "{}",
        answer.stderr
    );
    assert!(clock.elapsed() < PATIENCE);
    // A second signal waits for nothing: whatever the first one has begun.
    let out = folder("interrupted-twice");
    let mut child = start(ENDLESS, &out);
    wait_for(&mut child, &out.join(notes.0), notes.1);
    send("-INT", &child);
    let clock = Instant::now();
    while child.try_wait().unwrap().is_none() && clock.elapsed() < PATIENCE {
        send("-INT", &child);
        std::thread::sleep(Duration::from_millis(20));
    }
    assert_eq!(end(child).code, Some(130));
}

#[cfg(unix)]
#[test]
fn a_report_keeps_its_finished_sections() {
    let out = folder("interrupted-report");
    let answer = interrupted("reproduce --quiet", &out, ("index.html", 10), "-INT");
    assert!(answer.stderr.contains("index.html"), "{}", answer.stderr);
    let page = &files(&out)["index.html"];
    assert!(page.ends_with("</html>\n"));
    assert!(page.contains("id=\"section-2\"") && !page.contains("id=\"section-9\""));
}

/// Interrupts a command as soon as a file has so many lines, ends it later without warning and in the middle of a line,
/// and lets it come to its end: in all, what a run leaves that was never interrupted. Gives what the first interruption
/// left.
#[cfg(unix)]
fn goes_on(
    name: &str,
    line: &str,
    ready: (&str, usize),
    notes: &str,
    threads: &str,
) -> BTreeMap<String, String> {
    let whole = folder(&format!("whole-{name}"));
    let answer = end(start(line, &whole));
    assert_eq!(answer.code, Some(0), "{}", answer.stderr);

    let out = folder(&format!("resumed-{name}"));
    let first = interrupted(line, &out, ready, "-INT");
    assert!(first.stderr.contains("--resume"), "{}", first.stderr);
    let partial = files(&out);
    let resumed = format!("{line} --resume");
    let mut child = start(&resumed, &out);
    let count = lines(&out.join(notes)) + 1;
    wait_for(&mut child, &out.join(notes), count);
    child.kill().unwrap();
    child.wait().unwrap();
    let mut torn = files(&out)[notes].clone();
    assert!(torn.starts_with(&partial[notes]), "{name}: begun anew");
    torn.truncate(torn.len() - 5);
    fs::write(out.join(notes), torn).unwrap();

    let last = end(start(&format!("{resumed}{threads}"), &out));
    assert_eq!(last.code, Some(0), "{}", last.stderr);
    assert_eq!(files(&out), files(&whole), "{name}");
    let [out, whole] = [&out, &whole].map(|path| path.display().to_string());
    assert_eq!(last.stdout.replace(&out, &whole), answer.stdout);
    partial
}

#[cfg(unix)]
#[test]
fn a_diagram_goes_on_to_the_same_bytes() {
    for sweep in ["both", "fresh"] {
        let line = format!("{DIAGRAM} --sweep {sweep} --quiet");
        let notes = "diagram.resume";
        let partial = goes_on(sweep, &line, (notes, 2), notes, " --threads 1");
        let partial: Value = serde_json::from_str(&partial["diagram.json"]).unwrap();
        assert!(partial["interrupted"]["missing"].as_u64().unwrap() > 0);
    }
}

#[cfg(unix)]
#[test]
fn a_branch_goes_on_to_the_same_bytes() {
    let smoothed = "branch belt-pair --along v_dr=0.15..0.13 --smooth arctan:1e2 --accuracy 1e-4";
    for (name, line) in [("exact", BRANCH), ("smoothed", smoothed)] {
        let line = format!("{line} --quiet");
        let partial = goes_on(name, &line, ("branch.csv", 3), "branch.resume", "");
        let partial: Value = serde_json::from_str(&partial["branch.json"]).unwrap();
        assert_eq!(partial["ended"], "interrupted");
    }
}

/// What is left of a command does not go on with another question, and stays as it is.
#[cfg(unix)]
fn refuses(line: &str, notes: &str, changes: &[(&str, &str)]) {
    let out = folder(&format!("another-{notes}"));
    // The question alone is enough, and is there long before the answer, however fast the machine.
    interrupted(line, &out, (notes, 1), "-INT");
    let before = files(&out);
    let refused = |change: &str, part: &str| {
        let answer = end(start(&format!("{line} {change} --resume"), &out));
        assert_eq!(answer.code, Some(2), "{change}: {}", answer.stderr);
        assert!(answer.stderr.contains(part), "{change}: {}", answer.stderr);
    };
    for (change, part) in changes {
        refused(change, part);
        assert_eq!(files(&out), before, "{change}");
    }
    let (here, there) = (env!("CARGO_PKG_VERSION"), "0.0.1-other");
    fs::write(out.join(notes), before[notes].replacen(here, there, 1)).unwrap();
    refused("", &format!("the program was {there}"));
    fs::write(out.join(notes), "not notes\n").unwrap();
    refused("", "cannot be read");
}

#[cfg(unix)]
#[test]
fn another_question_is_not_resumed() {
    refuses(
        ENDLESS,
        "diagram.resume",
        &[
            ("--set gamma=3.5", "gamma was 3.0 and is 3.5"),
            ("--accuracy 1e-8", "`--accuracy` was 1e-9 and is 1e-8"),
            ("--sweep up", "`--sweep` was both and is up"),
            ("--smooth arctan:1e5", "the dynamics was exact"),
            ("--start x1=0.1", "`--start` was None"),
        ],
    );
    refuses(
        "branch belt-pair --along v_dr=0.14..0.05 --switch flips",
        "branch.resume",
        &[
            ("--set gamma=3.5", "gamma was 3.0 and is 3.5"),
            ("--depth 2", "`--switch` was"),
            ("--from 0.1", "v_dr was 0.14 and is 0.1"),
            ("--smooth arctan:1e5", "the dynamics was exact"),
        ],
    );
}

#[test]
fn what_cannot_be_resumed_says_so() {
    for (line, part) in [
        (format!("{DIAGRAM} --resume"), "--out DIR"),
        (
            "branch van-der-pol --along nu=1..0.5 --resume".to_owned(),
            "--out DIR",
        ),
        (
            "equilibria drill-string --along eta=4..6 --resume".to_owned(),
            "`diagram` or a `branch` only",
        ),
        (
            "trade belt-oscillator --resume".to_owned(),
            "`diagram` or a `branch` only",
        ),
    ] {
        let answer = stickslip(&words(&line));
        assert_eq!(answer.code, Some(2), "{line}: {}", answer.stderr);
        assert!(answer.stderr.contains(part), "{line}: {}", answer.stderr);
    }
}

#[test]
fn where_there_is_nothing_to_resume_it_begins() {
    let line =
        "diagram belt-oscillator --along v_dr=0.1..0.3 --values 2 --settle 2 --points 2 --resume";
    let out = folder("nothing");
    for _ in 0..2 {
        let answer = end(start(line, &out));
        assert_eq!(answer.code, Some(0), "{}", answer.stderr);
        assert!(answer.stderr.contains("begins anew"), "{}", answer.stderr);
        assert!(!out.join("diagram.resume").exists());
    }
}
