//! The functions that build the laws of a model's contacts.
//!
//! Each law is named in one place, so that a misspelt law or field is one message of the compiler.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote, quote_spanned};
use syn::spanned::Spanned;

use super::allowed;
use crate::check::Contact;
use crate::syntax::{Declaration, Friction};

/// The name of the function for a contact.
pub(super) fn name(contact: &Contact) -> Ident {
    numbered(contact.place, contact.has_memory())
}

fn numbered(place: usize, memory: bool) -> Ident {
    if memory {
        format_ident!("__memory_{place}")
    } else {
        format_ident!("__law_{place}")
    }
}

/// The data of the law of a contact of this model.
pub(super) fn info(model: &TokenStream, contact: &Contact) -> TokenStream {
    let law = name(contact);
    let info = if contact.has_memory() {
        quote!(memory_info_of)
    } else {
        quote!(info_of)
    };
    quote!(::stickslip::declared::#info(#model::#law::<f64>))
}

/// One function for each contact, from the fields in the order in which they are written.
pub(super) fn builders(written: &Declaration) -> TokenStream {
    let kind = |memory: bool| {
        let lines = written.frictions();
        let lines = lines.filter(move |line| line.memory.is_empty() != memory);
        let numbered = move |place| numbered(place, memory);
        lines
            .enumerate()
            .map(move |(place, line)| builder(&numbered(place), line))
    };
    let builders: Vec<TokenStream> = kind(false).chain(kind(true)).collect();
    if builders.is_empty() {
        return quote!();
    }
    let (allowed, model) = (allowed(), &written.header.name);
    quote! {
        #allowed
        impl #model { #(#builders)* }
    }
}

fn builder(name: &Ident, line: &Friction) -> TokenStream {
    let law = &line.law;
    let fields = line.fields.iter().map(|field| &field.name);
    let count = Literal::usize_unsuffixed(line.fields.len());
    let places = (0..line.fields.len()).map(Literal::usize_unsuffixed);
    let is_law = if line.memory.is_empty() {
        quote_spanned!(law.span()=> impl ::stickslip::friction::FrictionLaw<D>)
    } else {
        let states = Literal::usize_unsuffixed(line.memory.len());
        quote_spanned!(law.span()=> impl ::stickslip::memory::MemoryLaw<D, #states>)
    };
    quote! {
        #[inline]
        fn #name<D: ::stickslip::scalar::Scalar>(__fields: [D; #count]) -> #is_law {
            #law { #(#fields: __fields[#places]),* }
        }
    }
}
