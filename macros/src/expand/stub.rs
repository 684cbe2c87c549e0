//! What stands beside errors, so that one mistake is one message: the same items, without their bodies.

use std::collections::HashSet;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, quote};

use super::items::{Items, Sizes};
use super::law::generics;
use super::shell::{Field, Shell};
use super::{allowed, builder, info};
use crate::check::is_field;
use crate::syntax::{Declaration, Line};

/// A model that cannot be asked anything.
pub(super) fn model(written: &Declaration) -> TokenStream {
    let (shell, name) = (shell(written).tokens(), &written.name);
    let laws = builder::builders(name, written.frictions().map(Into::into));
    let count = |keyword| declared(written, keyword).len();
    let states = count("state") + count("drive");
    let unreachable = || quote!(::core::unreachable!());
    let items = Items {
        name,
        sizes: Sizes {
            states,
            parameters: count("param"),
            contacts: count("friction")
                - written
                    .frictions()
                    .filter(|line| !line.memory.is_empty())
                    .count(),
            observables: count("let"),
        },
        info: info(name),
        kinematic: quote!([::core::option::Option::None; #states]),
        sparsity: quote!([[false; #states]; #states]),
        values: unreachable(),
        from_values: unreachable(),
        rhs: unreachable(),
        entries: unreachable(),
        observables: unreachable(),
    };
    let items = items.tokens();
    quote!(#shell #laws #items)
}

fn info(name: &Ident) -> TokenStream {
    let (text, command) = (name.to_string(), info::command(name));
    quote! {
        ::stickslip::model::ModelInfo {
            name: #text,
            command: #command,
            doc: "",
            states: &[],
            parameters: &[],
            observables: &[],
            drive: ::core::option::Option::None,
            contacts: &[],
            memories: &[],
            moving: false,
        }
    }
}

/// A law that cannot be asked anything.
pub(super) fn law(written: &Declaration) -> TokenStream {
    let (shell, name, allowed) = (shell(written), &written.name, allowed());
    let generics = generics(name, shell.fields.is_empty());
    let structure = shell.structure(&generics, &quote!(D));
    let text = name.to_string();
    if written.has_memory() {
        let states = Literal::usize_unsuffixed(declared(written, "state").len());
        return quote! {
            #structure

            #allowed
            #[automatically_derived]
            impl<D: ::stickslip::scalar::Scalar> ::stickslip::memory::MemoryLaw<D, #states> for #name #generics {
                const INFO: &'static ::stickslip::memory::MemoryLawInfo = &::stickslip::memory::MemoryLawInfo {
                    name: #text,
                    doc: "",
                    parameters: &[],
                    states: &[],
                    abbreviations: &[],
                    speed: "",
                    force: "",
                };

                fn answer(&self, _: [D; #states], _: D) -> ::stickslip::memory::Answer<D, #states> {
                    ::core::unreachable!()
                }

                fn slopes(&self, _: &Self, _: [D; #states], _: D) -> ::stickslip::memory::AnswerSlopes<D, #states> {
                    ::core::unreachable!()
                }

                fn kinks(&self, _: [D; #states], _: D, _: impl ::core::ops::FnMut(D)) {
                    ::core::unreachable!()
                }
            }
        };
    }
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

            fn slopes(&self, _: &Self, _: D) -> ::stickslip::friction::LawSlopes<D> {
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
        page: TokenStream::new(),
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
        Line::Drive(line) => Some(&line.name).filter(|_| keyword == "drive"),
        Line::Friction(line) => Some(&line.name).filter(|_| keyword == "friction"),
        Line::Broken(line) => line.name.as_ref().filter(|_| line.keyword == Some(keyword)),
        Line::Derivative(_) | Line::Stick(_) | Line::Slip(_) | Line::Force(_) | Line::Stop(_) => {
            None
        }
    });
    names
        .filter(|name| is_field(name) && seen.insert(name.to_token_stream().to_string()))
        .collect()
}
