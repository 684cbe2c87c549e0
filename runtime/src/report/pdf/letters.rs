//! Letters in the two fonts that every reader of PDF has: Helvetica, and Symbol for Greek letters and signs.

use pdf_writer::Name;

/// The fonts: upright, oblique, and Symbol.
pub(super) const FONTS: [(Name<'static>, Name<'static>); 3] = [
    (Name(b"F1"), Name(b"Helvetica")),
    (Name(b"F2"), Name(b"Helvetica-Oblique")),
    (Name(b"F3"), Name(b"Symbol")),
];

/// The Greek letters in the order of Unicode, as Symbol numbers them.
const SMALL: &[u8; 25] = b"abgdezhqiklmnxoprVstufcyw";
const CAPITAL: &[u8; 25] = b"ABGDEZHQIKLMNXOPR?STUFCYW";

/// Whether it is a letter of Symbol, and its number there or in Helvetica; a question mark for one that neither has.
pub(super) fn letter(letter: char) -> (bool, u8) {
    let greek = |first: char, letters: &[u8; 25]| letters[letter as usize - first as usize];
    match letter {
        'α'..='ω' => (true, greek('α', SMALL)),
        'Α'..='Ω' => (true, greek('Α', CAPITAL)),
        '−' => (true, 0x2d),
        '′' => (true, 0xa2),
        '″' => (true, 0xb2),
        '≤' => (true, 0xa3),
        '≥' => (true, 0xb3),
        '∞' => (true, 0xa5),
        '√' => (true, 0xd6),
        '→' => (true, 0xae),
        '–' => (false, 0x96),
        '—' => (false, 0x97),
        '…' => (false, 0x85),
        '’' => (false, 0x92),
        '\u{202f}' => (false, b' '),
        ' '..='~' | '\u{a0}'..='ÿ' => (false, letter as u8),
        _ => (false, b'?'),
    }
}

/// Subscripts and superscripts of their own, as the digits that they are.
pub(super) fn digit(letter: char) -> Option<(char, bool)> {
    let below = "₀₁₂₃₄₅₆₇₈₉".chars().position(|digit| digit == letter);
    let digit = |place: usize| char::from_digit(place as u32, 10).unwrap_or('0');
    below.map(|place| (digit(place), true))
}
