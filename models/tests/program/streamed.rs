//! A motion of any length takes no more memory than what is kept of it, and leaves whole files whatever ends it.

use std::fs;

use serde_json::Value;

use crate::interrupted::{end, files, folder, interrupted, start};
use crate::{stickslip, words};

/// Steps beyond which a table is thinned.
const LONG: &str = "simulate belt-oscillator --time 1e4";

#[test]
fn a_long_motion_is_thinned_but_for_its_extremes() {
    let out = folder("streamed");
    let answer = end(start(&format!("{LONG} --json --quiet"), &out));
    assert_eq!(answer.code, Some(0), "{}", answer.stderr);
    let motion: Value = serde_json::from_str(&answer.stdout).unwrap();
    let rows = motion["time"].as_array().unwrap();
    let (every, samples) = (motion["every"].as_u64(), motion["samples"].as_u64());
    let kept = samples.unwrap().div_ceil(every.unwrap());
    assert!(
        every.unwrap() > 1 && (kept..kept + 6).contains(&(rows.len() as u64)),
        "{every:?}"
    );
    assert!(rows.len() < 70_000, "{}", rows.len());
    assert_eq!(rows.last().unwrap(), 1e4);
    let times = rows.iter().map(|time| time.as_f64().unwrap());
    assert!(times.is_sorted_by(|a, b| a < b));
    for state in ["x", "v"] {
        let values = motion["states"][state].as_array().unwrap();
        for side in ["min", "max"] {
            assert!(values.contains(&motion[side][state]), "{side} of {state}");
        }
        assert_eq!(values.last(), Some(&motion["state"][state]));
    }
    let files = files(&out);
    assert_eq!(files["trajectory.json"], answer.stdout);
    assert_eq!(files["trajectory.csv"].lines().count(), 1 + rows.len());
    assert!(files["trajectory.svg"].len() < 4_000_000);
}

#[test]
fn a_motion_that_takes_too_many_steps_says_so_early() {
    let out = folder("too-long");
    let line = "simulate belt-oscillator --time 1e12 --steps 20000 --json";
    let answer = end(start(line, &out));
    assert_eq!(answer.code, Some(1), "{}", answer.stderr);
    assert!(
        answer.stderr.contains("would take some"),
        "{}",
        answer.stderr
    );
    assert!(
        answer.stderr.contains("`--steps` allows more"),
        "{}",
        answer.stderr
    );
    let motion: Value = serde_json::from_str(&answer.stdout).unwrap();
    assert_eq!(motion["ended"], "too-many-steps");
    let reached = motion["reached"].as_f64().unwrap();
    assert!(1e3 < reached && reached < 1e5, "{reached}");
    assert_eq!(
        motion["time"].as_array().unwrap().last().unwrap(),
        &motion["reached"]
    );
    assert_eq!(files(&out)["trajectory.json"], answer.stdout);
}

#[test]
fn an_endless_motion_ends_with_whole_files() {
    let line = "simulate belt-oscillator --time 1e12 --json";
    for signal in ["-INT", "-TERM", "-HUP"] {
        let out = folder("endless");
        let answer = interrupted(line, &out, ("trajectory.csv", 1000), signal);
        assert!(
            answer.stderr.contains("was followed to t ="),
            "{}",
            answer.stderr
        );
        let motion: Value = serde_json::from_str(&answer.stdout).unwrap();
        assert_eq!(motion["ended"], "interrupted");
        let files = files(&out);
        assert_eq!(files["trajectory.json"], answer.stdout);
        let rows = motion["time"].as_array().unwrap().len();
        assert_eq!(files["trajectory.csv"].lines().count(), 1 + rows);
        assert!(files["trajectory.svg"].ends_with("</svg>"), "{signal}");
    }
}

#[test]
#[cfg(target_os = "linux")]
fn a_signal_that_is_to_be_ignored_is() {
    use std::process::{Command, Stdio};
    let out = folder("ignored");
    let line = "simulate belt-oscillator --time 3e4 --quiet --out";
    let mut child = Command::new("sh")
        .args([
            "-c",
            "trap '' HUP; exec \"$0\" \"$@\"",
            env!("CARGO_BIN_EXE_stickslip"),
        ])
        .args(words(line))
        .arg(&out)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    crate::interrupted::wait_for(&mut child, &out.join("trajectory.csv"), 100);
    let id = child.id().to_string();
    let _ = Command::new("kill").args(["-HUP", &id]).status();
    let answer = end(child);
    assert_eq!(answer.code, Some(0), "{}", answer.stderr);
    assert!(out.join("trajectory.json").exists());
}

#[test]
fn a_search_that_is_ended_prints_a_document() {
    // It has no other file to wait for than the one that it makes sure of.
    let out = folder("searching");
    let line = "orbit belt-pair --set alpha=1e12 --start x1=1 --json";
    fs::create_dir_all(&out).unwrap();
    let child = start(line, &out);
    std::thread::sleep(std::time::Duration::from_millis(300));
    let id = child.id().to_string();
    let sent = std::process::Command::new("kill")
        .args(["-HUP", &id])
        .status();
    assert!(sent.is_ok());
    let answer = end(child);
    // Whoever is faster than the signal has an answer of its own.
    if answer.code == Some(130) {
        let orbit: Value = serde_json::from_str(&answer.stdout).unwrap();
        assert_eq!(orbit["ended"], "interrupted");
        assert_eq!(orbit["parameters"]["alpha"], 1e12);
    }
}

#[test]
fn a_drive_that_turns_too_often_is_told() {
    let answer = stickslip(&words("orbit forced-belt --start x=0.1 --period 1e9"));
    assert_eq!(answer.code, Some(1));
    assert!(answer.stderr.contains("so many turns"), "{}", answer.stderr);
    let line = "simulate forced-belt --set omega=1e12 --steps 1000";
    let answer = stickslip(&words(line));
    assert_eq!(answer.code, Some(1), "{}", answer.stderr);
    assert!(answer.stderr.contains("`--steps`"), "{}", answer.stderr);
}

/// The most memory of a command so far, in MiB.
#[cfg(target_os = "linux")]
fn peak(line: &str) -> (f64, crate::Answer) {
    use std::process::{Command, Stdio};
    let mut child = Command::new(env!("CARGO_BIN_EXE_stickslip"))
        .args(words(line))
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let status = format!("/proc/{}/status", child.id());
    let mut most: f64 = 0.0;
    while child.try_wait().unwrap().is_none() {
        let text = fs::read_to_string(&status).unwrap_or_default();
        let line = text.lines().find(|line| line.starts_with("VmHWM:"));
        let size = line.and_then(|line| line.split_whitespace().nth(1)?.parse::<f64>().ok());
        most = most.max(size.unwrap_or(0.0) / 1024.0);
        std::thread::sleep(std::time::Duration::from_millis(2));
    }
    (most, end(child))
}

#[test]
#[ignore = "long"]
#[cfg(target_os = "linux")]
fn memory_is_bounded() {
    for (line, most) in [
        ("simulate belt-oscillator --time 4.7e6 --quiet", 100.0),
        ("simulate belt-oscillator --time 3e5", 100.0),
        ("simulate belt-pair --set alpha=1e5", 100.0),
        ("orbit forced-belt --set omega=1e12", 300.0),
    ] {
        let (size, answer) = peak(line);
        println!(
            "{line}: {size:.0} MiB, exit {:?}: {}",
            answer.code, answer.stderr
        );
        assert!(size < most, "{line}: {size} MiB");
    }
}
