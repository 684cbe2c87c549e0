//! Names: declared once, above their first use, known where used, and used at all.

use std::collections::HashSet;

use proc_macro2::Ident;
use syn::ext::IdentExt;

use super::arrays;
use crate::errors::Errors;
use crate::formula::Formula;
use crate::parse::Grammar;
use crate::suggest::nearest;
use crate::syntax::{Declaration, Line};

/// What a line that begins with this word declares, as a reader would say it; `None` if it declares nothing.
fn noun(keyword: &str) -> Option<&'static str> {
    match keyword {
        "state" => Some("state"),
        "param" => Some("parameter"),
        "let" => Some("`let`"),
        "friction" => Some("friction force"),
        "press" => Some("press"),
        "slip" => Some("sliding speed"),
        "force" => Some("relative speed"),
        "rebound" => Some("speed of approach"),
        "drive" => Some("phase of the drive"),
        _ => None,
    }
}

/// Every declared name with the word of its line, in the order of declaration.
pub(super) struct Names {
    pub(super) declared: Vec<(Ident, &'static str)>,
    /// Names of broken lines of which not even the kind is known.
    doubtful: Vec<Ident>,
    /// Elements of arrays about which enough is said already.
    missing: Vec<Ident>,
    /// Arrays, and their first elements.
    arrays: Vec<(String, i64)>,
    pub(super) in_model: bool,
}

impl Names {
    pub(super) fn of(written: &Declaration, grammar: Grammar) -> Self {
        let unknown = written.broken().filter(|line| line.keyword.is_none());
        Self {
            declared: written.lines.iter().flat_map(declared_by).collect(),
            doubtful: unknown.filter_map(|line| line.name.clone()).collect(),
            missing: arrays::missing(written)
                .map(|element| element.name.clone())
                .collect(),
            arrays: arrays::arrays(written)
                .into_iter()
                .filter_map(|(array, indices)| Some((array, *indices.first()?)))
                .collect(),
            in_model: grammar == Grammar::Model,
        }
    }

    /// What a name stands for, if it is declared.
    pub(super) fn noun_of(&self, name: &Ident) -> Option<&'static str> {
        noun(self.word_of(name)?)
    }

    /// The word of the line that declares a name.
    pub(super) fn word_of(&self, name: &Ident) -> Option<&'static str> {
        let found = self.declared.iter().find(|(known, _)| known == name);
        found.map(|(_, word)| *word)
    }

    /// Whether it is the name of a broken line of which not even the kind is known.
    pub(super) fn doubt(&self, name: &Ident) -> bool {
        self.doubtful.contains(name)
    }

    fn know(&self, name: &Ident) -> bool {
        self.noun_of(name).is_some() || self.doubt(name) || self.missing.contains(name)
    }

    fn texts(&self) -> Vec<String> {
        let names = self.declared.iter().map(|(name, _)| name);
        names.map(|name| name.unraw().to_string()).collect()
    }
}

fn declared_by(line: &Line) -> impl Iterator<Item = (Ident, &'static str)> {
    let word = line.keyword().filter(|word| noun(word).is_some());
    let rate = match line {
        Line::Force(rule) => rule.rate.as_ref(),
        _ => None,
    };
    let names = line.name().into_iter().chain(rate);
    names.filter_map(move |name| Some((name.clone(), word?)))
}

/// Nothing is declared twice.
pub(super) fn check_declared_once(names: &Names, errors: &mut Errors) {
    let mut seen: Vec<&(Ident, &str)> = Vec::new();
    for declared in &names.declared {
        let (name, word) = declared;
        match seen.iter().find(|(known, _)| known == name) {
            None => seen.push(declared),
            // Two lines for sliding are one mistake, of which another check tells.
            Some((_, "slip")) if *word == "slip" => {}
            Some((_, first)) => {
                let [first, noun] = [first, word].map(|word| noun(word).unwrap_or_default());
                errors.at(name, format!(
                    "`{name}` is declared twice: first as a {first}, here as a {noun}; rename one"
                ));
            }
        }
    }
}

/// Every name in a formula is declared.
pub(super) fn check_known(written: &Declaration, names: &Names, errors: &mut Errors) {
    let formulas = written.lines.iter().flat_map(Line::formulas);
    for name in formulas.flat_map(Formula::names) {
        if !names.know(name) {
            errors.at(name, unknown(name, names));
        }
    }
}

