//! Thesis chapter 4: a drill string in torsion.

mod equilibrium;
mod errors;

use stickslip::field::{Field, Kernel};
use stickslip::shooting::Orbit;
use stickslip::study::report::{Axis, Column, Curve, Figure, Marker, Panel, Section, Table};

use equilibrium::{figure_6, hopf};
use errors::{figure_5, figure_9};

use super::ReproduceError;
use super::cost::Cost;
use super::exact::{self, Exact};
use super::follow::{Drawn, Followed, draw, family, field, follow, search};
use super::parallel::parallel;
use super::words::{decimals, ending, power};
use crate::DrillString;

/// The smoothings are of size 10ⁱ.
const EXPONENTS: [i32; 5] = [0, -1, -2, -3, -4];
/// Where the branches begin.
const SPEED: f64 = 4.0;
/// Where they shall end: near 0 the sticking phase, and with it the period, grows without bound.
const LEAST: f64 = 0.02;
const MOST: f64 = 8.0;
/// Speed at which the exact cycle ends: its slip just fails to reach the table's speed again.
const EXACT_END: f64 = 4.611_989_021;

/// One smooth copy: its orbit at the first speed, and its branch both ways.
struct Copy {
    exponent: i32,
    cycle: Drawn<2>,
    down: Followed<2>,
    up: Followed<2>,
}

/// The section on the drill string.
pub(super) fn section(costs: &mut Vec<Cost>) -> Result<Section, ReproduceError> {
    let copies: Vec<Copy> = parallel(&EXPONENTS, |&exponent| compute(exponent))
        .into_iter()
        .collect::<Result<_, _>>()?;
    for copy in &copies {
        let name = |way| format!("drill string, *ε* = {}, {way}", power(copy.exponent));
        costs.push(Cost::of(
            name("*η* falling"),
            &copy.down,
            "about 6 min for both",
        ));
        costs.push(Cost::of(
            name("*η* rising"),
            &copy.up,
            "about 6 min for both",
        ));
    }
    let exact = exact()?;
    let name = "drill string, exact, both ways".to_owned();
    let points = exact.orbits.len();
    costs.push(Cost::counted(name, points, (&exact.work, exact.time), "–"));
    let errors = errors::all()?;
    Ok(Section::new("A drill string")
        .sketch(
            include_str!("sketches/drill_string.svg"),
            "A drill string: a rotary table turns at a constant rate, a kilometre of pipe acts as a torsional spring, \
             and friction holds the bit (Fig. 4.1 of the thesis).",
        )
        .text(
            "The rotary table turns steadily; the bit sticks, the pipe winds up, the bit breaks loose and spins several \
             times as fast as the table, and sticks again. *ψ* is the twist of the pipe, measured from the twist of \
             steady drilling, in units without dimension; the bit's speed is *η* − *ψ*′, with *η* the speed of the \
             table. Friction at rest holds up to *θ* = 4.2 more than friction in motion, and the damping is *ζ* = 0.05.",
        )
        .formula("*ψ*″ + 2*ζ* *ψ*′ + *ψ* = *T*_{c},   *T*_{c} = 0 while the bit turns,   *T*_{c} ≤ *θ* while it sticks (*ψ*′ = *η*)")
        .figure(figure_3()?)
        .figure(figure_4(&copies, &exact))
        .figure(figure_5(&errors))
        .figure(figure_6()?)
        .figure(figure_7(&copies, &exact))
        .figure(figure_8(&copies, &exact))
        .figure(figure_9(&errors))
        .table(errors::table(&errors))
        .table(ends(&copies))
        .table(values()?))
}

/// The drill string with its declared friction.
type ExactDrill = Exact<DrillString, 2>;

fn exact() -> Result<ExactDrill, ReproduceError> {
    let start = (SPEED, [0.0, SPEED]);
    exact::follow(
        DrillString::default(),
        DrillString::eta,
        start,
        &[LEAST, MOST],
    )
    .map_err(ReproduceError::at("drill string, exact"))
}

