//! Outlines as figures write them, as paths of PDF.

use pdf_writer::Content;

/// A quarter of a circle by a cubic: the length of its handles for the radius 1.
const QUARTER: f32 = 0.552_285;

/// Draws along an outline of the commands `M L H V C m l h v a z`; an arc is half a circle from left to right, or back.
pub(super) fn trace(outline: &str, content: &mut Content) {
    let mut pen = Pen {
        at: [0.0; 2],
        start: [0.0; 2],
    };
    let commands = outline
        .char_indices()
        .filter(|(_, c)| c.is_alphabetic() && *c != 'e');
    let places: Vec<(usize, char)> = commands.collect();
    let ends = places
        .iter()
        .skip(1)
        .map(|(i, _)| *i)
        .chain([outline.len()]);
    for (&(begin, command), end) in places.iter().zip(ends) {
        let numbers: Vec<f32> = numbers(&outline[begin + 1..end]);
        pen.draw(command, &numbers, content);
    }
}

/// Numbers between spaces, or with a minus sign between them.
fn numbers(text: &str) -> Vec<f32> {
    let spaced = text.replace('-', " -").replace(',', " ");
    spaced.split_whitespace().flat_map(str::parse).collect()
}

struct Pen {
    at: [f32; 2],
    start: [f32; 2],
}

impl Pen {
    fn draw(&mut self, command: char, numbers: &[f32], content: &mut Content) {
        let [x, y] = self.at;
        match (command, numbers) {
            ('M', &[x, y]) => self.set(x, y, content),
            ('m', &[right, down]) => self.set(x + right, y + down, content),
            ('L', &[x, y]) => self.line(x, y, content),
            ('l', &[right, down]) => self.line(x + right, y + down, content),
            ('H', &[x]) => self.line(x, y, content),
            ('h', &[right]) => self.line(x + right, y, content),
            ('V', &[y]) => self.line(x, y, content),
            ('v', &[down]) => self.line(x, y + down, content),
            ('C', &[x1, y1, x2, y2, x, y]) => self.cubic([x1, y1, x2, y2, x, y], content),
            ('a', &[_, _, _, _, _, right, _]) => self.half(0.5 * right, content),
            ('z' | 'Z', []) => {
                content.close_path();
                self.at = self.start;
            }
            _ => {}
        }
    }

    fn set(&mut self, x: f32, y: f32, content: &mut Content) {
        content.move_to(x, y);
        (self.at, self.start) = ([x, y], [x, y]);
    }

    fn line(&mut self, x: f32, y: f32, content: &mut Content) {
        content.line_to(x, y);
        self.at = [x, y];
    }

    fn cubic(&mut self, [x1, y1, x2, y2, x, y]: [f32; 6], content: &mut Content) {
        content.cubic_to(x1, y1, x2, y2, x, y);
        self.at = [x, y];
    }

    /// Half a circle of this radius: below if it goes to the right, above if it goes back.
    fn half(&mut self, radius: f32, content: &mut Content) {
        let ([x, y], far) = (self.at, QUARTER * radius);
        let (middle, end) = (x + radius, x + 2.0 * radius);
        let down = y + radius;
        self.cubic([x, y + far, middle - far, down, middle, down], content);
        self.cubic([middle + far, down, end, y + far, end, y], content);
    }
}
