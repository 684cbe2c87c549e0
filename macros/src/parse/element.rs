//! Names of elements: `x[10]` where an array is declared, `x[i + 1]` where one of its elements is meant.

use proc_macro2::Ident;
use quote::ToTokens;
use syn::parse::ParseStream;
use syn::{Expr, Token, bracketed, parenthesized, token};

use super::Reader;
use super::docs::name;
use super::shape::next;
use crate::arithmetic;
use crate::formula::tight;
use crate::syntax::word;

/// Most elements of an array.
const MOST: i64 = 10_000;

impl Reader<'_> {
    /// `name`, or the names of all elements of `name[length]`.
    pub(super) fn names(&mut self, input: ParseStream) -> syn::Result<Vec<Ident>> {
        let name = name(input)?;
        if !input.peek(token::Bracket) {
            return Ok(vec![name]);
        }
        let inside;
        bracketed!(inside in input);
        let length: Expr = inside.parse()?;
        let unknown = |_| {
            let written = tight(&length.to_token_stream());
            let message = format!(
                "`{name}[{written}]` has no number of elements: an array is declared as `{name}[10]`, and a unit is \
                 stated as `{name}: m`"
            );
            syn::Error::new_spanned(&length, message)
        };
        match arithmetic::index(&length).map_err(unknown)? {
            count @ 1..=MOST => {
                let elements = 0..count;
                Ok(elements
                    .map(|i| self.repeated.element(&name, i, true))
                    .collect())
            }
            other => Err(syn::Error::new_spanned(
                length,
                format!("`{name}` would have {other} elements; an array has 1 to {MOST}"),
            )),
        }
    }

    /// The name that a line declares, which may be that of an element.
    pub(super) fn declared(&mut self, input: ParseStream) -> syn::Result<Ident> {
        let name = name(input)?;
        self.element_if_indexed(name, input, true)
    }

    pub(super) fn element_if_indexed(
        &mut self,
        name: Ident,
        input: ParseStream,
        declares: bool,
    ) -> syn::Result<Ident> {
        if !input.peek(token::Bracket) {
            return Ok(name);
        }
        let inside;
        bracketed!(inside in input);
        let index = arithmetic::index(&inside.parse()?)?;
        Ok(self.repeated.element(&name, index, declares))
    }

    /// `(name)`
    pub(super) fn argument(&mut self, input: ParseStream) -> syn::Result<Ident> {
        let inside;
        if !input.peek(token::Paren) {
            let found = next(input).unwrap_or_default();
            return Err(input.error(format!("expected `(` before `{found}`")));
        }
        parenthesized!(inside in input);
        if inside.peek2(token::Paren) {
            return Err(inside.error(
                "equations are of first order: give the rate a state of its own, with `der(x) = v;` and `der(v) = ...;`",
            ));
        }
        let name = name(&inside)?;
        let name = self.element_if_indexed(name, &inside, false)?;
        match next(&inside) {
            None => Ok(name),
            Some(found) => Err(inside.error(format!(
                "`{found}` follows `{name}`, and between these parentheses stands one name"
            ))),
        }
    }

    /// `with state, ...`, or nothing.
    pub(super) fn memory_if_stated(&mut self, input: ParseStream) -> syn::Result<Vec<Ident>> {
        if input.parse::<Option<word::with>>()?.is_none() {
            return Ok(Vec::new());
        }
        let mut memory = Vec::new();
        loop {
            let name = name(input)?;
            memory.push(self.element_if_indexed(name, input, false)?);
            if input.parse::<Option<Token![,]>>()?.is_none() {
                return Ok(memory);
            }
        }
    }
}
