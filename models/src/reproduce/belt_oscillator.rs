//! Thesis section 3.2: one mass on a moving belt.

mod equilibrium;
mod errors;

use stickslip::field::{Field, Kernel};
use stickslip::friction::FrictionLaw;
use stickslip::shooting::Orbit;
use stickslip::study::report::{Axis, Column, Curve, Figure, Marker, Panel, Section, Table};

use equilibrium::{figure_8, hopf};
use errors::{figure_7, figure_11};

use super::ReproduceError;
use super::cost::Cost;
use super::exact::{self, Exact};
use super::follow::{Drawn, End, Followed, draw, family, field, follow, search};
use super::parallel::parallel;
use super::words::{decimals, ending, power};
use crate::BeltOscillator;
use crate::friction::Weakening;

/// The smoothings are of size 10ⁱ.
const EXPONENTS: [i32; 6] = [2, 3, 4, 5, 6, 7];
/// Where the branches begin.
const SPEED: f64 = 0.2;
/// Where they shall end: near 0 the sticking phase, and with it the period, grows without bound.
const LEAST: f64 = 0.002;

/// One smooth copy: its orbit at the first speed, and its branch.
struct Copy {
    exponent: i32,
    cycle: Drawn<2>,
    branch: Followed<2>,
}

/// The section on the belt oscillator.
pub(super) fn section(costs: &mut Vec<Cost>) -> Result<Section, ReproduceError> {
    let copies: Vec<Copy> = parallel(&EXPONENTS, |&exponent| compute(exponent))
        .into_iter()
        .collect::<Result<_, _>>()?;
    for copy in &copies {
        let name = format!("mass on a belt, *ε* = {}", power(copy.exponent));
        costs.push(Cost::of(name, &copy.branch, "about 10 min"));
    }
    let exact = exact()?;
    let name = "mass on a belt, exact".to_owned();
    let points = exact.orbits.len();
    costs.push(Cost::counted(name, points, (&exact.work, exact.time), "–"));
    let errors = errors::all()?;
    Ok(Section::new("One mass on a belt")
        .sketch(
            include_str!("sketches/belt_oscillator.svg"),
            "A mass on a belt that runs at constant speed, held by a spring (Fig. 3.4 of the thesis).",
        )
        .text(
            "The belt drags the mass along until the spring pulls harder than friction can hold; the mass slips back, \
             is caught by the belt and dragged along again. Friction weakens with the sliding speed *v*_{rel} = *ẋ* − \
             *v*_{dr}, which feeds the vibration. Mass, stiffness and the limit of friction are 1 (kg, N/m, N), and *δ* \
             = 3 s/m.",
        )
        .formula("*m* *ẍ* + *k* *x* = *F*,   *F* = − *F*_{s} sgn(*v*_{rel}) / (1 + *δ* |*v*_{rel}|) while sliding,   |*F*| ≤ *F*_{s} while sticking")
        .text(
            "The smooth copies replace sgn(*v*_{rel}) by (2/π) arctan(*ε* *v*_{rel}). They cannot stick: they creep.",
        )
        .figure(figure_5()?)
        .figure(figure_6(&copies, &exact))
        .figure(figure_7(&errors))
        .figure(figure_8()?)
        .figure(figure_9(&copies, &exact))
        .figure(figure_10(&copies, &exact))
        .figure(figure_11(&errors))
        .table(errors::table(&errors))
        .table(ends(&copies)?)
        .table(values(&copies)))
}

/// The belt oscillator with its declared friction.
type ExactBelt = Exact<BeltOscillator, 2>;

fn exact() -> Result<ExactBelt, ReproduceError> {
    let start = (SPEED, [0.0, SPEED]);
    exact::follow(
        BeltOscillator::default(),
        BeltOscillator::v_dr,
        start,
        &[LEAST],
    )
    .map_err(ReproduceError::at("belt oscillator, exact"))
}

fn compute(exponent: i32) -> Result<Copy, ReproduceError> {
    let what = || ReproduceError::at(format!("belt oscillator, arctan:1e{exponent}"));
    let smoothing = Some((Kernel::Arctan, 10f64.powi(exponent)));
    let family = family(BeltOscillator::default(), BeltOscillator::v_dr, smoothing);
    let cycle = draw(&family, SPEED, &search([1.0, 0.0], None)).map_err(what())?;
    let branch = follow(&family, &cycle.orbit, LEAST).map_err(what())?;
    Ok(Copy {
        exponent,
        cycle,
        branch,
    })
}

