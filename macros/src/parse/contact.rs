//! Lines of contacts: `friction F = Law { .. } opposing v;` and `press N = Law { .. } closing gap;`.

use proc_macro2::Ident;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Attribute, Path, Token, braced, token};

use super::shape::next;
use super::{Reader, value};
use crate::formula::{Formula, last_word};
use crate::syntax::{Broken, Field, Friction, Line, word};

impl Reader<'_> {
    /// A line of a contact, or what is left of it if something is wrong inside: enough is said of that then.
    pub(super) fn whole(
        &mut self,
        keyword: &'static str,
        line: fn(Friction) -> Line,
        read: impl FnOnce(&mut Self) -> syn::Result<Friction>,
    ) -> syn::Result<Vec<Line>> {
        let before = self.errors.len();
        let found = read(self)?;
        Ok(vec![if self.errors.len() == before {
            line(found)
        } else {
            Line::Broken(Broken {
                keyword: Some(keyword),
                name: Some(found.name),
            })
        }])
    }

    pub(super) fn friction(
        &mut self,
        docs: Vec<Attribute>,
        input: ParseStream,
    ) -> syn::Result<Friction> {
        let mut line = self.force_of(docs, input, |input, name| {
            if input.parse::<Option<word::opposing>>()?.is_some() {
                return Ok(());
            }
            Err(joining(input, name, ["opposing", "v - v_belt"]))
        })?;
        line.memory = self.memory_if_stated(input)?;
        Ok(line)
    }

    pub(super) fn press(
        &mut self,
        docs: Vec<Attribute>,
        input: ParseStream,
    ) -> syn::Result<Friction> {
        self.force_of(docs, input, |input, name| {
            if input.parse::<Option<word::closing>>()?.is_some() {
                return Ok(());
            }
            Err(joining(input, name, ["closing", "y - y_wall"]))
        })
    }

    /// `name: unit = Law { fields } word formula`
    fn force_of(
        &mut self,
        docs: Vec<Attribute>,
        input: ParseStream,
        word: impl FnOnce(ParseStream, &Ident) -> syn::Result<()>,
    ) -> syn::Result<Friction> {
        let name = self.declared(input)?;
        let unit = value::unit_if_stated(input)?;
        value::equals(input)?;
        let law = law(input)?;
        let fields = self.fields(&law, input)?;
        word(input, &name)?;
        Ok(Friction {
            docs,
            name,
            unit,
            law,
            fields,
            speed: self.formula(input)?,
            memory: Vec::new(),
        })
    }

    fn fields(&mut self, law: &Path, input: ParseStream) -> syn::Result<Vec<Field>> {
        let body;
        if !input.peek(token::Brace) {
            let words = law.segments.iter().map(|segment| segment.ident.to_string());
            // What `Law::new` is called on is the law.
            let mut laws = words.filter(|word| word.starts_with(char::is_uppercase));
            let law = laws.next_back().unwrap_or_else(|| last_word(law));
            return Err(input.error(format!(
                "what `{law}` is made of stands between braces: write `{law} {{ field: value }}`"
            )));
        }
        braced!(body in input);
        let mut fields = Vec::new();
        while !body.is_empty() {
            let field = self.field(&body)?;
            let name = &field.name;
            if fields.iter().any(|other: &Field| other.name == *name) {
                let message = format!("field `{name}` is given twice; keep one");
                self.errors.at(name, message);
            } else {
                fields.push(field);
            }
            if !body.is_empty() && body.parse::<Token![,]>().is_err() {
                let found = next(&body).unwrap_or_default();
                return Err(body.error(format!(
                    "`{found}` does not part fields: a field ends with `,`, as in `{{ level: 1.0, decay: 2.0 }}`"
                )));
            }
        }
        Ok(fields)
    }

    /// `name: formula`, or `name` alone where both are called the same.
    fn field(&mut self, input: ParseStream) -> syn::Result<Field> {
        if input.peek(Token![..]) {
            return Err(input.error(
                "`..` leaves fields to nobody: a law has no defaults, so give each field its value as `field: value`",
            ));
        }
        let name: Ident = input.parse().map_err(|_| {
            let found = next(input).unwrap_or_default();
            input.error(format!(
                "`{found}` is no field: a field has a name, as in `level: 1.0`"
            ))
        })?;
        if input.peek(Token![=]) {
            let message = format!("a field takes its value after `:`: write `{name}: ...`");
            return Err(input.error(message));
        }
        let formula = if input.parse::<Option<Token![:]>>()?.is_some() {
            self.formula(input)?
        } else {
            Formula::name(&name)
        };
        Ok(Field { name, formula })
    }
}

/// The law of a contact.
fn law(input: ParseStream) -> syn::Result<Path> {
    if input.peek(Ident::peek_any) {
        return input.call(Path::parse_mod_style);
    }
    let found = next(input).unwrap_or_default();
    Err(input.error(format!(
        "`{found}` stands where the name of a law should: a factor or a sign belongs to a field of the law, or to the \
         equation in which the force stands"
    )))
}

/// A line lacks the word that joins a force to what it depends on.
fn joining(input: ParseStream, name: &Ident, [word, example]: [&str; 2]) -> syn::Error {
    let found = match next(input).as_deref() {
        None | Some(";") => String::new(),
        Some(found) => format!(", not `{found}`"),
    };
    input.error(format!(
        "what `{name}` depends on follows `{word}`{found}: write `{word} {example}`"
    ))
}
