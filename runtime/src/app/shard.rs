//! `--shard`: which share of a list is done here.

use std::env::var;

use super::failure::{Failure, refuse};
use crate::study::Share;

/// A share as it is named on the command line, or by the scheduler that has started the program.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Shard(pub(super) Share);

/// What a scheduler says of the place of a process in an array.
struct Place {
    number: usize,
    of: Option<usize>,
}

impl Shard {
    /// `3/7`, `auto`, `auto/7`.
    pub(super) fn read(option: &str, word: &str) -> Result<Self, Failure> {
        let (number, of) = word
            .split_once('/')
            .map_or((word, None), |(i, n)| (i, Some(n)));
        let count = |word: &str| {
            let count = word.trim().parse::<usize>().ok().filter(|count| *count > 0);
            count.ok_or_else(|| {
                Failure::usage(format!(
                    "`{option} {word}`: `{word}` is no whole number above 0"
                ))
            })
        };
        let said = of.map(count).transpose()?;
        let (number, of) = if number.trim() == "auto" {
            let Some(place) = scheduled(&|name| var(name).ok()) else {
                return refuse!(
                    "`{option} {word}`: neither SLURM_ARRAY_TASK_ID nor HQ_TASK_ID is set: this is no job array"
                );
            };
            (place.number, said.or(place.of))
        } else {
            (count(number)?, said)
        };
        let Some(of) = of else {
            return refuse!("`{option} {word}` does not say of how many: write `{word}/7`");
        };
        match Share::new(number, of) {
            Some(share) => Ok(Self(share)),
            None => refuse!(
                "`{option} {word}`: there is no share {number} of {of}: they are counted from 1"
            ),
        }
    }
}

/// The place of this process, counted from 1: Slurm counts from the first number of its array in its steps, HyperQueue as
/// the array says.
fn scheduled(variable: &dyn Fn(&str) -> Option<String>) -> Option<Place> {
    let number = |name: &str| variable(name)?.trim().parse::<usize>().ok();
    if let Some(id) = number("SLURM_ARRAY_TASK_ID") {
        let first = number("SLURM_ARRAY_TASK_MIN").unwrap_or(1);
        let step = number("SLURM_ARRAY_TASK_STEP").unwrap_or(1).max(1);
        return Some(Place {
            number: id.checked_sub(first)? / step + 1,
            of: number("SLURM_ARRAY_TASK_COUNT"),
        });
    }
    number("HQ_TASK_ID").map(|number| Place { number, of: None })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_share_is_counted_from_one() {
        assert_eq!(Shard::read("--shard", "3/7").unwrap().0.to_string(), "3/7");
        for wrong in ["0/7", "8/7", "3", "3/0", "x/7", "3/x", "", "/", "-1/3"] {
            assert_eq!(
                Shard::read("--shard", wrong).unwrap_err().code(),
                2,
                "{wrong}"
            );
        }
    }

    #[test]
    fn schedulers_are_understood() {
        let slurm = |name: &str| {
            let value = match name {
                "SLURM_ARRAY_TASK_ID" => "14",
                "SLURM_ARRAY_TASK_MIN" => "10",
                "SLURM_ARRAY_TASK_STEP" => "2",
                "SLURM_ARRAY_TASK_COUNT" => "5",
                _ => return None,
            };
            Some(value.to_owned())
        };
        let place = scheduled(&slurm).unwrap();
        assert_eq!((place.number, place.of), (3, Some(5)));
        let queue = |name: &str| (name == "HQ_TASK_ID").then(|| "4".to_owned());
        let place = scheduled(&queue).unwrap();
        assert_eq!((place.number, place.of), (4, None));
        assert!(scheduled(&|_| None).is_none());
    }
}
