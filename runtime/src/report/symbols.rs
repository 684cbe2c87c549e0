//! Names as they are typeset: letters in italics, Greek ones as such, what follows them as an index.

use super::symbol::{GREEK, symbol};

/// A text in the markup of reports, in which every name that is a letter with an index is typeset.
///
/// ```
/// # use stickslip::report::symbols::typeset;
/// assert_eq!(typeset("max |x1|"), "max |*x*_{1}|");
/// assert_eq!(typeset("omega_0, v_dr"), "*ω*_{0}, *v*_{dr}");
/// assert_eq!(typeset("x[3] and stiffness"), "*x*_{3} and stiffness");
/// ```
#[must_use]
pub fn typeset(text: &str) -> String {
    let (mut out, mut rest) = (String::new(), text);
    while let Some(first) = rest.chars().next() {
        let name = rest.find(|c: char| !c.is_alphanumeric() && c != '_');
        let (name, after) = rest.split_at(name.unwrap_or(rest.len()));
        if name.is_empty() {
            out.push(first);
            rest = &rest[first.len_utf8()..];
        } else if let Some((letter, index)) = symbol(name) {
            let (element, after) = element(after);
            let indices = [index.as_str(), element].into_iter();
            let index: Vec<&str> = indices.filter(|part| !part.is_empty()).collect();
            out += &format!("*{letter}*");
            if !index.is_empty() {
                out += &format!("_{{{}}}", index.join(","));
            }
            rest = after;
        } else {
            out += name;
            rest = after;
        }
    }
    out
}

/// The number between brackets with which a text begins, and what follows; nothing if it does not begin so.
fn element(text: &str) -> (&str, &str) {
    let inner = text.strip_prefix('[').and_then(|text| text.split_once(']'));
    match inner {
        Some((number, rest)) if number.bytes().all(|byte| byte.is_ascii_digit()) => (number, rest),
        _ => ("", text),
    }
}

/// The name of a Greek letter, if this is one.
pub(super) fn spelt(letter: char) -> Option<String> {
    let code = letter as u32;
    let capital = (0x391..=0x3a9).contains(&code);
    let place = code.checked_sub(if capital { 0x391 } else { 0x3b1 })?;
    let name = GREEK.get((place - u32::from(place > 17)) as usize)?;
    let (first, rest) = name.split_at(1);
    Some(match capital {
        true => first.to_uppercase() + rest,
        false => (*name).to_owned(),
    })
}
