//! The collector of errors.

use std::fmt::Display;
use std::thread;

use quote::ToTokens;

/// Collects everything that is wrong with a declaration, so that one run reports it all.
///
/// Forgetting to ask for the verdict panics: no mistake of a user can be lost by one of ours.
pub(crate) struct Errors {
    found: Option<Vec<syn::Error>>,
}

impl Errors {
    pub(crate) fn new() -> Self {
        Self {
            found: Some(Vec::new()),
        }
    }

    /// Reports a mistake in the user's words, underlining `place`.
    pub(crate) fn at(&mut self, place: impl ToTokens, message: impl Display) {
        self.add(syn::Error::new_spanned(place, message));
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

    /// The verdict: every mistake, in the order in which they were found.
    pub(crate) fn finish(mut self) -> syn::Result<()> {
        let found = self.found.take().unwrap_or_default();
        match found.into_iter().reduce(joined) {
            None => Ok(()),
            Some(all) => Err(all),
        }
    }
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
