//! Words of the command line, and what to say of wrong ones.

use super::failure::{Failure, refuse};
use crate::model::within_reach;
use crate::suggest::did_you_mean;

/// A message that names a wrong word, and the nearest right one or all there are.
pub(super) fn unknown(what: &str, word: &str, names: &[&str]) -> String {
    match did_you_mean(word, names.iter().copied()) {
        Some(name) => format!("{what} `{word}`: did you mean `{name}`?"),
        None if names.is_empty() => format!("{what} `{word}`: there are none"),
        None => format!("{what} `{word}`: there {}", all(names)),
    }
}

fn all(names: &[&str]) -> String {
    let verb = if names.len() == 1 { "is" } else { "are" };
    format!("{verb} {}", names.join(", "))
}

/// The place of a name among others; `what` says what is missing, if it is.
pub(super) fn place(what: &str, name: &str, names: &[&str]) -> Result<usize, Failure> {
    let place = names.iter().position(|known| *known == name);
    place.ok_or_else(|| Failure::usage(unknown(what, name, names)))
}

/// The two sides of `name=value`.
pub(super) fn both_sides<'a>(option: &str, word: &'a str) -> Result<(&'a str, &'a str), Failure> {
    let Some((name, value)) = word.split_once('=') else {
        return Err(Failure::usage(match word.trim() {
            "" => format!("`{option}` holds an empty word: write `name=value`"),
            _ => format!("`{option} {word}` is no assignment: write `name=value`"),
        }));
    };
    let (name, value) = (name.trim(), value.trim());
    if name.is_empty() {
        return refuse!("`{option} {word}` has no name before its `=`: write `name=value`");
    }
    if value.is_empty() {
        return refuse!("`{option} {word}` has no value after its `=`: write `name=value`");
    }
    Ok((name, value))
}

/// A finite number.
pub(super) fn number(place: &str, word: &str) -> Result<f64, Failure> {
    let value: f64 = word.trim().parse().map_err(|_| {
        Failure::usage(match word.trim() {
            "" => format!("`{place}` has an empty word where a number should be"),
            word => format!("`{place}`: `{word}` is not a number"),
        })
    })?;
    if value.is_nan() {
        return refuse!(
            "`{place}`: `{word}` is not a number: NaN has no motion, give a finite number"
        );
    }
    if value.is_infinite() {
        return refuse!("`{place}`: `{word}` is infinite: give a finite number");
    }
    if !within_reach(value) {
        return refuse!(
            "`{place}`: {value:e} is out of reach: magnitudes lie between 1e-100 and 1e100"
        );
    }
    Ok(value)
}

/// A finite number above zero.
pub(super) fn positive(place: &str, word: &str) -> Result<f64, Failure> {
    let value = number(place, word)?;
    if value > 0.0 {
        return Ok(value);
    }
    refuse!("`{place} {word}`: {value} is not above 0")
}

/// A whole number between `least` and `most`.
pub(super) fn count(place: &str, word: &str, [least, most]: [usize; 2]) -> Result<usize, Failure> {
    let parsed = word.trim().parse::<usize>().ok();
    parsed
        .filter(|value| (least..=most).contains(value))
        .ok_or_else(|| {
            Failure::usage(format!(
                "`{place} {word}` is no whole number from {least} to {most}"
            ))
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn both_sides_must_be_there() {
        assert_eq!(both_sides("--set", " a = 1 "), Ok(("a", "1")));
        for word in ["", " ", "a", "=1", "a="] {
            assert_eq!(both_sides("--set", word).map_err(|f| f.code()), Err(2));
        }
    }

    #[test]
    fn counts_are_whole_and_bounded() {
        assert_eq!(count("--values", "7", [2, 9]), Ok(7));
        for word in ["", "1", "10", "-3", "2.5", "1e2", "many"] {
            assert_eq!(
                count("--values", word, [2, 9]).map_err(|f| f.code()),
                Err(2)
            );
        }
    }

    #[test]
    fn numbers_are_finite() {
        assert_eq!(number("--time", "-1.5e3"), Ok(-1500.0));
        for word in ["", "x", "nan", "inf", "-inf", "1e999", "1,5", "--json"] {
            assert_eq!(number("--time", word).map_err(|f| f.code()), Err(2));
        }
        assert_eq!(positive("--time", "0").map_err(|f| f.code()), Err(2));
    }
}
