//! Shares of one list: put together they are the bytes of one run, however they were done.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::Command;

use serde_json::Value;

use crate::interrupted::{TRIALS, end, files, folder, start, wait_for};
use crate::{Answer, stickslip, words};

const MAP: &str =
    "map belt-oscillator period --along v_dr=0.1..0.3:4 --and delta=1..3:3 --accuracy 1e-8";
const SURVEY: &str =
    "attractors van-der-pol --box x=-2..2,v=-1..1 --starts 40 --along nu=0.5..1.5 --values 3";

/// Rows of values that build on each other, and values that build on none.
const SWEEPS: &str =
    "diagram belt-oscillator --along v_dr=0.1..0.3 --values 4 --settle 20 --points 6 --lyapunov 4";
const TRADE: &str = "trade belt-oscillator --along v_dr=0.1..0.2 --smooth tanh:1e4 --accuracy 1e-2";

fn ask(line: &str, out: &Path) -> Answer {
    stickslip(&[words(line), vec!["--out", out.to_str().unwrap()]].concat())
}

fn merge(folder: &Path, words: &[&str]) -> Answer {
    stickslip(&[&["merge", folder.to_str().unwrap()], words].concat())
}

/// The answers, without what shares have left.
fn answers(folder: &Path) -> BTreeMap<String, String> {
    let all = files(folder).into_iter();
    all.filter(|(name, _)| !name.ends_with(".resume")).collect()
}

/// The same without times: they are measured, in lines of JSON and in the last column of a table.
fn timeless(folder: &Path) -> BTreeMap<String, String> {
    let line = |timed: bool, line: &str| match line.rsplit_once(',') {
        Some((row, _)) if timed => row.to_owned(),
        _ => line.to_owned(),
    };
    let content = |content: String| {
        let mut lines = content.lines();
        let timed = lines.next().is_some_and(|head| head.ends_with(",seconds"));
        let lines = lines.filter(|line| !line.contains("\"seconds\":"));
        lines
            .map(|one| line(timed, one))
            .collect::<Vec<_>>()
            .join("\n")
    };
    let all = answers(folder).into_iter();
    all.map(|(name, text)| (name, content(text))).collect()
}

/// Ends a share with a signal after its first items; whether it had not come to its end before.
fn ended(line: &str, out: &Path, notes: &str) -> bool {
    let mut child = start(line, out);
    wait_for(&mut child, &out.join(notes), 2);
    let id = child.id().to_string();
    if child.try_wait().unwrap().is_none() {
        let _ = Command::new("kill").args(["-TERM", &id]).status();
    }
    let answer = end(child);
    if answer.code == Some(75) {
        assert!(
            answer.stderr.contains("interrupted: share"),
            "{}",
            answer.stderr
        );
        return true;
    }
    assert_eq!(answer.code, Some(0), "{}", answer.stderr);
    false
}

#[test]
fn shares_in_any_order_are_the_bytes_of_one_run() {
    let fresh = format!("{SWEEPS} --sweep fresh");
    for (name, line) in [
        ("map", MAP),
        ("attractors", SURVEY),
        ("diagram", SWEEPS),
        ("diagram", &fresh),
        ("trade", TRADE),
    ] {
        let (whole, parts) = (
            folder("shared-in-any-order-whole"),
            folder("shared-in-any-order"),
        );
        let one = ask(&format!("{line} --threads 2"), &whole);
        assert_eq!(one.code, Some(0), "{}", one.stderr);
        for share in [2, 3, 1] {
            let answer = ask(&format!("{line} --shard {share}/3 --threads 1"), &parts);
            assert_eq!(answer.code, Some(0), "{}", answer.stderr);
            assert!(
                answer
                    .stdout
                    .starts_with(&format!("share {share}/3 of `{name}`"))
            );
        }
        assert_eq!(answers(&parts), BTreeMap::new());
        let merged = merge(&parts, &[]);
        assert_eq!(merged.code, Some(0), "{}", merged.stderr);
        assert_eq!(timeless(&parts), timeless(&whole), "{line}");
        if name != "trade" {
            assert_eq!(answers(&parts), files(&whole), "{line}");
            let [told, once] = [merged, one].map(|answer| answer.stdout.replace("-whole", ""));
            assert_eq!(told, once);
        }
    }
}

#[test]
#[ignore = "long"]
fn a_share_that_was_ended_goes_on() {
    let (whole, parts) = (folder("shared-ended-whole"), folder("shared-ended"));
    // Sharp enough that no machine has done it before it is asked to end.
    let line =
        "map belt-pair motion --along v_dr=0.1..0.2:6 --and gamma=2..4:5 --accuracy 1e-11 --quiet";
    assert_eq!(ask(line, &whole).code, Some(0));
    let first = format!("{line} --threads 1 --shard 1/2");
    let mut trials = 0..TRIALS;
    let interrupted = trials.any(|_| {
        let _ = fs::remove_dir_all(&parts);
        ended(&first, &parts, "map.1-of-2.resume")
    });
    assert!(interrupted, "done before it can be ended");
    let before = fs::read_to_string(parts.join("map.1-of-2.resume")).unwrap();
    assert!((2..16).contains(&before.lines().count()));
    assert_eq!(ask(&format!("{first} --resume"), &parts).code, Some(0));
    let after = fs::read_to_string(parts.join("map.1-of-2.resume")).unwrap();
    assert!(after.starts_with(&before));
    assert_eq!(ask(&format!("{line} --shard 2/2"), &parts).code, Some(0));
    assert_eq!(merge(&parts, &["--quiet"]).code, Some(0));
    assert_eq!(answers(&parts), files(&whole));
}

