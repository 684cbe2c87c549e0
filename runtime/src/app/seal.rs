//! Lines that belong together: each begins with a checksum of itself and of all lines before it.
//!
//! What a disk, an editor or a hand has changed shows at the first line that it reaches.

use crc32fast::Hasher;

/// The checksum of the lines so far.
#[derive(Debug, Clone, Default)]
pub(super) struct Seal(Hasher);

impl Seal {
    /// The next line, with its end; these words hold none.
    pub(super) fn line(&mut self, words: &str) -> String {
        let sum = self.after(words.as_bytes());
        format!("{sum:08x} {words}\n")
    }

    /// The words of the next line, which ends; `None` if it does not follow what came before, or is not as it was written.
    pub(super) fn open<'a>(&mut self, line: &'a [u8]) -> Option<&'a str> {
        let line = line.strip_suffix(b"\n")?;
        let (sum, words) = (line.get(..8)?, line.get(8..)?.strip_prefix(b" ")?);
        let right = format!("{:08x}", self.after(words));
        (sum == right.as_bytes()).then(|| std::str::from_utf8(words).ok())?
    }

    fn after(&mut self, words: &[u8]) -> u32 {
        self.0.update(words);
        // So that no end of a line can move.
        self.0.update(b"\n");
        self.0.clone().finalize()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn opened(lines: &[&[u8]]) -> Option<Vec<String>> {
        let mut seal = Seal::default();
        lines
            .iter()
            .map(|line| seal.open(line).map(str::to_owned))
            .collect()
    }

    #[test]
    fn lines_are_read_in_their_order_only() {
        let mut seal = Seal::default();
        let [one, two, three] = ["one", "", "three"].map(|words| seal.line(words).into_bytes());
        let words = opened(&[&one, &two, &three]);
        assert_eq!(words.unwrap(), ["one", "", "three"]);
        for wrong in [[&one, &three], [&two, &three], [&one, &one]] {
            assert_eq!(opened(&[wrong[0], wrong[1]]), None);
        }
    }

    #[test]
    fn no_byte_can_be_changed_removed_or_added() {
        let mut seal = Seal::default();
        let line = seal.line("AbC0").into_bytes();
        for place in 0..line.len() {
            for byte in 0..=u8::MAX {
                let (mut changed, mut added) = (line.clone(), line.clone());
                changed[place] = byte;
                added.insert(place, byte);
                let same = changed == line;
                assert_eq!(opened(&[&changed]).is_some(), same, "{place}: {byte}");
                assert_eq!(opened(&[&added]), None, "{place}: {byte}");
            }
            let mut removed = line.clone();
            removed.remove(place);
            assert_eq!(opened(&[&removed]), None, "{place}");
        }
    }
}
