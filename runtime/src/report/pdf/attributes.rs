//! Attributes of elements.

use roxmltree::Node;

/// The move of `translate(x y) rotate(-90)`.
pub(super) fn translation(text: &str) -> Option<[f32; 2]> {
    let inner = text
        .strip_prefix("translate(")?
        .strip_suffix(") rotate(-90)")?;
    let (x, y) = inner.split_once(' ')?;
    Some([x.parse().ok()?, y.parse().ok()?])
}

/// A number; 0 if there is none.
pub(super) fn number(node: Node<'_, '_>, name: &str) -> f32 {
    let text = node.attribute(name).unwrap_or_default();
    text.parse().unwrap_or(0.0)
}

/// Left, top, width and height; shares of the page where they are in per cent.
pub(super) fn corners(node: Node<'_, '_>, size: [f32; 2]) -> [f32; 4] {
    let share = |name: &str, whole: f32| match node.attribute(name) {
        Some("100%") => whole,
        _ => number(node, name),
    };
    let [width, height] = size;
    [
        number(node, "x"),
        number(node, "y"),
        share("width", width),
        share("height", height),
    ]
}

/// A colour; `None` for no paint.
pub(super) fn colour(node: Node<'_, '_>, name: &str) -> Option<[f32; 3]> {
    match node.attribute(name)? {
        "none" => None,
        "white" => Some([1.0; 3]),
        text => {
            let channel = |i: usize| u8::from_str_radix(text.get(i..i + 2)?, 16).ok();
            let known = [1, 3, 5].map(|i| channel(i).unwrap_or(0));
            Some(known.map(|part| f32::from(part) / 255.0))
        }
    }
}
