//! What stands before a line: its documentation, and what it declares.

use proc_macro2::Ident;
use quote::ToTokens;
use syn::Attribute;
use syn::ext::IdentExt;
use syn::parse::ParseStream;

use super::shape::next;
use crate::formula::tight;

pub(super) fn name(input: ParseStream) -> syn::Result<Ident> {
    let found = input.call(Ident::parse_any);
    found.map_err(|error| {
        let before = next(input).map_or_else(String::new, |next| format!(" before `{next}`"));
        syn::Error::new(error.span(), format!("expected a name{before}"))
    })
}

/// Doc comments; no other attribute has a meaning here.
pub(super) fn docs(input: ParseStream) -> syn::Result<Vec<Attribute>> {
    let attributes = input.call(Attribute::parse_outer)?;
    match attributes
        .iter()
        .find(|attribute| !attribute.path().is_ident("doc"))
    {
        None => Ok(attributes),
        Some(other) => Err(syn::Error::new_spanned(
            other,
            format!(
                "`#[{}]` has no meaning here: only doc comments (`///`) may stand before what is declared; remove it",
                tight(&other.path().to_token_stream())
            ),
        )),
    }
}

pub(super) fn undocumented(docs: &[Attribute]) -> syn::Result<()> {
    match docs.first() {
        None => Ok(()),
        Some(doc) => Err(syn::Error::new_spanned(
            doc,
            "a doc comment describes what a line declares, and this line declares nothing: use `//`",
        )),
    }
}