fn compute(exponent: i32) -> Result<Copy, ReproduceError> {
    let what = || ReproduceError::at(format!("drill string, quartic:1e{exponent}"));
    let smoothing = Some((Kernel::Quartic, 10f64.powi(exponent)));
    let family = family(DrillString::default(), DrillString::eta, smoothing);
    let cycle = draw(&family, SPEED, &search([6.0, 0.0], None)).map_err(what())?;
    let down = follow(&family, &cycle.orbit, LEAST).map_err(what())?;
    let up = follow(&family, &cycle.orbit, MOST).map_err(what())?;
    Ok(Copy {
        exponent,
        cycle,
        down,
        up,
    })
}

/// The friction term of the copy at the twist rate `omega`: what the integrator sees, at ψ = 0.
fn friction(size: f64, omega: f64) -> Result<f64, ReproduceError> {
    let model = DrillString::default();
    let field = field(&model, Kernel::Quartic, size).map_err(ReproduceError::at("figure 4.3"))?;
    Ok(field.f(&[0.0, omega])[1] + 2.0 * model.zeta * omega)
}

fn figure_3() -> Result<Figure, ReproduceError> {
    let DrillString { eta, theta, .. } = DrillString::default();
    let mut panel = Panel::new(
        Axis::new("twist rate *ψ*′").from(-1.0, 5.0),
        Axis::new("friction term *T*_{c}").from(-4.0, 6.0),
    )
    .curve(Curve::line(
        "exact, *η* = 4",
        0,
        vec![[-1.0, 0.0], [eta, 0.0], [eta, theta], [eta, -4.0]],
    ));
    for (i, exponent) in [0, -1].into_iter().enumerate() {
        let size = 10f64.powi(exponent);
        let points = (0..=600)
            .map(|k| -1.0 + (eta + 0.3 * size + 1.0) * f64::from(k) / 600.0)
            .map(|omega| Ok([omega, friction(size, omega)?]))
            .collect::<Result<_, ReproduceError>>()?;
        panel = panel.curve(Curve::line(
            format!("*ε* = {}", power(exponent)),
            i + 1,
            points,
        ));
    }
    Ok(Figure::new(
        "4.3",
        "Friction term *T*_{c} and its smooth copies",
        "While the bit turns (*ψ*′ < *η*) the term is zero; where it sticks (*ψ*′ = *η*) the term takes any value up to \
         *θ* = 4.2. The copy climbs to the same peak at *ψ*′ = *η* − *ε* by a polynomial of fourth degree that begins \
         at *η* − 4*ε*. It stands for forward motion only.",
    )
    .panel(panel))
}

fn label(copy: &Copy) -> String {
    format!("*ε* = {}", power(copy.exponent))
}

fn figure_4(copies: &[Copy], exact: &ExactDrill) -> Figure {
    let cycles = copies.iter().enumerate().map(|(i, copy)| {
        let path = copy.cycle.path.iter().map(|sample| sample.state).collect();
        Curve::line(label(copy), i + 1, path)
    });
    let panel = Panel::new(Axis::new("twist *ψ*"), Axis::new("twist rate *ψ*′"))
        .curves(cycles)
        .curve(Curve::line("exact", 0, exact.path.clone()))
        .curve(Curve::points(
            "stable equilibrium",
            0,
            Marker::Cross,
            vec![[0.0, 0.0]],
        ));
    Figure::new(
        "4.4",
        "Periodic solutions at *η* = 4",
        "Along the straight top the bit stands still and the pipe winds up at the speed of the table, 4; then the bit \
         breaks loose and the twist swings back. Inside lies steady drilling, which is stable as well: which of the \
         two happens depends on the start.",
    )
    .panel(panel)
}

