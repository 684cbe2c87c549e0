//! Figs. 4.5 and 4.9: how far the copies are from the exact orbit.

use stickslip::field::Kernel;
use stickslip::report::{Figure, Table};

use super::super::errors::{Measured, Thesis, printed};

pub(super) static THESIS: Thesis = Thesis {
    kernel: Kernel::Quartic,
    extremum: "*e_{ψ}*",
    size: "size of the smoothing *ε*",
    middle: -2.0,
    parameter: "*η*",
    axis: "speed of the rotary table *η*",
    extrema: [
        printed(1.0, 0.63, 0.30, "equal but for the last digit of *a*"),
        printed(2.0, 0.55, 0.25, "flatter: larger errors at small *ε*"),
        printed(3.0, 0.54, 0.28, "flatter: larger errors at small *ε*"),
        printed(
            4.0,
            0.59,
            0.30,
            "equal; after Fig. 4.5 printed as log_{10} *b* = −0.53",
        ),
    ],
    frequencies: [
        printed(1.0, 0.63, 0.22, "flatter: larger errors at small *ε*"),
        printed(2.0, 0.51, 0.16, "far flatter: noise of the old solver"),
        printed(3.0, 0.46, 0.093, "far flatter: noise of the old solver"),
        printed(
            4.0,
            0.62,
            0.086,
            "equal; after Fig. 4.5 printed as log_{10} *b* = −1.1",
        ),
    ],
};

pub(super) fn figure_5(errors: &Measured) -> Figure {
    errors.against_size(Figure::new(
        "4.5",
        "Errors of the copies at *η* = 4",
        "Relative errors of the largest twist, *e_{ψ}*, and of the frequency, *e_{f}*, against the exact orbit, and \
         straight lines fitted to their logarithms. Here a smaller size is nearer to the exact law.",
    ))
}

pub(super) fn figure_9(errors: &Measured) -> Figure {
    errors.against_parameter(Figure::new(
        "4.9",
        "Parameters *a* and *b* of the fits *e* = *b* *ε*^{*a*}",
        "Lines: here; markers: the thesis. As with the belt, the errors of the frequency grow as the table slows down. \
         Their exponent does not fall towards the middle, as it seems to in the thesis.",
    ))
}

pub(super) fn table(errors: &Measured) -> Table {
    let caption = "The fits *e* = *b* *ε*^{*a*} for *ε* = 1 to 10^{−4} beside the thesis's, and what both lines say in \
                   the middle of that range. At *η* = 1 the copy *ε* = 1 has no cycle, and the fit begins at 0.1. The \
                   thesis's exponents of *e_{f}* at *η* = 2 and 3 are no property of the system: with an \
                   error of 0.001 and of 0.0015 added to *e_{f}* at every *ε*, our fits give 0.51 and 0.46 as well. In theory all exponents \
                   tend to 2/3 for *ε* → 0.";
    errors.table("drill-string-fits", caption)
}
