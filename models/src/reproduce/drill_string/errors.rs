//! Figs. 4.5 and 4.9: how far the copies are from the exact orbit.

use stickslip::field::Kernel;
use stickslip::study::report::{Figure, Table};

use super::super::ReproduceError;
use super::super::errors::{
    self, Errors, Names, Of, Printed, against_parameter, against_size, measure,
};
use super::super::parallel::parallel;
use crate::DrillString;

/// The thesis's table speeds.
const SPEEDS: [f64; 4] = [1.0, 2.0, 3.0, 4.0];
const NAMES: Names = Names {
    extremum: "*e_{ψ}*",
    size: "size of the smoothing *ε*",
    parameter: "*η*",
    axis: "speed of the rotary table *η*",
};

const fn printed(of: Of, r: f64, a: f64, b: f64, remark: &'static str) -> Printed {
    Printed {
        of,
        r,
        a,
        b,
        remark,
    }
}

const PRINTED: [Printed; 8] = [
    printed(Of::Extremum, 1.0, 0.63, 0.30, ""),
    printed(Of::Extremum, 2.0, 0.55, 0.25, ""),
    printed(Of::Extremum, 3.0, 0.54, 0.28, ""),
    printed(Of::Extremum, 4.0, 0.59, 0.30, ""),
    printed(Of::Frequency, 1.0, 0.63, 0.22, ""),
    printed(Of::Frequency, 2.0, 0.51, 0.16, ""),
    printed(Of::Frequency, 3.0, 0.46, 0.093, ""),
    printed(Of::Frequency, 4.0, 0.62, 0.086, ""),
];

/// The errors at all speeds.
pub(super) fn all() -> Result<Vec<Errors>, ReproduceError> {
    let at = |&eta: &f64| {
        let model = DrillString {
            eta,
            ..DrillString::default()
        };
        let what = ReproduceError::at(format!("errors of the copies at eta = {eta}"));
        measure(&model, (eta, [0.0, eta]), Kernel::Quartic).map_err(what)
    };
    parallel(&SPEEDS, at).into_iter().collect()
}

pub(super) fn figure_5(all: &[Errors]) -> Figure {
    let figure = Figure::new(
        "4.5",
        "Errors of the copies at *η* = 4",
        "Relative errors of the largest twist, *e_{ψ}*, and of the frequency, *e_{f}*, against the exact orbit, and \
         straight lines fitted to their logarithms. Here a smaller size is nearer to the exact law.",
    );
    let last = all.last().map(|errors| against_size(errors, &NAMES));
    last.into_iter().fold(figure, Figure::panel)
}

pub(super) fn figure_9(all: &[Errors]) -> Figure {
    let figure = Figure::new(
        "4.9",
        "Parameters *a* and *b* of the fits *e* = *b* *ε*^{*a*}",
        "Lines: here; markers: the thesis. As with the belt, the factor grows as the table slows down. The exponent \
         does not fall towards the middle, as it seems to in the thesis.",
    );
    against_parameter(figure, all, &PRINTED, &NAMES)
}

pub(super) fn table(all: &[Errors]) -> Table {
    let caption = "TODO".to_owned();
    errors::table(("drill-string-fits", caption), all, &PRINTED, &NAMES, -2.0)
}
