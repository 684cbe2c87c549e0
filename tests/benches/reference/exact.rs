//! An exact orbit once around with its section map and ∂/∂r, beside the copy by arctan at ε = 1e5 and its error.

use std::time::Duration;

use stickslip::bifurcation::floquet;
use stickslip::field::{Design, Smoothing};
use stickslip::flow::{ExactFamily, SmoothFamily, Want};
use stickslip::integrate::Tolerance;
use stickslip::model::Model;
use stickslip::motion::Family;
use stickslip::shooting::{Orbit, Search, closest};
use stickslip_models::{BeltOscillator, BeltPair};

const ACCURACY: f64 = 1e-9;

pub(crate) fn table() {
    println!("\nonce around with the section map and ∂/∂r, at the accuracy {ACCURACY:e}");
    println!(
        "{:<18}{:>12}{:>8}{:>8}{:>14}{:>12}",
        "", "exact, µs", "wanted", "events", "arctan, µs", "its error"
    );
    let belt = [1.0, 0.0];
    row(
        BeltOscillator::default(),
        BeltOscillator::v_dr.index,
        belt,
        None,
        60.0,
    );
    let pair = [-0.5976, 0.0, -0.4604, -0.1607];
    row(
        BeltPair::default(),
        BeltPair::v_dr.index,
        pair,
        Some(16.14),
        150.0,
    );
}

fn row<M: Model<N>, const N: usize>(
    model: M,
    design: usize,
    start: [f64; N],
    period: Option<f64>,
    wanted: f64,
) {
    let tolerance = Tolerance::for_accuracy(ACCURACY);
    let (magnitude, r) = ([1.0; N], model.values().as_ref()[design]);
    let exact = ExactFamily {
        model,
        design: Some(design),
        tolerance,
        magnitude,
    }
    .into();
    let copy = SmoothFamily {
        model,
        smoothing: "arctan:1e5".parse::<Smoothing>().ok(),
        design: Design::Parameter(design),
        tolerance,
        magnitude,
    }
    .into();
    let search = Search {
        start: start.to_vec(),
        modes: Vec::new(),
        period,
        accuracy: ACCURACY,
        segments: 1,
    };
    let orbit = closest(&exact, r, &search).expect("the exact orbit");
    let search = Search {
        start: orbit.place.state.clone(),
        period: Some(orbit.period),
        ..search
    };
    let smooth = closest(&copy, r, &search).expect("its copy");
    let (time, events) = round(&exact, &orbit);
    let (copy_time, _) = round(&copy, &smooth);
    println!(
        "{:<18}{:>12.1}{wanted:>8}{events:>8}{:>14.1}{:>12.1e}",
        M::INFO.command,
        time * 1e6,
        copy_time * 1e6,
        smooth.period / orbit.period - 1.0,
    );
}

/// Seconds for one way around, and the number of events on it.
fn round(family: &Family, orbit: &Orbit) -> (f64, usize) {
    let want = Want {
        derivatives: true,
        ..Want::default()
    };
    let mut events = 0;
    let seconds = super::clock::best(Duration::from_secs(1), || {
        let flow = family.at(orbit.r).expect("a value within bounds");
        let passage = flow
            .advance(&orbit.place, orbit.period, want)
            .expect("once around");
        let derivatives = passage.derivatives.as_ref().expect("what was wanted");
        events = passage.events.len();
        std::hint::black_box(floquet(
            &derivatives.state,
            &derivatives.time,
            None,
            0,
            &[],
            0,
            ACCURACY,
        ));
    });
    (seconds, events)
}
