//! Agreement of a model's units with those of the laws that it names.
//!
//! The macro cannot see a law's tokens, so the comparison is left to the compiler.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, quote, quote_spanned};
use syn::ext::IdentExt;

use super::{builder, option, pattern};
use crate::check::{Contact, Dimension, Model};
use crate::formula::tight;

/// One assertion for each field of a law whose unit is known.
pub(super) fn assertions(model: &Model) -> TokenStream {
    let name = model.header.name.to_token_stream();
    let contacts = model.contacts().chain(model.memories());
    let contacts = contacts.chain(model.presses());
    let assertions = contacts.flat_map(|contact| {
        let info = builder::info(&name, contact);
        let mut all = of_fields(contact, &info);
        all.extend(of_carriers(contact, &info));
        if contact.has_memory() {
            all.extend(of_stops(contact, model, &info));
        }
        if contact.is_press() {
            all.extend(of_reaction(contact, model, &info));
        }
        all
    });
    assertions.collect()
}

fn of_fields(contact: &Contact, info: &TokenStream) -> Vec<TokenStream> {
    let fields = contact.line.fields.iter().zip(&contact.fields);
    let assertions = fields.filter_map(|(field, dimension)| {
        let (name, dimension) = (field.name.unraw().to_string(), (*dimension)?);
        let found = exponents(dimension)?;
        let asked = quote!(accepts(#info.parameters, #name, #found));
        let what = format!("`{}` is in {dimension}", field.formula);
        let whose = format!("`{}` in `{}`", field.name, law(contact));
        assertion(contact, &field.name, &asked, &what, &whose)
    });
    assertions.collect()
}

fn of_carriers(contact: &Contact, info: &TokenStream) -> Vec<TokenStream> {
    let carriers = contact.carriers.iter().enumerate();
    let assertions = carriers.filter_map(|(index, carrier)| {
        let (state, dimension) = (carrier.state, carrier.dimension?);
        let (found, index) = (exponents(dimension)?, Literal::usize_unsuffixed(index));
        let asked = quote!(carries(#info, #index, #found));
        let what = format!("`{state}` is in {dimension}");
        let law = law(contact);
        let whose = format!("the internal state of `{law}` that it carries");
        assertion(contact, state, &asked, &what, &whose)
    });
    assertions.collect()
}

/// That no stop moves with the states of the model.
fn of_stops(contact: &Contact, model: &Model, info: &TokenStream) -> Vec<TokenStream> {
    let fields = contact.line.fields.iter();
    let moving = fields.filter(|field| !pattern::stands_still(&field.formula, model));
    let assertions = moving.map(|field| {
        let name = field.name.unraw().to_string();
        let message = format!(
            "`{}` changes along a motion, and an internal state of `{}` stops at `{name}`, which stands still: \
             write a formula of the parameters alone",
            field.formula,
            law(contact)
        );
        quote_spanned! {field.name.span()=>
            const _: () = ::core::assert!(!#info.stops_at(#name), #message);
        }
    });
    assertions.collect()
}

/// That a rigid press, whose reaction is solved for, enters linearly, and that no law with internal state reads it.
fn of_reaction(contact: &Contact, model: &Model, info: &TokenStream) -> Vec<TokenStream> {
    let name = &contact.line.name;
    let law = law(contact);
    let reads = |other: &&Contact| pattern::presses_of(other, model).contains(&contact.place);
    let reader = model.memories().filter(reads).map(|other| {
        let other = &other.line.name;
        format!(
            "the law of `{other}` has internal state and reads `{name}`, the reaction of a rigid contact, which is solved for \
             together with friction that it causes at once: press with a compliant law, or take a law without internal state"
        )
    });
    let bent = model.bent.then(|| {
        format!(
            "`{law}` does not give way, and the reaction of such a contact is solved for: presses must enter linearly then, \
             and here one is multiplied by a force, stands in a denominator or inside a function"
        )
    });
    let messages = reader.chain(bent);
    let assertion = |message: String| {
        quote_spanned! {name.span()=>
            const _: () = ::core::assert!(!#info.is_rigid(), #message);
        }
    };
    messages.map(assertion).collect()
}

fn law(contact: &Contact) -> String {
    tight(&contact.line.law.to_token_stream())
}

/// That what is asked of the dimensions of a contact holds; `what` has not the unit of `whose`.
fn assertion(
    contact: &Contact,
    place: &Ident,
    asked: &TokenStream,
    what: &str,
    whose: &str,
) -> Option<TokenStream> {
    let (force, measure) = (&contact.line.name, &contact.line.speed);
    let kind = if contact.is_press() { "gap" } else { "speed" };
    let message = format!(
        "unit mismatch: {what}, which is not the unit of {whose}, measured with the force `{force}` and the {kind} `{measure}`"
    );
    let [force, speed] = [contact.measures.force, contact.measures.speed]
        .map(|known| option(known.and_then(exponents)));
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

fn exponents(dimension: Dimension) -> Option<TokenStream> {
    let exponents = dimension.exponents()?.map(Literal::i16_unsuffixed);
    Some(quote!([#(#exponents),*]))
}
