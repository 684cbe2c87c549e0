//! The three ways to reduce.

use std::fmt;
use std::str::FromStr;

/// How what the kept modes lack is taken into account.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Method {
    /// Modes of the structure with its points free, and its residual flexibility there with the mass that moves along:
    /// one more mode for each point (Rubin, AIAA J. 13 (1975) 995). Static displacements at the points are exact.
    #[default]
    Free,
    /// Modes of the structure with its points held, and the static shapes of their displacements: one more mode for each
    /// point (Craig and Bampton, AIAA J. 6 (1968) 1313). Static displacements at the points are exact.
    CraigBampton,
    /// Modes of the structure with its points free, and its residual flexibility there without mass (MacNeal, Computers
    /// & Structures 1 (1971) 581): a spring in series with each contact.
    Massless,
}

const NAMES: [(&str, Method); 3] = [
    ("free", Method::Free),
    ("craig-bampton", Method::CraigBampton),
    ("massless", Method::Massless),
];

impl Method {
    /// The names of all methods.
    #[must_use]
    pub fn names() -> [&'static str; 3] {
        NAMES.map(|(name, _)| name)
    }
}

impl fmt::Display for Method {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let known = NAMES.iter().find(|(_, method)| method == self);
        f.write_str(known.map_or("", |(name, _)| name))
    }
}

impl FromStr for Method {
    type Err = ();

    fn from_str(word: &str) -> Result<Self, ()> {
        let known = NAMES.iter().find(|(name, _)| *name == word);
        known.map(|(_, method)| *method).ok_or(())
    }
}
