//! A figure as PDF: the few elements of which our SVG consists, in fonts that every reader has.

mod attributes;
mod letters;
mod outline;
mod words;

use std::collections::HashMap;
use std::io;

use pdf_writer::types::{LineCapStyle, LineJoinStyle};
use pdf_writer::{Content, Finish, Name, Pdf, Rect, Ref, TextStr};
use roxmltree::{Document, Node};

use super::Figure;
use attributes::{colour, corners, number, translation};
use letters::FONTS;

/// A pixel in points.
const POINT: f32 = 0.75;
impl Figure {
    /// The figure as a PDF document of one page, in fonts that every reader has.
    ///
    /// # Errors
    /// A name in it cannot stand in a document.
    pub fn pdf(&self) -> io::Result<Vec<u8>> {
        pdf(&self.svg())
    }
}

fn pdf(svg: &str) -> io::Result<Vec<u8>> {
    let document = Document::parse(svg).map_err(io::Error::other)?;
    let root = document.root_element();
    let [width, height] = ["width", "height"].map(|name| number(root, name));
    let mut page = Page {
        content: Content::new(),
        clips: HashMap::new(),
    };
    let turned = [POINT, 0.0, 0.0, -POINT, 0.0, POINT * height];
    page.content.transform(turned);
    page.children(root, [width, height]);
    let title = root.children().find(|node| node.has_tag_name("title"));
    let title = title.and_then(|title| title.text()).unwrap_or_default();
    let size = [POINT * width, POINT * height];
    Ok(written(&page.content.finish(), size, title))
}

fn written(content: &[u8], [width, height]: [f32; 2], title: &str) -> Vec<u8> {
    let mut pdf = Pdf::new();
    let [catalog, tree, page, stream, info] = [1, 2, 3, 4, 5].map(Ref::new);
    let fonts = [6, 7, 8].map(Ref::new);
    pdf.catalog(catalog).pages(tree);
    pdf.pages(tree).kids([page]).count(1);
    let mut one = pdf.page(page);
    one.media_box(Rect::new(0.0, 0.0, width, height));
    one.parent(tree).contents(stream);
    let mut resources = one.resources();
    let mut known = resources.fonts();
    for ((name, _), font) in FONTS.iter().zip(fonts) {
        known.pair(*name, font);
    }
    known.finish();
    resources.finish();
    one.finish();
    for ((_, base), font) in FONTS.iter().zip(fonts) {
        let mut described = pdf.type1_font(font);
        described.base_font(*base);
        if base.0 != b"Symbol" {
            described.encoding_predefined(Name(b"WinAnsiEncoding"));
        }
    }
    pdf.document_info(info).title(TextStr(title));
    pdf.stream(stream, content);
    pdf.finish()
}

/// A page that is drawn.
struct Page {
    content: Content,
    /// The rectangles to which curves are cut.
    clips: HashMap<String, [f32; 4]>,
}

impl Page {
    fn children(&mut self, node: Node<'_, '_>, size: [f32; 2]) {
        for child in node.children().filter(Node::is_element) {
            match child.tag_name().name() {
                "g" => self.group(child, size),
                "rect" => self.rectangle(child, size),
                "path" => self.path(child),
                "text" => words::write(child, &mut self.content),
                "clipPath" => self.clip(child, size),
                _ => {}
            }
        }
    }

    /// A group, moved and turned by a quarter if it says so.
    fn group(&mut self, node: Node<'_, '_>, size: [f32; 2]) {
        self.content.save_state();
        if let Some([x, y]) = node.attribute("transform").and_then(translation) {
            self.content.transform([0.0, -1.0, 1.0, 0.0, x, y]);
        }
        self.children(node, size);
        self.content.restore_state();
    }

    fn clip(&mut self, node: Node<'_, '_>, size: [f32; 2]) {
        let area = node.children().find(|child| child.has_tag_name("rect"));
        if let (Some(name), Some(area)) = (node.attribute("id"), area) {
            self.clips
                .insert(format!("url(#{name})"), corners(area, size));
        }
    }

    fn rectangle(&mut self, node: Node<'_, '_>, size: [f32; 2]) {
        let [x, y, width, height] = corners(node, size);
        self.content.save_state();
        let inked = self.ink(node);
        let stroked = self.pen(node);
        self.content.rect(x, y, width, height);
        self.paint(inked, stroked);
        self.content.restore_state();
    }

    /// With what an area is filled; false if it is not.
    fn ink(&mut self, node: Node<'_, '_>) -> bool {
        let filled = colour(node, "fill");
        if let Some([red, green, blue]) = filled {
            self.content.set_fill_rgb(red, green, blue);
        }
        filled.is_some()
    }