/// Lets a share go on until it has noted two items more, and ends it without warning and in the middle of a line.
fn killed(line: &str, out: &Path, notes: &Path) {
    let before = fs::read_to_string(notes).unwrap_or_default();
    let killed = (0..TRIALS).any(|_| {
        fs::write(notes, &before).unwrap();
        let mut child = start(&format!("{line} --quiet --resume"), out);
        wait_for(&mut child, notes, before.lines().count().max(1) + 2);
        let ended = child.try_wait().unwrap();
        child.kill().unwrap();
        child.wait().unwrap();
        ended.is_none()
    });
    assert!(killed, "{line}: done before it can be ended");
    let after = fs::read_to_string(notes).unwrap();
    fs::write(notes, &after[..after.len() - 7]).unwrap();
}

#[test]
#[ignore = "long"]
fn seven_shares_each_killed_twice_are_the_bytes_of_one_run() {
    for (name, line) in [
        (
            "map",
            "map belt-pair motion --along v_dr=0.1..0.2:10 --and gamma=2..4:7 --accuracy 1e-11",
        ),
        (
            "diagram",
            "diagram belt-pair --along v_dr=0.1..0.2 --values 70 --sweep fresh --settle 2000",
        ),
        (
            "trade",
            "trade belt-oscillator --along v_dr=0.1..0.2 --accuracy 1e-3",
        ),
    ] {
        let (whole, parts) = (folder("shared-killed-whole"), folder("shared-killed"));
        let one = ask(line, &whole);
        assert_eq!(one.code, Some(0), "{}", one.stderr);
        fs::create_dir_all(&parts).unwrap();
        for share in [4, 2, 7, 1, 6, 3, 5] {
            let notes = parts.join(format!("{name}.{share}-of-7.resume"));
            let line = format!("{line} --shard {share}/7 --threads 1");
            killed(&line, &parts, &notes);
            killed(&line, &parts, &notes);
            let last = ask(&format!("{line} --resume"), &parts);
            assert_eq!(last.code, Some(0), "{}", last.stderr);
        }
        assert_eq!(merge(&parts, &["--quiet"]).code, Some(0));
        assert_eq!(timeless(&parts), timeless(&whole), "{line}");
    }
}

#[test]
fn a_sweep_is_a_share_of_its_own() {
    let parts = folder("shared-sweeps");
    for (share, items) in [(1, 4), (2, 4), (3, 0)] {
        let answer = ask(&format!("{SWEEPS} --shard {share}/3"), &parts);
        assert_eq!(answer.code, Some(0), "{}", answer.stderr);
        let said = format!("share {share}/3 of `diagram`: {items} of {items} items\n");
        assert_eq!(answer.stdout, said);
    }
    fs::remove_file(parts.join("diagram.2-of-3.resume")).unwrap();
    let refused = merge(&parts, &[]);
    assert_eq!(refused.code, Some(1));
    let named = "share 2/3 misses 4 items, the first number 4";
    assert!(refused.stderr.contains(named), "{}", refused.stderr);
    let partial = merge(&parts, &["--partial", "--json"]);
    assert_eq!(partial.code, Some(0), "{}", partial.stderr);
    let diagram: Value = serde_json::from_str(&partial.stdout).unwrap();
    assert_eq!(diagram["interrupted"]["missing"], 4);
    let sweeps = diagram["sweeps"].as_array().unwrap().iter();
    let values: Vec<usize> = sweeps
        .map(|sweep| sweep["values"].as_array().unwrap().len())
        .collect();
    assert_eq!(values, [4, 0]);
}

#[test]
fn a_lost_share_is_named_and_the_others_are_usable() {
    let parts = folder("shared-lost");
    for share in [1, 3] {
        assert_eq!(
            ask(&format!("{MAP} --shard {share}/3"), &parts).code,
            Some(0)
        );
    }
    let status = stickslip(&["status", parts.to_str().unwrap(), "--json"]);
    let status: Value = serde_json::from_str(&status.stdout).unwrap();
    assert_eq!(status["absent"], serde_json::json!(["2/3"]));
    assert_eq!(status["shares"][0]["items"], 4);
    let refused = merge(&parts, &[]);
    assert_eq!(refused.code, Some(1));
    let named = "share 2/3 misses 4 items, the first number 1";
    assert!(refused.stderr.contains(named), "{}", refused.stderr);
    let partial = merge(&parts, &["--partial", "--json"]);
    assert_eq!(partial.code, Some(0), "{}", partial.stderr);
    let map: Value = serde_json::from_str(&partial.stdout).unwrap();
    assert_eq!(map["nodes"].as_array().unwrap().len(), 8);
    assert_eq!(map["interrupted"]["missing"], 4);
}

#[test]
fn a_damaged_share_and_one_of_another_question_are_refused() {
    let parts = folder("shared-damaged");
    for share in [1, 2] {
        assert_eq!(
            ask(&format!("{MAP} --shard {share}/2"), &parts).code,
            Some(0)
        );
    }
    let place = parts.join("map.2-of-2.resume");
    let good = fs::read_to_string(&place).unwrap();
    fs::write(&place, good.replacen('A', "B", 1)).unwrap();
    let answer = merge(&parts, &[]);
    assert!(
        answer.code == Some(1) && answer.stderr.contains("map.2-of-2.resume"),
        "{}",
        answer.stderr
    );
    let other = MAP.replace("1e-8", "1e-7");
    assert_eq!(ask(&format!("{other} --shard 2/2"), &parts).code, Some(0));
    let answer = merge(&parts, &[]);
    assert!(
        answer.stderr.contains("another question: `--accuracy` was"),
        "{}",
        answer.stderr
    );
    assert_eq!(merge(&folder("shared-nothing"), &[]).code, Some(2));
}
