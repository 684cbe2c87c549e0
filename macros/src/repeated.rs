//! Arrays, and the loops over them.

use proc_macro2::Ident;
use quote::format_ident;
use syn::ext::IdentExt;

use crate::syntax::Bounds;

/// What is known of arrays and of the loops over them, which the lines no longer show.
#[derive(Default)]
pub(crate) struct Repeated {
    /// Every element that is declared or used.
    pub(crate) elements: Vec<Element>,
    /// The names that count in `for`.
    pub(crate) counters: Vec<Ident>,
}

/// `array[index]`, called `name` from there on.
pub(crate) struct Element {
    pub(crate) array: Ident,
    pub(crate) index: i64,
    pub(crate) name: Ident,
    /// Whether the line declares it.
    pub(crate) declares: bool,
}

impl Repeated {
    /// Notes an element of an array, and gives its name.
    pub(crate) fn element(&mut self, array: &Ident, index: i64, declares: bool) -> Ident {
        let sign = if index < 0 { "minus_" } else { "" };
        let (text, size) = (array.unraw(), index.unsigned_abs());
        let name = format_ident!("{text}_{sign}{size}", span = array.span());
        self.elements.push(Element {
            array: array.clone(),
            index,
            name: name.clone(),
            declares,
        });
        name
    }
}

impl Bounds {
    /// The bounds of an array as those of one of its elements, called `element`.
    pub(crate) fn on(mut self, element: &Ident) -> Self {
        let array = self.name.unraw().to_string();
        let name = element.unraw().to_string();
        let index = name
            .strip_prefix(&array)
            .and_then(|rest| rest.strip_prefix('_'));
        if index.is_some_and(|index| index.bytes().all(|digit| digit.is_ascii_digit())) {
            let span = self.name.span();
            self.name = element.clone();
            self.name.set_span(span);
        }
        self
    }
}
