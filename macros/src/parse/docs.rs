//! What stands before a line: its documentation, and what it declares.

use proc_macro2::Ident;
use syn::Attribute;
use syn::ext::IdentExt;
use syn::parse::ParseStream;

pub(super) fn name(input: ParseStream) -> syn::Result<Ident> {
    let found = input.call(Ident::parse_any);
    found.map_err(|error| syn::Error::new(error.span(), "expected a name"))
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
            "only doc comments (`///`) may stand here",
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
