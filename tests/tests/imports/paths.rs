//! The paths that a file names: in `use` trees, and in the midst of code.

/// A path as it is written, and where it stands.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(crate) struct Named {
    /// Its segments.
    pub(crate) path: Vec<String>,
    /// The name that it has in the file.
    pub(crate) name: String,
    /// Whether a `use` lends it this name.
    pub(crate) import: bool,
    /// Whether others can have it from here.
    pub(crate) public: bool,
}

/// Every path of a file with more than one segment, comments and unit tests left out.
pub(crate) fn named(text: &str) -> Vec<Named> {
    let code = text.split("#[cfg(test)]").next().unwrap_or_default();
    let lines = code.lines().map(|line| line.split("//").next());
    let code = lines.map(Option::unwrap_or_default).collect::<Vec<_>>();
    let mut reader = Reader {
        tokens: &tokens(&code.join("\n")),
        found: Vec::new(),
    };
    while reader.next() {}
    let paths = reader.found.into_iter();
    paths.filter(|named| named.path.len() > 1).collect()
}

/// Words, `::`, and single characters.
fn tokens(code: &str) -> Vec<String> {
    let mut tokens: Vec<String> = Vec::new();
    let (mut grows, mut colon) = (false, false);
    for letter in code.chars() {
        let word = letter.is_alphanumeric() || letter == '_';
        match tokens.last_mut() {
            Some(last) if grows && word => last.push(letter),
            Some(last) if colon && letter == ':' => last.push(letter),
            _ if letter.is_whitespace() => {}
            _ => tokens.push(letter.to_string()),
        }
        colon = letter == ':' && !(colon && tokens.last().is_some_and(|last| last == "::"));
        grows = word;
    }
    tokens
}

struct Reader<'a> {
    tokens: &'a [String],
    found: Vec<Named>,
}

impl Reader<'_> {
    fn peek(&self, place: usize) -> &str {
        self.tokens.get(place).map_or("", String::as_str)
    }

    fn skip(&mut self, count: usize) {
        self.tokens = &self.tokens[count.min(self.tokens.len())..];
    }

    /// Reads the next path; `false` at the end.
    fn next(&mut self) -> bool {
        let public = self.peek(0) == "pub";
        if public {
            self.skip(1);
            self.skip_scope();
        }
        if self.peek(0) == "use" {
            self.skip(1);
            self.tree(&[], true, public);
        } else if is_word(self.peek(0)) {
            self.tree(&[], false, false);
        } else {
            self.skip(1);
        }
        !self.tokens.is_empty()
    }

    /// `(crate)`, `(super)` or `(in a::b)` after `pub`.
    fn skip_scope(&mut self) {
        if self.peek(0) == "(" {
            let end = self.tokens.iter().position(|token| token == ")");
            self.skip(end.map_or(1, |end| end + 1));
        }
    }

    /// A path, of a `use` with all its branches.
    fn tree(&mut self, stem: &[String], import: bool, public: bool) {
        let mut path = stem.to_vec();
        loop {
            match self.peek(0) {
                "{" if import => return self.branches(&path, public),
                word if is_word(word) || word == "*" => path.push(word.to_owned()),
                _ => break,
            }
            self.skip(1);
            if self.peek(0) != "::" {
                break;
            }
            self.skip(1);
        }
        // A macro belongs to the crate and to no module.
        if self.peek(0) == "!" {
            return;
        }
        if path.len() > 1 && path.last().is_some_and(|last| last == "self") {
            path.pop();
        }
        let mut name = path.last().cloned().unwrap_or_default();
        if import && self.peek(0) == "as" {
            name = self.peek(1).to_owned();
            self.skip(2);
        }
        self.found.push(Named {
            path,
            name,
            import,
            public,
        });
    }

    fn branches(&mut self, stem: &[String], public: bool) {
        self.skip(1);
        while !matches!(self.peek(0), "}" | "") {
            if self.peek(0) == "," {
                self.skip(1);
            } else {
                self.tree(stem, true, public);
            }
        }
        self.skip(1);
    }
}

fn is_word(token: &str) -> bool {
    let first = token.chars().next();
    first.is_some_and(|first| first.is_alphabetic() || first == '_')
}

#[test]
fn trees_are_read_with_all_their_branches() {
    let text =
        "pub(crate) use super::{a::B, c as d}; // crate::x::y\nlet e = crate::f::g(h::<I>::new());";
    let read: Vec<(String, String, bool)> = named(text)
        .into_iter()
        .map(|named| (named.path.join("::"), named.name, named.public))
        .collect();
    let expected = [
        ("super::a::B", "B", true),
        ("super::c", "d", true),
        ("crate::f::g", "g", false),
    ];
    let expected = expected.map(|(path, name, public)| (path.to_owned(), name.to_owned(), public));
    assert_eq!(read, expected);
}
