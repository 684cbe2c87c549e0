//! The errors of smooth copies against the exact orbit, thesis (3.7) and (3.8), and their fits e = b εᵃ.

use stickslip::field::Kernel;
use stickslip::report::{Axis, Curve, Marker, Panel};
use stickslip::study::parallel;
use stickslip::study::trade::{self, Fit, Scope};

use super::ReproduceError;
use super::ask::Subject;
use super::words::{decimals, significant};

/// Factor by which an axis goes on beyond the sizes.
const MARGIN: f64 = 2.0;

/// The errors of one kernel's copies at one value of the parameter.
struct Errors {
    r: f64,
    curve: trade::Curve,
}

/// The errors of the copies of one system beside what the thesis prints of them.
pub(super) struct Measured {
    thesis: &'static Thesis,
    all: Vec<Errors>,
}

/// Which of the two errors.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Of {
    /// (3.7): the absolute maximum of the first state.
    Extremum,
    /// (3.8): the free frequency.
    Frequency,
}

/// What the thesis prints of one system, and how it is written.
pub(super) struct Thesis {
    pub(super) kernel: Kernel,
    /// The error of the extremum.
    pub(super) extremum: &'static str,
    /// The size of the smoothing.
    pub(super) size: &'static str,
    /// The power of ten at the middle of the sizes.
    pub(super) middle: f64,
    pub(super) extrema: [Printed; 4],
    pub(super) frequencies: [Printed; 4],
}

/// A fit at one value of the parameter.
pub(super) struct Printed {
    r: f64,
    a: f64,
    b: f64,
    remark: &'static str,
}

pub(super) const fn printed(r: f64, a: f64, b: f64, remark: &'static str) -> Printed {
    Printed { r, a, b, remark }
}

impl Errors {
    fn fit(&self, of: Of) -> Option<Fit> {
        match of {
            Of::Extremum => self.curve.max_abs.first().copied().flatten(),
            Of::Frequency => self.curve.frequency,
        }
    }

    fn points(&self, of: Of) -> Vec<[f64; 2]> {
        let error = |point: &trade::Point| match of {
            Of::Extremum => point.max_abs.first().copied().unwrap_or(f64::NAN),
            Of::Frequency => point.frequency,
        };
        let points = self.curve.points.iter();
        points.map(|p| [p.size, error(p).abs()]).collect()
    }

    fn panel(&self, thesis: &Thesis) -> Panel {
        let sizes = || self.curve.points.iter().map(|point| point.size);
        let (least, most) = (
            sizes().fold(f64::INFINITY, f64::min),
            sizes().fold(0.0, f64::max),
        );
        let axes = Panel::new(
            Axis::new(thesis.size)
                .logarithmic()
                .from(least / MARGIN, MARGIN * most),
            Axis::new("relative error").logarithmic(),
        );
        Of::BOTH.into_iter().fold(axes, |panel, of| {
            let (name, points) = (of.name(thesis), self.points(of));
            let fitted = self.fit(of).map_or_else(Vec::new, |fit| {
                let at = |point: &[f64; 2]| [point[0], fit.b * point[0].powf(fit.a)];
                points.iter().map(at).collect()
            });
            let label = self.fit(of).map_or_else(String::new, |fit| {
                let (a, b) = (decimals(fit.a, 3), significant(fit.b, 3));
                format!("fit {name} = {b} *ε*^{{{a}}}")
            });
            panel
                .curve(Curve::line(label, of.series(), fitted))
                .curve(Curve::points(name, of.series(), of.marker(), points))
        })
    }
}

impl Of {
    const BOTH: [Self; 2] = [Self::Extremum, Self::Frequency];

    const fn series(self) -> usize {
        match self {
            Self::Extremum => 1,
            Self::Frequency => 2,
        }
    }

    const fn marker(self) -> Marker {
        match self {
            Self::Extremum => Marker::Circle,
            Self::Frequency => Marker::Cross,
        }
    }

    const fn name(self, thesis: &Thesis) -> &'static str {
        match self {
            Self::Extremum => thesis.extremum,
            Self::Frequency => "*e_{f}*",
        }
    }

    const fn printed(self, thesis: &Thesis) -> &[Printed] {
        match self {
            Self::Extremum => &thesis.extrema,
            Self::Frequency => &thesis.frequencies,
        }
    }
}

impl Measured {
    /// The errors at all values of the parameter that the thesis has.
    pub(super) fn measure(
        subject: &Subject,
        thesis: &'static Thesis,
    ) -> Result<Self, ReproduceError> {
        let scope = Scope {
            kernels: vec![thesis.kernel],
            tolerances: Vec::new(),
            ..Scope::default()
        };
        let found = parallel(&thesis.extrema, |at| subject.trade(at.r, &scope));
        let mut all = Vec::new();
        for (&Printed { r, .. }, trades) in thesis.extrema.iter().zip(found) {
            let curves = trades?.into_iter().flat_map(|trade| trade.curves);
            all.extend(curves.map(|curve| Errors { r, curve }));
        }
        Ok(Self { thesis, all })
    }

    /// The last fit.
    pub(super) fn last(&self, of: Of) -> Option<Fit> {
        self.all.last()?.fit(of)
    }

    /// Both errors at the last value against the size, with their fits, in double logarithmic scales.
    pub(super) fn against_size(&self) -> Option<Panel> {
        self.all.last().map(|errors| errors.panel(self.thesis))
    }

    /// The parameters of the fits, first a and then b, and the thesis's.
    pub(super) fn against_parameter(&self) -> [Vec<Curve>; 2] {
        [
            self.fits(|fit| fit.a, |p| p.a),
            self.fits(|fit| fit.b, |p| p.b),
        ]
    }

    fn fits(&self, ours: fn(&Fit) -> f64, theirs: fn(&Printed) -> f64) -> Vec<Curve> {
        let both = Of::BOTH.into_iter().flat_map(|of| {
            let all = self.all.iter();
            let points = all.filter_map(|errors| Some([errors.r, ours(&errors.fit(of)?)]));
            let (series, name) = (of.series(), of.name(self.thesis));
            let thesis = of.printed(self.thesis).iter().map(|p| [p.r, theirs(p)]);
            let label = format!("{name}, thesis");
            [
                Curve::line(name, series, points.collect()),
                Curve::points(label, series, of.marker(), thesis.collect()),
            ]
        });
        both.collect()
    }

    /// The fits beside the thesis's.
    pub(super) fn rows(&self) -> Vec<Vec<String>> {
        let rows = Of::BOTH.into_iter().flat_map(|of| {
            let printed = of.printed(self.thesis).iter();
            printed.filter_map(move |p| self.row(of, p))
        });
        rows.collect()
    }

    fn row(&self, of: Of, p: &Printed) -> Option<Vec<String>> {
        let fit = self.all.iter().find(|errors| errors.r == p.r)?.fit(of)?;
        let size = 10f64.powf(self.thesis.middle);
        Some(vec![
            of.name(self.thesis).to_owned(),
            p.r.to_string(),
            decimals(p.a, 2),
            decimals(fit.a, 3),
            significant(p.b, 2),
            significant(fit.b, 3),
            significant(p.b * size.powf(p.a), 3),
            significant(fit.b * size.powf(fit.a), 3),
            p.remark.to_owned(),
        ])
    }
}
