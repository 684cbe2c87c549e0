//! The functions that build the laws of a model's contacts.
//!
//! Each law is named in one place, so that a misspelt law or field is one message of the compiler.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote, quote_spanned};
use syn::Path;
use syn::spanned::Spanned;

use super::allowed;
use crate::check::Contact;
use crate::syntax::Friction;

/// A law as a contact names it: its path and its fields.
pub(super) struct Named<'a> {
    law: &'a Path,
    fields: Vec<&'a Ident>,
}

impl<'a> From<&Contact<'a>> for Named<'a> {
    fn from(contact: &Contact<'a>) -> Self {
        Self {
            law: contact.law,
            fields: contact.fields.iter().map(|field| field.name).collect(),
        }
    }
}

impl<'a> From<&'a Friction> for Named<'a> {
    fn from(line: &'a Friction) -> Self {
        Self {
            law: &line.law,
            fields: line.fields.iter().map(|field| &field.name).collect(),
        }
    }
}

/// The name of the function for the contact of this index.
pub(super) fn name(contact: usize) -> Ident {
    format_ident!("__law_{contact}")
}

/// One function for each contact, from the fields in the order in which they are written.
pub(super) fn builders<'a>(
    model: &Ident,
    contacts: impl Iterator<Item = Named<'a>>,
) -> TokenStream {
    let builders: Vec<TokenStream> = contacts.enumerate().map(builder).collect();
    if builders.is_empty() {
        return quote!();
    }
    let allowed = allowed();
    quote! {
        #allowed
        impl #model { #(#builders)* }
    }
}

fn builder((index, Named { law, fields }): (usize, Named)) -> TokenStream {
    let (name, count) = (name(index), Literal::usize_unsuffixed(fields.len()));
    let places = (0..fields.len()).map(Literal::usize_unsuffixed);
    let is_law = quote_spanned!(law.span()=> impl ::stickslip::friction::FrictionLaw<D>);
    quote! {
        #[inline]
        fn #name<D: ::stickslip::scalar::Scalar>(__fields: [D; #count]) -> #is_law {
            #law { #(#fields: __fields[#places]),* }
        }
    }
}
