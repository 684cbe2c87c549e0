//! Agreement of a model's units with those of the laws that it names.
//!
//! The macro cannot see a law's tokens, so the comparison is left to the compiler.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{quote, quote_spanned};
use syn::ext::IdentExt;

use super::pattern;
use crate::check::{Carrier, Contact, Dimension, Field, Memory, Model};
use crate::formula::tight;

/// One assertion for each field of a law whose unit is known.
pub(super) fn assertions(model: &Model) -> TokenStream {
    let name = model.header.name;
    let contacts = model.contacts().enumerate().flat_map(|(index, contact)| {
        let law = super::builder::name(index);
        let info = quote!(::stickslip::declared::info_of(#name::#law::<f64>));
        of_fields(contact, &info)
    });
    let memories = model.memories().enumerate().flat_map(|(index, memory)| {
        let law = super::builder::memory_name(index);
        let info = quote!(::stickslip::declared::memory_info_of(#name::#law::<f64>));
        let mut all = of_fields(&memory.contact, &info);
        all.extend(of_carriers(memory, &info));
        all.extend(of_stops(memory, model, &info));
        all
    });
    contacts.chain(memories).collect()
}

fn of_fields(contact: &Contact, info: &TokenStream) -> Vec<TokenStream> {
    let fields = contact.fields.iter();
    let assertions = fields.filter_map(|field| {
        let dimension = field.dimension?;
        let (found, name) = (exponents(dimension)?, field.name.unraw().to_string());
        let asked = quote!(accepts(#info.parameters, #name, #found));
        assertion(
            contact,
            field.name,
            &asked,
            &message(contact, field, dimension),
        )
    });
    assertions.collect()
}

fn of_carriers(memory: &Memory, info: &TokenStream) -> Vec<TokenStream> {
    let carriers = memory.carriers.iter().enumerate();
    let assertions = carriers.filter_map(|(index, carrier)| {
        let dimension = carrier.dimension?;
        let (found, index) = (exponents(dimension)?, Literal::usize_unsuffixed(index));
        let asked = quote!(carries(#info, #index, #found));
        let message = message_of(memory, carrier, dimension);
        assertion(&memory.contact, &carrier.state, &asked, &message)
    });
    assertions.collect()
}

/// That no stop moves with the states of the model.
fn of_stops(memory: &Memory, model: &Model, info: &TokenStream) -> Vec<TokenStream> {
    let fields = memory.contact.fields.iter();
    let moving = fields.filter(|field| !pattern::stands_still(field.formula, model));
    let assertions = moving.map(|field| {
        let name = field.name.unraw().to_string();
        let law = tight(&quote::ToTokens::to_token_stream(memory.contact.law));
        let message = format!(
            "`{}` changes along a motion, and an internal state of `{law}` stops at `{name}`, which stands still: \
             write a formula of the parameters alone",
            field.formula
        );
        quote_spanned! {field.name.span()=>
            const _: () = ::core::assert!(!#info.stops_at(#name), #message);
        }
    });
    assertions.collect()
}

/// That what is asked of the dimensions of a contact holds.
fn assertion(
    contact: &Contact,
    place: &Ident,
    asked: &TokenStream,
    message: &str,
) -> Option<TokenStream> {
    let [force, speed] = [contact.measures.force, contact.measures.speed].map(if_known);
    let time = exponents(contact.measures.time)?;
    Some(quote_spanned! {place.span()=>
        const _: () = ::core::assert!(
            ::stickslip::declared::Contact {
                force: #force,
                speed: #speed,
                time: #time,
            }
            .#asked,
            #message,
        );
    })
}

fn message_of(memory: &Memory, carrier: &Carrier, dimension: Dimension) -> String {
    let contact = &memory.contact;
    let law = tight(&quote::ToTokens::to_token_stream(contact.law));
    let (state, force, speed) = (&carrier.state, contact.name, contact.speed);
    format!(
        "unit mismatch: `{state}` is in {dimension}, which is not the unit of the internal state of `{law}` that it \
         carries, measured with the force `{force}` and the speed `{speed}`"
    )
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
