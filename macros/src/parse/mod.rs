//! From tokens to a declaration as written.

mod docs;
mod element;
mod line;
mod measure;
mod repeat;
mod shape;
mod value;

use proc_macro2::{Punct, Spacing, Span, TokenStream, TokenTree};
use syn::parse::{ParseStream, Parser};
use syn::{Token, braced};

use self::line::Reader;
use crate::errors::Errors;
use crate::repeated::Repeated;
use crate::syntax::{Broken, Declaration, Line};

/// Which grammar a declaration follows, and its formulas.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Grammar {
    Model,
    Law,
    /// Lines of a law in which the internal state and its kinks may stand.
    Memory,
}

/// Reads a declaration; without a struct and its name there is none.
pub(crate) fn declaration(
    tokens: TokenStream,
    grammar: Grammar,
    errors: &mut Errors,
) -> Option<Declaration> {
    match header.parse2(tokens) {
        Ok((mut declaration, body)) => {
            let mut repeated = Repeated::default();
            let place = Place::outside(grammar);
            declaration.lines = lines(body, place, &mut repeated, errors);
            errors.show(&repeated.elements);
            declaration.repeated = repeated;
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
        docs: docs::docs(input)?,
        visibility: input.parse()?,
        keyword: input.parse()?,
        name: input.parse()?,
        lines: Vec::new(),
        repeated: Repeated::default(),
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
fn lines(
    body: TokenStream,
    place: Place,
    repeated: &mut Repeated,
    errors: &mut Errors,
) -> Vec<Line> {
    let mut lines = Vec::new();
    let mut line = TokenStream::new();
    let mut begins = false;
    for token in body {
        let ends = matches!(&token, TokenTree::Punct(mark) if mark.as_char() == ';');
        if line.is_empty() {
            begins = place.grammar == Grammar::Model && repeat::begins(&token);
        }
        let loops = begins && repeat::ends(&token);
        line.extend([token]);
        if loops {
            let all = repeat::lines(std::mem::take(&mut line), place, repeated, errors);
            lines.extend(all);
        } else if ends {
            let line = std::mem::take(&mut line);
            read(line, place, repeated, errors, &mut lines);
        }
    }
    if !line.is_empty() {
        unfinished(line, place, repeated, errors, &mut lines);
    }
    lines
}

/// Where a line stands.
#[derive(Clone, Copy)]
struct Place {
    grammar: Grammar,
    /// In so many `for`.
    depth: usize,
    /// Read so many times.
    turns: i64,
}

impl Place {
    fn outside(grammar: Grammar) -> Self {
        Self {
            grammar,
            depth: 0,
            turns: 1,
        }
    }

    /// What is left of a line; inside `for` it is not known which elements it declares.
    fn broken(self, tokens: &TokenStream) -> Broken {
        let broken = shape::broken(tokens, self.grammar);
        let name = broken.name.filter(|_| self.depth == 0);
        Broken { name, ..broken }
    }
}

/// The last line has no semicolon: that is worth a word only if nothing else is wrong with it.
fn unfinished(
    line: TokenStream,
    place: Place,
    repeated: &mut Repeated,
    errors: &mut Errors,
    lines: &mut Vec<Line>,
) {
    let last = line.clone().into_iter().last();
    let mut ended = line;
    let mut semicolon = Punct::new(';', Spacing::Alone);
    semicolon.set_span(last.as_ref().map_or_else(Span::call_site, TokenTree::span));
    ended.extend([TokenTree::from(semicolon)]);
    read(ended, place, repeated, errors, lines);
    if !matches!(lines.last(), Some(Line::Broken(_))) {
        errors.at(last, "missing `;` at the end of this line");
    }
}

fn read(
    tokens: TokenStream,
    place: Place,
    repeated: &mut Repeated,
    errors: &mut Errors,
    lines: &mut Vec<Line>,
) {
    if let Some(unreadable) = measure::unreadable(&tokens) {
        errors.at(&tokens, unreadable);
        lines.push(Line::Broken(place.broken(&tokens)));
        return;
    }
    let whole = tokens.clone();
    let reader = |input: ParseStream| {
        let line = Reader {
            grammar: place.grammar,
            inside: place.depth > 0,
            repeated,
            errors,
        }
        .line(input)?;
        input.parse::<Option<Token![;]>>()?;
        Ok((line, input.parse::<TokenStream>()?))
    };
    match reader.parse2(tokens) {
        Ok((line, rest)) => {
            lines.extend(line);
            if let Some(keyword) = shape::keyword_of(&rest) {
                errors.at(
                    &keyword,
                    format!("missing `;` at the end of the line before `{keyword}`"),
                );
                read(rest, place, repeated, errors, lines);
            }
        }
        Err(error) => {
            errors.add(error);
            lines.push(Line::Broken(place.broken(&whole)));
        }
    }
}
