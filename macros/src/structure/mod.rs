//! Structures that `stickslip reduce` has made: `structure beam = "beam.structure" keeping 12;`.

mod file;
mod lines;
mod terms;

use proc_macro2::Ident;
use quote::format_ident;
use syn::ext::IdentExt;

pub(crate) use self::file::{Mode, Reduced};
pub(crate) use self::lines::named;
pub(crate) use self::terms::number;
use crate::errors::Errors;
use crate::suggest::nearest;
use crate::syntax::Unit;

/// The structures of a model, which its lines no longer show.
#[derive(Default)]
pub(crate) struct Structures {
    pub(crate) all: Vec<Structure>,
    /// Structures whose files could not be read, of which enough is said.
    pub(crate) lost: Vec<Ident>,
    /// Quantities whose units files state.
    pub(crate) stated: Vec<(Ident, Unit)>,
    /// Loads, with the place that is spoken of.
    pub(crate) loads: Vec<Load>,
}

/// `structure name = "path" keeping count;`
pub(crate) struct Structure {
    pub(crate) name: Ident,
    /// Where the file is.
    pub(crate) path: String,
    pub(crate) reduced: Reduced,
    /// How many of its modes are kept.
    pub(crate) kept: usize,
}

/// `load structure.point = formula;`
pub(crate) struct Load {
    /// The `let` line that it became.
    pub(crate) name: Ident,
    /// As it is written.
    pub(crate) place: String,
    pub(crate) turns: bool,
    pub(crate) si: bool,
}

/// What of a point is meant.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Quantity {
    Displacement,
    Speed,
    Load,
}

impl Structure {
    /// The name of a quantity at a point.
    pub(crate) fn at(&self, point: &Ident, quantity: Quantity) -> Ident {
        let (name, text) = (self.name.unraw(), point.unraw());
        let end = match quantity {
            Quantity::Displacement => "",
            Quantity::Speed => "_speed",
            Quantity::Load => "_load",
        };
        format_ident!("{name}_{text}{end}", span = point.span())
    }

    /// What a unit load at a point displaces it through the modes that are left out.
    pub(crate) fn flexibility(&self, point: usize) -> f64 {
        let beyond = self.reduced.modes[self.kept..].iter();
        let elastic = beyond.filter(|mode| mode.frequency > 0.0);
        let modes: f64 = elastic
            .map(|mode| (mode.shape[point] / mode.frequency).powi(2))
            .sum();
        modes + self.reduced.residual[point]
    }
}

impl Structures {
    /// The structure and the number of its point, or a message.
    ///
    /// `None` where enough is said already.
    pub(crate) fn find(
        &self,
        structure: &Ident,
        point: &Ident,
        errors: &mut Errors,
    ) -> Option<(&Structure, usize)> {
        if self.lost.contains(structure) {
            return None;
        }
        let Some(found) = self.all.iter().find(|one| one.name == *structure) else {
            errors.at(structure, self.unknown(structure));
            return None;
        };
        let text = point.unraw().to_string();
        let mut points = found.reduced.points.iter();
        let place = points.position(|one| one.name == text);
        if place.is_none() {
            errors.at(point, no_point(found, &text));
        }
        place.map(|place| (found, place))
    }

    /// Displacements and speeds by their names, and as they are written.
    pub(crate) fn measured(&self) -> impl Iterator<Item = (String, String)> {
        self.all.iter().flat_map(|one| {
            let name = one.name.unraw().to_string();
            one.reduced.points.iter().flat_map(move |point| {
                let written = format!("{name}.{}", point.name);
                let called = format!("{name}_{}", point.name);
                [
                    (format!("{called}_speed"), format!("der({written})")),
                    (called, written),
                ]
            })
        })
    }

    fn unknown(&self, name: &Ident) -> String {
        let text = name.unraw().to_string();
        let known: Vec<String> = self
            .all
            .iter()
            .map(|one| one.name.unraw().to_string())
            .collect();
        match nearest(&text, known.iter().map(String::as_str)) {
            Some(near) => format!("unknown structure `{text}`; did you mean `{near}`?"),
            None => format!(
                "`{text}` is no structure; one is declared above its use by `structure {text} = \"{text}.structure\";`"
            ),
        }
    }
}

fn no_point(structure: &Structure, text: &str) -> String {
    let Structure { name, reduced, .. } = structure;
    let known: Vec<&str> = reduced.points.iter().map(|one| one.name.as_str()).collect();
    match nearest(text, known.iter().copied()) {
        Some(near) => format!("`{name}` has no point `{text}`; did you mean `{near}`?"),
        None => format!(
            "`{name}` has no point `{text}`: its file names {}; `stickslip reduce ... --at {text}=NODE:DIRECTION` names \
             others",
            known.join(", ")
        ),
    }
}
