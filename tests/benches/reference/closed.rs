//! Once around with all derivatives where a model is linear between events: in closed form, and by the integrator.

use std::time::Duration;

use stickslip::flow::{ExactFamily, Flow, Want};
use stickslip::integrate::Tolerance;
use stickslip::model;
use stickslip::model::Model;
use stickslip::shooting::{Search, closest};
use stickslip_models::DrillString;
use stickslip_models::friction::CoulombStatic;

const ACCURACY: f64 = 1e-9;

model! {
    /// A mass on a belt under Coulomb's law with a larger force at rest.
    struct LinearBelt {
        state x: m = 1.0;
        state v: m/s = 0.0;
        param m: kg = 1.0 where m > 0.0;
        param k: N/m = 1.0 where k > 0.0;
        param c: N*s/m = 0.0 where c >= 0.0;
        param v_dr: m/s = 0.2;
        param rest: N = 1.3 where rest >= 0.0;
        param level: N = 1.0 where level >= 0.0;
        friction F: N = CoulombStatic { static_level: rest, kinetic_level: level } opposing v - v_dr;
        der(x) = v;
        der(v) = (F - k * x - c * v) / m;
    }
}

pub(crate) fn table() {
    println!("\nonce around with all derivatives, at the accuracy {ACCURACY:e}");
    println!(
        "{:<18}{:>12}{:>16}{:>8}",
        "", "closed, µs", "integrated, µs", "events"
    );
    row(DrillString::default(), DrillString::eta.index, [4.0, 3.9]);
    row(LinearBelt::default(), LinearBelt::v_dr.index, [1.2, 0.2]);
}

fn row<M: Model<N>, const N: usize>(model: M, design: usize, start: [f64; N]) {
    let family = ExactFamily {
        model,
        design: Some(design),
        tolerance: Tolerance::for_accuracy(ACCURACY),
        magnitude: [1.0; N],
    };
    let r = model.values().as_ref()[design];
    let search = Search {
        start: start.to_vec(),
        modes: Vec::new(),
        period: None,
        accuracy: ACCURACY,
        segments: 1,
    };
    let orbit = closest(&family.into(), r, &search).expect("the orbit");
    let mut state = [0.0; N];
    state.copy_from_slice(&orbit.place.state);
    let mut events = 0;
    let mut best = |integrated: bool| {
        let flow = family.at(r).expect("a value within bounds");
        let flow = if integrated { flow.integrated() } else { flow };
        let place = flow.place(state).expect("a place");
        super::clock::best(Duration::from_secs(1), || {
            let passage = flow.advance(&place, orbit.period, Want::DERIVATIVES);
            events = std::hint::black_box(passage)
                .expect("once around")
                .events
                .len();
        })
    };
    let times = [false, true].map(|integrated| best(integrated) * 1e6);
    println!(
        "{:<18}{:>12.2}{:>16.2}{events:>8}",
        M::INFO.command,
        times[0],
        times[1]
    );
}
