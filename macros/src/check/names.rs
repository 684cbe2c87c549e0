//! Names: declared once, above their first use, known where used, and used at all.

use std::collections::HashSet;

use proc_macro2::Ident;
use syn::ext::IdentExt;

use crate::errors::Errors;
use crate::suggest::nearest;
use crate::syntax::{Declaration, Formula, Line};

/// What a name stands for, as a reader would say it.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Role {
    State,
    Parameter,
    Let,
    Friction,
    Speed,
}

impl Role {
    fn noun(self) -> &'static str {
        match self {
            Self::State => "state",
            Self::Parameter => "parameter",
            Self::Let => "`let`",
            Self::Friction => "friction force",
            Self::Speed => "sliding speed",
        }
    }
}

/// Every declared name with its role, in the order of declaration.
pub(super) struct Names {
    declared: Vec<(Ident, Role)>,
    in_model: bool,
}

impl Names {
    pub(super) fn of_model(written: &Declaration) -> Self {
        let declared = written.lines.iter().filter_map(declared_by).collect();
        Self {
            declared,
            in_model: true,
        }
    }

    pub(super) fn of_law(written: &Declaration) -> Self {
        let declared = written.lines.iter().filter_map(declared_by).collect();
        Self {
            declared,
            in_model: false,
        }
    }

    fn role_of(&self, name: &Ident) -> Option<Role> {
        let found = self.declared.iter().find(|(known, _)| known == name);
        found.map(|(_, role)| *role)
    }

    fn texts(&self) -> Vec<String> {
        self.declared
            .iter()
            .map(|(name, _)| name.unraw().to_string())
            .collect()
    }
}

fn declared_by(line: &Line) -> Option<(Ident, Role)> {
    match line {
        Line::State(line) => Some((line.name.clone(), Role::State)),
        Line::Param(line) => Some((line.name.clone(), Role::Parameter)),
        Line::Let(line) => Some((line.name.clone(), Role::Let)),
        Line::Friction(line) => Some((line.name.clone(), Role::Friction)),
        Line::Slip(line) => Some((line.speed.clone(), Role::Speed)),
        Line::Broken(line) => {
            let role = match line.keyword.as_str() {
                "state" => Role::State,
                "param" => Role::Parameter,
                "let" => Role::Let,
                "friction" => Role::Friction,
                "slip" => Role::Speed,
                _ => return None,
            };
            line.name.clone().map(|name| (name, role))
        }
        Line::Derivative(_) | Line::Stick(_) => None,
    }
}

/// The words of the language itself.
const WORDS: [&str; 7] = [
    "der", "friction", "opposing", "param", "slip", "state", "stick",
];

/// What the generated code or the program calls by these names.
const TAKEN: [(&str, &str); 9] = [
    ("clone", "every model has a method of this name"),
    ("default", "every model has a method of this name"),
    ("eq", "every model has a method of this name"),
    ("fmt", "every model has a method of this name"),
    ("from_values", "every model has a method of this name"),
    ("observables", "every model has a method of this name"),
    ("rhs", "every model has a method of this name"),
    (
        "smooth",
        "the program uses it for the size of the smoothing",
    ),
    ("values", "every model has a method of this name"),
];

/// A name must not shadow what the generated code or the language calls by it.
pub(super) fn check_reserved(written: &Declaration, names: &Names, errors: &mut Errors) {
    for (name, _) in &names.declared {
        if let Some(reason) = reserved(name, names.in_model) {
            errors.at(
                name,
                format!("`{name}` cannot be a name here: {reason}; choose another"),
            );
        }
    }
    let types = written
        .frictions()
        .filter_map(|friction| friction.law.get_ident());
    for name in types.chain([&written.name]).filter(|name| *name == "D") {
        errors.at(name, "`D` cannot be the name of a type here: formulas use it for their numbers; choose another");
    }
}

