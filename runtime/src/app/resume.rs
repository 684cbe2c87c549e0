//! `--resume`: what a long command notes as it goes on, so that it can go on where it was ended.
//!
//! The notes lie beside the tables. Their first line is the question, for notes help with no other one; each further line
//! is a finding, with every digit, under a [`Seal`] that begins with the question. They go when the command has come to
//! its end.

use std::fmt::{Debug, Display};
use std::io::ErrorKind;
use std::path::PathBuf;

use base64::Engine;
use base64::engine::general_purpose::STANDARD_NO_PAD as BASE64;

use super::arguments::Resume;
use super::failure::{Failure, refuse};
use super::interrupt::ENDING;
use super::journal::Growing;
use super::output::Output;
use super::seal::Seal;
use crate::model::ModelInfo;
use crate::study::Case;

/// The way out of notes that do not help.
const ANEW: &str = "leave out `--resume` to begin anew";

/// What is asked, as far as an answer depends on it: pairs of words.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Question(Vec<(String, String)>);

impl Question {
    /// What all commands ask.
    pub(super) fn new(version: &str, info: &ModelInfo, case: &Case) -> Self {
        let program = format!(
            "{version}, stickslip {}, {}{}-{}",
            env!("CARGO_PKG_VERSION"),
            if cfg!(debug_assertions) { "debug " } else { "" },
            std::env::consts::ARCH,
            std::env::consts::OS
        );
        // Whole: a field that is left out here would be one of which answers do not depend.
        let Case {
            parameters,
            dynamics,
            along,
            start,
            period,
            accuracy,
            beginning,
            switch,
            harmonics,
        } = case;
        let mut question = Self(Vec::new())
            .and("the model", info.command)
            .and("the program", program)
            .exactly("the declaration of the model", info)
            .and("the dynamics", dynamics);
        for (declared, value) in info.parameters.iter().zip(parameters) {
            question = question.exactly(declared.name, value);
        }
        question
            .exactly("`--along`", along)
            .exactly("`--start`", start)
            .exactly("`--period`", period)
            .exactly("`--accuracy`", accuracy)
            .exactly("`--from`", beginning)
            .exactly("`--switch`", switch)
            .exactly("`--harmonics`", harmonics)
    }

    /// The same with one more word.
    pub(super) fn and(mut self, name: &str, value: impl Display) -> Self {
        self.0.push((name.to_owned(), value.to_string()));
        self
    }

    /// The same with one more value, of which each digit counts.
    pub(super) fn exactly(self, name: &str, value: &impl Debug) -> Self {
        self.and(name, format!("{value:?}"))
    }

    fn line(&self) -> Result<String, Failure> {
        serde_json::to_string(&self.0)
            .map_err(|error| Failure::failed(format!("the notes cannot be written: {error}")))
    }

    /// What another question asks otherwise.
    fn differs(&self, other: &Self) -> Option<String> {
        let mut pairs = self.0.iter().zip(&other.0);
        let different = pairs.find(|(here, there)| here != there);
        match different {
            Some(((name, here), (there, value))) if name == there => {
                let long = here.len().max(value.len()) > 100;
                Some(if long {
                    format!("{name} has changed")
                } else {
                    format!("{name} was {value} and is {here}")
                })
            }
            None if self.0.len() == other.0.len() => None,
            _ => Some("it was asked in other words".to_owned()),
        }
    }
}

/// The notes of a command.
pub(super) struct Notes(Option<(PathBuf, Option<Sealed>)>);

/// A file that is whole after each line, and what seals the next one.
struct Sealed {
    file: Growing,
    seal: Seal,
}

impl Notes {
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
    let refused = |reason: String| Err(format!("cannot be read: {reason}; {ANEW}"));
    let mut seal = Seal::default();
    for (line, number) in lines.split_inclusive(|byte| *byte == b'\n').zip(1..) {
        let Some(words) = seal.open(line) else {
            return refused(format!("line {number} is not as it was written"));
        };
        let read = match number {
            1 => serde_json::from_str(words).ok().map(|asked| {
                question
                    .differs(&Question(asked))
                    .map_or(Ok(()), |difference| {
                        Err(format!(
                            "belongs to another question: {difference}; ask the same one, or {ANEW}"
                        ))
                    })
            }),
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
        Question(Vec::new()).and("`--accuracy`", accuracy)
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
        assert!(one.differs(&Question(Vec::new())).is_some());
        let text = noted(&other, &[]);
        let reason = agreed(text.as_bytes(), &one, &mut |_| None).unwrap_err();
        let wanted = format!("belongs to another question: {told}; ask the same one, or {ANEW}");
        assert_eq!(reason, wanted);
    }
}
