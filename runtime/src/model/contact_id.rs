//! Which contact is meant, in the words of its model.

use std::fmt;

use super::info::ModelInfo;

/// A contact that rubs or presses: its number, those that rub first, and the name of its force.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct ContactId {
    /// Its number.
    pub number: usize,
    /// The name of its force.
    pub name: &'static str,
}

impl ModelInfo {
    /// The contact of this number.
    #[must_use]
    pub fn contact_id(&self, number: usize) -> ContactId {
        let name = self.contact(number).unwrap_or("?");
        ContactId { number, name }
    }
}

impl fmt::Display for ContactId {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "`{}`", self.name)
    }
}

impl PartialEq<usize> for ContactId {
    fn eq(&self, number: &usize) -> bool {
        self.number == *number
    }
}

/// Contacts as a sentence shows them: `F` and `N`.
#[must_use]
pub fn listed(contacts: &[ContactId]) -> String {
    let words: Vec<String> = contacts.iter().map(ContactId::to_string).collect();
    match words.as_slice() {
        [first @ .., last] if !first.is_empty() => format!("{} and {last}", first.join(", ")),
        _ => words.concat(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn contacts_are_a_sentence() {
        let contacts = |names: &[&'static str]| {
            let all = names.iter().enumerate();
            let all: Vec<_> = all
                .map(|(number, &name)| ContactId { number, name })
                .collect();
            listed(&all)
        };
        assert_eq!(contacts(&["F"]), "`F`");
        assert_eq!(contacts(&["F", "G", "N"]), "`F`, `G` and `N`");
    }
}
