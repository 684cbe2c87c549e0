//! From tokens to a declaration as written.

mod line;
mod shape;
mod value;

use proc_macro2::{Punct, Spacing, Span, TokenStream, TokenTree};
use syn::parse::{ParseStream, Parser};
use syn::{Token, braced};

use self::line::Reader;
use crate::errors::Errors;
use crate::syntax::{Declaration, Line};

/// Which of the two grammars a declaration follows.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Grammar {
    Model,
    Law,
}

/// Reads a declaration; without a struct and its name there is none.
pub(crate) fn declaration(
    tokens: TokenStream,
    grammar: Grammar,
    errors: &mut Errors,
) -> Option<Declaration> {
    match header.parse2(tokens) {
        Ok((mut declaration, body)) => {
            declaration.lines = lines(body, grammar, errors);
            Some(declaration)
        }
        Err(error) => {
            errors.add(error);
            None
        }
    }
}

fn header(input: ParseStream) -> syn::Result<(Declaration, TokenStream)> {
    let declaration = Declaration {
        docs: line::docs(input)?,
        visibility: input.parse()?,
        keyword: input.parse()?,
        name: input.parse()?,
        lines: Vec::new(),
    };
    let body;
    braced!(body in input);
    let body = body.parse()?;
    if !input.is_empty() {
        return Err(input.error("one declaration each: nothing may follow the closing brace"));
    }
    Ok((declaration, body))
}

/// Cuts the body at its semicolons first, so that a broken line cannot hide the others.
fn lines(body: TokenStream, grammar: Grammar, errors: &mut Errors) -> Vec<Line> {
    let mut lines = Vec::new();
    let mut line = TokenStream::new();
    for token in body {
        let ends = matches!(&token, TokenTree::Punct(mark) if mark.as_char() == ';');
        line.extend([token]);
        if ends {
            read(std::mem::take(&mut line), grammar, errors, &mut lines);
        }
    }
    if !line.is_empty() {
        unfinished(line, grammar, errors, &mut lines);
    }
    lines
}

/// The last line has no semicolon: that is worth a word only if nothing else is wrong with it.
fn unfinished(line: TokenStream, grammar: Grammar, errors: &mut Errors, lines: &mut Vec<Line>) {
    let last = line.clone().into_iter().last();
    let mut ended = line;
    let mut semicolon = Punct::new(';', Spacing::Alone);
    semicolon.set_span(last.as_ref().map_or_else(Span::call_site, TokenTree::span));
    ended.extend([TokenTree::from(semicolon)]);
    read(ended, grammar, errors, lines);
    if !matches!(lines.last(), Some(Line::Broken(_))) {
        errors.at(last, "missing `;` at the end of this line");
    }
}

fn read(tokens: TokenStream, grammar: Grammar, errors: &mut Errors, lines: &mut Vec<Line>) {
    let whole = tokens.clone();
    let reader = |input: ParseStream| {
        let line = Reader { grammar, errors }.line(input)?;
        input.parse::<Option<Token![;]>>()?;
        Ok((line, input.parse::<TokenStream>()?))
    };
    match reader.parse2(tokens) {
        Ok((line, rest)) => {
            lines.push(line);
            if let Some(keyword) = shape::keyword_of(&rest) {
                errors.at(
                    &keyword,
                    format!("missing `;` at the end of the line before `{keyword}`"),
                );
                read(rest, grammar, errors, lines);
            }
        }
        Err(error) => {
            errors.add(error);
            lines.push(Line::Broken(shape::broken(&whole, grammar)));
        }
    }
}
