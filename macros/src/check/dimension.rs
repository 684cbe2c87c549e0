//! Dimensions: exponents of the SI base units, and the symbols that stand for them.

use std::fmt::{Display, Formatter, Result};

use proc_macro2::Ident;

use crate::suggest::nearest;
use crate::syntax::TWELFTHS;

/// Exponents of m, kg, s, A, K, mol, cd, in twelfths: roots of units occur inside formulas.
#[derive(Clone, Copy, PartialEq, Eq, Debug, Default)]
pub(crate) struct Dimension([i32; 7]);

/// Twelfths of exponents that a unit may have: products of two units are still numbers.
const LARGEST: u16 = 127 * TWELFTHS as u16;
const BASE: [&str; 7] = ["m", "kg", "s", "A", "K", "mol", "cd"];

/// The symbols, each with its exponents.
const SYMBOLS: [(&str, [i32; 7]); 21] = [
    ("m", [1, 0, 0, 0, 0, 0, 0]),
    ("kg", [0, 1, 0, 0, 0, 0, 0]),
    ("s", [0, 0, 1, 0, 0, 0, 0]),
    ("A", [0, 0, 0, 1, 0, 0, 0]),
    ("K", [0, 0, 0, 0, 1, 0, 0]),
    ("mol", [0, 0, 0, 0, 0, 1, 0]),
    ("cd", [0, 0, 0, 0, 0, 0, 1]),
    ("rad", [0; 7]),
    ("sr", [0; 7]),
    ("Hz", [0, 0, -1, 0, 0, 0, 0]),
    ("N", [1, 1, -2, 0, 0, 0, 0]),
    ("Pa", [-1, 1, -2, 0, 0, 0, 0]),
    ("J", [2, 1, -2, 0, 0, 0, 0]),
    ("W", [2, 1, -3, 0, 0, 0, 0]),
    ("C", [0, 0, 1, 1, 0, 0, 0]),
    ("V", [2, 1, -3, -1, 0, 0, 0]),
    ("ohm", [2, 1, -3, -2, 0, 0, 0]),
    ("F", [-2, -1, 4, 2, 0, 0, 0]),
    ("Wb", [2, 1, -2, -1, 0, 0, 0]),
    ("T", [0, 1, -2, -1, 0, 0, 0]),
    ("H", [2, 1, -2, -2, 0, 0, 0]),
];

const PREFIXES: [&str; 17] = [
    "da", "k", "M", "G", "T", "P", "h", "d", "c", "m", "u", "µ", "μ", "n", "p", "f", "a",
];

/// Units that are not coherent: the unit to write instead, and what to do with the values.
const FOREIGN: [(&str, &str, &str); 16] = [
    ("g", "kg", "divide the values by 1000"),
    ("t", "kg", "multiply the values by 1000"),
    ("min", "s", "multiply the values by 60"),
    ("h", "s", "multiply the values by 3600"),
    ("Nm", "N*m", "the values stay as they are"),
    ("Ns", "N*s", "the values stay as they are"),
    ("deg", "rad", "multiply the values by pi/180"),
    ("rev", "rad", "multiply the values by 2 pi"),
    ("rpm", "rad/s", "multiply the values by pi/30"),
    ("bar", "Pa", "multiply the values by 1e5"),
    ("L", "m^3", "divide the values by 1000"),
    ("inch", "m", "multiply the values by 0.0254"),
    ("ft", "m", "multiply the values by 0.3048"),
    ("lb", "kg", "multiply the values by 0.45359237"),
    ("lbf", "N", "multiply the values by 4.4482216152605"),
    ("kgf", "N", "multiply the values by 9.80665"),
];

/// What to call a dimension where no line says it: the first that fits.
const FAMILIAR: [(&str, [i32; 7]); 16] = [
    ("1", [0; 7]),
    ("m/s", [1, 0, -1, 0, 0, 0, 0]),
    ("m/s^2", [1, 0, -2, 0, 0, 0, 0]),
    ("1/s", [0, 0, -1, 0, 0, 0, 0]),
    ("1/s^2", [0, 0, -2, 0, 0, 0, 0]),
    ("s/m", [-1, 0, 1, 0, 0, 0, 0]),
    ("N", [1, 1, -2, 0, 0, 0, 0]),
    ("N/m", [0, 1, -2, 0, 0, 0, 0]),
    ("N*s/m", [0, 1, -1, 0, 0, 0, 0]),
    ("N*s", [1, 1, -1, 0, 0, 0, 0]),
    ("N/s", [1, 1, -3, 0, 0, 0, 0]),
    ("N*m", [2, 1, -2, 0, 0, 0, 0]),
    ("N*m*s", [2, 1, -1, 0, 0, 0, 0]),
    ("W", [2, 1, -3, 0, 0, 0, 0]),
    ("Pa", [-1, 1, -2, 0, 0, 0, 0]),
    ("V", [2, 1, -3, -1, 0, 0, 0]),
];

impl Dimension {
    pub(crate) const NONE: Self = Self([0; 7]);
    pub(crate) const FORCE: Self = Self::of([1, 1, -2, 0, 0, 0, 0]);
    pub(crate) const LENGTH: Self = Self::of([1, 0, 0, 0, 0, 0, 0]);
    pub(crate) const SPEED: Self = Self::of([1, 0, -1, 0, 0, 0, 0]);
    pub(crate) const TIME: Self = Self::of([0, 0, 1, 0, 0, 0, 0]);

