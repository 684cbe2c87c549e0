//! Agreement of a model's units with those of the laws that it names.
//!
//! The macro cannot see a law's tokens, so the comparison is left to the compiler.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{quote, quote_spanned};
use syn::ext::IdentExt;

use crate::check::{Contact, Dimension, Field, Model};
use crate::formula::tight;

/// One assertion for each field of a law whose unit is known.
pub(super) fn assertions(model: &Model) -> TokenStream {
    let contacts = model.contacts().enumerate();
    contacts
        .flat_map(|(index, contact)| of_contact(model.header.name, index, contact))
        .collect()
}

fn of_contact<'a>(
    model: &'a Ident,
    index: usize,
    contact: &'a Contact,
) -> impl Iterator<Item = TokenStream> {
    let fields = contact.fields.iter();
    fields.filter_map(move |field| assertion(model, index, contact, field))
}

fn assertion(model: &Ident, index: usize, contact: &Contact, field: &Field) -> Option<TokenStream> {
    let dimension = field.dimension?;
    let (found, law) = (exponents(dimension)?, super::builder::name(index));
    let [force, speed] = [contact.measures.force, contact.measures.speed].map(if_known);
    let time = exponents(contact.measures.time)?;
    let name = field.name.unraw().to_string();
    let message = message(contact, field, dimension);
    Some(quote_spanned! {field.name.span()=>
        const _: () = ::core::assert!(
            ::stickslip::declared::Contact {
                force: #force,
                speed: #speed,
                time: #time,
            }
            .accepts(
                ::stickslip::declared::info_of(#model::#law::<f64>),
                #name,
                #found,
            ),
            #message,
        );
    })
}

fn message(contact: &Contact, field: &Field, dimension: Dimension) -> String {
    let law = tight(&quote::ToTokens::to_token_stream(contact.law));
    let (name, formula, force) = (field.name, field.formula, contact.name);
    format!(
        "unit mismatch: `{formula}` is in {dimension}, which is not the unit of `{name}` in `{law}`, \
         measured with the force `{force}` and the speed `{speed}`",
        speed = contact.speed,
    )
}

fn if_known(dimension: Option<Dimension>) -> TokenStream {
    match dimension.and_then(exponents) {
        None => quote!(::core::option::Option::None),
        Some(exponents) => quote!(::core::option::Option::Some(#exponents)),
    }
}

fn exponents(dimension: Dimension) -> Option<TokenStream> {
    let exponents = dimension.exponents()?.map(Literal::i8_unsuffixed);
    Some(quote!([#(#exponents),*]))
}
