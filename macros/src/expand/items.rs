//! The implementation of `Model`.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::{allowed, info, linear, model, option, pattern};
use crate::check::Model;

/// States up to which derivatives are written out where they are asked for.
const SMALL: usize = 8;
/// States up to which formulas may be: beyond, each unit of code that asks would hold a copy of what is no call's cost.
const MEDIUM: usize = 24;

pub(super) fn tokens(model: &Model) -> TokenStream {
    let (name, allowed) = (&model.header.name, allowed());
    let sizes = [
        model.states.len(),
        model.parameters.len(),
        model.contacts().chain(model.presses()).count(),
        model.lets().count(),
    ];
    let sizes = sizes.map(Literal::usize_unsuffixed);
    let (types, constants) = (types(model, &sizes), constants(model, &sizes));
    let (conversions, formulas) = (conversions(model, &sizes), formulas(model, &sizes));
    let [states, ..] = sizes;
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

/// How many states, parameters, contacts and observables there are.
type Sizes = [Literal; 4];

fn types(model: &Model, [_, parameters, contacts, observables]: &Sizes) -> TokenStream {
    let order = model.states.len();
    let count = Literal::usize_unsuffixed(order + 1);
    let lanes = match order <= MEDIUM {
        true => quote!(::stickslip::DualSVec64<#count>),
        false => quote!(::stickslip::scalar::Wide<#count>),
    };
    quote! {
        type Params<D: ::stickslip::scalar::Scalar> = [D; #parameters];
        type PerContact<T: ::core::marker::Copy + ::core::marker::Send + ::core::marker::Sync> =
            [T; #contacts];
        type Observables = [f64; #observables];
        type Lanes = #lanes;
    }
}

fn constants(model: &Model, [states, ..]: &Sizes) -> TokenStream {
    let info = info::of_model(model);
    let kinematic = pattern::kinematic(model).into_iter().map(|row| {
        let row = row.map(Literal::usize_unsuffixed);
        option(row.map(|state| quote!(#state)))
    });
    let sparsity = pattern::sparsity(model).into_iter().map(|row| {
        let columns = row.into_iter().map(Literal::usize_unsuffixed);
        quote!(&[#(#columns),*])
    });
    quote! {
        const INFO: &'static ::stickslip::model::ModelInfo = &#info;
        const KINEMATIC: [::core::option::Option<usize>; #states] = [#(#kinematic),*];
        const SPARSITY: [[bool; #states]; #states] =
            ::stickslip::declared::pattern([#(#sparsity),*]);
    }
}

fn conversions(model: &Model, [_, parameters, ..]: &Sizes) -> TokenStream {
    let names = || {
        model
            .parameters
            .iter()
            .map(|parameter| &parameter.line.name)
    };
    let (values, fields) = (names(), names());
    let places = (0..model.parameters.len()).map(Literal::usize_unsuffixed);
    quote! {
        #[inline]
        fn values(&self) -> [f64; #parameters] {
            [#(self.#values),*]
        }

        #[inline]
        fn from_values(__values: [f64; #parameters]) -> Self {
            Self { #(#fields: __values[#places]),* }
        }
    }
}

fn formulas(model: &Model, [states, parameters, _, count]: &Sizes) -> TokenStream {
    let order = model.states.len();
    let offered = (order <= MEDIUM).then(|| quote!(#[inline]));
    // A call costs a small model three times its formulas.
    let inlined = match order <= SMALL {
        true => Some(quote!(#[inline(always)])),
        false => offered.clone(),
    };
    let (rhs, entries) = (model::rhs(model), linear::body(model));
    let observables = model::observables(model);
    quote! {
        #offered
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
