//! A law with internal state: its struct, and its force and rates over any scalar.

use std::collections::{BTreeMap, HashMap};

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, quote};

use super::law::{fields, generics, structure};
use super::lift::Lift;
use super::tangent::{Slope, Slopes, Tangents};
use super::{allowed, info, page};
use crate::arithmetic::CORNERS;
use crate::check::MemoryLaw;
use crate::formula::{Formula, Kind};

pub(super) fn tokens(law: &MemoryLaw) -> TokenStream {
    let structure = structure(law.header, &law.parameters, page::of_memory_law(law));
    let (name, allowed, info) = (law.header.name, allowed(), info::of_memory_law(law));
    let generics = generics(name, law.parameters.is_empty());
    let count = Literal::usize_unsuffixed(law.states.len());
    let quantity = |name: &Ident| {
        let moving = name == law.speed || law.states.iter().any(|state| state.name == name);
        if moving {
            quote!(__moving.#name)
        } else {
            quote!(self.#name)
        }
    };
    let lift = |scalar| Lift {
        scalar,
        quantity: &quantity,
    };
    let opening = opening(law);
    let force = opposing(&law.force);
    let answer = answer(law, &force, &lift(quote!(D)));
    let slopes = slopes(law, &force, lift(quote!(D)));
    let kinks = kinks(law, &lift(quote!(D)));
    let stops = stops(law, &lift(quote!(D)));
    let fields = fields(&law.parameters);
    quote! {
        #structure

        #allowed
        #[automatically_derived]
        impl<D: ::stickslip::scalar::Scalar> ::stickslip::memory::MemoryLaw<D, #count> for #name #generics {
            const INFO: &'static ::stickslip::memory::MemoryLawInfo = &#info;

            #[inline]
            fn answer(&self, __memory: [D; #count], __speed: D) -> ::stickslip::memory::Answer<D, #count> {
                #opening
                #answer
            }

            #[inline]
            fn slopes(
                &self,
                __along: &Self,
                __memory: [D; #count],
                __speed: D,
            ) -> ::stickslip::memory::AnswerSlopes<D, #count> {
                #opening
                #slopes
            }

            fn kinks(&self, __memory: [D; #count], __speed: D, mut __visit: impl ::core::ops::FnMut(D)) {
                #opening
                #kinks
            }

            #stops

            #fields
        }
    }
}

/// Speed and internal states as fields, which nothing can capture.
fn opening(law: &MemoryLaw) -> TokenStream {
    let (speed, states) = (law.speed, law.states.iter().map(|state| state.name));
    let names: Vec<&Ident> = states.collect();
    let places = (0..names.len()).map(Literal::usize_unsuffixed);
    quote! {
        struct __Moving<D> { #speed: D, #(#names: D),* }
        let __moving = __Moving { #speed: __speed, #(#names: __memory[#places]),* };
    }
}

/// The force as it stands in the equations.
fn opposing(force: &Formula) -> Formula {
    let inside = Formula {
        kind: Kind::Group(Box::new(force.clone())),
        source: force.to_token_stream(),
    };
    Formula {
        kind: Kind::Minus(Box::new(inside)),
        source: force.to_token_stream(),
    }
}

fn answer(law: &MemoryLaw, force: &Formula, lift: &Lift) -> TokenStream {
    let force = lift.formula(force);
    let rates = law.states.iter().map(|state| lift.formula(&state.rate));
    quote! {
        ::stickslip::memory::Answer {
            force: #force,
            rates: [#(#rates),*],
        }
    }
}

/// The directions in which a law is differentiated: its speed, its internal states, and along given derivatives of its fields.
const SPEED: usize = 0;

/// The body of `slopes`.
fn slopes<'a>(law: &'a MemoryLaw, force: &Formula, lift: Lift<'a>) -> TokenStream {
    let count = law.states.len();
    let along = count + 1;
    let fields = law.parameters.iter().map(|parameter| {
        let name = parameter.name;
        (
            name,
            Slopes::from([(along, Slope::of(quote!(__along.#name)))]),
        )
    });
    let mut known: HashMap<&Ident, Slopes> = fields.collect();
    known.insert(law.speed, Slopes::from([(SPEED, Slope::One)]));
    for (place, state) in law.states.iter().enumerate() {
        known.insert(state.name, Slopes::from([(place + 1, Slope::One)]));
    }
    let mut tangents = Tangents::new(lift, known);
    let mut sloped = |formula: &Formula| {
        let quantity = tangents.formula(formula);
        let [by_speed, along] = [SPEED, along].map(|d| tangents.slope(&quantity.slopes, d));
        let by_memory = (1..=count).map(|d| tangents.slope(&quantity.slopes, d));
        let (by_memory, value): (Vec<_>, _) = (by_memory.collect(), tangents.value(&quantity));
        quote! {
            ::stickslip::memory::Sloped {
                value: #value,
                by_speed: #by_speed,
                by_memory: [#(#by_memory),*],
                along: #along,
            }
        }
    };
    let force = sloped(force);
    let rates: Vec<_> = law.states.iter().map(|state| sloped(&state.rate)).collect();
    let lines = tangents.lines;
    quote! {
        #lines
        ::stickslip::memory::AnswerSlopes {
            force: #force,
            rates: [#(#rates),*],
        }
    }
}

/// Each argument of a function with a kink, once.
fn kinks(law: &MemoryLaw, lift: &Lift) -> TokenStream {
    let rates = law.states.iter().map(|state| &state.rate);
    let calls = rates
        .chain([&law.force])
        .flat_map(|formula| formula.calls_of(&CORNERS));
    let arguments: BTreeMap<String, &Formula> = calls
        .map(|(_, argument)| (argument.bare().to_string(), argument))
        .collect();
    let arguments = arguments.values().map(|argument| lift.formula(argument));
    quote!(#(__visit(#arguments);)*)
}

/// The magnitude at which each internal state stops; nothing where none does.
fn stops(law: &MemoryLaw, lift: &Lift) -> Option<TokenStream> {
    let stops = law.states.iter().enumerate().filter_map(|(place, state)| {
        let (place, bound) = (
            Literal::usize_unsuffixed(place),
            &state.stop.as_ref()?.bound,
        );
        let bound = lift.formula(bound);
        Some(quote!(__visit(#place, #bound);))
    });
    let stops: Vec<_> = stops.collect();
    (!stops.is_empty()).then(|| {
        quote! {
            #[inline]
            fn stops(&self, mut __visit: impl ::core::ops::FnMut(usize, D)) {
                #(#stops)*
            }
        }
    })
}
