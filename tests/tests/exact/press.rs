//! Contacts that press and let go.

use stickslip::field::exact::{Mode, Modes};
use stickslip::flow::exact::ExactFlow;
use stickslip::flow::{EventKind, Flow, Passage, Want};
use stickslip::integrate::Tolerance;
use stickslip::model::Model;
use stickslip_models::friction::Coulomb;
use stickslip_models::press::{Compliant, Hertz, HuntCrossley};

const TIGHT: Tolerance = Tolerance {
    relative: 1e-13,
    absolute: 1e-13,
};

stickslip::model! {
    /// A mass on a spring beside which, on one side, another stands.
    pub struct Bilinear {
        state x: m = 0.0;
        state v: m/s = 1.0;
        param m: kg = 1.0 where m > 0.0;
        param k: N/m = 1.0 where k > 0.0;
        param wall: N/m = 8.0 where wall > 0.0;
        param c: N*s/m = 0.0 where c >= 0.0;
        param gap: m = 0.0;
        press N: N = Compliant { stiffness: wall, damping: c } closing x + gap;
        der(x) = v;
        der(v) = (N - k * x) / m;
    }
}

fn flow<M: Model<N>, const N: usize>(model: &M) -> ExactFlow<M, N> {
    ExactFlow::new(model, None, TIGHT).unwrap()
}

fn switches<M: Model<N>, const N: usize>(passage: &Passage<N, Modes<M, N>>) -> Vec<(EventKind, f64)> {
    let switches = passage.events.iter().filter(|event| event.kind.is_switch());
    switches.map(|event| (event.kind, event.time)).collect()
}

#[test]
fn a_spring_on_one_side_shortens_half_of_the_period() {
    let bilinear = Bilinear::default();
    let flow = flow(&bilinear);
    let (free, pressed) = (std::f64::consts::PI, std::f64::consts::PI / 3.0);
    let place = flow.place([0.0, 1.0]).unwrap();
    assert_eq!(place.mode.as_slice(), [Mode::Open]);
    let passage = flow.advance(&place, free + pressed, Want::SHOT).unwrap();
    for (found, expected) in passage.end.state.iter().zip([0.0, 1.0]) {
        assert!((found - expected).abs() < 1e-12, "{found}");
    }
    let found = switches(&passage);
    assert_eq!(found[0].0, EventKind::Closing);
    assert!((found[0].1 - free).abs() < 1e-12);
    println!("{found:?} {:?} {:?}", passage.derivatives, passage.segments);
}
