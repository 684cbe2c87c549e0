//! The errors that smoothings make: predicted, measured, and fitted.

use stickslip::field::exact::Modes;
use stickslip::flow::ExactFamily;
use stickslip::integrate::Tolerance;
use stickslip::model::Model;
use stickslip::shooting::{Orbit, Search, closest};
use stickslip::study::trade::{Scope, Trade, trade};
use stickslip_models::{BeltOscillator, BeltPair, DrillString};

fn exact<M: Model<N>, const N: usize>(model: &M, start: [f64; N]) -> Orbit<N, Modes<M, N>> {
    let family = ExactFamily {
        model: *model,
        design: None,
        tolerance: Tolerance::for_accuracy(1e-11),
        magnitude: [1.0; N],
    };
    let search = Search {
        start,
        period: None,
        accuracy: 1e-11,
        segments: 1,
    };
    closest(&family, 0.0, &search).unwrap()
}

fn show<M: Model<N>, const N: usize>(model: &M, start: [f64; N]) -> Trade {
    let clock = std::time::Instant::now();
    let scope = Scope {
        accuracy: Some(1e-3),
        ..Scope::default()
    };
    let t = trade(model, &exact(model, start), &scope).unwrap();
    println!("exact {:?} need {:?}", t.exact, t.need);
    for c in &t.curves {
        println!(
            "{} refused {} fit {:?} {:?} lost {:?}",
            c.kernel,
            c.refused.is_some(),
            c.frequency,
            c.max_abs,
            c.lost
        );
        for p in &c.points {
            let r = p.predicted.as_ref().map(|q| {
                (
                    q.frequency / p.frequency,
                    q.max_abs
                        .iter()
                        .zip(&p.max_abs)
                        .map(|(a, b)| a.map(|a| a / b))
                        .collect::<Vec<_>>(),
                    q.doubts.len(),
                )
            });
            println!(
                "  {:e} stiff {:.1e} e_f {:.4e} x {:.3e} res {:.0e} {:.0}us steps {} {r:.3?}",
                p.size,
                p.stiffness,
                p.frequency,
                p.max_abs[0],
                p.resolution,
                p.cost.seconds * 1e6,
                p.cost.work.steps
            );
        }
        println!("  need {:?}", c.need);
    }
    for p in t.precision.iter().take(3) {
        println!("{:?}", p.smoothing);
        for q in &p.points {
            println!(
                "   {:.0e} {:.2e} {:.2e} {:.0}us {}",
                q.tolerance,
                q.integration,
                q.total,
                q.cost.seconds * 1e6,
                q.cost.work.steps
            );
        }
        println!("   failed {:?}", p.failed);
    }
    println!("took {:?}", clock.elapsed());
    t
}

#[test]
fn look() {
    show(&BeltOscillator::default(), [0.0, 0.2]);
    show(&DrillString::default(), [0.0, 4.0]);
    show(&BeltPair::default(), [-0.5976, 0.0, -0.4604, -0.1607]);
    show(
        &BeltPair {
            v_dr: 0.35,
            ..Default::default()
        },
        [-0.02798, 0.0, 0.678, 0.3089],
    );
}