    /// Ends an outline.
    fn paint(&mut self, inked: bool, stroked: bool) {
        match (inked, stroked) {
            (true, true) => self.content.fill_nonzero_and_stroke(),
            (true, false) => self.content.fill_nonzero(),
            (false, true) => self.content.stroke(),
            (false, false) => self.content.end_path(),
        };
    }

    fn path(&mut self, node: Node<'_, '_>) {
        self.content.save_state();
        let clip = node
            .attribute("clip-path")
            .and_then(|name| self.clips.get(name));
        if let Some(&[x, y, width, height]) = clip {
            self.content
                .rect(x, y, width, height)
                .clip_nonzero()
                .end_path();
        }
        let inked = self.ink(node);
        let stroked = self.pen(node);
        outline::trace(node.attribute("d").unwrap_or_default(), &mut self.content);
        self.paint(inked, stroked);
        self.content.restore_state();
    }

    /// How an outline is drawn; false if it is not.
    fn pen(&mut self, node: Node<'_, '_>) -> bool {
        let Some([red, green, blue]) = colour(node, "stroke") else {
            return false;
        };
        self.content.set_stroke_rgb(red, green, blue);
        let width = node
            .attribute("stroke-width")
            .map_or(1.0, |_| number(node, "stroke-width"));
        self.content.set_line_width(width);
        if node.attribute("stroke-linejoin") == Some("round") {
            self.content.set_line_join(LineJoinStyle::RoundJoin);
        }
        if node.attribute("stroke-linecap") == Some("round") {
            self.content.set_line_cap(LineCapStyle::RoundCap);
        }
        let dashes = node.attribute("stroke-dasharray").unwrap_or_default();
        let dashes: Vec<f32> = dashes.split(' ').flat_map(str::parse).collect();
        self.content.set_dash_pattern(dashes, 0.0);
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::{Axis, Curve, Marker, Panel};

    #[test]
    fn all_that_is_drawn_is_in_the_document() {
        let points = vec![[0.0, 1.0], [1.0, 2.0], [2.0, 0.5]];
        let panel = Panel::new(Axis::new("*ω*_{0} (1/s)"), Axis::new("|x₁|"))
            .curve(Curve::smooth("line", 1, points.clone()))
            .curve(Curve::points("marks", 2, Marker::Circle, points).labelled(vec!["PD1".into()]));
        let figure = Figure::new("1", "A <title>", "").panel(panel);
        let bytes = figure.pdf().unwrap();
        let text = String::from_utf8_lossy(&bytes);
        assert!(text.starts_with("%PDF-"));
        for part in [
            "(marks) Tj",
            "(PD1) Tj",
            "(line) Tj",
            "/Helvetica-Oblique",
            "/F3",
            "(w) Tj",
            "A <title>",
        ] {
            assert!(text.contains(part), "{part}: {text}");
        }
        // A cubic for each stretch of the line, and four for each circle, in the legend, too.
        assert_eq!(text.matches(" c\n").count(), 2 + 4 * 4);
    }

    #[test]
    fn tiles_are_filled_with_their_shades() {
        let tiles = Curve::tiles("low", None, 0, [2, 1], vec![[0.0, 0.0], [1.0, 0.0]]);
        let panel = Panel::new(Axis::new("x"), Axis::new("y")).curve(tiles);
        let bytes = Figure::new("1", "", "").panel(panel).pdf().unwrap();
        let text = String::from_utf8_lossy(&bytes);
        let shade = "0.019607844 0.015686275 0.09019608 rg";
        // In the panel and in the legend; each tile ends with a closed outline, and areas with their paint.
        assert_eq!(text.matches(shade).count(), 2, "{text}");
        assert!(text.matches("h\nf\n").count() >= 2, "{text}");
    }

    #[test]
    fn outlines_are_traced_to_their_ends() {
        let mut content = Content::new();
        outline::trace(
            "M1 2H5V-6l1-1m-1 0h0zC1 2 3 4 5 6a4 4 0 1 0 8 0",
            &mut content,
        );
        let path = String::from_utf8_lossy(&content.finish()).into_owned();
        for step in [
            "1 2 m",
            "5 2 l",
            "5 -6 l",
            "6 -7 l",
            "5 -7 m",
            "5 -7 l",
            "h",
            "1 2 3 4 5 6 c",
            "9 10 c",
            "13 6 c",
        ] {
            assert!(path.contains(step), "{step}: {path}");
        }
    }
}
