//! The implementation of `Model`: the same items for a good model and for a stub.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::allowed;

/// States up to which derivatives are written out where they are asked for.
const SMALL: usize = 8;

/// How many states, parameters, contacts and observables there are.
#[derive(Clone, Copy)]
pub(super) struct Sizes {
    pub(super) states: usize,
    pub(super) parameters: usize,
    pub(super) contacts: usize,
    pub(super) observables: usize,
}

/// The values of the constants and the bodies of the functions.
pub(super) struct Items<'a> {
    pub(super) name: &'a Ident,
    pub(super) sizes: Sizes,
    pub(super) info: TokenStream,
    pub(super) kinematic: TokenStream,
    pub(super) sparsity: TokenStream,
    pub(super) values: TokenStream,
    pub(super) from_values: TokenStream,
    pub(super) rhs: TokenStream,
    pub(super) entries: TokenStream,
    pub(super) observables: TokenStream,
}

impl Items<'_> {
    pub(super) fn tokens(&self) -> TokenStream {
        let (name, allowed) = (self.name, allowed());
        let states = Literal::usize_unsuffixed(self.sizes.states);
        let (types, constants) = (self.types(), self.constants());
        let (conversions, formulas) = (self.conversions(), self.formulas());
        quote! {
            #allowed
            #[automatically_derived]
            impl ::stickslip::model::Model<#states> for #name {
                #types
                #constants
                #conversions
                #formulas
            }
        }
    }

    fn types(&self) -> TokenStream {
        let sizes = self.sizes;
        let [parameters, contacts, observables, lanes] = [
            sizes.parameters,
            sizes.contacts,
            sizes.observables,
            sizes.states + 1,
        ]
        .map(Literal::usize_unsuffixed);
        quote! {
            type Params<D: ::stickslip::scalar::Scalar> = [D; #parameters];
            type PerContact<T: ::core::marker::Copy + ::core::marker::Send + ::core::marker::Sync> =
                [T; #contacts];
            type Observables = [f64; #observables];
            type Lanes = ::stickslip::DualSVec64<#lanes>;
        }
    }

    fn constants(&self) -> TokenStream {
        let states = Literal::usize_unsuffixed(self.sizes.states);
        let Self {
            info,
            kinematic,
            sparsity,
            ..
        } = self;
        quote! {
            const INFO: &'static ::stickslip::model::ModelInfo = &#info;
            const KINEMATIC: [::core::option::Option<usize>; #states] = #kinematic;
            const SPARSITY: [[bool; #states]; #states] = #sparsity;
        }
    }

    fn conversions(&self) -> TokenStream {
        let parameters = Literal::usize_unsuffixed(self.sizes.parameters);
        let Self {
            values,
            from_values,
            ..
        } = self;
        quote! {
            #[inline]
            fn values(&self) -> [f64; #parameters] {
                #values
            }

            #[inline]
            fn from_values(__values: [f64; #parameters]) -> Self {
                #from_values
            }
        }
    }

    fn formulas(&self) -> TokenStream {
        let sizes = self.sizes;
        let [states, parameters, count] =
            [sizes.states, sizes.parameters, sizes.observables].map(Literal::usize_unsuffixed);
        // A call costs a small model three times its formulas.
        let inlined = if sizes.states <= SMALL {
            quote!(#[inline(always)])
        } else {
            quote!(#[inline])
        };
        let Self {
            rhs,
            entries,
            observables,
            ..
        } = self;
        quote! {
            #[inline]
            fn rhs<D: ::stickslip::scalar::Scalar>(
                __params: &[D; #parameters],
                __state: [D; #states],
                __contacts: &mut impl ::stickslip::friction::ContactRule<D>,
            ) -> [D; #states] {
                #rhs
            }

            #inlined
            fn entries(
                __params: &[f64; #parameters],
                __seeds: &[f64; #parameters],
                __state: [f64; #states],
                __contacts: &mut impl ::stickslip::friction::SlopeRule,
                mut __entry: impl ::core::ops::FnMut(usize, usize, f64),
            ) -> ::stickslip::model::Rates<#states> {
                #entries
            }

            #[inline]
            fn observables(
                __params: &[f64; #parameters],
                __state: [f64; #states],
                __contacts: &mut impl ::stickslip::friction::ContactRule<f64>,
            ) -> [f64; #count] {
                #observables
            }
        }
    }
}
