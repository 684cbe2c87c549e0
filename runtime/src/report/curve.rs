//! A curve as data: points, and the way to draw them.

/// How many shades there are for values.
pub const SHADES: usize = 9;
/// Colours of series: from there on they come again.
pub const COLOURS: usize = 7;

/// Points to draw and the way to draw them.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct Curve {
    /// What the legend says of it.
    pub label: String,
    /// Number of its colour and line style; curves of different panels that belong together share it.
    pub series: usize,
    /// How its points are drawn.
    pub shape: Shape,
    /// Its points.
    pub points: Vec<[f64; 2]>,
    /// The direction of a smooth line at each point, of any length, where it is known; NaN or nothing elsewhere.
    pub directions: Vec<[f64; 2]>,
    /// When a motion is at each point, if the directions are its rates.
    pub times: Vec<f64>,
    /// What stands beside each point, if anything does.
    pub labels: Vec<String>,
}

/// How the points of a curve are drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// Joined by a line in the style of the series, straight from each to the next.
    Line,
    /// Joined by a smooth line in the style of the series.
    Smooth,
    /// A marker each.
    Points(Marker),
    /// A tile each, of which so many fill the panel side by side, and on top of each other.
    Tiles {
        /// How many.
        fill: [usize; 2],
        /// The number of its shade, where values are shades; else the series has a colour.
        shade: Option<usize>,
    },
}

/// A marker.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Marker {
    /// ○
    Circle,
    /// ×
    Cross,
    /// +
    Plus,
    /// ◇
    Diamond,
    /// □
    Square,
    /// △
    Triangle,
    /// A dot, for clouds of points.
    Dot,
    /// A smaller dot, which leaves a rim of the dot that it covers.
    Speck,
}

impl Curve {
    fn new(
        label: impl Into<String>,
        series: usize,
        shape: Shape,
        points: impl IntoIterator<Item = [f64; 2]>,
    ) -> Self {
        Self {
            label: label.into(),
            series,
            shape,
            points: points.into_iter().collect(),
            directions: Vec::new(),
            times: Vec::new(),
            labels: Vec::new(),
        }
    }

    /// Straight lines from point to point in the style of series number `series`.
    pub fn line(label: impl Into<String>, series: usize, points: Vec<[f64; 2]>) -> Self {
        Self::new(label, series, Shape::Line, points)
    }

    /// A smooth line through points in the style of series number `series`: cubics with the directions that are known,
    /// and with those of parabolas through neighbours elsewhere.
    pub fn smooth(label: impl Into<String>, series: usize, points: Vec<[f64; 2]>) -> Self {
        Self::new(label, series, Shape::Smooth, points)
    }

    /// Tiles in the colour of a series, or else in shade number `shade`, of which `fill` fill the panel.
    pub fn tiles(
        label: impl Into<String>,
        series: Option<usize>,
        shade: usize,
        fill: [usize; 2],
        points: Vec<[f64; 2]>,
    ) -> Self {
        let shade = series.is_none().then_some(shade);
        let tiled = Shape::Tiles { fill, shade };
        Self::new(label, series.unwrap_or(0), tiled, points)
    }

    /// Markers in the colour of series number `series`.
    pub fn points(
        label: impl Into<String>,
        series: usize,
        marker: Marker,
        points: Vec<[f64; 2]>,
    ) -> Self {
        Self::new(label, series, Shape::Points(marker), points)
    }

    /// The same curve, with these directions at its points.
    pub fn directed(self, directions: Vec<[f64; 2]>) -> Self {
        Self { directions, ..self }
    }

    /// The same curve, a motion that is at its points at these times and has its directions for rates.
    pub fn timed(self, times: Vec<f64>) -> Self {
        Self { times, ..self }
    }

    /// The same curve, with words beside its points.
    pub fn labelled(self, labels: Vec<String>) -> Self {
        Self { labels, ..self }
    }
}
