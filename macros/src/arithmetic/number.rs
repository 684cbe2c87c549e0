//! Literals and whole numbers.

use quote::ToTokens;
use syn::Lit;

use crate::formula::Number;

/// The value of a literal.
pub(crate) fn number(literal: &Lit) -> syn::Result<Number> {
    let (digits, suffix) = match literal {
        Lit::Int(whole) => (whole.base10_digits().to_owned(), whole.suffix().to_owned()),
        Lit::Float(real) => (real.base10_digits().to_owned(), real.suffix().to_owned()),
        _ => {
            return Err(syn::Error::new_spanned(
                literal,
                "expected a number such as `1.0`",
            ));
        }
    };
    if !matches!(suffix.as_str(), "" | "f64") {
        return Err(syn::Error::new_spanned(
            literal,
            with_suffix(&digits, &suffix),
        ));
    }
    match digits.parse() {
        Ok(value) if f64::is_finite(value) => Ok(Number {
            value,
            source: literal.to_token_stream(),
        }),
        _ => Err(syn::Error::new_spanned(
            literal,
            format!(
                "`{}` is too large for an `f64`, of which the largest is 1.8e308",
                literal.to_token_stream()
            ),
        )),
    }
}

fn with_suffix(digits: &str, suffix: &str) -> String {
    let typed = suffix.strip_prefix(['i', 'u', 'f']);
    if typed.is_some_and(|bits| bits.parse::<u8>().is_ok() || bits == "size") {
        format!("every number is an `f64` here: write `{digits}`")
    } else {
        let factor = suffix.trim_start_matches('_');
        format!("`{digits}{suffix}` is no number; a product is written `{digits} * {factor}`")
    }
}

/// A whole number that an exponent may be.
pub(crate) fn whole(value: f64) -> Option<i32> {
    let limit = f64::from(1 << 15);
    #[allow(clippy::cast_possible_truncation)]
    (value.fract() == 0.0 && value.abs() <= limit).then_some(value as i32)
}
