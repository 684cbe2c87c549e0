//! A figure as data: panels of curves, not yet drawn.

use super::curve::Curve;

/// A numbered figure.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct Figure {
    /// Its number, for instance `3.2`; also names its files.
    pub number: String,
    /// A few words.
    pub title: String,
    /// What to see in it.
    pub caption: String,
    /// Its panels, in reading order.
    pub panels: Vec<Panel>,
    /// Panels side by side.
    pub columns: usize,
}

/// One pair of axes with its curves.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct Panel {
    /// What tells it from its neighbours; empty if it stands alone.
    pub title: String,
    /// The horizontal axis.
    pub x: Axis,
    /// The vertical axis.
    pub y: Axis,
    /// What is drawn, back to front.
    pub curves: Vec<Curve>,
    /// A part of it, enlarged where nothing else is drawn.
    pub inset: Option<Inset>,
}

/// A part of a panel, enlarged.
#[derive(Debug, Clone, PartialEq)]
pub struct Inset {
    /// What of the horizontal axis.
    pub x: [f64; 2],
    /// What of the vertical axis.
    pub y: [f64; 2],
    /// Where it stands: the left, upper, right and lower end in shares of the panel, from its upper left corner.
    pub place: [f64; 4],
}

/// An axis.
#[derive(Debug, Clone, PartialEq)]
#[must_use]
pub struct Axis {
    /// What it measures, with its unit.
    pub label: String,
    /// Its ends, if the data shall not decide.
    pub range: Option<[f64; 2]>,
    /// Whether it is logarithmic.
    pub logarithmic: bool,
    /// Whether it counts: between whole numbers there is nothing to mark.
    pub counts: bool,
}

impl Figure {
    /// A figure without panels yet.
    pub fn new(number: &str, title: &str, caption: impl Into<String>) -> Self {
        Self {
            number: number.to_owned(),
            title: title.to_owned(),
            caption: caption.into(),
            panels: Vec::new(),
            columns: 1,
        }
    }

    /// The same figure with one more panel.
    pub fn panel(mut self, panel: Panel) -> Self {
        self.panels.push(panel);
        self
    }

    /// The same figure, this many panels side by side.
    pub fn columns(mut self, columns: usize) -> Self {
        self.columns = columns.max(1);
        self
    }

    /// Its name in files and links: `figure-3-2`.
    #[must_use]
    pub fn name(&self) -> String {
        format!("figure-{}", self.number.replace('.', "-"))
    }

    /// The name of panel number `index` in files: `figure-3-2`, or `figure-3-3b` of several.
    #[must_use]
    pub fn panel_name(&self, index: usize) -> String {
        let letter = (b'a'..=b'z').nth(index).map_or('z', char::from);
        if self.panels.len() == 1 {
            self.name()
        } else {
            format!("{}{letter}", self.name())
        }
    }
}

impl Panel {
    /// A panel without curves yet.
    pub fn new(x: Axis, y: Axis) -> Self {
        Self {
            title: String::new(),
            x,
            y,
            curves: Vec::new(),
            inset: None,
        }
    }

    /// Whether the legend says anything of its curves.
    pub(super) fn is_named(&self) -> bool {
        self.curves.iter().any(|curve| !curve.label.is_empty())
    }

    /// The same panel with a part of it enlarged.
    pub fn inset(self, inset: Inset) -> Self {
        Self {
            inset: Some(inset),
            ..self
        }
    }

    /// The panel that an inset of it is.
    pub(super) fn enlarged(&self, inset: &Inset) -> Self {
        let axis = |axis: &Axis, range| Axis {
            label: String::new(),
            range: Some(range),
            ..axis.clone()
        };
        Self {
            title: String::new(),
            x: axis(&self.x, inset.x),
            y: axis(&self.y, inset.y),
            curves: self.curves.clone(),
            inset: None,
        }
    }

    /// The same panel, titled.
    pub fn titled(mut self, title: impl Into<String>) -> Self {
        self.title = title.into();
        self
    }

    /// The same panel with one more curve in front.
    pub fn curve(mut self, curve: Curve) -> Self {
        self.curves.push(curve);
        self
    }

    /// The same panel with more curves in front.
    pub fn curves(mut self, curves: impl IntoIterator<Item = Curve>) -> Self {
        self.curves.extend(curves);
        self
    }
}

impl Axis {
    /// A linear axis whose ends the data decide.
    pub fn new(label: &str) -> Self {
        Self {
            label: label.to_owned(),
            range: None,
            logarithmic: false,
            counts: false,
        }
    }

    /// The same axis from `low` to `high`.
    pub fn from(mut self, low: f64, high: f64) -> Self {
        self.range = Some([low, high]);
        self
    }

    /// The same axis, of whole numbers.
    pub fn counting(mut self) -> Self {
        self.counts = true;
        self
    }

    /// The same axis, logarithmic.
    pub fn logarithmic(mut self) -> Self {
        self.logarithmic = true;
        self
    }
}
