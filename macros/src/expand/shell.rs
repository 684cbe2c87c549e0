//! The struct of the parameters, its defaults and the handles.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{quote, quote_spanned};

use super::{allowed, info};
use crate::check::{Parameter, describe};
use crate::syntax::{Header, Value};

pub(super) struct Shell<'a> {
    pub(super) header: &'a Header,
    /// Documentation that follows the header's own.
    pub(super) page: TokenStream,
    pub(super) parameters: &'a [Parameter<'a>],
}

/// A law without parameters has nothing to be generic over.
pub(super) fn generics(law: &Ident, no_parameters: bool) -> TokenStream {
    if no_parameters {
        quote!()
    } else {
        quote_spanned!(law.span()=> <D>)
    }
}

impl Shell<'_> {
    pub(super) fn tokens(&self) -> TokenStream {
        let structure = self.structure(&quote!(), &quote!(f64));
        let (default, handles) = (self.default(), self.handles());
        let uses = self.uses(&quote!());
        quote!(#structure #default #handles #uses)
    }

    /// The plain struct.
    pub(super) fn structure(&self, generics: &TokenStream, scalar: &TokenStream) -> TokenStream {
        let Header {
            docs,
            visibility,
            keyword,
            name,
        } = self.header;
        let (names, page) = (self.names(), &self.page);
        let field_docs = self.parameters.iter().map(documented);
        quote! {
            #(#docs)*
            #page
            #[derive(
                ::core::clone::Clone,
                ::core::marker::Copy,
                ::core::fmt::Debug,
                ::core::cmp::PartialEq,
            )]
            #[allow(non_snake_case)]
            #visibility #keyword #name #generics {
                #(#field_docs #visibility #names: #scalar,)*
            }
        }
    }

    fn names(&self) -> impl Iterator<Item = &Ident> {
        self.parameters.iter().map(|parameter| &parameter.line.name)
    }

    /// A function that uses every field as its bounds name it: an editor should find them there.
    pub(super) fn uses(&self, generics: &TokenStream) -> TokenStream {
        let lines = self.parameters.iter().map(|parameter| parameter.line);
        let fields = lines.filter_map(|line| Some(&line.bounds.as_ref()?.name));
        let fields: Vec<&Ident> = fields.collect();
        if fields.is_empty() {
            return quote!();
        }
        let (name, allowed) = (&self.header.name, allowed());
        quote! {
            #allowed
            impl #generics #name #generics {
                fn __bounded(&self) {
                    #(let _ = &self.#fields;)*
                }
            }
        }
    }

    fn default(&self) -> TokenStream {
        let (name, allowed) = (&self.header.name, allowed());
        let names = self.names();
        let numbers = self
            .parameters
            .iter()
            .map(|parameter| &parameter.line.number);
        let values = numbers.map(|number| info::number(number.as_ref().map_or(0.0, |n| n.value)));
        quote! {
            #allowed
            #[automatically_derived]
            impl ::core::default::Default for #name {
                fn default() -> Self {
                    Self { #(#names: #values),* }
                }
            }
        }
    }

    fn handles(&self) -> TokenStream {
        let (name, allowed) = (&self.header.name, allowed());
        let visibility = &self.header.visibility;
        let names = self.names();
        let docs = self.parameters.iter().map(documented);
        let places = (0..self.parameters.len()).map(Literal::usize_unsuffixed);
        quote! {
            #allowed
            impl #name {
                #(
                    #docs
                    #visibility const #names: ::stickslip::model::ParamId<Self> =
                        ::stickslip::model::ParamId::new(#places);
                )*
            }
        }
    }
}

/// The docs as written, then unit, default and bounds.
fn documented(parameter: &Parameter) -> TokenStream {
    let Value {
        docs,
        number,
        bounds,
        ..
    } = parameter.line;
    let unit = parameter.unit.as_ref();
    let unit = unit.map(|unit| format!("In `{}`", unit.text));
    let default = number.as_ref();
    let default = default.map(|number| format!("{} by default", number.value));
    let bounds = bounds.as_ref();
    let bounds = bounds.map(|bounds| format!("`{}`", describe(bounds)));
    let facts: Vec<String> = unit.into_iter().chain(default).chain(bounds).collect();
    let facts = format!(" {}.", facts.join(", "));
    match (docs.is_empty(), facts.len() > 2) {
        (true, true) => {
            let all = format!(" Parameter{facts}");
            quote!(#[doc = #all])
        }
        (true, false) => quote!(#[doc = " Parameter."]),
        (false, true) => quote!(#(#docs)* #[doc = ""] #[doc = #facts]),
        (false, false) => quote!(#(#docs)*),
    }
}
