//! A pair of axes: its frame, ticks and labels, and the curves in it.

use super::element::{path, words};
use super::scale::Scale;
use super::ticks::Tick;
use super::{beside, curve};
use crate::report::figure::Panel;
use crate::report::text::{self, number, width};

/// Sizes of the labels of ticks and of axes, px.
const TICK: f64 = 12.0;
const LABEL: f64 = 13.0;
/// Free space around a frame, px: above, to the right, and below with its labels.
const ABOVE: f64 = 10.0;
const RIGHT: f64 = 22.0;
const BELOW: f64 = 48.0;
/// Free space between labels, px.
const GAP: f64 = 14.0;
/// From a frame to what its ticks say, px.
const MARK: f64 = 7.0;
/// From the left end of a panel to the foot of its vertical label, px.
const EDGE: f64 = 16.0;
/// Least distances of labelled ticks on both axes, px.
const APART: [f64; 2] = [44.0, 28.0];
/// No renderer draws what is further away, px.
const FAR: f64 = 1e5;

const GRID: &str = r##"stroke="#d0d0d0" stroke-width="0.5""##;
const LINES: &str = r#"stroke="black" stroke-width="0.8""#;

/// A panel and its place in the figure, px.
pub(super) struct Frame<'a> {
    panel: &'a Panel,
    x: Scale,
    y: Scale,
    /// The foot of the vertical label.
    edge: f64,
    left: f64,
    right: f64,
    top: f64,
    bottom: f64,
}

/// The space that a panel of this height needs to the left of its frame, px.
pub(super) fn margin(panel: &Panel, height: f64) -> f64 {
    let ticks = upright(&scale(panel, 1), height - ABOVE - BELOW);
    let widths = ticks.iter().map(|tick| TICK * width(&tick.label));
    widths.fold(0.0, f64::max) + EDGE + GAP + MARK
}

fn scale(panel: &Panel, column: usize) -> Scale {
    let points = panel.curves.iter().flat_map(|curve| &curve.points);
    let axis = [&panel.x, &panel.y][column];
    Scale::new(axis, points.map(|point| point[column]))
}

/// The ticks of a vertical axis of this length, px.
fn upright(scale: &Scale, length: f64) -> Vec<Tick> {
    scale.ticks(|ticks| {
        let place = |tick: &Tick| length * scale.share(tick.value);
        let mut pairs = ticks.windows(2);
        pairs.all(|pair| place(&pair[1]) - place(&pair[0]) >= APART[1])
    })
}

/// A place as far away as renderers can draw at most; what has none keeps none.
const fn near(at: f64) -> f64 {
    if at.is_finite() {
        at.clamp(-FAR, FAR)
    } else {
        at
    }
}

