//! The page shows what this program draws: each command on it is run, and the words of its pictures are compared.
//!
//! `BLESS=1` writes the pictures anew.

use std::path::{Path, PathBuf};
use std::process::Command;

const PAGE: &str = include_str!("../README.md");

/// A command of the page with the picture below it.
struct Shown {
    words: &'static str,
    picture: &'static str,
}

fn shown() -> Vec<Shown> {
    let sections = PAGE.split("\n`gallery ").skip(1);
    let shown = sections.map(|section| {
        let words = section.split('`').next().unwrap();
        let link = section.split("](pictures/").nth(1).unwrap();
        let picture = link.split(')').next().unwrap();
        Shown { words, picture }
    });
    shown.collect()
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_TARGET_TMPDIR")).join("gallery")
}

/// The words of a drawing: titles, ticks, legends and labels. How many points make a curve is the machine's affair.
fn words_of(drawing: &str) -> Vec<&str> {
    let texts = drawing.split("<text ").skip(1);
    texts
        .map(|text| {
            let text = text.split("</text>").next().unwrap_or(text);
            text.split_once('>').map_or(text, |(_, words)| words)
        })
        .collect()
}

#[test]
fn the_pictures_are_those_of_the_program() {
    std::fs::create_dir_all(folder()).unwrap();
    let all = shown();
    assert!(all.len() >= 20, "{} systems", all.len());
    for Shown { words, picture } in all {
        let done = Command::new(env!("CARGO_BIN_EXE_gallery"))
            .args(words.split_whitespace())
            .current_dir(folder())
            .output()
            .unwrap();
        let errors = String::from_utf8_lossy(&done.stderr);
        assert!(done.status.success(), "{words}: {errors}");
        let made = std::fs::read_to_string(folder().join("pictures").join(picture)).unwrap();
        let keeps = Path::new(env!("CARGO_MANIFEST_DIR")).join("pictures");
        let keep = keeps.join(picture);
        if std::env::var_os("BLESS").is_some() {
            std::fs::create_dir_all(keep.parent().unwrap()).unwrap();
            std::fs::write(&keep, &made).unwrap();
        }
        let kept = std::fs::read_to_string(keep).unwrap();
        assert_eq!(
            words_of(&kept),
            words_of(&made),
            "{picture} is not what `{words}` draws"
        );
    }
}

#[test]
fn every_model_has_its_place_on_the_page() {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    for entry in std::fs::read_dir(source).unwrap() {
        let name = entry.unwrap().file_name().into_string().unwrap();
        let model = !["main.rs", "asked.rs", "balance.rs", "reference.rs"].contains(&name.as_str());
        let link = format!("](src/{name})");
        assert!(!model || PAGE.contains(&link), "{name} is not on the page");
    }
}
