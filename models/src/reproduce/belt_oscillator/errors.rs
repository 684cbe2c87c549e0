//! Figs. 3.7 and 3.11: how far the copies are from the exact orbit.

use stickslip::field::Kernel;
use stickslip::report::{Figure, Table};

use super::super::ReproduceError;
use super::super::errors::{
    self, Errors, Names, Of, Printed, against_parameter, against_size, measure,
};
use super::super::words::scientific;
use crate::BeltOscillator;
use stickslip::study::parallel;

/// The thesis's belt speeds.
const SPEEDS: [f64; 4] = [0.05, 0.1, 0.15, 0.2];
const NAMES: Names = Names {
    extremum: "*e_{x}*",
    size: "size of the smoothing *ε* (s/m)",
    parameter: "*v*_{dr} (m/s)",
    axis: "belt speed *v*_{dr} (m/s)",
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
    printed(Of::Extremum, 0.05, -0.58, 4.7, "equal within its digits"),
    printed(
        Of::Extremum,
        0.1,
        -0.57,
        3.5,
        "flatter; 4 % larger in the middle",
    ),
    printed(
        Of::Extremum,
        0.15,
        -0.57,
        3.2,
        "flatter; 7 % larger in the middle",
    ),
    printed(
        Of::Extremum,
        0.2,
        -0.59,
        3.3,
        "equal within the rounding of *a*",
    ),
    printed(
        Of::Frequency,
        0.05,
        -0.60,
        11.0,
        "steeper; 6 % smaller in the middle",
    ),
    printed(
        Of::Frequency,
        0.1,
        -0.61,
        8.1,
        "equal within the rounding of *a*",
    ),
    printed(
        Of::Frequency,
        0.15,
        -0.61,
        5.6,
        "equal in the middle: a steeper line has a larger *b*",
    ),
    printed(
        Of::Frequency,
        0.2,
        -0.60,
        3.9,
        "equal within the rounding of *a*",
    ),
];

/// The errors at all speeds.
pub(super) fn all() -> Result<Vec<Errors>, ReproduceError> {
    let at = |&v_dr: &f64| {
        let model = BeltOscillator {
            v_dr,
            ..BeltOscillator::default()
        };
        let what = ReproduceError::at(format!("errors of the copies at v_dr = {v_dr}"));
        measure(&model, (v_dr, [0.0, v_dr]), Kernel::Arctan).map_err(what)
    };
    parallel(&SPEEDS, at).into_iter().collect()
}

pub(super) fn figure_7(all: &[Errors]) -> Figure {
    let figure = Figure::new(
        "3.7",
        "Errors of the copies at *v*_{dr} = 0.2 m/s",
        "Relative errors of the largest displacement, *e_{x}*, and of the frequency, *e_{f}*, against the exact orbit, \
         and straight lines fitted to their logarithms. Ten times the size buys only a factor of about four: the \
         arctan approaches its limit slowly, and misses the top of the friction peak by much.",
    );
    let last = all.last().map(|errors| against_size(errors, &NAMES));
    last.into_iter().fold(figure, Figure::panel)
}

pub(super) fn figure_11(all: &[Errors]) -> Figure {
    let figure = Figure::new(
        "3.11",
        "Parameters *a* and *b* of the fits *e* = *b* *ε*^{*a*}",
        "Lines: here; markers: the thesis. The exponent hardly depends on the speed of the belt, but the errors grow as it \
         slows down, those of the frequency most. A size should therefore be chosen by the frequency at the lowest \
         speed of interest.",
    );
    against_parameter(figure, all, &PRINTED, &NAMES)
}

pub(super) fn table(all: &[Errors]) -> Table {
    let wanted = all
        .last()
        .and_then(|errors| errors.fit(Of::Frequency))
        .map_or(f64::NAN, |fit| fit.size(1e-3));
    let caption = format!(
        "The fits *e* = *b* *ε*^{{*a*}} for *ε* = 10^{{2}} to 10^{{7}} beside the thesis's, and what both lines say in the \
         middle of that range. At *v*_{{dr}} = 0.05 the copy *ε* = 10^{{2}} has no cycle, and the fit begins at 10^{{3}}. A \
         line in logarithms ties *b* to *a*: the rounding of *a* to two digits alone is worth 5 % of *b*. What differs \
         more goes back to the integration of that time, whose error adds to the smallest errors or takes from them. By \
         our line *e_{{f}}* = 10^{{−3}} at 0.2 m/s needs *ε* = {} (thesis: 9.7 × 10^{{5}}).",
        scientific(wanted, 2)
    );
    errors::table(
        ("belt-oscillator-fits", caption),
        all,
        &PRINTED,
        &NAMES,
        4.5,
    )
}
