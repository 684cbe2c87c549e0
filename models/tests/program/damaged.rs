//! Nothing false comes from disk: what is resumed from a folder in which a byte was changed, removed or added is what it
//! would have been, or it is refused.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use fastrand::Rng;

use crate::interrupted::{end, folder, interrupted, start};

/// Folders for each command: 2,000 in all.
const FOLDERS: usize = 500;

type Files = BTreeMap<String, Vec<u8>>;

fn bytes(folder: &Path) -> Files {
    let entries = fs::read_dir(folder).unwrap().map(Result::unwrap);
    let named = entries.map(|entry| {
        let name = entry.file_name().into_string().unwrap();
        (name, fs::read(entry.path()).unwrap())
    });
    named.collect()
}

fn restore(folder: &Path, files: &Files) {
    let _ = fs::remove_dir_all(folder);
    fs::create_dir(folder).unwrap();
    for (name, content) in files {
        fs::write(folder.join(name), content).unwrap();
    }
}

/// Changes, removes or adds a byte; of the notes in seven of eight times.
fn damage(files: &Files, notes: &str, dice: &mut Rng) -> (Files, String) {
    let mut files = files.clone();
    let names: Vec<String> = files.keys().cloned().collect();
    let name = match dice.u8(0..8) {
        0 => names[dice.usize(0..names.len())].clone(),
        _ => notes.to_owned(),
    };
    let content = files.get_mut(&name).unwrap();
    let at = dice.usize(0..content.len());
    let byte = match dice.u8(0..3) {
        0 => b'\n',
        1 => dice.alphanumeric() as u8,
        _ => dice.u8(..),
    };
    let what = match dice.u8(0..4) {
        0 => {
            content.remove(at);
            format!("{name}: byte {at} removed")
        }
        1 => {
            content.insert(at, byte);
            format!("{name}: {byte} added at {at}")
        }
        2 => {
            content.truncate(at);
            format!("{name}: cut off at {at}")
        }
        _ => {
            content[at] = byte;
            format!("{name}: byte {at} is {byte}")
        }
    };
    (files, what)
}

/// Resumes a command in so many damaged folders.
fn holds(name: &str, line: &str, ready: (&str, usize), notes: &str, folders: usize) {
    let whole = folder(&format!("undamaged-{name}"));
    assert_eq!(end(start(line, &whole)).code, Some(0));
    let whole = bytes(&whole);
    let out = folder(&format!("damaged-{name}"));
    interrupted(line, &out, ready, "-INT");
    let partial = bytes(&out);
    let resumed = format!("{line} --resume");
    let mut dice = Rng::with_seed(13);
    let (mut refused, mut done) = (0, 0);
    for _ in 0..folders {
        let (files, what) = damage(&partial, notes, &mut dice);
        restore(&out, &files);
        let answer = end(start(&resumed, &out));
        if answer.code == Some(2) {
            let told = answer.stderr.contains(notes) && answer.stderr.contains("--resume");
            assert!(told, "{what}: {}", answer.stderr);
            assert_eq!(bytes(&out), files, "{what}: refused, and changed");
            refused += 1;
        } else {
            assert_eq!(answer.code, Some(0), "{what}: {}", answer.stderr);
            assert!(bytes(&out) == whole, "{what}: other bytes");
            done += 1;
        }
    }
    println!("{name}: {refused} refused, {done} the same");
    assert!(refused > folders / 4 && done > folders / 20);
}

const DIAGRAM: &str =
    "diagram forced-belt --along omega=0.5..3 --values 24 --settle 40 --points 8 --quiet";

#[test]
fn a_damaged_diagram_is_refused_or_whole() {
    let ready = ("diagram.resume", 4);
    holds("diagram", DIAGRAM, ready, "diagram.resume", 40);
}

#[test]
#[ignore = "long"]
fn damaged_diagrams_are_refused_or_whole() {
    let ready = ("diagram.resume", 12);
    let folders = 2 * FOLDERS + 3 * FOLDERS / 4;
    holds("diagrams", DIAGRAM, ready, "diagram.resume", folders);
}

#[test]
#[ignore = "long"]
fn damaged_branches_are_refused_or_whole() {
    // Long enough to be interrupted on any machine, and so gone through less often.
    let line =
        "branch drill-string --smooth quartic:0.1 --along eta=4..7.49 --accuracy 1e-11 --quiet";
    let folders = FOLDERS / 4;
    holds(
        "branches",
        line,
        ("branch.csv", 4),
        "branch.resume",
        folders,
    );
}

#[test]
#[ignore = "long"]
fn damaged_curves_are_refused_or_whole() {
    let line =
        "branch belt-pair --along v_dr=0.1..0.08 --and beta=1.3..1.31 --accuracy 1e-11 --quiet";
    holds("curves", line, ("branch.csv", 3), "curve.resume", FOLDERS);
}
