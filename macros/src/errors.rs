//! The collector of errors.

use std::collections::{HashMap, HashSet};
use std::fmt::Display;
use std::thread;

use proc_macro2::TokenStream;
use quote::ToTokens;

use crate::repeated::Element;

/// Collects everything that is wrong with a declaration, so that one run reports it all.
///
/// Forgetting to ask for the verdict panics: no mistake of a user can be lost by one of ours.
pub(crate) struct Errors {
    found: Option<Vec<syn::Error>>,
    /// Words of ours, and what the user wrote for them.
    written: HashMap<String, String>,
    places: HashSet<(String, String)>,
}

impl Errors {
    pub(crate) fn new() -> Self {
        Self {
            found: Some(Vec::new()),
            written: HashMap::new(),
            places: HashSet::new(),
        }
    }

    /// Reports a mistake in the user's words, underlining `place`.
    pub(crate) fn at(&mut self, place: impl ToTokens, message: impl Display) {
        let (place, message) = (
            place.into_token_stream(),
            self.in_words(&message.to_string()),
        );
        let said = place_of(&place, &message).is_some_and(|key| !self.places.insert(key));
        if !said || self.written.is_empty() {
            self.add(syn::Error::new_spanned(place, message));
        }
    }

    /// Reports a mistake that the parser has found.
    pub(crate) fn add(&mut self, error: syn::Error) {
        if let Some(found) = &mut self.found {
            found.push(error);
        }
    }

    /// Whether nothing is wrong so far.
    pub(crate) fn is_empty(&self) -> bool {
        self.found.as_ref().is_none_or(Vec::is_empty)
    }

    /// A message with elements of arrays as they are written.
    fn in_words(&self, message: &str) -> String {
        if self.written.is_empty() {
            return message.to_owned();
        }
        let (mut found, mut word) = (String::new(), String::new());
        for letter in message.chars().chain(['\n']) {
            if letter.is_alphanumeric() || letter == '_' {
                word.push(letter);
                continue;
            }
            found += self.written.get(&word).unwrap_or(&word);
            found.push(letter);
            word.clear();
        }
        found.pop();
        found
    }

    /// How many mistakes are found so far.
    pub(crate) fn len(&self) -> usize {
        self.found.as_ref().map_or(0, Vec::len)
    }

    /// Lets go of what was found, since it has been said before.
    pub(crate) fn forget(mut self) {
        self.found = None;
    }

    /// Elements of arrays are called in messages what they are called in the declaration.
    pub(crate) fn show(&mut self, elements: &[Element]) {
        for element in elements {
            let written = format!("{}[{}]", element.array, element.index);
            self.written.insert(element.name.to_string(), written);
        }
    }

    /// What is measured at points of structures is called in messages what it is called in the declaration.
    pub(crate) fn show_points(&mut self, measured: impl Iterator<Item = (String, String)>) {
        self.written.extend(measured);
    }

    /// The verdict: every mistake, in the order in which they were found.
    pub(crate) fn finish(mut self) -> syn::Result<()> {
        let found = self.found.take().unwrap_or_default();
        match found.into_iter().reduce(joined) {
            None => Ok(()),
            Some(all) => Err(all),
        }
    }
}

/// Where a message stands, and the message without its numbers: that of one mistake in every turn of a loop.
///
/// `None` where places cannot be told apart, as in unit tests.
fn place_of(tokens: &TokenStream, message: &str) -> Option<(String, String)> {
    let first = tokens.clone().into_iter().next()?;
    let span = format!("{:?}", first.span());
    let text = message.chars().filter(|letter| !letter.is_ascii_digit());
    span.contains("bytes").then(|| (span, text.collect()))
}

fn joined(mut all: syn::Error, next: syn::Error) -> syn::Error {
    all.combine(next);
    all
}

impl Drop for Errors {
    fn drop(&mut self) {
        assert!(
            self.found.is_none() || thread::panicking(),
            "errors were collected and never reported"
        );
    }
}
