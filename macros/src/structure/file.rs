//! The file of a reduced structure, as `stickslip reduce` writes it.

use std::str::SplitWhitespace;

/// Modes of modal mass 1, by what there is of them at the points.
#[derive(Debug, PartialEq)]
pub(crate) struct Reduced {
    /// Whether its numbers are in units of the SI; otherwise their units are not known.
    pub(crate) si: bool,
    pub(crate) points: Vec<Point>,
    pub(crate) modes: Vec<Mode>,
    /// What the points give way under their own unit loads, the modes apart.
    pub(crate) residual: Vec<f64>,
}

#[derive(Debug, PartialEq)]
pub(crate) struct Point {
    pub(crate) name: String,
    /// Whether it is a rotation.
    pub(crate) turns: bool,
}

#[derive(Debug, PartialEq)]
pub(crate) struct Mode {
    /// Angular, undamped.
    pub(crate) frequency: f64,
    pub(crate) damping: f64,
    pub(crate) shape: Vec<f64>,
}

const HEADING: &str = "stickslip structure 1";

impl Reduced {
    /// Reads the text of such a file; or says at which line it makes no sense.
    pub(crate) fn read(text: &str) -> Result<Self, String> {
        let mut lines = text.lines().enumerate();
        if lines.next().map(|(_, line)| line.trim()) != Some(HEADING) {
            return Err(format!(
                "is no reduced structure: its first line is not `{HEADING}`"
            ));
        }
        let mut read = Self {
            si: false,
            points: Vec::new(),
            modes: Vec::new(),
            residual: Vec::new(),
        };
        for (index, line) in lines {
            read.line(line)
                .map_err(|what| format!("makes no sense at line {}: {what}", index + 1))?;
        }
        read.whole()?;
        Ok(read)
    }

    fn line(&mut self, line: &str) -> Result<(), String> {
        let mut words = line.split_whitespace();
        match words.next() {
            None | Some("method" | "unknowns" | "source") => {}
            Some("units") => self.si = words.next() == Some("SI"),
            Some("point") => {
                let name = words.next().ok_or("a point has a name")?.to_owned();
                let place = words.next().unwrap_or_default();
                let turns = place.split_once(":r").is_some();
                self.points.push(Point { name, turns });
            }
            Some("mode") => {
                let mut all = numbers(words)?.into_iter();
                let (frequency, damping) = (all.next(), all.next());
                let (frequency, damping) = frequency
                    .zip(damping)
                    .ok_or("a mode has a frequency and a damping ratio")?;
                if frequency < 0.0 || damping < 0.0 {
                    return Err("frequency and damping are not negative".to_owned());
                }
                let shape = all.collect();
                self.modes.push(Mode {
                    frequency,
                    damping,
                    shape,
                });
            }
            Some("residual") => {
                let row = numbers(words)?;
                let own = row.get(self.residual.len()).copied();
                self.residual
                    .push(own.ok_or("a residual has a number for each point")?);
            }
            Some(other) => return Err(format!("`{other}` begins no line")),
        }
        Ok(())
    }

    fn whole(&self) -> Result<(), String> {
        let count = self.points.len();
        if self.modes.is_empty() {
            return Err("has no mode".to_owned());
        }
        if let Some(mode) = self.modes.iter().find(|mode| mode.shape.len() != count) {
            let found = mode.shape.len();
            return Err(format!(
                "has {count} points, but a mode with {found} displacements"
            ));
        }
        if self.residual.len() != count {
            let found = self.residual.len();
            return Err(format!(
                "has {count} points, but {found} lines of residual flexibility"
            ));
        }
        Ok(())
    }
}

fn numbers(words: SplitWhitespace<'_>) -> Result<Vec<f64>, String> {
    let read = |word: &str| match word.parse::<f64>() {
        Ok(value) if value.is_finite() && value.abs() < 1e100 => Ok(value),
        _ => Err(format!("`{word}` is no finite number")),
    };
    words.map(read).collect()
}

#[cfg(test)]
mod tests {
    use super::Reduced;

    #[test]
    fn what_is_missing_is_told() {
        let cases = [
            ("", "first line"),
            ("stickslip structure 1\nunits SI\n", "has no mode"),
            (
                "stickslip structure 1\npoint tip 1:y\nmode 1 0 1 2\nresidual 0\n",
                "displacements",
            ),
            (
                "stickslip structure 1\npoint tip 1:y\nmode 1 0 1\n",
                "residual flexibility",
            ),
            ("stickslip structure 1\nmode 1\n", "line 2"),
            ("stickslip structure 1\nmode nan 0\n", "`nan`"),
            ("stickslip structure 1\nmode 1 -1\n", "not negative"),
            (
                "stickslip structure 1\nmodes 1 0\n",
                "`modes` begins no line",
            ),
        ];
        for (text, part) in cases {
            let error = Reduced::read(text).unwrap_err();
            assert!(error.contains(part), "{text:?}: {error}");
        }
    }

    #[test]
    fn rotations_are_known() {
        let text = "stickslip structure 1\nunits SI\npoint tip 1:rz\npoint end 2:y\nmode 1 0 1 2\nresidual 0 0\nresidual 0 3\n";
        let read = Reduced::read(text).unwrap();
        assert!(read.points[0].turns && !read.points[1].turns && read.si);
        assert_eq!(read.residual, [0.0, 3.0]);
    }
}
