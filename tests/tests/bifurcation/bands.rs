//! Bands in which friction holds: all there are, and in any units.

use stickslip::bifurcation::Stability;
use stickslip::model;
use stickslip::model::Model;
use stickslip::study::{Case, Dynamics, EquilibriumRecord, System};
use stickslip_models::friction::Coulomb;

model! {
    /// A pendulum on a shaft that turns, with dry friction in its pin (after Biemond, van de Wouw, Nijmeijer 2010).
    struct Turned {
        state angle = 0.6;
        state w = 0.0;
        param spin = 64.0;
        param pull = 32.7;
        param hold = 0.5 where hold >= 0.0;
        friction F = Coulomb { level: hold } opposing w;
        der(angle) = w;
        der(w) = F - 0.1 * w + (spin * cos(angle) - pull) * sin(angle);
    }
}

model! {
    /// A check valve before a small volume of oil, in units of the SI.
    struct Valve {
        state x: m = 5e-4;
        state v: m/s = 0.0;
        state p: Pa = 3.5e6;
        param mass: kg = 0.02 where mass > 0.0;
        param k: N/m = 3e4 where k > 0.0;
        param preload: N = 150.0;
        param area: m^2 = 5e-5;
        param bulk: Pa/m^3 = 2e13;
        param inflow: m^3/s = 8e-4;
        param outflow: m^2/s/Pa = 4e-7;
        param hold: N = 1.0 where hold >= 0.0;
        friction F: N = Coulomb { level: hold } opposing v;
        der(x) = v;
        der(v) = (p * area - k * x - preload + F) / mass;
        der(p) = bulk * (inflow - outflow * x * p);
    }
}

model! {
    /// A plate that a charge pulls over a gap of nanometres.
    struct Plate {
        state x: m = 6e-9;
        state v: m/s = 0.0;
        param mass: kg = 1e-15 where mass > 0.0;
        param k: N/m = 1.0;
        param gap: m = 9e-9;
        param pull: N*m^2 = 5e-26;
        der(x) = v;
        der(v) = (pull / powi(gap - x, 2) - k * x - 1e-9 * v) / mass;
    }
}

/// Whether one of the bands of a state has these ends.
fn has(found: &[EquilibriumRecord], j: usize, (low, high): (f64, f64)) -> bool {
    let near = |a: f64, b: f64| (a - b).abs() <= 1e-8 * b.abs();
    found.iter().any(|one| {
        one.set
            .as_ref()
            .is_some_and(|extent| near(extent.low[j], low) && near(extent.high[j], high))
    })
}

/// (s cos θ − p) sin θ = ±h, by halving.
fn bears(low: f64, high: f64, force: f64) -> f64 {
    let off = |angle: f64| (64.0 * angle.cos() - 32.7) * angle.sin() - force;
    let (mut low, mut high) = (low, high);
    for _ in 0..60 {
        let middle = f64::midpoint(low, high);
        if (off(middle) > 0.0) == (off(low) > 0.0) {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

#[test]
fn a_pendulum_that_turns_has_a_band_wherever_it_balances() {
    let case = Case::declared(Turned::INFO, Dynamics::Exact);
    let found = System::of::<Turned, 2>().equilibria(&case).unwrap();
    let out = (bears(0.8, 1.1, 0.5), bears(0.8, 1.1, -0.5));
    let down = bears(-0.1, 0.1, 0.5);
    for band in [(-down, down), out, (-out.1, -out.0)] {
        assert!(has(&found, 0, band), "{band:?} {found:?}");
    }
    // The ends of two bands are not those of one.
    for one in &found {
        let extent = one.set.as_ref().unwrap();
        assert!(extent.high[0] - extent.low[0] < 0.04, "{one:?}");
    }
}

/// p A = k x + F₀ ± h and q = b x p at the ends.
#[test]
fn a_valve_in_pascals_and_metres_sticks() {
    let case = Case::declared(Valve::INFO, Dynamics::Exact);
    let found = System::of::<Valve, 3>().equilibria(&case).unwrap();
    let lift =
        |preload: f64| (-preload + (preload * preload + 4.0 * 3e4 * 5e-5 * 2e3).sqrt()) / 6e4;
    assert!(has(&found, 0, (lift(151.0), lift(149.0))), "{found:?}");
    let open = found.iter().find(|one| one.state[0] > 0.0).unwrap();
    assert_eq!(open.stability, Stability::Stable);
}

/// x (g − x)² = P/k: two roots in the gap, and one beyond it, which its equations have as well.
#[test]
fn nanometres_apart_are_not_one() {
    let case = Case::declared(Plate::INFO, Dynamics::Smooth);
    let found = System::of::<Plate, 2>().equilibria(&case).unwrap();
    assert_eq!(found.len(), 3, "{found:?}");
    for one in &found {
        let x = one.state[0] * 1e9;
        assert!((x * (9.0 - x).powi(2) - 50.0).abs() < 1e-9, "{one:?}");
    }
}
