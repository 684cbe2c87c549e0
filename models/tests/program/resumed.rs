//! What was interrupted goes on from there to the same bytes, and with no other question.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use serde_json::Value;

use crate::interrupted::{
    TRIALS, end, files, folder, interrupted, interrupted_before, start, wait_for,
};
use crate::{stickslip, words};

const DIAGRAM: &str = "diagram belt-oscillator --along v_dr=0.1..0.3 --values 5 --settle 200 --points 12 --lyapunov 4";

const BRANCH: &str = "branch belt-oscillator --along v_dr=0.2..0.05 --accuracy 1e-11";

/// Both ways, and onto the branches that leave it.
const TREE: &str = "branch belt-pair --along v_dr=0.0826..0.088 --from 0.086 --switch flips --depth 2 --accuracy 1e-6";

/// The first flip of a long way.
const CURVE: &str =
    "branch belt-pair --along v_dr=0.3..0.05 --and beta=1.2..1.21 --of PD1 --accuracy 1e-11";

/// A folder with these files and no others.
fn restore(folder: &Path, files: &BTreeMap<String, String>) {
    fs::remove_dir_all(folder).unwrap();
    fs::create_dir(folder).unwrap();
    for (name, content) in files {
        fs::write(folder.join(name), content).unwrap();
    }
}

/// Lets a command go on from what is there until it has noted one thing more, and ends it without warning; gives its
/// notes.
fn goes_a_step(line: &str, out: &Path, partial: &BTreeMap<String, String>, notes: &str) -> String {
    let trial = |_| {
        restore(out, partial);
        let mut child = start(line, out);
        wait_for(
            &mut child,
            &out.join(notes),
            partial[notes].lines().count() + 1,
        );
        child.kill().unwrap();
        child.wait().unwrap();
        // There are none any more where it has come to its end.
        files(out).remove(notes)
    };
    let noted = (0..TRIALS).find_map(trial);
    noted.unwrap_or_else(|| panic!("{line}: done before it can be ended"))
}

/// Interrupts a command as soon as a file has so many lines, ends it later without warning and in the middle of a line,
/// and lets it come to its end: in all, what a run leaves that was never interrupted. Gives what the first interruption
/// left.
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
    let first = interrupted_before("curve.csv", line, &out, ready, "-INT");
    assert!(first.stderr.contains("--resume"), "{}", first.stderr);
    let partial = files(&out);
    let resumed = format!("{line} --resume");
    let mut torn = goes_a_step(&resumed, &out, &partial, notes);
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

fn a_diagram_goes_on(sweep: &str) {
    let line = format!("{DIAGRAM} --sweep {sweep} --quiet");
    let notes = "diagram.resume";
    let partial = goes_on(sweep, &line, (notes, 2), notes, " --threads 1");
    let partial: Value = serde_json::from_str(&partial["diagram.json"]).unwrap();
    assert!(partial["interrupted"]["missing"].as_u64().unwrap() > 0);
}

#[test]
fn a_diagram_goes_on_to_the_same_bytes() {
    a_diagram_goes_on("both");
}

#[test]
#[ignore = "long"]
fn a_diagram_of_fresh_starts_goes_on_to_the_same_bytes() {
    a_diagram_goes_on("fresh");
}

fn a_branch_goes_on(name: &str, line: &str) {
    let line = format!("{line} --quiet");
    let partial = goes_on(name, &line, ("branch.csv", 3), "branch.resume", "");
    let partial: Value = serde_json::from_str(&partial["branch.json"]).unwrap();
    assert!(is_interrupted(&partial), "{partial}");
}

/// Whether a branch was interrupted, or one of those that leave it: which of them is at work is the machine's affair.
fn is_interrupted(branch: &Value) -> bool {
    let below = branch["branches"].as_array();
    ["ended", "began"]
        .iter()
        .any(|end| branch[end] == "interrupted")
        || below.is_some_and(|below| below.iter().any(is_interrupted))
}

#[test]
fn a_branch_goes_on_to_the_same_bytes() {
    a_branch_goes_on("exact", BRANCH);
}

#[test]
#[ignore = "long"]
fn a_smoothed_branch_goes_on_to_the_same_bytes() {
    a_branch_goes_on("smoothed", &format!("{BRANCH} --smooth arctan:1e3"));
}

#[test]
#[ignore = "long"]
fn branches_that_leave_others_go_on_to_the_same_bytes() {
    a_branch_goes_on("tree", TREE);
}

#[test]
#[ignore = "long"]
fn the_way_to_a_curve_goes_on_to_the_same_bytes() {
    let line = format!("{CURVE} --json --quiet");
    let partial = goes_on("curve", &line, ("branch.csv", 3), "curve.resume", "");
    let branch: Value = serde_json::from_str(&partial["branch.json"]).unwrap();
    assert_eq!(branch["ended"], "interrupted");
    let points = branch["points"].as_array().unwrap().len();
    assert_eq!(partial["branch.csv"].lines().count(), 1 + points);
}

/// What is left of a command does not go on with another question, and stays as it is.
fn refuses(line: &str, ready: (&str, usize), notes: &str, changes: &[(&str, &str)]) {
    let out = folder(&format!("another-{notes}"));
    interrupted(line, &out, ready, "-INT");
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
    for wrong in [
        before[notes].replacen(here, there, 1),
        "not notes\n".to_owned(),
    ] {
        fs::write(out.join(notes), wrong).unwrap();
        refused("", "cannot be read: line 1 is not as it was written");
    }
}

#[test]
fn another_diagram_is_not_resumed() {
    refuses(
        DIAGRAM,
        ("diagram.resume", 2),
        "diagram.resume",
        &[
            ("--set delta=3.5", "delta was 3.0 and is 3.5"),
            ("--accuracy 1e-8", "`--accuracy` was 1e-9 and is 1e-8"),
            ("--sweep up", "`--sweep` was both and is up"),
            ("--smooth arctan:1e5", "the dynamics was exact"),
            ("--start x=0.1", "`--start` was None"),
        ],
    );
}

#[test]
fn another_branch_is_not_resumed() {
    refuses(
        &format!("{BRANCH} --switch flips"),
        ("branch.csv", 2),
        "branch.resume",
        &[
            ("--set delta=3.5", "delta was 3.0 and is 3.5"),
            ("--depth 2", "`--switch` was"),
            ("--from 0.1", "v_dr was 0.2 and is 0.1"),
            ("--harmonics 2", "`--harmonics` was [] and is [2]"),
            ("--smooth arctan:1e5", "the dynamics was exact"),
        ],
    );
}

#[test]
fn another_curve_is_not_resumed() {
    refuses(
        CURVE,
        ("branch.csv", 2),
        "curve.resume",
        &[
            ("--harmonics 1,3", "`--harmonics` was [] and is [1, 3]"),
            ("--set gamma=3.1", "gamma was 3.0 and is 3.1"),
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
            "a `map` or `attractors` only",
        ),
        ("trade belt-oscillator --resume".to_owned(), "--out DIR"),
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
