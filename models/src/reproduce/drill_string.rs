//! Thesis chapter 4: a drill string in torsion.

use stickslip::field::{Field, Kernel};
use stickslip::shooting::Orbit;
use stickslip::study::report::{Axis, Column, Curve, Figure, Marker, Panel, Section, Table};

use super::ReproduceError;
use super::cost::Cost;
use super::follow::{Drawn, Followed, draw, family, field, follow, search};
use super::parallel::parallel;
use super::words::{decimals, ending, power, stability};
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
        costs.push(Cost::of(name("*η* falling"), &copy.down, "6 min, both"));
        costs.push(Cost::of(name("*η* rising"), &copy.up, "6 min, both"));
    }
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
        .figure(figure_4(&copies))
        .figure(figure_7(&copies))
        .figure(figure_8(&copies))
        .table(ends(&copies))
        .text(
            "In a fold the stable cycle meets an unstable one that comes to rest for a moment but does not stick. The \
             smaller *ε*, the sharper the fold: for *ε* ≤ 10^{−2} it is sharper than double precision, and path \
             following stops in front of it, within a thousandth of where the cycle ends.",
        )
        .table(values(&copies)))
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

fn figure_4(copies: &[Copy]) -> Figure {
    let cycles = copies.iter().enumerate().map(|(i, copy)| {
        let path = copy.cycle.path.iter().map(|sample| sample.state).collect();
        Curve::line(label(copy), i + 1, path)
    });
    let panel = Panel::new(Axis::new("twist *ψ*"), Axis::new("twist rate *ψ*′"))
        .curves(cycles)
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

fn figure_7(copies: &[Copy]) -> Figure {
    Figure::new(
        "4.7",
        "Absolute maximum of *ψ*",
        "At low speed the bit breaks loose at *ψ* = *θ* − 2*ζη* → 4.2. At high speed damping keeps the bit from ever \
         coming to rest again, and the cycle ends: the exact one at *η* = 4.612, the copies later, the later the larger \
         *ε*. The copy *ε* = 1 is far from the real system at both ends.",
    )
    .panel(
        Panel::new(table_speed(), Axis::new("max |*ψ*|"))
            .curves(along(copies, |orbit| orbit.max_abs()[0])),
    )
}

fn figure_8(copies: &[Copy]) -> Figure {
    Figure::new(
        "4.8",
        "Free frequency",
        "The slower the table, the longer the bit sticks, and the frequency falls to 0. At high speed it approaches the \
         natural frequency, 1/2π ≈ 0.159.",
    )
    .panel(
        Panel::new(table_speed(), Axis::new("frequency *f*").from(0.0, 0.2))
            .curves(along(copies, |orbit| 1.0 / orbit.period)),
    )
}

fn ends(copies: &[Copy]) -> Table {
    let columns = [
        Column::numbers("*ε*"),
        Column::numbers("*f* at 4"),
        Column::numbers("max |*ψ*| at 4"),
        Column::words("downwards it ends at"),
        Column::numbers("max |*ψ*| there"),
        Column::words("upwards it ends at"),
    ];
    let caption = format!(
        "The copies at *η* = 4, and where their branches end. The exact cycle exists from *η* = 0 to {}, where its slip phase just fails to reach the \
         table's speed again; a copy loses it in a fold.",
        decimals(EXACT_END, 4)
    );
    Table::new("drill-string-ends", caption, columns).rows(copies.iter().map(|copy| {
        let first = &copy.cycle.orbit;
        let last = copy.down.orbits.last().unwrap_or(first);
        vec![
            power(copy.exponent),
            decimals(1.0 / first.period, 7),
            decimals(first.max_abs()[0], 6),
            ending(&copy.down.end, "*η*"),
            decimals(last.max_abs()[0], 4),
            ending(&copy.up.end, "*η*"),
        ]
    }))
}

/// Speeds between which the copy's equilibrium is unstable: the slope of its friction term is 2ζ.
fn hopf(size: f64) -> [f64; 2] {
    let DrillString { theta, zeta, .. } = DrillString::default();
    // With u = η/ε: 4θ (u − 4)² (u − 1) = 54 ζ ε, once below the maximum at u = 2 and once above.
    let slope = |u: f64| 4.0 * theta * (u - 4.0).powi(2) * (u - 1.0) - 54.0 * zeta * size;
    let root = |mut below: f64, mut above: f64| {
        for _ in 0..100 {
            let middle = 0.5 * (below + above);
            if slope(middle) < 0.0 {
                below = middle;
            } else {
                above = middle;
            }
        }
        size * below
    };
    [root(4.0, 2.0), root(1.0, 2.0)]
}

fn values(copies: &[Copy]) -> Table {
    let columns = [
        Column::words("quantity"),
        Column::numbers("thesis"),
        Column::numbers("here"),
        Column::words("remark"),
    ];
    let [first, second] = hopf(1.0);
    let all = copies
        .iter()
        .flat_map(|copy| copy.down.orbits.iter().chain(&copy.up.orbits));
    Table::new(
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
        "stability of all branches".into(),
        "stable".into(),
        stability(all),
        "the others lie at the tip of a fold, or where the cycle vanishes".to_owned(),
    ])
    .row([
        "end of sticking".into(),
        "2*ζθ* + *ψ* = *T*_{c}".into(),
        "2*ζη* + *ψ* = *T*_{c}".into(),
        "a misprint in (4.10): the release at *ψ* = *θ* − 2*ζη* needs *η*".to_owned(),
    ])
}
