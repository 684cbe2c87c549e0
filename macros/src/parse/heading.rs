//! What stands before the braces.

use proc_macro2::TokenTree;
use syn::parse::ParseStream;
use syn::{Ident, Token, token};

use super::docs::docs;
use super::shape::next;
use crate::syntax::Header;

/// How a declaration begins.
const FORM: &str = "write `pub struct Name { ... }`";

/// Documentation, visibility, `struct` and a name, and nothing else before the braces.
pub(super) fn heading(input: ParseStream) -> syn::Result<Header> {
    let (docs, visibility) = (docs(input)?, input.parse()?);
    if !input.peek(Token![struct]) {
        let message = match input.fork().parse::<TokenTree>() {
            Ok(word) => format!("`{word}` declares nothing here: {FORM}"),
            Err(_) => format!("nothing is declared: {FORM}"),
        };
        return Err(input.error(message));
    }
    let keyword = input.parse()?;
    if !input.peek(Ident) {
        return Err(input.error(format!("what is declared needs a name: {FORM}")));
    }
    let name: Ident = input.parse()?;
    if input.peek(token::Brace) {
        return Ok(Header {
            docs,
            visibility,
            keyword,
            name,
        });
    }
    let advice = if input.peek(Token![<]) {
        format!(
            "`{name}` takes nothing between `<` and `>`: what varies is a `param`, and an array has a number of elements"
        )
    } else if input.peek(token::Paren) {
        format!("the lines of `{name}` stand between braces")
    } else {
        let not = next(input).map_or_else(String::new, |found| format!(", not `{found}`"));
        format!("after `{name}` its lines follow between braces{not}")
    };
    Err(input.error(format!("{advice}: write `pub struct {name} {{ ... }}`")))
}
