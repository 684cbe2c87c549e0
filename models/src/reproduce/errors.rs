//! The errors of smooth copies against the exact orbit, thesis (3.7) and (3.8), and their fits e = b εᵃ.

use stickslip::field::Kernel;
use stickslip::report::numerals::{decimals, significant};
use stickslip::report::{Axis, Curve, Marker, Panel};
use stickslip::study::parallel;
use stickslip::study::trade::{self, Fit, Scope};

use super::ReproduceError;
use super::ask::Subject;

/// Factor by which an axis goes on beyond the sizes.
const MARGIN: f64 = 2.0;

/// The errors of the copies of one system beside what the thesis prints of them.
pub(super) struct Measured {
    thesis: &'static Thesis,
    /// The errors of the copies, with the value of the parameter.
    all: Vec<(f64, trade::Curve)>,
}

/// Which of the two errors: (3.7), the absolute maximum of the first state, or (3.8), the free frequency.
type Of = usize;
const EXTREMUM: Of = 0;
pub(super) const FREQUENCY: Of = 1;
/// Both, with the number of their series and their markers.
const BOTH: [(Of, usize, Marker); 2] =
    [(EXTREMUM, 1, Marker::Circle), (FREQUENCY, 2, Marker::Cross)];

/// What the thesis prints of one system, and how it is written.
pub(super) struct Thesis {
    pub(super) kernel: Kernel,
    /// The size of the smoothing.
    pub(super) size: &'static str,
    /// The power of ten at the middle of the sizes.
    pub(super) middle: f64,
    /// The names of both errors, and what is printed of them.
    pub(super) errors: [(&'static str, [Printed; 4]); 2],
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

fn fit(curve: &trade::Curve, of: Of) -> Option<Fit> {
    match of {
        EXTREMUM => curve.max_abs.first().copied().flatten(),
        _ => curve.frequency,
    }
}

fn points(curve: &trade::Curve, of: Of) -> Vec<[f64; 2]> {
    let error = |point: &trade::Point| match of {
        EXTREMUM => point.max_abs.first().copied().unwrap_or(f64::NAN),
        _ => point.frequency,
    };
    let points = curve.points.iter();
    points.map(|p| [p.size, error(p).abs()]).collect()
}

impl Thesis {
    fn panel(&self, curve: &trade::Curve) -> Panel {
        let sizes = || curve.points.iter().map(|point| point.size);
        let least = sizes().fold(f64::INFINITY, f64::min) / MARGIN;
        let most = sizes().fold(0.0, f64::max) * MARGIN;
        let axes = Panel::new(
            Axis::new(self.size).logarithmic().from(least, most),
            Axis::new("relative error").logarithmic(),
        );
        BOTH.into_iter().fold(axes, |panel, (of, series, marker)| {
            let (name, points) = (self.errors[of].0, points(curve, of));
            let Some(Fit { a, b, .. }) = fit(curve, of) else {
                return panel.curve(Curve::points(name, series, marker, points));
            };
            let fitted = points.iter().map(|[size, _]| [*size, b * size.powf(a)]);
            let label = format!(
                "fit {name} = {} *ε*^{{{}}}",
                significant(b, 3),
                decimals(a, 3)
            );
            panel
                .curve(Curve::line(label, series, fitted.collect()))
                .curve(Curve::points(name, series, marker, points))
        })
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
        let printed = &thesis.errors[EXTREMUM].1;
        let found = parallel(printed, |at| subject.trade(at.r, &scope));
        let mut all = Vec::new();
        for (&Printed { r, .. }, trades) in printed.iter().zip(found) {
            let curves = trades?.into_iter().flat_map(|trade| trade.curves);
            all.extend(curves.map(|curve| (r, curve)));
        }
        Ok(Self { thesis, all })
    }

    /// The last fit.
    pub(super) fn last(&self, of: Of) -> Option<Fit> {
        fit(&self.all.last()?.1, of)
    }

    /// Both errors at the last value against the size, with their fits, in double logarithmic scales.
    pub(super) fn against_size(&self) -> Option<Panel> {
        self.all.last().map(|(_, curve)| self.thesis.panel(curve))
    }

    /// The parameters of the fits, first a and then b, and the thesis's.
    pub(super) fn against_parameter(&self) -> [Vec<Curve>; 2] {
        [
            self.fits(|fit| fit.a, |p| p.a),
            self.fits(|fit| fit.b, |p| p.b),
        ]
    }

    fn fits(&self, ours: fn(&Fit) -> f64, theirs: fn(&Printed) -> f64) -> Vec<Curve> {
        let both = BOTH.into_iter().flat_map(|(of, series, marker)| {
            let all = self.all.iter();
            let points = all.filter_map(|(r, curve)| Some([*r, ours(&fit(curve, of)?)]));
            let (name, printed) = &self.thesis.errors[of];
            let thesis = printed.iter().map(|p| [p.r, theirs(p)]);
            let label = format!("{name}, thesis");
            [
                Curve::line(*name, series, points.collect()),
                Curve::points(label, series, marker, thesis.collect()),
            ]
        });
        both.collect()
    }

    /// The fits beside the thesis's.
    pub(super) fn rows(&self) -> Vec<Vec<String>> {
        let errors = self.thesis.errors.iter().enumerate();
        let rows = errors
            .flat_map(|(of, (_, printed))| printed.iter().filter_map(move |p| self.row(of, p)));
        rows.collect()
    }

    fn row(&self, of: Of, p: &Printed) -> Option<Vec<String>> {
        let (_, curve) = self.all.iter().find(|(r, _)| *r == p.r)?;
        let fit = fit(curve, of)?;
        let size = 10f64.powf(self.thesis.middle);
        Some(vec![
            self.thesis.errors[of].0.to_owned(),
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
