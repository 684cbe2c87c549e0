//! `--resume`: what a long command notes as it goes on, so that it can go on where it was ended.
//!
//! The notes lie beside the tables. Their first line is the question, for notes help with no other one; each further line
//! is a finding, with every digit, under a [`Seal`] that begins with the question. They go when the command has come to
//! its end.

use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use base64::Engine;
use base64::engine::general_purpose::STANDARD_NO_PAD as BASE64;

use super::arguments::Resume;
use super::failure::{Failure, refuse};
use super::interrupt::ENDING;
use super::journal::Growing;
use super::output::Output;
use super::question::{ANEW, Question};
use super::seal::Seal;

/// The notes of a command.
pub(super) struct Notes(Option<(PathBuf, Option<Sealed>)>);

/// A file that is whole after each line, and what seals the next one.
struct Sealed {
    file: Growing,
    seal: Seal,
}

impl Notes {
    /// Notes of nothing.
    pub(super) const fn none() -> Self {
        Self(None)
    }

    /// Notes of this name: new ones, or with `--resume` those that are there, of which each whole line is read.
    ///
    /// # Errors
    /// There is no folder to resume in, or its notes belong to another question, or are not as they were written.
    pub(super) fn open(
        output: &Output,
        resume: &Resume,
        name: &str,
        question: &Question,
        read: &mut dyn FnMut(&[u8]) -> Option<()>,
    ) -> Result<Self, Failure> {
        let Some(path) = output.path(&format!("{name}.{ENDING}")) else {
            return if resume.resume {
                refuse!("`--resume` goes on from what is in a folder: name it with `--out DIR`")
            } else {
                Ok(Self(None))
            };
        };
        let unusable = |error: std::io::Error| {
            let place = path.display();
            Failure::usage(format!("`--out`: {place} cannot be used: {error}"))
        };
        let old = match resume.resume.then(|| std::fs::read(&path)) {
            Some(Err(error)) if error.kind() != ErrorKind::NotFound => return Err(unusable(error)),
            Some(old) => old.unwrap_or_default(),
            None => Vec::new(),
        };
        let sealed = if let Some(lines) = whole(&old) {
            let seal = agreed(lines, question, read).map_err(|reason| {
                Failure::usage(format!("`--resume`: {} {reason}", path.display()))
            })?;
            let file = Growing::carry_on(path.clone(), lines.len() as u64);
            file.map(|file| Sealed { file, seal })
        } else {
            if resume.resume {
                output.note("note: there is nothing to resume: it begins anew");
            }
            let mut seal = Seal::default();
            let first = seal.line(&question.line()?);
            let file = Growing::begin(path.clone(), &first);
            file.map(|file| Sealed { file, seal })
        };
        let sealed = sealed.map_err(unusable)?;
        Ok(Self(Some((path, Some(sealed)))))
    }

    /// Whether there is a file that takes them.
    pub(super) const fn are_kept(&self) -> bool {
        matches!(self.0, Some((_, Some(_))))
    }

    /// Notes a finding; once that fails, no more.
    pub(super) fn add(&mut self, finding: Option<Vec<u8>>) {
        if let Some((_, kept)) = &mut self.0
            && let Some(Sealed { file, seal }) = kept
        {
            let line = finding.map(|finding| seal.line(&BASE64.encode(finding)));
            if line.and_then(|line| file.add(&line).ok()).is_none() {
                *kept = None;
            }
        }
    }

    /// The command is done: they are needed no more.
    pub(super) fn discard(&self) {
        if let Some((path, _)) = &self.0 {
            let _ = std::fs::remove_file(path);
        }
    }
}

/// All lines that end, if there are any: what was being written when the program ended does not.
fn whole(text: &[u8]) -> Option<&[u8]> {
    let end = text.iter().rposition(|byte| *byte == b'\n')?;
    text.get(..=end)
}

/// Reads the findings in these lines, if they are as they were written and belong to this question; the seal of what may
/// follow, or why there is none.
fn agreed(
    lines: &[u8],
    question: &Question,
    read: &mut dyn FnMut(&[u8]) -> Option<()>,
) -> Result<Seal, String> {
    opened(lines, &|asked| question.same(asked), read)
}