/// The force of the copy at sliding speed w: what the integrator sees, at x = 0 and m = 1.
fn force(size: f64, w: f64) -> Result<f64, ReproduceError> {
    let model = BeltOscillator::default();
    let field = field(&model, Kernel::Arctan, size).map_err(ReproduceError::at("figure 3.5"))?;
    Ok(field.f(&[0.0, model.v_dr + w])[1])
}

/// Sliding speeds up to `most` either way, dense where the copies are steep.
fn speeds(most: f64) -> impl Iterator<Item = f64> {
    (-300..=300).map(move |i| {
        let share = f64::from(i) / 300.0;
        most * share * share.abs() * share.abs()
    })
}

fn figure_5() -> Result<Figure, ReproduceError> {
    Ok(Figure::new(
        "3.5",
        "Friction force *F* and its smooth copies",
        "Left: friction pushes against the direction of sliding, and weakens with speed; at rest it takes any value \
         between −1 N and 1 N. Right: the same near rest. The larger *ε*, the closer the copy; but its peak is always \
         lower than the limit at rest, and its slope there, −(2/π) *ε* *F*_{s}, is what makes the equations stiff.",
    )
    .columns(2)
    .panel(forces(1.0)?)
    .panel(forces(0.05)?))
}

fn forces(most: f64) -> Result<Panel, ReproduceError> {
    let law = Weakening {
        limit: 1.0,
        decay: 3.0,
    };
    let exact = speeds(most)
        .filter(|w| *w != 0.0)
        .map(|w| [w, -w.signum() * law.slip(w.abs())])
        .collect();
    let axes = Panel::new(
        Axis::new("sliding speed *v*_{rel} (m/s)").from(-most, most),
        Axis::new("friction force *F* (N)").from(-1.2, 1.2),
    );
    let mut panel = axes.curve(Curve::line("exact", 0, exact));
    for (i, exponent) in [2, 3, 4].into_iter().enumerate() {
        let points = speeds(most)
            .map(|w| Ok([w, force(10f64.powi(exponent), w)?]))
            .collect::<Result<_, ReproduceError>>()?;
        panel = panel.curve(Curve::line(
            format!("*ε* = {} s/m", power(exponent)),
            i + 1,
            points,
        ));
    }
    Ok(panel)
}

fn label(copy: &Copy) -> String {
    format!("*ε* = {} s/m", power(copy.exponent))
}

fn figure_6(copies: &[Copy], exact: &ExactBelt) -> Figure {
    let cycles = copies.iter().enumerate().map(|(i, copy)| {
        let path = copy.cycle.path.iter().map(|sample| sample.state).collect();
        Curve::line(label(copy), i + 1, path)
    });
    let panel = Panel::new(
        Axis::new("displacement *x* (m)"),
        Axis::new("velocity *ẋ* (m/s)"),
    )
    .curves(cycles)
    .curve(Curve::line("exact", 0, exact.path.clone()))
    .curve(Curve::points(
        "unstable equilibrium",
        0,
        Marker::Cross,
        vec![[0.625, 0.0]],
    ));
    Figure::new(
        "3.6",
        "Periodic solutions at *v*_{dr} = 0.2 m/s",
        "The straight top of each curve is the mass carried by the belt at 0.2 m/s, the arc below it slips. As *ε* \
         grows the curves tend to one: from 10^{5} on they are hard to tell apart. The smaller *ε*, the sooner the \
         mass slips, because the copy has lost the top of the friction peak.",
    )
    .panel(panel)
}

fn along(copies: &[Copy], of: fn(&Orbit<2, ()>) -> f64) -> impl Iterator<Item = Curve> {
    copies.iter().enumerate().map(move |(i, copy)| {
        let points = copy.branch.orbits.iter().map(|o| [o.r, of(o)]).collect();
        Curve::line(label(copy), i + 1, points)
    })
}

fn belt_speed() -> Axis {
    Axis::new("belt speed *v*_{dr} (m/s)").from(0.0, SPEED)
}

