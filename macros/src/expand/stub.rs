//! What stands beside errors, so that one mistake is one message: the same items, without their bodies.

use std::collections::HashSet;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, quote};

use super::law::generics;
use super::shell::{Field, Shell};
use super::{allowed, builder, info};
use crate::check::is_field;
use crate::syntax::{Declaration, Line};

/// A model that cannot be asked anything.
pub(super) fn model(written: &Declaration) -> TokenStream {
    let (shell, name, allowed) = (shell(written).tokens(), &written.name, allowed());
    let count = |keyword: &str| Literal::usize_unsuffixed(declared(written, keyword).len());
    let states = count("state");
    let (parameters, contacts, observables) = (count("param"), count("friction"), count("let"));
    let lanes = Literal::usize_unsuffixed(declared(written, "state").len() + 1);
    let (text, command) = (name.to_string(), info::command(name));
    let laws = builder::builders(name, written.frictions().map(Into::into));
    quote! {
        #shell
        #laws

        #allowed
        #[automatically_derived]
        impl ::stickslip::model::Model<#states> for #name {
            type Params<D: ::stickslip::scalar::Scalar> = [D; #parameters];
            type PerContact<T: ::core::marker::Copy + ::core::marker::Send + ::core::marker::Sync> =
                [T; #contacts];
            type Observables = [f64; #observables];
            type Lanes = ::stickslip::DualSVec64<#lanes>;

            const INFO: &'static ::stickslip::model::ModelInfo = &::stickslip::model::ModelInfo {
                name: #text,
                command: #command,
                doc: "",
                states: &[],
                parameters: &[],
                observables: &[],
                contacts: &[],
            };
            const KINEMATIC: [::core::option::Option<usize>; #states] =
                [::core::option::Option::None; #states];
            const SPARSITY: [[bool; #states]; #states] = [[false; #states]; #states];

            fn values(&self) -> [f64; #parameters] {
                ::core::unreachable!()
            }

            fn from_values(_: [f64; #parameters]) -> Self {
                ::core::unreachable!()
            }

            fn rhs<D: ::stickslip::scalar::Scalar>(
                _: &[D; #parameters],
                _: [D; #states],
                _: &mut impl ::stickslip::friction::ContactRule<D>,
            ) -> [D; #states] {
                ::core::unreachable!()
            }

            fn observables(
                _: &[f64; #parameters],
                _: [f64; #states],
                _: &mut impl ::stickslip::friction::ContactRule<f64>,
            ) -> [f64; #observables] {
                ::core::unreachable!()
            }
        }
    }
}

/// A law that cannot be asked anything.
pub(super) fn law(written: &Declaration) -> TokenStream {
    let (shell, name, allowed) = (shell(written), &written.name, allowed());
    let generics = generics(name, shell.fields.is_empty());
    let structure = shell.structure(&generics, &quote!(D));
    let text = name.to_string();
    quote! {
        #structure

        #allowed
        #[automatically_derived]
        impl<D: ::stickslip::scalar::Scalar> ::stickslip::friction::FrictionLaw<D> for #name #generics {
            const INFO: &'static ::stickslip::friction::LawInfo = &::stickslip::friction::LawInfo {
                name: #text,
                doc: "",
                parameters: &[],
                stick: "",
                slip: "",
            };

            fn stick(&self) -> D {
                ::core::unreachable!()
            }

            fn slip(&self, _: D) -> D {
                ::core::unreachable!()
            }
        }
    }
}

fn shell(written: &Declaration) -> Shell<'_> {
    let field = |name| Field {
        name,
        docs: quote!(#[doc = ""]),
        default: 0.0,
    };
    Shell {
        header: written.header(),
        fields: declared(written, "param").into_iter().map(field).collect(),
        bounded: Vec::new(),
    }
}

/// The names that lines of this kind declare, broken or not, each once.
fn declared<'a>(written: &'a Declaration, keyword: &str) -> Vec<&'a Ident> {
    let mut seen = HashSet::new();
    let names = written.lines.iter().filter_map(|line| match line {
        Line::State(line) => Some(&line.name).filter(|_| keyword == "state"),
        Line::Param(line) => Some(&line.name).filter(|_| keyword == "param"),
        Line::Let(line) => Some(&line.name).filter(|_| keyword == "let"),
        Line::Friction(line) => Some(&line.name).filter(|_| keyword == "friction"),
        Line::Broken(line) => line.name.as_ref().filter(|_| line.keyword == Some(keyword)),
        Line::Derivative(_) | Line::Stick(_) | Line::Slip(_) => None,
    });
    names
        .filter(|name| is_field(name) && seen.insert(name.to_token_stream().to_string()))
        .collect()
}