/// Reads the findings in a file of notes as far as it has whole lines, whose question is the right one to `check`.
///
/// # Errors
/// It cannot be read, or its notes are not as they were written; why.
pub(super) fn peruse(
    path: &Path,
    check: &dyn Fn(&Question) -> Result<(), String>,
    read: &mut dyn FnMut(&[u8]) -> Option<()>,
) -> Result<(), String> {
    let old = std::fs::read(path).map_err(|error| format!("cannot be read: {error}"))?;
    match whole(&old) {
        Some(lines) => opened(lines, check, read).map(drop),
        None => Err("holds no whole line".to_owned()),
    }
}

fn opened(
    lines: &[u8],
    check: &dyn Fn(&Question) -> Result<(), String>,
    read: &mut dyn FnMut(&[u8]) -> Option<()>,
) -> Result<Seal, String> {
    let refused = |reason: String| Err(format!("cannot be read: {reason}; {ANEW}"));
    let mut seal = Seal::default();
    for (line, number) in lines.split_inclusive(|byte| *byte == b'\n').zip(1..) {
        let Some(words) = seal.open(line) else {
            return refused(format!("line {number} is not as it was written"));
        };
        let read = match number {
            1 => Question::read(words).map(|asked| check(&asked)),
            _ => BASE64
                .decode(words)
                .ok()
                .and_then(|finding| read(&finding))
                .map(Ok),
        };
        match read {
            Some(verdict) => verdict?,
            None => return refused(format!("line {number} makes no sense")),
        }
    }
    Ok(seal)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The notes with this question and these findings.
    fn noted(question: &Question, findings: &[&[u8]]) -> String {
        let mut seal = Seal::default();
        let first = seal.line(&question.line().unwrap());
        let lines = findings
            .iter()
            .map(|finding| seal.line(&BASE64.encode(finding)));
        std::iter::once(first)
            .chain(lines.collect::<Vec<_>>())
            .collect()
    }

    fn asked(accuracy: f64) -> Question {
        Question::default().and("`--accuracy`", accuracy)
    }

    #[test]
    fn a_torn_line_is_forgotten() {
        let mut text = noted(&asked(1e-9), &[b"one", b"two"]).into_bytes();
        let length = text.len();
        assert_eq!(whole(&text), Some(text.as_slice()));
        text.extend(b"0123abcd Zm91");
        assert_eq!(whole(&text), Some(&text[..length]));
        assert_eq!(whole(b"torn"), None);
        assert_eq!(whole(b""), None);
    }

    #[test]
    fn what_is_not_as_it_was_written_is_refused_by_its_line() {
        let question = asked(1e-9);
        let text = noted(&question, &[b"one", b"two"]);
        let mut seen: Vec<u8> = Vec::new();
        let mut read = |finding: &[u8]| (finding.len() > 1).then(|| seen.extend(finding));
        assert!(agreed(text.as_bytes(), &question, &mut read).is_ok());
        let lines: Vec<&str> = text.split_inclusive('\n').collect();
        let missing = [lines[0], lines[2]].concat();
        let reason = agreed(missing.as_bytes(), &question, &mut read).unwrap_err();
        assert_eq!(
            reason,
            format!("cannot be read: line 2 is not as it was written; {ANEW}")
        );
        let senseless = noted(&question, &[b"four", b"5", b"six"]);
        let reason = agreed(senseless.as_bytes(), &question, &mut read).unwrap_err();
        assert_eq!(
            reason,
            format!("cannot be read: line 3 makes no sense; {ANEW}")
        );
        assert_eq!(seen, b"onetwofour");
    }

    #[test]
    fn another_question_is_named() {
        let (one, other) = (asked(1e-9), asked(1e-8));
        assert_eq!(one.differs(&one), None);
        let told = one.differs(&other).unwrap();
        assert_eq!(told, "`--accuracy` was 0.00000001 and is 0.000000001");
        assert!(one.differs(&Question::default()).is_some());
        let text = noted(&other, &[]);
        let reason = agreed(text.as_bytes(), &one, &mut |_| None).unwrap_err();
        let wanted = format!("belongs to another question: {told}; ask the same one, or {ANEW}");
        assert_eq!(reason, wanted);
    }
}