fn unknown(name: &Ident, names: &Names) -> String {
    let text = name.unraw().to_string();
    if matches!(text.as_str(), "t" | "time") && names.in_model {
        return format!(
            "`{text}` is not declared: equations are autonomous and cannot depend on time; \
             a harmonic force is `cos(phi)` with the line `drive phi at omega;`"
        );
    }
    if let Some((array, first)) = names.arrays.iter().find(|(array, _)| *array == text) {
        return format!("`{array}` is an array: write which element, as in `{array}[{first}]`");
    }
    if matches!(text.as_str(), "PI" | "TAU" | "E" | "pi") {
        let constant = text.to_uppercase();
        return format!("unknown name `{text}`; the constant is `std::f64::consts::{constant}`");
    }
    let known = names.texts();
    if let Some(near) = nearest(&text, known.iter().map(String::as_str)) {
        return format!("unknown name `{text}`; did you mean `{near}`?");
    }
    if names.in_model {
        format!("unknown name `{text}`; declare it with `state`, `param` or `let`")
    } else {
        format!("unknown name `{text}`; declare it with `param`")
    }
}

/// `let` and friction lines are computed from top to bottom.
pub(super) fn check_declared_above(written: &Declaration, errors: &mut Errors) {
    let sequential =
        |line: &&Line| matches!(line, Line::Let(_) | Line::Friction(_) | Line::Press(_));
    let steps: Vec<&Line> = written.lines.iter().filter(sequential).collect();
    for (i, line) in steps.iter().enumerate() {
        let later: Vec<Ident> = steps[i..]
            .iter()
            .flat_map(|line| declared_by(line).map(|(name, _)| name))
            .collect();
        for name in line.formulas().into_iter().flat_map(Formula::names) {
            match later.iter().position(|declared| declared == name) {
                None => {}
                Some(0) => errors.at(
                    name,
                    format!("`{name}` is defined by itself; lines are computed from top to bottom"),
                ),
                Some(_) => errors.at(
                    name,
                    format!("`{name}` is used above the line that declares it; move that line up"),
                ),
            }
        }
    }
}

/// These names, and those of the `let` lines that are made of them.
pub(super) fn made_of<'a>(written: &'a Declaration, mut names: Vec<&'a Ident>) -> Vec<&'a Ident> {
    for line in written.lets() {
        let read = line.formula.names();
        if read.iter().any(|name| names.contains(name)) {
            names.push(&line.name);
        }
    }
    names
}

/// At rest there is no sliding speed.
pub(super) fn check_rest_has_no_speed(written: &Declaration, errors: &mut Errors) {
    let is_parameter = |name: &Ident| written.params().any(|param| param.name == *name);
    let speeds = written.slips().map(|slip| &slip.name);
    let speeds = made_of(
        written,
        speeds.filter(|speed| !is_parameter(speed)).collect(),
    );
    for name in written.sticks().flat_map(|stick| stick.formula.names()) {
        if speeds.contains(&name) {
            let abbreviates = written.lets().any(|line| line.name == *name);
            let what = if abbreviates {
                "made of the sliding speed"
            } else {
                "the sliding speed"
            };
            errors.at(name, format!(
                "`{name}` is {what}, and at rest there is none: `stick` is a formula of the parameters"
            ));
        }
    }
}

/// Parameters and friction forces are used.
///
/// Asked only when every formula could be read. What an unknown name may have been meant for is not accused as well.
pub(super) fn check_used(written: &Declaration, names: &Names, errors: &mut Errors) {
    let formulas = written.lines.iter().flat_map(Line::formulas);
    let used: HashSet<&Ident> = formulas.flat_map(Formula::names).collect();
    let Some(meant) = meant(&used, names) else {
        return;
    };
    let whole = if names.in_model { "model" } else { "law" };
    for (name, word) in &names.declared {
        let needed = matches!(*word, "param" | "friction" | "press" | "drive");
        if needed && !used.contains(name) && !meant.contains(&name.unraw().to_string()) {
            let noun = noun(word).unwrap_or_default();
            errors.at(
                name,
                format!("{noun} `{name}` is never used in this {whole}; use it or remove its line"),
            );
        }
    }
}

/// What the unknown names were probably meant for; nothing if one may have been meant for anything.
fn meant(used: &HashSet<&Ident>, names: &Names) -> Option<Vec<String>> {
    let texts = names.texts();
    let unknown = used.iter().filter(|name| !names.know(name));
    let near = |name: &&&Ident| {
        let near = nearest(&name.unraw().to_string(), texts.iter().map(String::as_str));
        near.map(str::to_owned)
    };
    unknown.map(|name| near(&name)).collect()
}
