//! The functions of a law with internal state.

use std::collections::BTreeMap;

use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens, quote};

use super::law::{SPEED, along, opening, tangents};
use super::lift::Lift;
use crate::arithmetic::CORNERS;
use crate::check::{Law, Whole};
use crate::formula::{Formula, Kind};

pub(super) fn items<'l>(law: &'l Law<'_>, force: &Whole, lift: Lift<'l>) -> TokenStream {
    let count = Literal::usize_unsuffixed(law.states.len());
    let opening = opening(law);
    let opposing = opposing(&force.formula);
    let answer = answer(law, &opposing, &lift);
    let (kinks, stops) = (kinks(law, &force.formula, &lift), stops(law, &lift));
    let slopes = slopes(law, &opposing, lift);
    quote! {
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

fn answer(law: &Law, force: &Formula, lift: &Lift) -> TokenStream {
    let force = lift.formula(force);
    let rates = law.states.iter();
    let rates = rates.map(|state| lift.formula(&state.rate.formula));
    quote! {
        ::stickslip::memory::Answer {
            force: #force,
            rates: [#(#rates),*],
        }
    }
}

/// The body of `slopes`.
fn slopes<'l>(law: &'l Law<'_>, force: &Formula, lift: Lift<'l>) -> TokenStream {
    let along = along(law);
    let mut tangents = tangents(law, lift);
    let mut sloped = |formula: &Formula| {
        let quantity = tangents.formula(formula);
        let [by_speed, by_fields] =
            [SPEED, along].map(|direction| tangents.slope(&quantity.slopes, direction));
        let by_memory = (SPEED + 1..along).map(|d| tangents.slope(&quantity.slopes, d));
        let (by_memory, value): (Vec<_>, _) = (by_memory.collect(), tangents.value(&quantity));
        quote! {
            ::stickslip::memory::Sloped {
                value: #value,
                by_speed: #by_speed,
                by_memory: [#(#by_memory),*],
                along: #by_fields,
            }
        }
    };
    let force = sloped(force);
    let rates = law.states.iter().map(|state| sloped(&state.rate.formula));
    let rates: Vec<_> = rates.collect();
    let lines = tangents.lines();
    quote! {
        #lines
        ::stickslip::memory::AnswerSlopes {
            force: #force,
            rates: [#(#rates),*],
        }
    }
}

/// Each argument of a function with a kink, once.
fn kinks(law: &Law, force: &Formula, lift: &Lift) -> TokenStream {
    let rates = law.states.iter().map(|state| &state.rate.formula);
    let calls = rates
        .chain([force])
        .flat_map(|formula| formula.calls_of(&CORNERS));
    let arguments: BTreeMap<String, &Formula> = calls
        .map(|(_, argument)| (argument.bare().to_string(), argument))
        .collect();
    let arguments = arguments.values().map(|argument| lift.formula(argument));
    quote!(#(__visit(#arguments);)*)
}

/// The magnitude at which each internal state stops; nothing where none does.
fn stops(law: &Law, lift: &Lift) -> Option<TokenStream> {
    let stops = law.states.iter().enumerate().filter_map(|(place, state)| {
        let bound = lift.formula(&state.stop.as_ref()?.formula);
        let place = Literal::usize_unsuffixed(place);
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