fn figure_9(copies: &[Copy], exact: &ExactBelt) -> Figure {
    Figure::new(
        "3.9",
        "Absolute maximum of *x*",
        "As the belt slows down, the mass should turn at *x* = *F*_{s}/*k* = 1 m, where the spring overcomes friction: \
         the copies come the closer the larger *ε* is. Each loses its cycle at a belt speed of its own, where the \
         curve plunges to the displacement of the equilibrium; the real system keeps vibrating at every speed.",
    )
    .panel(
        Panel::new(belt_speed(), Axis::new("max |*x*| (m)"))
            .curves(along(copies, |orbit| orbit.max_abs()[0]))
            .curve(Curve::line(
                "exact",
                0,
                exact.along(|orbit| orbit.max_abs()[0]),
            )),
    )
}

fn figure_10(copies: &[Copy], exact: &ExactBelt) -> Figure {
    Figure::new(
        "3.10",
        "Free frequency",
        "The slower the belt, the longer the mass sticks, and the frequency should fall to 0. Where a copy loses its \
         cycle, the frequency instead returns to that of the mass on its spring, 1/2π ≈ 0.159 Hz.",
    )
    .panel(
        Panel::new(belt_speed(), Axis::new("frequency *f* (Hz)").from(0.0, 0.2))
            .curves(along(copies, |orbit| 1.0 / orbit.period))
            .curve(Curve::line(
                "exact",
                0,
                exact.along(|orbit| 1.0 / orbit.period),
            )),
    )
}

fn ends(copies: &[Copy]) -> Result<Table, ReproduceError> {
    let columns = [
        Column::numbers("*ε* (s/m)"),
        Column::numbers("*v*_{bif} in theory"),
        Column::words("the branch ends at"),
        Column::numbers("max |*x*| there (m)"),
        Column::numbers("*f* there (Hz)"),
        Column::numbers("least *f* (Hz)"),
    ];
    let caption = "Where the branches end. Below *v*_{bif} the equilibrium of the copy is stable and there is no cycle: an \
                   artefact of smoothing, for the real equilibrium is unstable at all speeds. The thesis gives \
                   *v*_{bif} ≈ 0.052 m/s for *ε* = 10^{2}; its branches ended when steps became too small.";
    let speeds: Vec<f64> = copies
        .iter()
        .map(|copy| hopf(10f64.powi(copy.exponent)))
        .collect::<Result<_, _>>()?;
    let table = Table::new("belt-oscillator-ends", caption, columns);
    Ok(table.rows(copies.iter().zip(speeds).map(|(copy, v_bif)| {
        let orbits = &copy.branch.orbits;
        let last = orbits.last();
        let least = orbits.iter().map(|o| 1.0 / o.period).fold(1.0, f64::min);
        vec![
            power(copy.exponent),
            decimals(v_bif, 7),
            ending(&copy.branch.end, "*v*_{dr}"),
            decimals(last.map_or(f64::NAN, |o| o.max_abs()[0]), 4),
            decimals(last.map_or(f64::NAN, |o| 1.0 / o.period), 5),
            decimals(least, 5),
        ]
    })))
}

fn values(copies: &[Copy]) -> Table {
    let columns = [
        Column::words("quantity"),
        Column::numbers("thesis"),
        Column::numbers("here"),
        Column::words("remark"),
    ];
    let mut table = Table::new(
        "belt-oscillator",
        "One mass on a belt: values of the thesis beside ours.",
        columns,
    )
    .row([
        "equilibrium at *v*_{dr} = 0.2 (m)",
        "0.625",
        "0.625",
        "*F*_{s}/*k*/(1 + *δ* *v*_{dr}), exactly",
    ]);
    if let Some(copy) = copies.first() {
        let measured = match copy.branch.end {
            End::Vanishes(r) => decimals(r, 5),
            _ => "–".to_owned(),
        };
        table = table.row([
            "*v*_{bif} for *ε* = 10^{2} (m/s)".into(),
            "0.052".into(),
            measured,
            "where the followed cycle has shrunk to nothing".to_owned(),
        ]);
    }
    table.rows(copies.iter().map(|copy| {
        let orbit = &copy.cycle.orbit;
        vec![
            format!(
                "*f*, max |*x*| at *v*_{{dr}} = 0.2, *ε* = {}",
                power(copy.exponent)
            ),
            "–".to_owned(),
            format!(
                "{} Hz, {} m",
                decimals(1.0 / orbit.period, 7),
                decimals(orbit.max_abs()[0], 6)
            ),
            "drawn in the thesis, not printed".to_owned(),
        ]
    }))
}
