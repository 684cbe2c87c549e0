//! A friction law: its struct and its formulas over any scalar.

use std::collections::HashMap;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::lift::Lift;
use super::shell::{Shell, generics};
use super::tangent::{Slope, Slopes, Tangents};
use super::{allowed, info, memory_law, page, presses};
use crate::check::{Force, Law, Parameter};
use crate::formula::Formula;

pub(super) fn tokens(law: &Law) -> TokenStream {
    let shell = Shell {
        header: law.header,
        page: page::of_law(law),
        parameters: &law.parameters,
    };
    let (name, allowed) = (&law.header.name, allowed());
    let generics = generics(name, law.parameters.is_empty());
    let structure = shell.structure(&generics, &quote!(D));
    let uses = shell.uses(&generics);
    let quantity = |name: &Ident| {
        if law.moving().any(|moving| moving == name) {
            quote!(__moving.#name)
        } else {
            quote!(self.#name)
        }
    };
    let lift = Lift {
        scalar: quote!(D),
        quantity: &quantity,
    };
    let info = info::of_law(law);
    let (kind, items) = match &law.force {
        Force::Static(stick, slip) => {
            let kind = quote!(friction::FrictionLaw<D>);
            (kind, items(law, [&stick.formula, &slip.formula], lift))
        }
        Force::Memory(force) => {
            let count = Literal::usize_unsuffixed(law.states.len());
            let kind = quote!(memory::MemoryLaw<D, #count>);
            (kind, memory_law::items(law, force, lift))
        }
        Force::Press(force) => {
            let kind = quote!(press::PressLaw<D>);
            (kind, presses::items(law, force, lift))
        }
        Force::Rigid(rebound) => {
            let kind = quote!(press::PressLaw<D>);
            (kind, presses::rigid(law, rebound, lift))
        }
    };
    let fields = fields(&law.parameters);
    quote! {
        #structure
        #uses

        #allowed
        #[automatically_derived]
        impl<D: ::stickslip::scalar::Scalar> ::stickslip::#kind for #name #generics {
            #info

            #items

            #fields
        }
    }
}

/// Shows the values of all fields; nothing where there are none.
fn fields(parameters: &[Parameter]) -> Option<TokenStream> {
    let lines = parameters.iter().enumerate().map(|(place, parameter)| {
        let (place, name) = (Literal::usize_unsuffixed(place), &parameter.line.name);
        quote!(__visit(#place, self.#name);)
    });
    (!parameters.is_empty()).then(|| {
        quote! {
            #[inline]
            fn fields(&self, mut __visit: impl ::core::ops::FnMut(usize, D)) {
                #(#lines)*
            }
        }
    })
}

/// The functions of a law without internal state, from its force at rest and while sliding.
fn items<'l>(law: &'l Law<'_>, formulas: [&Formula; 2], lift: Lift<'l>) -> TokenStream {
    let opening = opening(law);
    let [at_rest, sliding] = formulas.map(|formula| lift.formula(formula));
    let mut tangents = tangents(law, lift);
    let [stick, slip] = formulas.map(|formula| tangents.formula(formula));
    let [stick_along, slip_along] =
        [&stick, &slip].map(|quantity| tangents.slope(&quantity.slopes, along(law)));
    let by_speed = tangents.slope(&slip.slopes, SPEED);
    let (stick, slip) = (tangents.value(&stick), tangents.value(&slip));
    let lines = tangents.lines();
    quote! {
        #[inline]
        fn stick(&self) -> D {
            #at_rest
        }

        #[inline]
        fn slip(&self, __speed: D) -> D {
            #opening
            #sliding
        }

        #[inline]
        fn slopes(&self, __along: &Self, __speed: D) -> ::stickslip::friction::LawSlopes<D> {
            #opening
            #lines
            ::stickslip::friction::LawSlopes {
                stick: #stick,
                stick_along: #stick_along,
                slip: #slip,
                slip_by_speed: #by_speed,
                slip_along: #slip_along,
            }
        }
    }
}

/// Speed and internal states, or depth and rate, as fields, which nothing can capture.
pub(super) fn opening(law: &Law) -> TokenStream {
    let (first, names) = (law.speed, law.moving().skip(1).collect::<Vec<&Ident>>());
    let values = (0..names.len()).map(|place| {
        let place = Literal::usize_unsuffixed(place);
        match law.rate {
            Some(_) => quote!(__rate),
            None => quote!(__memory[#place]),
        }
    });
    quote! {
        struct __Moving<D> { #first: D, #(#names: D),* }
        let __moving = __Moving { #first: __speed, #(#names: #values),* };
    }
}

/// The first of the directions in which a law is differentiated; its internal states, or the rate of its depth, follow.
pub(super) const SPEED: usize = 0;

/// The last of these directions: along given derivatives of its fields.
pub(super) fn along(law: &Law) -> usize {
    law.moving().count()
}

/// What differentiates the formulas of a law in these directions.
pub(super) fn tangents<'l>(law: &'l Law<'_>, lift: Lift<'l>) -> Tangents<'l> {
    let fields = law.parameters.iter().map(|parameter| {
        let name = &parameter.line.name;
        let slope = Slope::of(quote!(__along.#name));
        (name, Slopes::from([(along(law), slope)]))
    });
    let moving = law.moving().enumerate();
    let moving = moving.map(|(direction, name)| (name, Slopes::from([(direction, Slope::One)])));
    let known: HashMap<&Ident, Slopes> = fields.chain(moving).collect();
    Tangents::new(lift, known)
}
