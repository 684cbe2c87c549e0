//! Figs. 4.5 and 4.9: how far the copies are from the exact orbit.

use stickslip::field::Kernel;
use stickslip::report::{Figure, Table};

use super::super::ReproduceError;
use super::super::errors::{
    self, Errors, Names, Of, Printed, against_parameter, against_size, measure,
};
use crate::DrillString;
use stickslip::study::parallel;

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
    printed(
        Of::Extremum,
        1.0,
        0.63,
        0.30,
        "equal but for the last digit of *a*",
    ),
    printed(
        Of::Extremum,
        2.0,
        0.55,
        0.25,
        "flatter: larger errors at small *ε*",
    ),
    printed(
        Of::Extremum,
        3.0,
        0.54,
        0.28,
        "flatter: larger errors at small *ε*",
    ),
    printed(
        Of::Extremum,
        4.0,
        0.59,
        0.30,
        "equal; after Fig. 4.5 printed as log_{10} *b* = −0.53",
    ),
    printed(
        Of::Frequency,
        1.0,
        0.63,
        0.22,
        "flatter: larger errors at small *ε*",
    ),
    printed(
        Of::Frequency,
        2.0,
        0.51,
        0.16,
        "far flatter: noise of the old solver",
    ),
    printed(
        Of::Frequency,
        3.0,
        0.46,
        0.093,
        "far flatter: noise of the old solver",
    ),
    printed(
        Of::Frequency,
        4.0,
        0.62,
        0.086,
        "equal; after Fig. 4.5 printed as log_{10} *b* = −1.1",
    ),
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
        "Lines: here; markers: the thesis. As with the belt, the errors of the frequency grow as the table slows down. \
         Their exponent does not fall towards the middle, as it seems to in the thesis.",
    );
    against_parameter(figure, all, &PRINTED, &NAMES)
}

pub(super) fn table(all: &[Errors]) -> Table {
    let caption = "The fits *e* = *b* *ε*^{*a*} for *ε* = 1 to 10^{−4} beside the thesis's, and what both lines say in \
                   the middle of that range. At *η* = 1 the copy *ε* = 1 has no cycle, and the fit begins at 0.1. The \
                   thesis's exponents of *e_{f}* at *η* = 2 and 3 are no property of the system: with an \
                   error of 0.001 and of 0.0015 added to *e_{f}* at every *ε*, our fits give 0.51 and 0.46 as well. In theory all exponents \
                   tend to 2/3 for *ε* → 0."
        .to_owned();
    errors::table(("drill-string-fits", caption), all, &PRINTED, &NAMES, -2.0)
}
