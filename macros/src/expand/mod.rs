//! From declarations that are known to be good to tokens; beside errors, stubs.

mod agreement;
mod builder;
mod doc;
mod info;
mod items;
mod law;
mod lift;
mod linear;
mod memory_law;
mod model;
mod page;
mod pattern;
mod presses;
mod shell;
mod straight;
mod structure;
mod stub;
mod tangent;
mod typeset;

#[cfg(test)]
pub(crate) use self::lift::lifted;

use proc_macro2::TokenStream;
use quote::quote;

use crate::check;
use crate::errors::Errors;
use crate::parse::{self, Grammar};

/// Expands `model!`.
pub(crate) fn model(tokens: TokenStream) -> TokenStream {
    let mut errors = Errors::new();
    let written = parse::declaration(tokens, Grammar::Model, &mut errors);
    let expanded = written.as_ref().map(|written| {
        let good = check::model(written, &mut errors);
        good.map_or_else(
            || stub::model(written),
            |good| model::tokens(&good, written),
        )
    });
    with_errors(expanded, errors)
}

/// Expands `friction_law!`.
pub(crate) fn law(tokens: TokenStream) -> TokenStream {
    law_in(Grammar::Law, tokens)
}

/// Expands `press_law!`.
pub(crate) fn press_law(tokens: TokenStream) -> TokenStream {
    law_in(Grammar::Press, tokens)
}

fn law_in(grammar: Grammar, tokens: TokenStream) -> TokenStream {
    let mut errors = Errors::new();
    let written = parse::declaration(tokens, grammar, &mut errors);
    let expanded = written.as_ref().map(|written| {
        let good = check::law(written, grammar, &mut errors);
        good.map_or_else(|| stub::law(written, grammar), |good| law::tokens(&good))
    });
    with_errors(expanded, errors)
}

fn with_errors(expanded: Option<TokenStream>, errors: Errors) -> TokenStream {
    match errors.finish() {
        Ok(()) => quote!(#expanded),
        Err(errors) => {
            let errors = errors.into_compile_error();
            quote!(#errors #expanded)
        }
    }
}

/// An `Option` as an expression.
fn option(some: Option<TokenStream>) -> TokenStream {
    match some {
        None => quote!(::core::option::Option::None),
        Some(some) => quote!(::core::option::Option::Some(#some)),
    }
}

/// Lints that a user's names or way of writing may raise in generated code.
fn allowed() -> TokenStream {
    quote!(#[allow(clippy::all, clippy::pedantic, dead_code, non_snake_case, non_upper_case_globals, unused)])
}
