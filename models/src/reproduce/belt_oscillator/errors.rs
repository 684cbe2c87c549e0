//! Figs. 3.7 and 3.11: how far the copies are from the exact orbit.

use stickslip::field::Kernel;
use stickslip::report::{Figure, Table};

use super::super::errors::{Measured, Of, Thesis, printed};
use super::super::words::scientific;

pub(super) static THESIS: Thesis = Thesis {
    kernel: Kernel::Arctan,
    extremum: "*e_{x}*",
    size: "size of the smoothing *ε* (s/m)",
    middle: 4.5,
    parameter: "*v*_{dr} (m/s)",
    axis: "belt speed *v*_{dr} (m/s)",
    extrema: [
        printed(0.05, -0.58, 4.7, "equal within its digits"),
        printed(0.1, -0.57, 3.5, "flatter; 4 % larger in the middle"),
        printed(0.15, -0.57, 3.2, "flatter; 7 % larger in the middle"),
        printed(0.2, -0.59, 3.3, "equal within the rounding of *a*"),
    ],
    frequencies: [
        printed(0.05, -0.60, 11.0, "steeper; 6 % smaller in the middle"),
        printed(0.1, -0.61, 8.1, "equal within the rounding of *a*"),
        printed(
            0.15,
            -0.61,
            5.6,
            "equal in the middle: a steeper line has a larger *b*",
        ),
        printed(0.2, -0.60, 3.9, "equal within the rounding of *a*"),
    ],
};

pub(super) fn figure_7(errors: &Measured) -> Figure {
    errors.against_size(Figure::new(
        "3.7",
        "Errors of the copies at *v*_{dr} = 0.2 m/s",
        "Relative errors of the largest displacement, *e_{x}*, and of the frequency, *e_{f}*, against the exact orbit, \
         and straight lines fitted to their logarithms. Ten times the size buys only a factor of about four: the \
         arctan approaches its limit slowly, and misses the top of the friction peak by much.",
    ))
}

pub(super) fn figure_11(errors: &Measured) -> Figure {
    errors.against_parameter(Figure::new(
        "3.11",
        "Parameters *a* and *b* of the fits *e* = *b* *ε*^{*a*}",
        "Lines: here; markers: the thesis. The exponent hardly depends on the speed of the belt, but the errors grow as it \
         slows down, those of the frequency most. A size should therefore be chosen by the frequency at the lowest \
         speed of interest.",
    ))
}

pub(super) fn table(errors: &Measured) -> Table {
    let wanted = errors.last(Of::Frequency);
    let wanted = wanted.map_or(f64::NAN, |fit| fit.size(1e-3));
    let caption = format!(
        "The fits *e* = *b* *ε*^{{*a*}} for *ε* = 10^{{2}} to 10^{{7}} beside the thesis's, and what both lines say in the \
         middle of that range. At *v*_{{dr}} = 0.05 the copy *ε* = 10^{{2}} has no cycle, and the fit begins at 10^{{3}}. A \
         line in logarithms ties *b* to *a*: the rounding of *a* to two digits alone is worth 5 % of *b*. What differs \
         more goes back to the integration of that time, whose error adds to the smallest errors or takes from them. By \
         our line *e_{{f}}* = 10^{{−3}} at 0.2 m/s needs *ε* = {} (thesis: 9.7 × 10^{{5}}).",
        scientific(wanted, 2)
    );
    errors.table("belt-oscillator-fits", caption)
}
