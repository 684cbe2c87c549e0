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
    let kind = match contact {
        press if press.is_press() => Kind::Press,
        remembering if remembering.has_memory() => Kind::Memory,
        _ => Kind::Law,
    };
    kind.numbered(contact.place)
}

/// What laws there are; those of presses are numbered after the others without memory.
#[derive(Clone, Copy, PartialEq)]
enum Kind {
    Law,
    Memory,
    Press,
}

impl Kind {
    fn numbered(self, place: usize) -> Ident {
        match self {
            Self::Memory => format_ident!("__memory_{place}"),
            Self::Law | Self::Press => format_ident!("__law_{place}"),
        }
    }
}

/// The data of the law of a contact of this model.
pub(super) fn info(model: &TokenStream, contact: &Contact) -> TokenStream {
    let law = name(contact);
    let info = if contact.is_press() {
        quote!(press_info_of)
    } else if contact.has_memory() {
        quote!(memory_info_of)
    } else {
        quote!(info_of)
    };
    quote!(::stickslip::declared::#info(#model::#law::<f64>))
}

/// One function for each contact, from the fields in the order in which they are written.
pub(super) fn builders(written: &Declaration) -> TokenStream {
    let of_kind = |memory: bool| {
        let lines = written.frictions();
        lines.filter(move |line| line.memory.is_empty() != memory)
    };
    let numbered = |first: usize, kind: Kind| {
        move |(place, line)| builder(&kind.numbered(first + place), kind, line)
    };
    let laws = of_kind(false).enumerate().map(numbered(0, Kind::Law));
    let memories = of_kind(true).enumerate().map(numbered(0, Kind::Memory));
    let first = of_kind(false).count();
    let presses = written.presses().enumerate();
    let presses = presses.map(numbered(first, Kind::Press));
    let builders: Vec<TokenStream> = laws.chain(memories).chain(presses).collect();
    if builders.is_empty() {
        return quote!();
    }
    let (allowed, model) = (allowed(), &written.header.name);
    quote! {
        #allowed
        impl #model { #(#builders)* }
    }
}

fn builder(name: &Ident, kind: Kind, line: &Friction) -> TokenStream {
    let law = &line.law;
    let fields = line.fields.iter().map(|field| &field.name);
    let count = Literal::usize_unsuffixed(line.fields.len());
    let places = (0..line.fields.len()).map(Literal::usize_unsuffixed);
    let is_law = match kind {
        Kind::Law => quote_spanned!(law.span()=> impl ::stickslip::friction::FrictionLaw<D>),
        Kind::Press => quote_spanned!(law.span()=> impl ::stickslip::press::PressLaw<D>),
        Kind::Memory => {
            let states = Literal::usize_unsuffixed(line.memory.len());
            quote_spanned!(law.span()=> impl ::stickslip::memory::MemoryLaw<D, #states>)
        }
    };
    // Spelt as by the user: for a field that the law has not the compiler then names those that it has.
    let values = quote!(#(#fields: __fields[#places]),*);
    let literal = quote_spanned!(law.span()=> #law { #values });
    quote! {
        #[inline]
        fn #name<D: ::stickslip::scalar::Scalar>(__fields: [D; #count]) -> #is_law {
            #literal
        }
    }
}
