//! What an error costs: every method on every reference system, over all tolerances; a table and a picture.

use std::path::Path;
use std::time::Duration;

use stickslip::model::Model;
use stickslip::report::{Axis, Block, Curve, Figure, Panel, Report, ReportError, Section, Written};

use crate::clock::best;
use crate::contender::{library, methods};
use crate::round::{
    ExactRound, Round, Sensitivities, belt, belt_pair, drill_string, errors, exact_belt,
    exact_belt_pair, exact_drill_string, van_der_pol,
};

/// Errors that the table asks for.
const WANTED: [f64; 4] = [1e-4, 1e-6, 1e-8, 1e-10];
/// Errors that the picture shows.
const SHOWN: [f64; 2] = [1e-10, 1.0];
/// A run that takes longer is not repeated at tighter tolerances, seconds.
const PATIENCE: f64 = 0.1;

/// What a method has measured: its errors of Φ, and its seconds.
struct Line {
    name: &'static str,
    points: Vec<[f64; 2]>,
}

pub(crate) fn table() {
    println!("\nonce around with Φ and ∂φ/∂r: µs at an error of Φ of at most");
    println!(
        "{:<42}{}",
        "",
        WANTED.map(|error| format!("{error:>10.0e}")).concat()
    );
    let van_der_pol = van_der_pol();
    let (belt, pair, drill) = (belt("arctan:1e5"), belt_pair(), drill_string());
    let panels = [
        panel(&van_der_pol, "Van der Pol, ν = 5", None),
        panel(&belt, "belt oscillator, arctan 1e5", Some(exact_belt())),
        panel(&pair, "belt pair, arctan 1e5", Some(exact_belt_pair())),
        panel(
            &drill,
            "drill string, quartic 1e-3",
            Some(exact_drill_string()),
        ),
    ];
    let out = Path::new(env!("CARGO_TARGET_TMPDIR")).join("work-precision");
    match report(panels, &out) {
        Ok(written) => println!("drawn in {}", written.page.display()),
        Err(error) => println!("not drawn: {error}"),
    }
}

fn panel<M: Model<N>, const N: usize>(
    round: &Round<M, N>,
    title: &str,
    exact: Option<ExactRound<M, N>>,
) -> Panel {
    println!("{title}");
    let truth = round.truth();
    let mut lines: Vec<Line> = methods()
        .iter()
        .chain(&library())
        .map(|contender| Line {
            name: contender.name,
            points: measure(&truth, |tolerance| (contender.run)(round, tolerance)),
        })
        .collect();
    if let Some(exact) = exact {
        let truth = exact.go(1e-14).expect("once around");
        lines.push(Line {
            name: "exact",
            points: measure(&truth, |tolerance| exact.go(tolerance)),
        });
    }
    let error = Axis::new("error of Φ")
        .logarithmic()
        .from(SHOWN[0], SHOWN[1]);
    let cost = Axis::new("time (µs)").logarithmic();
    let mut panel = Panel::new(error, cost).titled(title);
    for (series, line) in lines.into_iter().enumerate() {
        line.print();
        panel = panel.curve(Curve::line(
            line.name,
            series_of(line.name, series),
            line.front(),
        ));
    }
    panel
}

/// Series are told by their names, since not every panel has all of them.
fn series_of(name: &str, place: usize) -> usize {
    if name == "exact" { 5 } else { place }
}

/// Errors and best times, from loose to tight.
fn measure<const N: usize>(
    truth: &Sensitivities<N>,
    run: impl Fn(f64) -> Option<Sensitivities<N>>,
) -> Vec<[f64; 2]> {
    let mut points = Vec::new();
    for half in 4..=26 {
        let tolerance = 10_f64.powf(-f64::from(half) / 2.0);
        let Some(found) = run(tolerance) else {
            continue;
        };
        let (error, _) = errors(&found, truth);
        let seconds = best(Duration::from_millis(60), || {
            std::hint::black_box(run(std::hint::black_box(tolerance)));
        });
        if error.is_finite() {
            points.push([error, seconds * 1e6]);
        }
        if seconds > PATIENCE {
            break;
        }
    }
    points
}

impl Line {
    /// What can be had: points to which no other is preferable in both error and time.
    fn front(&self) -> Vec<[f64; 2]> {
        let mut sorted = self.points.clone();
        sorted.sort_by(|a, b| a[1].total_cmp(&b[1]));
        let mut front: Vec<[f64; 2]> = Vec::new();
        for point in sorted {
            if front.last().is_none_or(|last| point[0] < last[0]) {
                front.push(point);
            }
        }
        front.retain(|[error, _]| (SHOWN[0]..=SHOWN[1]).contains(error));
        front
    }

    /// The least time of all runs that are as accurate as wanted.
    fn print(&self) {
        let cells = WANTED.map(|wanted| {
            let good = self.points.iter().filter(|[error, _]| *error <= wanted);
            let least = good.map(|[_, time]| *time).min_by(f64::total_cmp);
            least.map_or_else(|| format!("{:>10}", "-"), |time| format!("{time:>10.0}"))
        });
        println!("  {:<40}{}", self.name, cells.concat());
    }
}

fn report(panels: [Panel; 4], out: &Path) -> Result<Written, ReportError> {
    let caption = "Time of one period with Φ and ∂φ/∂r against the error of Φ that it leaves. Further left is more \
                   accurate, further down is faster. `exact` is the exact system and not a copy of it.";
    let figure = panels
        .into_iter()
        .fold(
            Figure::new("1", "Work and precision", caption),
            Figure::panel,
        )
        .columns(2);
    let mut report = Report::begin("", "", out)?;
    report.add(Section {
        title: "Work and precision".to_owned(),
        blocks: vec![Block::Figure(figure)],
    })?;
    Ok(report.written())
}
