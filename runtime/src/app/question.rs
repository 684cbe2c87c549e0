//! What is asked, in words that are compared with those of another run.

use std::ffi::OsString;
use std::fmt::{Debug, Display};
use std::sync::{Mutex, PoisonError};

use super::failure::Failure;
use crate::model::ModelInfo;
use crate::study::{Case, Rows};

/// The way out of notes that do not help.
pub(super) const ANEW: &str = "leave out `--resume` to begin anew";
/// The name of the words with which it was asked, which may differ where the question does not.
const COMMAND: &str = "the command line";
/// The names of the number of rows of a list, and of the items of each.
const ROWS: &str = "the number of rows";
const LENGTH: &str = "the items of each row";
/// Options that say where and how, and not what: with a value, and without.
const VALUED: [&str; 4] = ["--out", "--shard", "--threads", "--merged"];
const BARE: [&str; 4] = ["--resume", "--json", "--quiet", "--partial"];

/// The words with which this process is asked.
static WORDS: Mutex<Vec<String>> = Mutex::new(Vec::new());

/// From now on the process is asked with these words.
pub(super) fn ask(words: &[OsString]) {
    let words = words.iter().skip(1);
    let words = words.map(|word| word.to_string_lossy().into_owned());
    *WORDS.lock().unwrap_or_else(PoisonError::into_inner) = words.collect();
}

/// The words that say what is asked.
pub(super) fn command() -> Vec<String> {
    let words = WORDS.lock().unwrap_or_else(PoisonError::into_inner);
    lasting(words.iter().cloned()).collect()
}

/// What is asked, as far as an answer depends on it: pairs of words.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
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
            modes,
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
            .exactly("the modes of `--start`", modes)
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

    /// The words by which it can be asked again.
    pub(super) fn words(&self) -> Option<Vec<String>> {
        serde_json::from_str(self.word(COMMAND)?).ok()
    }

    /// As it is written.
    pub(super) fn line(&self) -> Result<String, Failure> {
        serde_json::to_string(&self.0)
            .map_err(|error| Failure::failed(format!("the notes cannot be written: {error}")))
    }

    /// As it was written; `None` if that makes no sense.
    pub(super) fn read(words: &str) -> Option<Self> {
        serde_json::from_str(words).ok().map(Self)
    }

    /// The items of its list.
    pub(super) fn rows(&self) -> Option<Rows> {
        let number = |name| self.word(name)?.parse().ok();
        let (count, length) = (number(ROWS)?, number(LENGTH)?);
        Some(Rows { count, length })
    }

    /// The same about a list of such items, with the words of this process, by which it can be asked again.
    pub(super) fn of_rows(self, rows: Rows) -> Self {
        let words = serde_json::to_string(&command()).unwrap_or_default();
        self.and(ROWS, rows.count)
            .and(LENGTH, rows.length)
            .and(COMMAND, words)
    }

    /// What it says of this.
    fn word(&self, name: &str) -> Option<&str> {
        let mut pairs = self.0.iter();
        pairs
            .find(|(known, _)| known == name)
            .map(|(_, word)| word.as_str())
    }

    /// That another question is the same.
    ///
    /// # Errors
    /// It is not: what it asks otherwise.
    pub(super) fn same(&self, other: &Self) -> Result<(), String> {
        self.differs(other).map_or(Ok(()), |difference| {
            Err(format!(
                "belongs to another question: {difference}; ask the same one, or {ANEW}"
            ))
        })
    }

    /// What another question asks otherwise.
    pub(super) fn differs(&self, other: &Self) -> Option<String> {
        let asked = |question: &Self| -> Vec<(String, String)> {
            let pairs = question.0.iter();
            pairs.filter(|(name, _)| name != COMMAND).cloned().collect()
        };
        let (here, there) = (asked(self), asked(other));
        let mut pairs = here.iter().zip(&there);
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
            None if here.len() == there.len() => None,
            _ => Some("it was asked in other words".to_owned()),
        }
    }
}

/// The words of a command line that say what is asked.
fn lasting(words: impl Iterator<Item = String>) -> impl Iterator<Item = String> {
    let mut value_follows = false;
    words.filter(move |word| {
        if std::mem::take(&mut value_follows) {
            return false;
        }
        let name = word.split('=').next().unwrap_or_default();
        value_follows = VALUED.contains(&word.as_str());
        !VALUED.contains(&name) && !BARE.contains(&word.as_str())
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn where_and_how_are_left_out_of_what() {
        let line =
            "map a --out x --shard=1/2 --set k=1 --threads 2 --resume --along b=1..2:5 --json";
        let words = line.split(' ').map(str::to_owned);
        let kept: Vec<String> = lasting(words).collect();
        assert_eq!(kept.join(" "), "map a --set k=1 --along b=1..2:5");
    }
}
