//! What is emitted even beside errors: the struct of the parameters, its defaults and the handles.

use super::{allowed, info};
use crate::check::Parameter;
use crate::syntax::Header;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

pub(super) struct Shell<'a> {
    pub(super) header: Header<'a>,
    /// Documentation that follows the header's own.
    pub(super) page: TokenStream,
    pub(super) fields: Vec<Field<'a>>,
    /// The fields as named in bounds: used nowhere, but an editor should find them.
    pub(super) bounded: Vec<&'a Ident>,
}

/// A parameter: its name, its docs with unit, default and bounds, and its default.
pub(super) struct Field<'a> {
    pub(super) name: &'a Ident,
    pub(super) docs: TokenStream,
    pub(super) default: f64,
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
        let (fields, page) = (&self.fields, &self.page);
        let names = fields.iter().map(|field| field.name);
        let field_docs = fields.iter().map(|field| &field.docs);
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

    /// A function that uses every field that has bounds.
    pub(super) fn uses(&self, generics: &TokenStream) -> TokenStream {
        if self.bounded.is_empty() {
            return quote!();
        }
        let (name, fields, allowed) = (self.header.name, &self.bounded, allowed());
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
        let (name, allowed) = (self.header.name, allowed());
        let names = self.fields.iter().map(|field| field.name);
        let values = self.fields.iter().map(|field| info::number(field.default));
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
        let (name, allowed) = (self.header.name, allowed());
        let visibility = self.header.visibility;
        let names = self.fields.iter().map(|field| field.name);
        let docs = self.fields.iter().map(|field| &field.docs);
        let places = (0..self.fields.len()).map(Literal::usize_unsuffixed);
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

impl<'a> From<&Parameter<'a>> for Field<'a> {
    fn from(parameter: &Parameter<'a>) -> Self {
        Self {
            name: parameter.name,
            docs: documented(parameter),
            default: parameter.default.unwrap_or_default(),
        }
    }
}

/// The docs as written, then unit, default and bounds.
fn documented(parameter: &Parameter) -> TokenStream {
    let mut facts = Vec::new();
    facts.extend(
        parameter
            .unit
            .as_ref()
            .map(|unit| format!("In `{}`", unit.text)),
    );
    facts.extend(
        parameter
            .default
            .map(|default| format!("{default} by default")),
    );
    facts.extend(
        Some(&parameter.bounds.text)
            .filter(|text| !text.is_empty())
            .map(|text| format!("`{text}`")),
    );
    let facts = format!(" {}.", facts.join(", "));
    let docs = parameter.docs;
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