fn rectangle([left, top, right, bottom]: [f64; 4], attributes: &str) -> String {
    let [x, y, width, height] = [left, top, right - left, bottom - top].map(number);
    format!(r#"<rect x="{x}" y="{y}" width="{width}" height="{height}" {attributes}/>"#)
}

impl<'a> Frame<'a> {
    /// The frame of a panel in a cell of the figure; `margin` is left of it.
    pub(super) fn new(
        panel: &'a Panel,
        [x, y]: [f64; 2],
        [width, height]: [f64; 2],
        margin: f64,
    ) -> Self {
        Self {
            panel,
            x: scale(panel, 0),
            y: scale(panel, 1),
            edge: x + EDGE,
            left: x + margin,
            right: x + width - RIGHT,
            top: y + ABOVE,
            bottom: y + height - BELOW,
        }
    }

    /// Where a point is drawn, px; not finite if nowhere.
    pub(super) fn place(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        [self.across(x), self.up(y)]
    }

    /// A direction at a point as it is drawn.
    pub(super) fn direction(&self, [x, y]: [f64; 2], [along, up]: [f64; 2]) -> [f64; 2] {
        let [width, height] = [self.right - self.left, self.bottom - self.top];
        [
            along * self.x.rate(x) * width,
            -up * self.y.rate(y) * height,
        ]
    }

    fn across(&self, x: f64) -> f64 {
        near(self.left + self.x.share(x) * (self.right - self.left))
    }

    fn up(&self, y: f64) -> f64 {
        near(self.bottom - self.y.share(y) * (self.bottom - self.top))
    }

    /// Its width and height.
    pub(super) fn size(&self) -> [f64; 2] {
        [self.right - self.left, self.bottom - self.top]
    }

    /// Whether a place is inside, or less than a pixel outside.
    pub(super) fn holds(&self, [x, y]: [f64; 2]) -> bool {
        (self.left - 1.0..self.right + 1.0).contains(&x)
            && (self.top - 1.0..self.bottom + 1.0).contains(&y)
    }

    /// The panel; what it needs identifiers for begins with `name`.
    pub(super) fn draw(&self, name: &str) -> String {
        let clip = format!("{name}-clip");
        let curves = self.panel.curves.iter();
        let curves: String = curves.map(|one| curve::draw(one, self, &clip)).collect();
        let [left, top] = [self.left, self.top].map(number);
        let [width, height] = [self.right - self.left, self.bottom - self.top].map(number);
        let [x_label, y_label] = [&self.panel.x, &self.panel.y];
        let what = [y_label, x_label].map(|axis| text::escape(&text::plain(&axis.label)));
        format!(
            r#"<g role="group" aria-label="{}"><clipPath id="{clip}"><rect x="{left}" y="{top}" width="{width}" height="{height}"/></clipPath>{}{curves}{}{}</g>"#,
            what.join(" against "),
            self.axes(),
            beside::draw(self.panel, self),
            self.labels(),
        ) + &self.inset(name)
    }

    /// The part that is enlarged, and where it is from.
    fn inset(&self, name: &str) -> String {
        let Some(inset) = &self.panel.inset else {
            return String::new();
        };
        let panel = self.panel.enlarged(inset);
        let [width, height] = [self.right - self.left, self.bottom - self.top];
        let [left, top, right, bottom] = inset.place;
        let [left, right] = [left, right].map(|share| self.left + share * width);
        let [top, bottom] = [top, bottom].map(|share| self.top + share * height);
        let ticks = margin(&panel, bottom - top) - EDGE;
        let frame = Frame {
            panel: &panel,
            x: scale(&panel, 0),
            y: scale(&panel, 1),
            edge: left,
            left: left + ticks,
            right: right - GAP,
            top: top + MARK,
            bottom: bottom - 1.8 * TICK,
        };
        let [x0, x1] = inset.x.map(|x| self.across(x));
        let [y0, y1] = inset.y.map(|y| self.up(y));
        rectangle([left, top, right, bottom], r#"fill="white""#)
            + &rectangle([x0, y1, x1, y0], r##"fill="none" stroke="#808080""##)
            + &frame.draw(&format!("{name}-inset"))
    }

    /// Grid, frame, ticks and what they say.
    fn axes(&self) -> String {
        let [left, right, top, bottom] = [self.left, self.right, self.top, self.bottom].map(number);
        let (mut grid, mut texts) = (String::new(), String::new());
        let mut lines = format!("M{left} {top}H{right}V{bottom}H{left}Z");
        for tick in self.flat() {
            let x = number(self.across(tick.value));
            grid += &format!("M{x} {top}V{bottom}");
            lines += &format!("M{x} {bottom}v-5");
            let place = [self.centre(&tick), self.bottom + 1.4 * TICK];
            texts += &words(&tick.label, place, TICK, "middle");
        }
        for tick in upright(&self.y, self.bottom - self.top) {
            let at = self.up(tick.value);
            let y = number(at);
            grid += &format!("M{left} {y}H{right}");
            lines += &format!("M{left} {y}h5");
            let place = [self.left - MARK, at + 0.36 * TICK];
            texts += &words(&tick.label, place, TICK, "end");
        }
        for x in self.x.unlabelled() {
            lines += &format!("M{} {bottom}v-2.5", number(self.across(x)));
        }
        for y in self.y.unlabelled() {
            lines += &format!("M{left} {}h2.5", number(self.up(y)));
        }
        path(&grid, GRID) + &path(&lines, LINES) + &texts
    }

    /// The ticks of the horizontal axis: no label touches its neighbour.
    fn flat(&self) -> Vec<Tick> {
        self.x.ticks(|ticks| {
            ticks.windows(2).all(|pair| {
                let [from, to] = [&pair[0], &pair[1]];
                let half = |tick: &Tick| 0.5 * TICK * width(&tick.label);
                let apart = (half(from) + GAP + half(to)).max(APART[0]);
                self.centre(to) - self.centre(from) >= apart
            })
        })
    }

    /// The middle of the label of a horizontal tick: under it, unless it would leave the cell.
    fn centre(&self, tick: &Tick) -> f64 {
        let last = self.right + RIGHT - 0.5 * TICK * width(&tick.label);
        self.across(tick.value).min(last)
    }

    /// The title and what the axes measure, small enough not to reach far over the frame's ends.
    fn labels(&self) -> String {
        let Panel { title, x, y, .. } = self.panel;
        let [across, up] = [self.right - self.left, self.bottom - self.top];
        let middle = self.left + 0.5 * across;
        let fitted = |label: &str, place: [f64; 2], room: f64| {
            let size = LABEL.min((room + RIGHT) / width(label));
            words(label, place, size, "middle")
        };
        let [edge, half] = [self.edge, self.top + 0.5 * up].map(number);
        format!(
            r#"{}{}<g transform="translate({edge} {half}) rotate(-90)">{}</g>"#,
            fitted(title, [middle, self.top - ABOVE], across),
            fitted(&x.label, [middle, self.bottom + BELOW - GAP], across),
            fitted(&y.label, [0.0, 0.0], up),
        )
    }
}
