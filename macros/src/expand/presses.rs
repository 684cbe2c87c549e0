//! The functions of a law of contacts that press.

use proc_macro2::TokenStream;
use quote::quote;

use super::law::{SPEED, along, opening, tangents};
use super::lift::Lift;
use crate::check::{Law, Whole};

/// The direction of the rate at which the depth grows; that of the depth is the first.
const RATE: usize = SPEED + 1;

pub(super) fn items<'l>(law: &'l Law<'_>, force: &Whole, lift: Lift<'l>) -> TokenStream {
    let opening = opening(law);
    let formula = lift.formula(&force.formula);
    let mut tangents = tangents(law, lift);
    let quantity = tangents.formula(&force.formula);
    let [by_depth, by_rate, by_fields] =
        [SPEED, RATE, along(law)].map(|direction| tangents.slope(&quantity.slopes, direction));
    let value = tangents.value(&quantity);
    let lines = tangents.lines();
    quote! {
        #[inline]
        fn force(&self, __speed: D, __rate: D) -> D {
            #opening
            #formula
        }

        #[inline]
        fn slopes(&self, __along: &Self, __speed: D, __rate: D) -> ::stickslip::press::PressSlopes<D> {
            #opening
            #lines
            ::stickslip::press::PressSlopes {
                force: #value,
                by_depth: #by_depth,
                by_rate: #by_rate,
                along: #by_fields,
            }
        }
    }
}

/// A law that does not give way: it has no force of its own.
pub(super) fn rigid<'l>(law: &'l Law<'_>, rebound: &Whole, lift: Lift<'l>) -> TokenStream {
    let (opening, formula) = (opening(law), lift.formula(&rebound.formula));
    let mut tangents = tangents(law, lift);
    let quantity = tangents.formula(&rebound.formula);
    let by_fields = tangents.slope(&quantity.slopes, along(law));
    let value = tangents.value(&quantity);
    let lines = tangents.lines();
    quote! {
        #[inline]
        fn force(&self, _: D, _: D) -> D {
            D::from(0.0)
        }

        #[inline]
        fn slopes(&self, _: &Self, _: D, _: D) -> ::stickslip::press::PressSlopes<D> {
            let nothing = D::from(0.0);
            ::stickslip::press::PressSlopes {
                force: nothing,
                by_depth: nothing,
                by_rate: nothing,
                along: nothing,
            }
        }

        #[inline]
        fn rebound(&self, __speed: D) -> D {
            #opening
            #formula
        }

        #[inline]
        fn rebound_along(&self, __along: &Self, __speed: D) -> [D; 2] {
            #opening
            #lines
            [#value, #by_fields]
        }
    }
}