fn reserved(name: &Ident, in_model: bool) -> Option<String> {
    let text = name.to_string();
    let taken = TAKEN.iter().find(|(word, _)| in_model && *word == text);
    if let Some((_, reason)) = taken {
        Some((*reason).to_owned())
    } else if !is_field(name) {
        Some("it is a word of Rust".to_owned())
    } else if WORDS.contains(&text.as_str()) {
        Some("it is a word of this language".to_owned())
    } else if text.starts_with("__") {
        Some("names with two leading underscores are the generated code's".to_owned())
    } else {
        None
    }
}

/// Whether Rust accepts this as the name of a field.
pub(crate) fn is_field(name: &Ident) -> bool {
    syn::parse2::<Ident>(quote::quote!(#name)).is_ok()
}

/// Nothing is declared twice.
pub(super) fn check_declared_once(names: &Names, errors: &mut Errors) {
    let mut seen: Vec<&(Ident, Role)> = Vec::new();
    for declared in &names.declared {
        let (name, role) = declared;
        match seen.iter().find(|(known, _)| known == name) {
            None => seen.push(declared),
            Some((_, first)) => {
                let (first, role) = (first.noun(), role.noun());
                errors.at(name, format!(
                    "`{name}` is declared twice: first as a {first}, here as a {role}; rename one"
                ));
            }
        }
    }
}

/// Every name in a formula is declared.
pub(super) fn check_known(written: &Declaration, names: &Names, errors: &mut Errors) {
    let formulas = written.lines.iter().flat_map(Line::formulas);
    for name in formulas.flat_map(Formula::names) {
        if names.role_of(name).is_none() {
            errors.at(name, unknown(name, names));
        }
    }
}

fn unknown(name: &Ident, names: &Names) -> String {
    let text = name.unraw().to_string();
    if matches!(text.as_str(), "t" | "time") && names.in_model {
        return format!(
            "`{text}` is not declared: equations are autonomous and cannot depend on time"
        );
    }
    let known = names.texts();
    if let Some(near) = nearest(&text, known.iter().map(String::as_str)) {
        return format!("unknown name `{text}`; did you mean `{near}`?");
    }
    if matches!(text.as_str(), "PI" | "TAU" | "E" | "pi") {
        let constant = text.to_uppercase();
        return format!("unknown name `{text}`; the constant is `std::f64::consts::{constant}`");
    }
    if names.in_model {
        format!("unknown name `{text}`; declare it with `state`, `param` or `let`")
    } else {
        format!("unknown name `{text}`; declare it with `param`")
    }
}

/// `let` and friction lines are computed from top to bottom.
pub(super) fn check_declared_above(written: &Declaration, errors: &mut Errors) {
    let sequential = |line: &&Line| matches!(line, Line::Let(_) | Line::Friction(_));
    let steps: Vec<&Line> = written.lines.iter().filter(sequential).collect();
    for (i, line) in steps.iter().enumerate() {
        let later: Vec<Ident> = steps[i..]
            .iter()
            .filter_map(|line| Some(declared_by(line)?.0))
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

/// At rest there is no sliding speed.
pub(super) fn check_rest_has_no_speed(written: &Declaration, errors: &mut Errors) {
    let speeds: Vec<&Ident> = written.slips().map(|slip| &slip.speed).collect();
    for name in written.sticks().flat_map(|stick| stick.formula.names()) {
        if speeds.contains(&name) {
            errors.at(name, format!(
                "`{name}` is the sliding speed, and at rest there is none: `stick` is a formula of the parameters"
            ));
        }
    }
}

/// Parameters and friction forces are used; asked only when all is well, since a misspelt use would count as none.
pub(super) fn check_used(written: &Declaration, names: &Names, errors: &mut Errors) {
    if !errors.is_empty() {
        return;
    }
    let formulas = written.lines.iter().flat_map(Line::formulas);
    let used: HashSet<&Ident> = formulas.flat_map(Formula::names).collect();
    let whole = if names.in_model { "model" } else { "law" };
    for (name, role) in &names.declared {
        if matches!(role, Role::Parameter | Role::Friction) && !used.contains(name) {
            let noun = role.noun();
            errors.at(
                name,
                format!("{noun} `{name}` is never used in this {whole}; use it or remove its line"),
            );
        }
    }
}
