//! The declaration language of `stickslip`: [`model!`], [`friction_law!`] and [`press_law!`].
//!
//! A declaration passes through three representations that never mix: as written (`syntax`),
//! known good (`check`) and tokens (`expand`). Whatever is wrong is collected on the way.

mod arithmetic;
mod check;
mod errors;
mod expand;
mod formula;
mod parse;
mod repeated;
mod structure;
mod suggest;
mod symbol;
mod syntax;

#[cfg(test)]
mod tests;

use proc_macro::TokenStream;

/// Expands a model, as `stickslip::model!` describes.
#[proc_macro]
pub fn model(declaration: TokenStream) -> TokenStream {
    expand::model(declaration.into()).into()
}

/// Expands a friction law, as `stickslip::friction_law!` describes.
#[proc_macro]
pub fn friction_law(declaration: TokenStream) -> TokenStream {
    expand::law(declaration.into()).into()
}

/// Expands a law of contacts that press, as `stickslip::press_law!` describes.
#[proc_macro]
pub fn press_law(declaration: TokenStream) -> TokenStream {
    expand::press_law(declaration.into()).into()
}
