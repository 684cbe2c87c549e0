//! Names as symbols: a letter, perhaps Greek, and its index. The library typesets by the same file.

/// The Greek letters in the order of Unicode.
pub(crate) const GREEK: [&str; 24] = [
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa",
    "lambda", "mu", "nu", "xi", "omicron", "pi", "rho", "sigma", "tau", "upsilon", "phi", "chi",
    "psi", "omega",
];

/// The letter and the index of a name such as `x`, `F_s`, `x1` or `mu_max`; `None` for a word.
pub(crate) fn symbol(name: &str) -> Option<(char, String)> {
    let end = name.find(|c: char| c == '_' || c.is_ascii_digit());
    let (base, index) = name.split_at(end.unwrap_or(name.len()));
    let mut letters = base.chars();
    let letter = match (letters.next(), letters.next()) {
        (Some(letter), None) => letter,
        _ => greek(base)?,
    };
    Some((letter, index.trim_start_matches('_').replace('_', ",")))
}

fn greek(name: &str) -> Option<char> {
    let place = GREEK
        .iter()
        .position(|known| known.eq_ignore_ascii_case(name))?;
    let capital = name.chars().next().is_some_and(char::is_uppercase);
    // Between rho and sigma stands another form of sigma.
    let code = place as u32 + u32::from(place > 16);
    char::from_u32(code + if capital { 0x391 } else { 0x3b1 })
}
