//! From tokens to a declaration as written.

mod contact;
mod docs;
mod element;
mod foreign;
mod heading;
mod line;
mod measure;
mod repeat;
mod shape;
mod structure;
mod value;

use proc_macro2::{Punct, Spacing, Span, TokenStream, TokenTree};
use syn::parse::{ParseStream, Parser};
use syn::{Token, braced};

use crate::errors::Errors;
use crate::repeated::Repeated;
use crate::structure::Structures;
use crate::syntax::{Broken, Declaration, Line};

/// Which grammar a declaration follows, and its formulas.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Grammar {
    Model,
    Law,
    /// Lines of a law in which the internal state and its kinks may stand.
    Memory,
    /// A law of a contact that presses.
    Press,
}

/// Reads a declaration; without a struct and its name there is none.
pub(crate) fn declaration(
    tokens: TokenStream,
    grammar: Grammar,
    errors: &mut Errors,
) -> Option<Declaration> {
    match header.parse2(tokens) {
        Ok((mut declaration, body)) => {
            let mut reader = Reader {
                place: Place::outside(grammar),
                repeated: &mut declaration.repeated,
                structures: &mut declaration.structures,
                errors,
            };
            declaration.lines = reader.lines(body);
            declaration.lines.extend(reader.equations_of_structures());
            errors.show(&declaration.repeated.elements);
            errors.show_points(declaration.structures.measured());
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
        header: heading::heading(input)?,
        lines: Vec::new(),
        repeated: Repeated::default(),
        structures: Structures::default(),
    };
    let body;
    braced!(body in input);
    let body = body.parse()?;
    if !input.is_empty() {
        let more = shape::next(input).unwrap_or_default();
        return Err(input.error(format!(
            "`{more}` follows the closing brace: one declaration each, and nothing after it; remove it"
        )));
    }
    Ok((declaration, body))
}

/// Reads lines; what is wrong with one is collected, and it is broken.
struct Reader<'a> {
    place: Place,
    repeated: &'a mut Repeated,
    structures: &'a mut Structures,
    errors: &'a mut Errors,
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

impl Reader<'_> {
    /// Cuts the body at its semicolons first, so that a broken line cannot hide the others.
    fn lines(&mut self, body: TokenStream) -> Vec<Line> {
        let mut lines = Vec::new();
        let mut line = TokenStream::new();
        let (mut begins, mut blocks) = (false, false);
        for token in body {
            let ends = matches!(&token, TokenTree::Punct(mark) if mark.as_char() == ';');
            if line.is_empty() {
                begins = self.place.grammar == Grammar::Model && repeat::begins(&token);
                blocks = foreign::begins_block(&token);
            }
            let loops = begins && repeat::ends(&token);
            let ends = ends || blocks && repeat::ends(&token);
            line.extend([token]);
            if loops {
                lines.extend(self.repeat(std::mem::take(&mut line)));
            } else if ends {
                self.read(std::mem::take(&mut line), &mut lines);
            }
        }
        if !line.is_empty() {
            self.unfinished(line, &mut lines);
        }
        lines
    }

    /// The last line has no semicolon: that is worth a word only if nothing else is wrong with it.
    fn unfinished(&mut self, mut line: TokenStream, lines: &mut Vec<Line>) {
        let last = line.clone().into_iter().last();
        let mut semicolon = Punct::new(';', Spacing::Alone);
        semicolon.set_span(last.as_ref().map_or_else(Span::call_site, TokenTree::span));
        line.extend([TokenTree::from(semicolon)]);
        let before = self.errors.len();
        self.read(line, lines);
        if self.errors.len() == before {
            self.errors.at(last, "missing `;` at the end of this line");
        }
    }

    /// Marks that stand where a line should begin.
    fn stray(&mut self, input: ParseStream) -> syn::Result<()> {
        while input.peek(Token![,]) || input.peek(Token![;]) {
            let mark: TokenTree = input.parse()?;
            let message = format!(
                "`{mark}` stands alone: each line ends with one `;`, and nothing parts it from the next; remove it"
            );
            self.errors.at(mark, message);
        }
        Ok(())
    }

    fn read(&mut self, tokens: TokenStream, lines: &mut Vec<Line>) {
        if let Some(unreadable) = measure::unreadable(&tokens) {
            self.errors.at(&tokens, unreadable);
            lines.push(Line::Broken(self.place.broken(&tokens)));
            return;
        }
        let whole = tokens.clone();
        let reader = |input: ParseStream| {
            self.stray(input)?;
            if input.is_empty() {
                return Ok(Default::default());
            }
            let line = self.line(input)?;
            let comma = input.parse::<Option<Token![,]>>()?;
            input.parse::<Option<Token![;]>>()?;
            Ok((line, comma, input.parse::<TokenStream>()?))
        };
        match reader.parse2(tokens) {
            Ok((line, comma, rest)) => {
                lines.extend(line);
                if let Some(comma) = comma {
                    self.errors
                        .at(comma, "`,` ends no line: write `;` in its place");
                    if !rest.is_empty() {
                        self.read(rest, lines);
                    }
                } else if let Some(keyword) = shape::keyword_of(&rest) {
                    let missing = format!("missing `;` at the end of the line before `{keyword}`");
                    self.errors.at(&keyword, missing);
                    self.read(rest, lines);
                }
            }
            Err(error) => {
                self.errors.add(error);
                lines.push(Line::Broken(self.place.broken(&whole)));
                if let Some(next) = shape::after_comma(whole) {
                    self.read(next, lines);
                }
            }
        }
    }
}
