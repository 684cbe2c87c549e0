//! Structures and the loads at their points.

use std::path::{Path, PathBuf};

use proc_macro2::Ident;
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::{Attribute, LitInt, LitStr, Token};

use super::docs::name;
use super::shape::next;
use super::{Reader, value};
use crate::structure::{Load, Quantity, Reduced, Structure, named};
use crate::syntax::{Broken, Line, word};

impl Reader<'_> {
    /// `name = "path" keeping count`
    pub(super) fn structure(&mut self, input: ParseStream) -> syn::Result<Vec<Line>> {
        let name = name(input)?;
        value::equals(input)?;
        let path: LitStr = input.parse()?;
        let kept = match input.parse::<Option<word::keeping>>()? {
            None => None,
            Some(_) if input.peek(LitInt) => Some(input.parse::<LitInt>()?),
            Some(_) => {
                let found = next(input).unwrap_or_default();
                return Err(input.error(format!(
                    "`{found}` is no number of modes: `keeping` is followed by a whole number, as in `keeping 12`"
                )));
            }
        };
        match read(&name, &path, kept.as_ref()) {
            Ok(structure) => {
                let lines = structure.declared(self.repeated);
                self.structures.stated.extend(structure.units());
                self.structures.all.push(structure);
                Ok(lines)
            }
            Err(error) => {
                self.errors.add(error);
                self.structures.lost.push(name);
                let (keyword, name) = (Some("state"), None);
                Ok(vec![Line::Broken(Broken { keyword, name })])
            }
        }
    }

    /// `structure.point = formula`
    pub(super) fn load(
        &mut self,
        docs: Vec<Attribute>,
        input: ParseStream,
    ) -> syn::Result<Vec<Line>> {
        let structure = name(input)?;
        input.parse::<Token![.]>()?;
        let point = input.call(Ident::parse_any)?;
        let formula = self.right_side(input)?;
        let Some((found, index)) = self.structures.find(&structure, &point, self.errors) else {
            return Ok(Vec::new());
        };
        let load = Load {
            name: found.at(&point, Quantity::Load),
            place: format!("{structure}.{point}"),
            turns: found.reduced.points[index].turns,
            si: found.reduced.si,
        };
        let name = load.name.clone();
        if self.structures.loads.iter().any(|known| known.name == name) {
            let message = format!(
                "second load at `{}`; write all forces there as one sum",
                load.place
            );
            self.errors.at(&point, message);
            return Ok(Vec::new());
        }
        self.structures.loads.push(load);
        Ok(vec![named(name, docs, formula)])
    }

    /// The equations of all structures, once all loads are known.
    pub(super) fn equations_of_structures(&mut self) -> Vec<Line> {
        let all = self.structures.all.iter();
        all.flat_map(|one| one.equations(self.structures, self.repeated))
            .collect()
    }
}

/// Reads the file of a structure, relative to the crate's manifest.
fn read(name: &Ident, path: &LitStr, kept: Option<&LitInt>) -> syn::Result<Structure> {
    let written = path.value();
    let whole = whole(&written);
    let refused = |what: String| syn::Error::new(path.span(), what);
    let text = std::fs::read_to_string(&whole).map_err(|error| {
        refused(format!(
            "`{}` cannot be read: {error}; the path is relative to the folder of `Cargo.toml`, and `stickslip reduce` \
             writes such files",
            whole.display()
        ))
    })?;
    let reduced = Reduced::read(&text).map_err(|what| {
        refused(format!(
            "`{written}` {what}; `stickslip reduce` writes such files"
        ))
    })?;
    let there = reduced.modes.len();
    let count = match kept {
        None => there,
        Some(literal) => match literal.base10_parse() {
            Ok(count) if (1..=there).contains(&count) => count,
            _ => {
                let message = format!("`{written}` has {there} modes: keep 1 to {there} of them");
                return Err(syn::Error::new(literal.span(), message));
            }
        },
    };
    Ok(Structure {
        name: name.clone(),
        path: whole.display().to_string(),
        reduced,
        kept: count,
    })
}

fn whole(path: &str) -> PathBuf {
    let folder = std::env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default();
    Path::new(&folder).join(path)
}
