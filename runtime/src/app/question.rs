//! What is asked, in words that are compared with those of another run.

use std::fmt::{Debug, Display};

use super::failure::Failure;
use crate::model::ModelInfo;
use crate::study::Case;

/// The way out of notes that do not help.
pub(super) const ANEW: &str = "leave out `--resume` to begin anew";
/// The name of the words with which it was asked, which may differ where the question does not.
const COMMAND: &str = "the command line";
/// The name of the number of items of a list.
const ITEMS: &str = "the number of items";
/// Options that say where and how, and not what: with a value, and without.
const VALUED: [&str; 3] = ["--out", "--shard", "--threads"];
const BARE: [&str; 4] = ["--resume", "--json", "--quiet", "--partial"];

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

    /// How many items its list has.
    pub(super) fn count(&self) -> Option<usize> {
        self.word(ITEMS)?.parse().ok()
    }

    /// The same about a list of so many items, with the words of this process, by which it can be asked again.
    pub(super) fn of_items(self, count: usize) -> Self {
        let words: Vec<String> = lasting(std::env::args().skip(1)).collect();
        let words = serde_json::to_string(&words).unwrap_or_default();
        self.and(ITEMS, count).and(COMMAND, words)
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
