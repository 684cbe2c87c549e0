//! The errors of smooth copies against the exact orbit, thesis (3.7) and (3.8), and their fits e = b εᵃ.

use stickslip::field::Kernel;
use stickslip::flow::ExactFamily;
use stickslip::integrate::Tolerance;
use stickslip::model::Model;
use stickslip::report::{Axis, Column, Curve, Figure, Marker, Panel, Table};
use stickslip::shooting::closest;
use stickslip::study::trade::{self, Fit, Scope, Trade};

use super::follow::{FollowError, search};
use super::words::{decimals, significant};

/// Accuracy of the exact orbit against which copies are measured.
const ACCURACY: f64 = 1e-11;

/// Factor by which an axis goes on beyond the sizes.
const MARGIN: f64 = 2.0;

/// The errors of one kernel's copies at one value of the parameter.
pub(super) struct Errors {
    pub(super) r: f64,
    pub(super) curve: trade::Curve,
}

/// Which of the two errors.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Of {
    /// (3.7): the absolute maximum of the first state.
    Extremum,
    /// (3.8): the free frequency.
    Frequency,
}

/// A column of the thesis's tables of fits.
pub(super) struct Printed {
    pub(super) of: Of,
    pub(super) r: f64,
    pub(super) a: f64,
    pub(super) b: f64,
    pub(super) remark: &'static str,
}

/// How a model's errors are written.
pub(super) struct Names {
    /// The error of the extremum.
    pub(super) extremum: &'static str,
    /// The size of the smoothing.
    pub(super) size: &'static str,
    /// The parameter, in a column.
    pub(super) parameter: &'static str,
    /// The parameter, on an axis.
    pub(super) axis: &'static str,
}

/// Smooth copies of `model` against its exact orbit near `start`.
pub(super) fn trade<M: Model<N>, const N: usize>(
    model: &M,
    start: [f64; N],
    scope: &Scope,
) -> Result<Trade, FollowError> {
    let family = ExactFamily {
        model: *model,
        design: None,
        tolerance: Tolerance::for_accuracy(ACCURACY),
        magnitude: [1.0; N],
    };
    let mut tight = search(start, None);
    tight.accuracy = ACCURACY;
    let orbit = closest(&family, 0.0, &tight)?;
    Ok(trade::trade(model, &orbit, scope)?)
}

/// The errors of all copies of one kernel at the usual sizes.
pub(super) fn measure<M: Model<N>, const N: usize>(
    model: &M,
    (r, start): (f64, [f64; N]),
    kernel: Kernel,
) -> Result<Errors, FollowError> {
    let scope = Scope {
        kernels: vec![kernel],
        tolerances: Vec::new(),
        ..Scope::default()
    };
    let curve = trade(model, start, &scope)?.curves.into_iter().next();
    let curve = curve.ok_or(FollowError::NoCopies)?;
    Ok(Errors { r, curve })
}

impl Errors {
    pub(super) fn fit(&self, of: Of) -> Option<Fit> {
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

    const fn name(self, names: &Names) -> &'static str {
        match self {
            Self::Extremum => names.extremum,
            Self::Frequency => "*e_{f}*",
        }
    }
}

/// Both errors against the size, with their fits, in double logarithmic scales.
pub(super) fn against_size(errors: &Errors, names: &Names) -> Panel {
    let sizes = || errors.curve.points.iter().map(|point| point.size);
    let (least, most) = (
        sizes().fold(f64::INFINITY, f64::min),
        sizes().fold(0.0, f64::max),
    );
    let axes = Panel::new(
        Axis::new(names.size)
            .logarithmic()
            .from(least / MARGIN, MARGIN * most),
        Axis::new("relative error").logarithmic(),
    );
    Of::BOTH.into_iter().fold(axes, |panel, of| {
        let (name, points) = (of.name(names), errors.points(of));
        let fitted = errors.fit(of).map_or_else(Vec::new, |fit| {
            let at = |point: &[f64; 2]| [point[0], fit.b * point[0].powf(fit.a)];
            points.iter().map(at).collect()
        });
        let label = errors.fit(of).map_or_else(String::new, |fit| {
            let (a, b) = (decimals(fit.a, 3), significant(fit.b, 3));
            format!("fit {name} = {b} *ε*^{{{a}}}")
        });
        panel
            .curve(Curve::line(label, of.series(), fitted))
            .curve(Curve::points(name, of.series(), of.marker(), points))
    })
}

/// The parameters of the fits, a at the left and b at the right, and the thesis's.
pub(super) fn against_parameter(
    figure: Figure,
    all: &[Errors],
    printed: &[Printed],
    names: &Names,
) -> Figure {
    let panel = |label, ours: fn(&Fit) -> f64, theirs: fn(&Printed) -> f64| {
        let axes = Panel::new(Axis::new(names.axis), Axis::new(label));
        Of::BOTH.into_iter().fold(axes, |panel, of| {
            let points = all
                .iter()
                .filter_map(|errors| Some([errors.r, ours(&errors.fit(of)?)]));
            let thesis = printed.iter().filter(|p| p.of == of);
            let name = of.name(names);
            panel
                .curve(Curve::line(name, of.series(), points.collect()))
                .curve(Curve::points(
                    format!("{name}, thesis"),
                    of.series(),
                    of.marker(),
                    thesis.map(|p| [p.r, theirs(p)]).collect(),
                ))
        })
    };
    figure
        .columns(2)
        .panel(panel("exponent *a*", |fit| fit.a, |p| p.a))
        .panel(panel("factor *b*", |fit| fit.b, |p| p.b))
}

/// The fits beside the thesis's; `middle` is the power of ten at the middle of the sizes.
pub(super) fn table(
    (name, caption): (&str, String),
    all: &[Errors],
    printed: &[Printed],
    names: &Names,
    middle: f64,
) -> Table {
    let power = decimals(middle, usize::from(middle.fract() != 0.0));
    let columns = [
        Column::words("error"),
        Column::numbers(names.parameter),
        Column::numbers("*a*, thesis"),
        Column::numbers("here"),
        Column::numbers("*b*, thesis"),
        Column::numbers("here"),
        Column::numbers(&format!("*e* at *ε* = 10^{{{power}}}, thesis")),
        Column::numbers("here"),
        Column::words("remark"),
    ];
    let size = 10f64.powf(middle);
    let rows = printed.iter().filter_map(|p| {
        let fit = all.iter().find(|errors| errors.r == p.r)?.fit(p.of)?;
        Some(vec![
            p.of.name(names).to_owned(),
            p.r.to_string(),
            decimals(p.a, 2),
            decimals(fit.a, 3),
            significant(p.b, 2),
            significant(fit.b, 3),
            significant(p.b * size.powf(p.a), 3),
            significant(fit.b * size.powf(fit.a), 3),
            p.remark.to_owned(),
        ])
    });
    Table::new(name, caption, columns).rows(rows)
}
