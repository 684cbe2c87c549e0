//! Nothing that was found is lost, and the same question has the same answer.

use std::path::Path;
use std::process::{Command, Stdio};
use std::time::Duration;

use crate::{stickslip, words};

/// The rows of a table that are whole: as wide as its head.
fn rows(sheet: &Path) -> usize {
    let text = std::fs::read_to_string(sheet).unwrap_or_default();
    let mut reader = csv::Reader::from_reader(text.as_bytes());
    reader.records().map_while(Result::ok).count()
}

#[test]
fn what_is_found_stays_when_the_program_is_ended() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("ended");
    let sheet = folder.join("branch.csv");
    let _ = std::fs::remove_file(&sheet);
    let line = "branch belt-oscillator --along v_dr=0.2..0.05 --quiet --accuracy 1e-11 --out";
    let mut child = Command::new(env!("CARGO_BIN_EXE_stickslip"))
        .args(words(line))
        .arg(&folder)
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .unwrap();
    while rows(&sheet) < 3 && child.try_wait().unwrap().is_none() {
        std::thread::sleep(Duration::from_millis(1));
    }
    child.kill().unwrap();
    child.wait().unwrap();
    assert!(rows(&sheet) >= 3, "{} rows", rows(&sheet));
    let text = std::fs::read_to_string(&sheet).unwrap();
    let whole = csv::Reader::from_reader(text.as_bytes())
        .into_records()
        .all(|row| row.is_ok());
    assert!(whole && text.ends_with('\n'), "a torn row");
}

#[test]
fn what_came_first_stands_first_at_the_end() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("whole");
    let place = folder.to_str().unwrap();
    for (line, sheet) in [
        ("branch van-der-pol --along nu=1..0.5 --quiet", "branch.csv"),
        (
            "equilibria belt-oscillator --smooth arctan:1e3 --along v_dr=0.2..0.1 --quiet",
            "equilibria.csv",
        ),
    ] {
        let answer = stickslip(&[words(line), vec!["--out", place]].concat());
        assert_eq!(answer.code, Some(0), "{line}: {}", answer.stderr);
        assert!(rows(&folder.join(sheet)) > 3, "{line}");
        let left = std::fs::read_dir(&folder)
            .unwrap()
            .map(|file| file.unwrap().path());
        let parts = left.filter(|path| path.extension().is_some_and(|end| end == "part"));
        assert_eq!(parts.count(), 0, "{line}");
    }
}

/// Where every byte is one too many: a place that Linux has for such tests.
#[cfg(unix)]
const FULL: &str = "/dev/full";

#[cfg(unix)]
#[test]
fn a_full_disk_costs_no_answer() {
    if !Path::new(FULL).exists() {
        eprintln!("skipped: {FULL} is not there");
        return;
    }
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("full");
    let place = folder.to_str().unwrap();
    let diagram = "diagram belt-oscillator --along v_dr=0.1..0.3 --values 2 --settle 2 --points 2";
    for (line, sheet, whole) in [
        (
            "branch van-der-pol --along nu=1..0.5",
            "branch.csv",
            "branch.csv.part",
        ),
        (
            "branch van-der-pol --along nu=1..0.5",
            "branch.csv",
            "branch.svg.part",
        ),
        (
            "branch van-der-pol --along nu=1..0.5",
            "branch.csv",
            "branch.json.part",
        ),
        (diagram, "values.csv", "points.csv.part"),
        ("orbit van-der-pol", "orbit.csv", "orbit.svg.part"),
    ] {
        let _ = std::fs::remove_dir_all(&folder);
        std::fs::create_dir_all(&folder).unwrap();
        let told = stickslip(&words(line)).stdout;
        // It is full for the growing table first, and for the whole one at the end.
        for name in [sheet, whole] {
            std::os::unix::fs::symlink(FULL, folder.join(name)).unwrap();
        }
        let answer = stickslip(&[words(line), vec!["--quiet", "--out", place]].concat());
        assert!(
            answer.stdout.starts_with(told.trim_end()),
            "{line} {whole}: {}",
            answer.stdout
        );
        assert!(answer.code != Some(0), "{line} {whole}");
        let name = whole.trim_end_matches(".part");
        let named = answer.stderr.contains(name) || answer.stderr.contains(sheet);
        assert!(
            named && answer.stderr.contains("space"),
            "{line} {whole}: {}",
            answer.stderr
        );
    }
}

/// Years of work, if it were begun.
const ENDLESS: &str = "diagram belt-oscillator --along v_dr=0.1..0.3 --settle 100000000 --out";

