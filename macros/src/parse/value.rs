//! Numbers, bounds and units.

use proc_macro2::{Delimiter, Ident, TokenStream, TokenTree};
use quote::quote;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{BinOp, Lit, LitInt, LitStr, Token, token};

use super::shape::{ends_with_comma, next};
use crate::arithmetic;
use crate::formula::Number;
use crate::syntax::{Bound, Bounds, TWELFTHS, Unit, UnitFactor};

/// `=`
pub(super) fn equals(input: ParseStream) -> syn::Result<()> {
    if input.peek(Token![==]) {
        return Err(input.error("a line says by one `=`, not by `==`, what its left side is"));
    }
    if input.parse::<Option<Token![=]>>()?.is_some() {
        return Ok(());
    }
    let found = next(input).unwrap_or_default();
    Err(input.error(match found.as_str() {
        ";" => "expected `=` and a value before `;`".to_owned(),
        "(" => "`(` has no place after a name: what is declared moves with time by itself, and is written alone".to_owned(),
        "+" | "-" | "*" | "/" => {
            format!("`{found}` stands left of `=`: a left side is one name or one rate, and all else is taken to the right")
        }
        "." => "`.` joins no symbols of a unit: write `*` or `/`, as in `N*m`".to_owned(),
        _ => format!("expected `=` before `{found}`"),
    }))
}

