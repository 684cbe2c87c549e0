//! The functions that build the laws of a model's contacts.
//!
//! Each law is named in one place, so that a misspelt law or field is one message of the compiler.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote, quote_spanned};
use syn::Path;
use syn::spanned::Spanned;

use super::allowed;
use crate::check::{Contact, Model};
use crate::syntax::Friction;

/// A law as a contact names it: its path and its fields.
pub(super) struct Named<'a> {
    law: &'a Path,
    fields: Vec<&'a Ident>,
    /// How many states carry its memory.
    memory: usize,
}

impl<'a> From<&Contact<'a>> for Named<'a> {
    fn from(contact: &Contact<'a>) -> Self {
        Self {
            law: contact.law,
            fields: contact.fields.iter().map(|field| field.name).collect(),
            memory: 0,
        }
    }
}

impl<'a> From<&'a Friction> for Named<'a> {
    fn from(line: &'a Friction) -> Self {
        Self {
            law: &line.law,
            fields: line.fields.iter().map(|field| &field.name).collect(),
            memory: line.memory.len(),
        }
    }
}

/// The name of the function for the contact of this index.
pub(super) fn name(contact: usize) -> Ident {
    format_ident!("__law_{contact}")
}

/// The name of the function for the law with internal state of this index.
pub(super) fn memory_name(element: usize) -> Ident {
    format_ident!("__memory_{element}")
}

/// The laws that a model names.
pub(super) fn named<'a>(model: &Model<'a>) -> Vec<Named<'a>> {
    let memories = model.memories().map(|memory| Named {
        memory: memory.carriers.len(),
        ..Named::from(&memory.contact)
    });
    model.contacts().map(Named::from).chain(memories).collect()
}

/// One function for each contact, from the fields in the order in which they are written.
pub(super) fn builders<'a>(
    model: &Ident,
    contacts: impl Iterator<Item = Named<'a>>,
) -> TokenStream {
    let (memories, contacts): (Vec<_>, Vec<_>) = contacts.partition(|named| named.memory > 0);
    let contacts = contacts.into_iter().enumerate();
    let contacts = contacts.map(|(index, named)| builder(&name(index), &named));
    let memories = memories.into_iter().enumerate();
    let memories = memories.map(|(index, named)| builder(&memory_name(index), &named));
    let builders: Vec<TokenStream> = contacts.chain(memories).collect();
    if builders.is_empty() {
        return quote!();
    }
    let allowed = allowed();
    quote! {
        #allowed
        impl #model { #(#builders)* }
    }
}

fn builder(name: &Ident, named: &Named) -> TokenStream {
    let Named {
        law,
        fields,
        memory,
    } = named;
    let count = Literal::usize_unsuffixed(fields.len());
    let places = (0..fields.len()).map(Literal::usize_unsuffixed);
    let is_law = if *memory == 0 {
        quote_spanned!(law.span()=> impl ::stickslip::friction::FrictionLaw<D>)
    } else {
        let states = Literal::usize_unsuffixed(*memory);
        quote_spanned!(law.span()=> impl ::stickslip::memory::MemoryLaw<D, #states>)
    };
    quote! {
        #[inline]
        fn #name<D: ::stickslip::scalar::Scalar>(__fields: [D; #count]) -> #is_law {
            #law { #(#fields: __fields[#places]),* }
        }
    }
}