    const fn of(exponents: [i32; 7]) -> Self {
        let mut twelfths = [0; 7];
        let mut i = 0;
        while i < 7 {
            twelfths[i] = exponents[i] * TWELFTHS;
            i += 1;
        }
        Self(twelfths)
    }

    /// The dimension of a symbol, or what to write instead.
    pub(super) fn of_symbol(symbol: &Ident) -> std::result::Result<Self, String> {
        let text = symbol.to_string();
        match SYMBOLS.iter().find(|(known, _)| *known == text) {
            Some((_, exponents)) => Ok(Self::of(*exponents)),
            None => Err(unknown(&text)),
        }
    }

    pub(super) fn times(self, other: Self) -> Self {
        Self(std::array::from_fn(|i| {
            self.0[i].saturating_add(other.0[i])
        }))
    }

    pub(super) fn over(self, other: Self) -> Self {
        self.times(other.to_power(-1))
    }

    pub(super) fn to_power(self, exponent: i32) -> Self {
        Self(self.0.map(|twelfths| twelfths.saturating_mul(exponent)))
    }

    /// A real power, where its exponents are twelfths again.
    pub(super) fn to_real_power(self, exponent: f64) -> Option<Self> {
        let mut powered = [0; 7];
        for (power, twelfths) in powered.iter_mut().zip(self.0) {
            let exact = f64::from(twelfths) * exponent;
            *power = crate::arithmetic::whole(exact)?;
        }
        Some(Self(powered))
    }

    /// So many twelfths of a power.
    pub(super) fn to_twelfths(self, twelfths: i32) -> Self {
        Self(self.0.map(|own| own.saturating_mul(twelfths) / TWELFTHS))
    }

    /// The exponents in twelfths, where they are as small as those of a stated unit.
    pub(crate) fn exponents(self) -> Option<[i16; 7]> {
        let mut small = [0; 7];
        for (exponent, twelfths) in small.iter_mut().zip(self.0) {
            *exponent = i16::try_from(twelfths)
                .ok()
                .filter(|twelfths| twelfths.unsigned_abs() <= LARGEST)?;
        }
        Some(small)
    }
}

fn unknown(text: &str) -> String {
    let symbols = || SYMBOLS.iter().map(|(symbol, _)| *symbol);
    if let Some((_, coherent, advice)) = FOREIGN.iter().find(|(foreign, _, _)| *foreign == text) {
        return format!(
            "`{text}` is not an SI unit without a factor; write `{coherent}` ({advice})"
        );
    }
    let unscaled = PREFIXES.iter().find_map(|prefix| {
        let rest = text.strip_prefix(prefix)?;
        symbols().find(|symbol| *symbol == rest || rest == "g" && *symbol == "kg")
    });
    if let Some(unscaled) = unscaled {
        return format!(
            "`{text}` is a scaled unit, and nothing here is scaled silently; \
             write `{unscaled}` and give the values in it"
        );
    }
    if matches!(text, "f64" | "f32" | "Real" | "float" | "double") {
        return format!(
            "`{text}` is a type, and what stands after `:` is a unit, as in `x: m = 1.0`: every number is an `f64`"
        );
    }
    let base = text.trim_end_matches(|letter: char| letter.is_ascii_digit());
    if base != text && symbols().any(|symbol| symbol == base) {
        let power = &text[base.len()..];
        return format!("unknown unit `{text}`; a power is written `{base}^{power}`");
    }
    if text.contains(['·', '⋅']) {
        let product = text.replace(['·', '⋅'], "*");
        return format!("unknown unit `{text}`; a product is written `{product}`");
    }
    match nearest(text, symbols()) {
        Some(near) => format!("unknown unit `{text}`; did you mean `{near}`?"),
        None => format!(
            "unknown unit `{text}`; there are {}",
            symbols().collect::<Vec<_>>().join(", ")
        ),
    }
}

impl Display for Dimension {
    fn fmt(&self, f: &mut Formatter<'_>) -> Result {
        if let Some((name, _)) = FAMILIAR
            .iter()
            .find(|(_, exponents)| Self::of(*exponents) == *self)
        {
            return f.write_str(name);
        }
        let factors = BASE
            .iter()
            .zip(self.0)
            .filter(|(_, twelfths)| *twelfths != 0);
        let written: Vec<String> = factors
            .map(|(symbol, twelfths)| factor(symbol, twelfths))
            .collect();
        f.write_str(&written.join("*"))
    }
}

fn factor(symbol: &str, twelfths: i32) -> String {
    if twelfths == TWELFTHS {
        symbol.to_owned()
    } else if twelfths % TWELFTHS == 0 {
        format!("{symbol}^{}", twelfths / TWELFTHS)
    } else {
        let common = [6, 4, 3, 2]
            .into_iter()
            .find(|n| twelfths % n == 0)
            .unwrap_or(1);
        format!("{symbol}^({}/{})", twelfths / common, TWELFTHS / common)
    }
}