fn along(copies: &[Copy], of: fn(&Orbit<2, ()>) -> f64) -> impl Iterator<Item = Curve> {
    copies.iter().enumerate().map(move |(i, copy)| {
        let down = copy.down.orbits.iter().rev();
        let up = copy.up.orbits.iter().skip(1);
        let points = down.chain(up).map(|o| [o.r, of(o)]).collect();
        Curve::line(label(copy), i + 1, points)
    })
}

fn table_speed() -> Axis {
    Axis::new("speed of the rotary table *η*").from(0.0, MOST)
}

fn figure_7(copies: &[Copy], exact: &ExactDrill) -> Figure {
    Figure::new(
        "4.7",
        "Absolute maximum of *ψ*",
        "At low speed the bit breaks loose at *ψ* = *θ* − 2*ζη* → 4.2. At high speed damping keeps the bit from ever \
         coming to rest again, and the cycle ends: the exact one at *η* = 4.612, the copies later, the later the larger \
         *ε*. The copy *ε* = 1 is far from the real system at both ends.",
    )
    .panel(
        Panel::new(table_speed(), Axis::new("max |*ψ*|"))
            .curves(along(copies, |orbit| orbit.max_abs()[0]))
            .curve(Curve::line(
                "exact",
                0,
                exact.along(|orbit| orbit.max_abs()[0]),
            )),
    )
}

fn figure_8(copies: &[Copy], exact: &ExactDrill) -> Figure {
    Figure::new(
        "4.8",
        "Free frequency",
        "The slower the table, the longer the bit sticks, and the frequency falls to 0. At high speed it approaches the \
         natural frequency, 1/2π ≈ 0.159.",
    )
    .panel(
        Panel::new(table_speed(), Axis::new("frequency *f*").from(0.0, 0.2))
            .curves(along(copies, |orbit| 1.0 / orbit.period))
            .curve(Curve::line(
                "exact",
                0,
                exact.along(|orbit| 1.0 / orbit.period),
            )),
    )
}

fn ends(copies: &[Copy]) -> Table {
    let columns = [
        Column::numbers("*ε*"),
        Column::words("downwards the branch ends at"),
        Column::numbers("max *ψ* there"),
        Column::numbers("*f* there"),
        Column::words("upwards the branch ends at"),
    ];
    let caption = format!(
        "Where the branches end. The exact cycle exists from *η* = 0 to {}, where its slip phase just fails to reach the \
         table's speed again; a copy loses it in a fold.",
        decimals(EXACT_END, 4)
    );
    Table::new("drill-string-ends", caption, columns).rows(copies.iter().map(|copy| {
        let last = copy.down.orbits.last();
        vec![
            power(copy.exponent),
            ending(&copy.down.end, "*η*"),
            decimals(last.map_or(f64::NAN, |o| o.max_abs()[0]), 4),
            decimals(last.map_or(f64::NAN, |o| 1.0 / o.period), 5),
            ending(&copy.up.end, "*η*"),
        ]
    }))
}

fn values() -> Result<Table, ReproduceError> {
    let columns = [
        Column::words("quantity"),
        Column::numbers("thesis"),
        Column::numbers("here"),
        Column::words("remark"),
    ];
    let [first, second] = hopf(1.0)?;
    Ok(Table::new(
        "drill-string",
        "Drill string: values of the thesis beside ours.",
        columns,
    )
    .row([
        "*η*_{bif,1} for *ε* = 1".into(),
        "3.759".into(),
        decimals(first, 6),
        "below it the copy's equilibrium is unstable".to_owned(),
    ])
    .row([
        "*η*_{bif,2} for *ε* = 1".into(),
        "1.018".into(),
        decimals(second, 6),
        "below it the equilibrium is stable again and the copy has no cycle".to_owned(),
    ])
    .row([
        "end of sticking".into(),
        "2*ζθ* + *ψ* = *T*_{c}".into(),
        "2*ζη* + *ψ* = *T*_{c}".into(),
        "a misprint in (4.10): the release at *ψ* = *θ* − 2*ζη* needs *η*".to_owned(),
    ]))
}