#[cfg(unix)]
#[test]
fn a_folder_that_takes_no_file_is_an_error_before_the_work() {
    use std::os::unix::fs::PermissionsExt;
    let locked = Path::new(env!("CARGO_TARGET_TMPDIR")).join("locked");
    std::fs::create_dir_all(&locked).unwrap();
    std::fs::set_permissions(&locked, std::fs::Permissions::from_mode(0o555)).unwrap();
    let mut places = vec![locked.join("report")];
    if std::fs::write(locked.join("probe"), "").is_ok() {
        eprintln!("skipped in part: this user may write anywhere");
        places.clear();
    }
    // Where not even root makes a folder.
    if Path::new("/proc/self").exists() {
        places.push("/proc/stickslip".into());
    }
    for place in places {
        let answer = stickslip(&[words(ENDLESS), vec![place.to_str().unwrap()]].concat());
        let told = format!("nothing can be written to `--out {}`", place.display());
        assert_eq!(answer.code, Some(2), "{}", answer.stderr);
        assert!(answer.stderr.contains(&told), "{}", answer.stderr);
    }
}

#[cfg(unix)]
#[test]
fn a_disk_that_is_full_already_is_an_error_before_the_work() {
    if !Path::new(FULL).exists() {
        eprintln!("skipped: {FULL} is not there");
        return;
    }
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("full-already");
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    std::os::unix::fs::symlink(FULL, folder.join("diagram.resume")).unwrap();
    let answer = stickslip(&[words(ENDLESS), vec![folder.to_str().unwrap()]].concat());
    assert_eq!(answer.code, Some(2), "{}", answer.stderr);
    assert!(
        answer.stderr.contains("diagram.resume"),
        "{}",
        answer.stderr
    );
}

#[cfg(unix)]
#[test]
fn an_answer_that_cannot_be_printed_is_an_error() {
    let Ok(full) = std::fs::File::options().write(true).open(FULL) else {
        eprintln!("skipped: {FULL} is not there");
        return;
    };
    let done = Command::new(env!("CARGO_BIN_EXE_stickslip"))
        .args(words("orbit van-der-pol"))
        .stdout(full)
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
        .wait_with_output()
        .unwrap();
    assert_eq!(done.status.code(), Some(1));
    assert!(
        String::from_utf8(done.stderr)
            .unwrap()
            .contains("cannot write the answer")
    );
}

#[test]
fn the_same_question_has_the_same_answer() {
    for line in [
        "orbit belt-pair --json",
        "orbit drill-string --smooth quartic:1e-3 --json",
        "branch belt-oscillator --along v_dr=0.2..0.15 --json",
    ] {
        let [one, two] = [(); 2].map(|()| stickslip(&words(line)).stdout);
        assert!(!one.is_empty() && one == two, "{line}");
    }
}

/// `.ci/run` names the optimised build here: both round differently, and may differ in no digit that is claimed.
#[test]
fn another_build_has_the_same_digits() {
    let Some(other) = std::env::var_os("STICKSLIP_OTHER") else {
        return;
    };
    for line in [
        "orbit van-der-pol --json",
        "orbit belt-oscillator --json",
        "orbit belt-pair --json",
        "orbit drill-string --json",
        "orbit belt-pair --smooth arctan:1e6 --json",
        "orbit drill-string --smooth quartic:1e-4 --json",
    ] {
        let there = Command::new(&other).args(words(line)).output().unwrap();
        let there = String::from_utf8(there.stdout).unwrap();
        let [here, there] = [stickslip(&words(line)).stdout, there]
            .map(|text| serde_json::from_str::<serde_json::Value>(&text).unwrap());
        let number = |from: &serde_json::Value, name: &str| from[name].as_f64().unwrap();
        // An estimate that claims nothing would hide any difference.
        assert!(number(&here, "error_estimate") < 1e-6, "{line}");
        for exactly in ["stability", "word", "period_count", "dynamics"] {
            assert_eq!(here[exactly], there[exactly], "{line}");
        }
        let off = number(&here, "period") / number(&there, "period") - 1.0;
        assert!(
            off.abs() <= number(&here, "error_estimate"),
            "{line}: {off:e}"
        );
        for (name, value) in here["max_abs"].as_object().unwrap() {
            let off = value.as_f64().unwrap() / number(&there["max_abs"], name) - 1.0;
            assert!(
                off.abs() <= number(&here, "error_estimate"),
                "{line} {name}: {off:e}"
            );
        }
    }
}