/// `["-"] literal`
pub(super) fn number(input: ParseStream) -> syn::Result<Number> {
    let sign: Option<Token![-]> = input.parse()?;
    if input.peek(Token![+]) {
        return Err(input.error("`+` says nothing before a number: remove it"));
    }
    if input.peek(token::Bracket) {
        return Err(input.error(
            "`[` begins no number: all elements of an array begin at the same one, such as `1.0`",
        ));
    }
    if let Ok(name) = input.fork().call(Ident::parse_any) {
        let message = format!(
            "expected a number such as `1.0`, not the name `{name}`: starts, defaults and bounds are numbers"
        );
        return Err(input.error(message));
    }
    if !input.peek(Lit) || input.peek(LitStr) {
        return Err(input.error("expected a number such as `1.0`"));
    }
    let magnitude = arithmetic::number(&input.parse()?)?;
    Ok(match sign {
        None => magnitude,
        Some(minus) => Number {
            value: -magnitude.value,
            source: quote!(#minus #magnitude),
        },
    })
}

/// `where bounds`, or nothing.
pub(super) fn bounds_if_stated(input: ParseStream) -> syn::Result<Option<Bounds>> {
    if input.parse::<Option<Token![where]>>()?.is_none() {
        return Ok(None);
    }
    let ahead = input.fork();
    let mut bounds = bounds(input)?;
    bounds.source = consumed(&ahead, input)?;
    let joined =
        next(input).filter(|next| matches!(next.as_str(), "," | "&&" | "and" | "or" | "||"));
    if let Some(joined) = joined.filter(|_| !ends_with_comma(input)) {
        let name = &bounds.name;
        return Err(input.error(format!(
            "`{joined}` joins no bounds: write both ends of an interval as `0.0 <= {name} < 1.0`"
        )));
    }
    Ok(Some(bounds))
}

/// `name > number`, or `number < name < number`, the last part optional.
fn bounds(input: ParseStream) -> syn::Result<Bounds> {
    let follows = || input.peek(Token![<]) || input.peek(Token![>]);
    let one_sided = input.peek(syn::Ident::peek_any);
    let (mut lower, mut upper) = (None, None);
    if !one_sided {
        let (number, inclusive) = (number(input)?, upward(input)?);
        lower = Some(Bound { number, inclusive });
    }
    let name = input.call(Ident::parse_any)?;
    if input.peek(token::Paren) {
        return Err(input.error(format!(
            "`{name}(` bounds no parameter: write both ends of an interval as `-10.0 < k < 10.0`"
        )));
    }
    if one_sided {
        let (less, inclusive) = relation(input)?;
        let number = number(input)?;
        let end = if less { &mut upper } else { &mut lower };
        *end = Some(Bound { number, inclusive });
        if follows() {
            return Err(input.error(format!("write an interval as `0.0 < {name} < 1.0`")));
        }
    } else if follows() {
        let (inclusive, number) = (upward(input)?, number(input)?);
        upper = Some(Bound { number, inclusive });
    }
    Ok(Bounds {
        name,
        lower,
        upper,
        source: TokenStream::new(),
    })
}

/// `<` or `<=`: whether the end belongs to the interval.
fn upward(input: ParseStream) -> syn::Result<bool> {
    let place = input.fork();
    match relation(input)? {
        (true, inclusive) => Ok(inclusive),
        _ => Err(place.error("write the smaller end first, as in `0.0 <= x < 1.0`")),
    }
}

/// Whether it is less that is meant, and whether the end belongs to the interval.
fn relation(input: ParseStream) -> syn::Result<(bool, bool)> {
    let found = match input.fork().parse() {
        Ok(BinOp::Lt(_)) => (true, false),
        Ok(BinOp::Le(_)) => (true, true),
        Ok(BinOp::Gt(_)) => (false, false),
        Ok(BinOp::Ge(_)) => (false, true),
        _ => {
            let found = next(input).unwrap_or_default();
            return Err(input.error(format!(
                "expected one of `>`, `>=`, `<`, `<=` before `{found}`"
            )));
        }
    };
    input.parse::<BinOp>()?;
    Ok(found)
}

/// `: unit`, or nothing.
pub(super) fn unit_if_stated(input: ParseStream) -> syn::Result<Option<Unit>> {
    if input.parse::<Option<Token![:]>>()?.is_none() {
        return Ok(None);
    }
    let ahead = input.fork();
    let mut factors = Vec::new();
    if input.peek(LitInt) {
        one(input)?;
    } else {
        factors.push(factor(input, false)?);
    }
    while input.peek(Token![*]) || input.peek(Token![/]) {
        let divides = input.parse::<Option<Token![/]>>()?.is_some();
        if !divides {
            input.parse::<Token![*]>()?;
        }
        factors.push(factor(input, divides)?);
    }
    let source = consumed(&ahead, input)?;
    if let Ok(symbol) = input.fork().parse::<Ident>() {
        return Err(input.error(match symbol.to_string().as_str() {
            word @ ("opposing" | "closing" | "with") => {
                format!("`{word}` stands behind the law: `= Law {{ field: value }} {word} v`")
            }
            symbol => {
                format!("join the symbol `{symbol}` to a unit with `*` or `/`, as in `N*m`")
            }
        }));
    }
    Ok(Some(Unit { factors, source }))
}

fn one(input: ParseStream) -> syn::Result<()> {
    let literal: LitInt = input.parse()?;
    if literal.to_string() == "1" {
        Ok(())
    } else {
        Err(syn::Error::new(
            literal.span(),
            "a unit is `1`, or symbols such as `kg*m/s^2`; its factor is not part of it",
        ))
    }
}

/// `symbol["^"int]`
fn factor(input: ParseStream, divides: bool) -> syn::Result<UnitFactor> {
    if input.peek(syn::token::Paren) {
        return Err(input.error("units have no parentheses: write `N/m/s` for N/(m s)"));
    }
    if input.peek(LitStr) {
        return Err(input.error("a unit stands without quotes, as in `kg*m/s^2`"));
    }
    if input.peek(Token![=]) {
        return Err(input.error("between `:` and `=` stands a unit, as in `x: m = 1.0`; write `=` alone where there is none"));
    }
    if !input.peek(syn::Ident::peek_any) {
        return Err(input.error("expected the symbol of a unit, as in `kg*m/s^2`,"));
    }
    let symbol = input.call(Ident::parse_any)?;
    let twelfths = match input.parse::<Option<Token![^]>>()? {
        Some(_) => power(input)?,
        None => TWELFTHS,
    };
    Ok(UnitFactor {
        symbol,
        twelfths,
        divides,
    })
}

/// `int | "(" int "/" int ")"`, in twelfths.
fn power(input: ParseStream) -> syn::Result<i32> {
    if input.peek(LitInt) || input.peek(Token![-]) {
        return Ok(whole(input)?.saturating_mul(TWELFTHS));
    }
    if !input.peek(syn::token::Paren) {
        return Err(input.error(POWER));
    }
    let fraction;
    let place = syn::parenthesized!(fraction in input).span.join();
    let numerator = whole(&fraction)?;
    fraction.parse::<Token![/]>()?;
    let denominator = whole(&fraction)?;
    let twelfths = numerator.saturating_mul(TWELFTHS);
    match twelfths.checked_rem(denominator) {
        Some(0) if fraction.is_empty() => Ok(twelfths / denominator),
        _ => Err(syn::Error::new(place, POWER)),
    }
}

fn whole(input: ParseStream) -> syn::Result<i32> {
    let negative = input.parse::<Option<Token![-]>>()?.is_some();
    if !input.peek(LitInt) {
        return Err(input.error(POWER));
    }
    let magnitude: i32 = input.parse::<LitInt>()?.base10_parse()?;
    Ok(if negative { -magnitude } else { magnitude })
}

const POWER: &str = "the power of a unit is a whole number, as in `m^2`, or a fraction of twelfths, as in `Pa^(1/2)`";

/// The tokens between two places of the same stream.
fn consumed(from: ParseStream, to: ParseStream) -> syn::Result<TokenStream> {
    let from = seen(from.fork().parse()?);
    let to = seen(to.fork().parse()?);
    let length = from.len().saturating_sub(to.len());
    Ok(from.into_iter().take(length).collect())
}

/// The tokens as a parser meets them: it walks into an invisible group (what a `macro_rules!` fragment becomes), and may
/// stop in the middle of one.
fn seen(tokens: TokenStream) -> Vec<TokenTree> {
    tokens
        .into_iter()
        .flat_map(|token| match token {
            TokenTree::Group(group) if group.delimiter() == Delimiter::None => seen(group.stream()),
            token => vec![token],
        })
        .collect()
}
