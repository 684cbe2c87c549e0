//! `--resume`: what a long command notes as it goes on, so that it can go on where it was ended.
//!
//! The notes lie beside the tables. Their first line is the question, for notes help with no other one; each further line
//! is a finding, with every digit. They go when the command has come to its end.

use std::fmt::{Debug, Display};
use std::path::PathBuf;

use base64::Engine;
use base64::engine::general_purpose::STANDARD_NO_PAD as BASE64;

use super::arguments::Resume;
use super::failure::{Failure, refuse};
use super::interrupt::ENDING;
use super::journal::Growing;
use super::output::Output;
use crate::model::ModelInfo;
use crate::study::Case;

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
        let mut question = Self(Vec::new())
            .and("the model", info.command)
            .and("the program", program)
            .exactly("the declaration of the model", info)
            .and("the dynamics", case.dynamics);
        for (declared, value) in info.parameters.iter().zip(&case.parameters) {
            question = question.exactly(declared.name, value);
        }
        question
            .exactly("`--along`", &case.along)
            .exactly("`--start`", &case.start)
            .exactly("`--period`", &case.period)
            .exactly("`--accuracy`", &case.accuracy)
            .exactly("`--from`", &case.beginning)
            .exactly("`--switch`", &case.switch)
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
pub(super) struct Notes(Option<(PathBuf, Option<Growing>)>);

impl Notes {
    /// Notes of this name: new ones, or with `--resume` those that are there, of which each line is read until one
    /// makes no sense.
    ///
    /// # Errors
    /// There is no folder to resume in, or its notes belong to another question.
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
        let old = resume.resume.then(|| std::fs::read_to_string(&path));
        let file = match old {
            Some(Ok(text)) => {
                let length = agreed(&text, question, &path.display())?;
                let whole = length + whole(&text[length..], read);
                Growing::carry_on(path.clone(), whole as u64)
            }
            Some(Err(error)) if error.kind() != std::io::ErrorKind::NotFound => Err(error),
            missing => {
                if missing.is_some() {
                    output.note("note: there is nothing to resume: it begins anew");
                }
                Growing::begin(path.clone(), &(question.line()? + "\n"))
            }
        };
        let file = file.map_err(|error| {
            Failure::usage(format!(
                "`--out`: {} cannot be used: {error}",
                path.display()
            ))
        })?;
        Ok(Self(Some((path, Some(file)))))
    }

    /// Whether there is a file that takes them.
    pub(super) const fn are_kept(&self) -> bool {
        matches!(self.0, Some((_, Some(_))))
    }

    /// Notes a finding; once that fails, no more.
    pub(super) fn add(&mut self, finding: Option<Vec<u8>>) {
        if let Some((_, kept)) = &mut self.0
            && let Some(file) = kept
        {
            let line = finding.map(|finding| BASE64.encode(finding) + "\n");
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

/// The length of the first line, if it is this question.
fn agreed(text: &str, question: &Question, place: &impl Display) -> Result<usize, Failure> {
    let anew = "leave out `--resume` to begin anew";
    let length = text.find('\n').map_or(text.len(), |end| end + 1);
    let asked = serde_json::from_str(&text[..length]).map(Question);
    let asked = asked.map_err(|error| {
        Failure::usage(format!(
            "`--resume`: {place} cannot be read: {error}; {anew}"
        ))
    })?;
    question.differs(&asked).map_or(Ok(length), |difference| {
        refuse!("`--resume`: {place} belongs to another question: {difference}; ask the same one, or {anew}")
    })
}

/// The length of the lines that are whole and make sense; what was being written when the program ended does not.
fn whole(text: &str, read: &mut dyn FnMut(&[u8]) -> Option<()>) -> usize {
    let lines = text
        .split_inclusive('\n')
        .filter(|line| line.ends_with('\n'));
    lines
        .map_while(|line| {
            let finding = BASE64.decode(line.trim_end()).ok()?;
            read(&finding).map(|()| line.len())
        })
        .sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_torn_line_is_forgotten() {
        let mut seen: Vec<u8> = Vec::new();
        let mut read = |finding: &[u8]| (finding.len() > 1).then(|| seen.extend(finding));
        let line = |finding: &[u8]| BASE64.encode(finding) + "\n";
        let torn = [line(b"one"), line(b"two"), "dGhy".to_owned()].concat();
        assert_eq!(whole(&torn, &mut read), 10);
        let senseless = [line(b"four"), line(b"5"), line(b"six")].concat();
        assert_eq!(whole(&senseless, &mut read), 7);
        assert_eq!(seen, b"onetwofour");
    }

    #[test]
    fn another_question_is_named() {
        let one = Question(Vec::new()).and("`--accuracy`", 1e-9);
        let other = Question(Vec::new()).and("`--accuracy`", 1e-8);
        assert_eq!(one.differs(&one), None);
        let told = one.differs(&other).unwrap();
        assert_eq!(told, "`--accuracy` was 0.00000001 and is 0.000000001");
        assert!(one.differs(&Question(Vec::new())).is_some());
        let line = one.line().unwrap();
        assert!(agreed(&line, &one, &"it").is_ok());
        assert_eq!(agreed("", &one, &"it").unwrap_err().code(), 2);
    }
}
