//! The exact flow against motions in closed form.

use stickslip::flow::exact::ExactFlow;
use stickslip::flow::{EventKind, Flow, Want};
use stickslip::integrate::Tolerance;
use stickslip::model::Model;
use stickslip_models::DrillString;
use stickslip_models::closed_form::{CoulombBelt, Cycle, Ringdown, drill_string};
use stickslip_models::friction::CoulombStatic;

const TIGHT: Tolerance = Tolerance {
    relative: 1e-12,
    absolute: 1e-12,
};
const EXTREMA: Want = Want {
    path: true,
    ..Want::EXTREMA
};

stickslip::model! {
    /// One mass on a belt with Coulomb's law and a larger force at rest.
    pub struct Slider {
        state x: m = 0.0;
        state v: m/s = 0.0;
        param m: kg = 1.0 where m > 0.0;
        param k: N/m = 1.0 where k > 0.0;
        param v_dr: m/s = 0.5;
        param F_s: N = 1.5 where F_s >= 0.0;
        param F_k: N = 1.0 where F_k >= 0.0;
        friction F: N = CoulombStatic { static_level: F_s, kinetic_level: F_k } opposing v - v_dr;
        der(x) = v;
        der(v) = (F - k * x) / m;
    }
}

/// From rest on the belt: release, landing, durations and extrema of the first whole cycle.
fn follows<M: Model<2>>(model: &M, belt: f64, cycle: &Cycle) {
    let flow = ExactFlow::new(model, None, TIGHT).unwrap();
    let wait = 0.1 * cycle.stick;
    let start = flow.place([cycle.release - wait * belt, belt]).unwrap();
    let passage = flow.advance(&start, 1.3 * cycle.period(), EXTREMA).unwrap();
    let events: Vec<_> = passage
        .events
        .iter()
        .filter(|e| !matches!(e.kind, EventKind::Nearest { .. }))
        .collect();
    let [first, landing, second, ..] = events[..] else {
        panic!("{events:?}");
    };
    near(first.time, wait, "release");
    near(first.state[0], cycle.release, "release");
    near(landing.time - first.time, cycle.slip, "slip");
    near(landing.state[0], cycle.landing, "landing");
    near(second.time - first.time, cycle.period(), "period");
    let extreme = |maximum: bool| {
        let of = passage.extrema.iter().filter(|e| e.index == 0);
        of.filter(|e| e.maximum == maximum)
            .map(|e| e.state[0])
            .next()
            .unwrap()
    };
    near(extreme(true), cycle.max, "max");
    near(extreme(false), cycle.min, "min");
}

fn near(value: f64, truth: f64, what: &str) {
    let error = (value - truth).abs();
    assert!(
        error < 2e-10 * (1.0 + truth.abs()),
        "{what}: {value} {truth} {error:e}"
    );
}

#[test]
fn the_closed_form_agrees_with_the_reference_periods() {
    for (eta, period) in [(1.0, 11.227_385_281_133_796), (4.0, 6.530_582_884_211_251)] {
        let model = DrillString {
            eta,
            ..Default::default()
        };
        near(drill_string(&model).unwrap().period(), period, "period");
    }
}

#[test]
fn the_drill_string_follows_its_closed_form() {
    for eta in [0.3, 1.0, 2.0, 3.0, 4.0, 4.6] {
        for zeta in [0.01, 0.05] {
            let model = DrillString {
                eta,
                zeta,
                ..Default::default()
            };
            follows(&model, eta, &drill_string(&model).unwrap());
        }
    }
}

#[test]
fn the_drill_string_stops_sticking_where_its_cycle_grazes() {
    // The cycle ends where the bit just reaches the table's speed again.
    let grazing = 4.611_989_021_286_665;
    let at = |eta: f64| DrillString {
        eta,
        ..Default::default()
    };
    assert!(drill_string(&at(grazing - 1e-9)).is_some());
    assert!(drill_string(&at(grazing + 1e-9)).is_none());
    let lands = |eta: f64| {
        let model = at(eta);
        let flow = ExactFlow::new(&model, None, TIGHT).unwrap();
        let passage = flow
            .advance(&flow.place([2.0, eta]).unwrap(), 30.0, Want::default())
            .unwrap();
        passage
            .events
            .iter()
            .any(|e| matches!(e.kind, EventKind::Landing { .. }))
    };
    assert!(lands(grazing - 1e-8));
    assert!(!lands(grazing + 1e-8));
}

#[test]
fn the_slip_of_the_drill_string_is_a_ringdown() {
    let model = DrillString::default();
    let slip = Ringdown {
        damping: model.zeta,
        position: 6.0,
        rate: 0.0,
    };
    let flow = ExactFlow::new(&model, None, TIGHT).unwrap();
    let start = flow.place([6.0, 0.0]).unwrap();
    let passage = flow.advance(&start, 3.0, EXTREMA).unwrap();
    assert!(passage.path.len() > 16);
    for sample in passage.path {
        assert!((sample.state[0] - slip.position(sample.time)).abs() < 1e-9);
        assert!((sample.state[1] - slip.rate(sample.time)).abs() < 1e-9);
    }
}

#[test]
fn coulomb_sliders_follow_their_closed_form() {
    for (m, k, v_dr, peak, level) in [
        (1.0, 1.0, 0.5, 1.5, 1.0),
        (2.0, 9.0, 0.05, 3.0, 1.0),
        (0.3, 1.0, 2.0, 1.2, 1.1),
        (1200.0, 2.5e6, 0.4, 9000.0, 6000.0),
    ] {
        let model = Slider {
            m,
            k,
            v_dr,
            F_s: peak,
            F_k: level,
        };
        let closed = CoulombBelt {
            mass: m,
            stiffness: k,
            belt: v_dr,
            static_force: peak,
            kinetic_force: level,
        };
        follows(&model, v_dr, &closed.cycle().unwrap());
    }
}
