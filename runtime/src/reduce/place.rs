//! Places: a direction at a node.

use std::fmt;
use std::str::FromStr;

/// A direction at a node, such as `871:y`; the row of a matrix without names of nodes, such as `871`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Place {
    /// The number of the node, or of the row from 1.
    pub node: u64,
    /// 1 to 3 for displacements along x, y and z, 4 to 6 for rotations about them; 0 for a scalar.
    pub direction: u8,
}

/// A point with a name.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Point {
    /// What models call it.
    pub name: String,
    /// Where it is.
    pub place: Place,
}

const DIRECTIONS: [&str; 6] = ["x", "y", "z", "rx", "ry", "rz"];

impl Place {
    /// Whether it is a rotation that is meant.
    #[must_use]
    pub fn turns(self) -> bool {
        self.direction > 3
    }
}

impl fmt::Display for Place {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match usize::from(self.direction).checked_sub(1) {
            Some(known) => write!(f, "{}:{}", self.node, DIRECTIONS[known.min(5)]),
            None => write!(f, "{}", self.node),
        }
    }
}

impl FromStr for Place {
    type Err = String;

    fn from_str(word: &str) -> Result<Self, String> {
        let (node, direction) = match word.split_once(':') {
            None => (word, 0),
            Some((node, letter)) => {
                let letter = letter.trim().to_ascii_lowercase();
                let numbered = letter
                    .parse()
                    .ok()
                    .filter(|number| (1..=6).contains(number));
                let named = DIRECTIONS.iter().position(|known| *known == letter);
                let named = named.map(|index| index as u8 + 1);
                let Some(direction) = named.or(numbered) else {
                    return Err(format!(
                        "`{letter}` is no direction: there are x, y, z and the rotations rx, ry, rz"
                    ));
                };
                (node, direction)
            }
        };
        let node = node.trim().parse().map_err(|_| {
            format!(
                "`{}` is no number of a node: write for instance 871:y",
                node.trim()
            )
        })?;
        Ok(Self { node, direction })
    }
}
