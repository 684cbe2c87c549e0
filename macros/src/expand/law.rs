//! A friction law: its struct and its two formulas over any scalar.

use std::collections::HashMap;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{quote, quote_spanned};

use super::lift::Lift;
use super::shell::Shell;
use super::tangent::{Slope, Slopes, Tangents};
use super::{allowed, info, page};
use crate::check::{Parameter, StaticLaw};
use crate::syntax::Header;

pub(super) fn tokens(law: &StaticLaw) -> TokenStream {
    let structure = structure(law.header, &law.parameters, page::of_law(law));
    let (name, speed, allowed, info) = (law.header.name, law.speed, allowed(), info::of_law(law));
    let generics = generics(law.header.name, law.parameters.is_empty());
    let quantity = |name: &Ident| {
        if name == speed {
            quote!(__sliding.#name)
        } else {
            quote!(self.#name)
        }
    };
    let lift = Lift {
        scalar: quote!(D),
        quantity: &quantity,
    };
    let (stick, slip) = (lift.formula(&law.stick), lift.formula(&law.slip));
    let slopes = slopes(law, lift);
    let fields = fields(&law.parameters);
    quote! {
        #structure

        #allowed
        #[automatically_derived]
        impl<D: ::stickslip::scalar::Scalar> ::stickslip::friction::FrictionLaw<D> for #name #generics {
            const INFO: &'static ::stickslip::friction::LawInfo = &#info;

            #[inline]
            fn stick(&self) -> D {
                #stick
            }

            #[inline]
            fn slip(&self, __speed: D) -> D {
                struct __Sliding<D> { #speed: D }
                let __sliding = __Sliding { #speed: __speed };
                #slip
            }

            #[inline]
            fn slopes(&self, __along: &Self, __speed: D) -> ::stickslip::friction::LawSlopes<D> {
                struct __Sliding<D> { #speed: D }
                let __sliding = __Sliding { #speed: __speed };
                #slopes
            }

            #fields
        }
    }
}

/// Shows the values of all fields; nothing where there are none.
pub(super) fn fields(parameters: &[Parameter]) -> Option<TokenStream> {
    let lines = parameters.iter().enumerate().map(|(place, parameter)| {
        let (place, name) = (Literal::usize_unsuffixed(place), parameter.name);
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

/// The directions in which a law is differentiated: its speed, and along the given derivatives of its fields.
const SPEED: usize = 0;
const ALONG: usize = 1;

/// The body of `slopes`.
fn slopes<'a>(law: &'a StaticLaw, lift: Lift<'a>) -> TokenStream {
    let along = |name: &Ident| Slopes::from([(ALONG, Slope::of(quote!(__along.#name)))]);
    let fields = law.parameters.iter().map(|parameter| parameter.name);
    let mut known: HashMap<&Ident, Slopes> = fields.map(|name| (name, along(name))).collect();
    known.insert(law.speed, Slopes::from([(SPEED, Slope::One)]));
    let mut tangents = Tangents::new(lift, known);
    let (stick, slip) = (tangents.formula(&law.stick), tangents.formula(&law.slip));
    let stick_along = tangents.slope(&stick.slopes, ALONG);
    let [slip_by_speed, slip_along] =
        [SPEED, ALONG].map(|direction| tangents.slope(&slip.slopes, direction));
    let (stick, slip) = (tangents.value(&stick), tangents.value(&slip));
    let lines = tangents.lines;
    quote! {
        #lines
        ::stickslip::friction::LawSlopes {
            stick: #stick,
            stick_along: #stick_along,
            slip: #slip,
            slip_by_speed: #slip_by_speed,
            slip_along: #slip_along,
        }
    }
}

/// A law without parameters has nothing to be generic over.
pub(super) fn generics(law: &Ident, no_parameters: bool) -> TokenStream {
    if no_parameters {
        quote!()
    } else {
        quote_spanned!(law.span()=> <D>)
    }
}

/// The struct of a law.
pub(super) fn structure(
    header: Header,
    parameters: &[Parameter],
    page: TokenStream,
) -> TokenStream {
    let bounded = parameters.iter();
    let shell = Shell {
        header,
        page,
        fields: parameters.iter().map(Into::into).collect(),
        bounded: bounded.filter_map(|parameter| parameter.bounded).collect(),
    };
    let generics = generics(header.name, parameters.is_empty());
    let (structure, uses) = (
        shell.structure(&generics, &quote!(D)),
        shell.uses(&generics),
    );
    quote!(#structure #uses)
}
