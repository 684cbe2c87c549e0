//! States that seem to move and rest, and others that seem to rest and move.

use stickslip::model;
use stickslip::study::{Case, Dynamics, System};
use stickslip_models::friction::{Coulomb, Gaussian};

model! {
    /// A deck on two hangers that twists, and heaves by what rounding leaves of its weight.
    struct Deck {
        state th: rad = 0.1;
        state om: rad/s = 0.0;
        state y: m = 0.0;
        state v: m/s = 0.0;
        param m: kg = 2500.0 where m > 0.0;
        param k: N/m = 1000.0 where k > 0.0;
        param d: 1/s = 0.01;
        param hold: 1/s^2 = 0.002 where hold >= 0.0;
        drive phi at 1.25;
        let sag = m * 9.81 / (2.0 * k);
        let left = k * (sag + y - 6.0 * sin(th));
        let right = k * (sag + y + 6.0 * sin(th));
        friction F: 1/s^2 = Coulomb { level: hold } opposing om;
        der(th) = om;
        der(om) = 3.0 * cos(th) / (m * 6.0) * (left - right) - d * om + 0.05 * cos(phi) + F;
        der(y) = v;
        der(v) = 9.81 - (left + right) / m - d * v;
    }
}

/// Its heave was measured in its own rounding errors, to which no motion can be followed. Disturbed, it swings as
/// ÿ + d ẏ + (2 k/m) y = 0 says.
#[test]
fn what_only_rounding_moves_is_at_rest() {
    let system = System::of::<Deck, _>();
    let orbit = system.orbit(&Case::declared(system.info(), Dynamics::Exact));
    let orbit = orbit.unwrap();
    assert!(orbit.error_estimate < 1e-8, "{:e}", orbit.error_estimate);
    assert_eq!((orbit.min[2], orbit.max[2]), (0.0, 0.0));
    assert_eq!((orbit.min[3], orbit.max[3]), (0.0, 0.0));
    let period = std::f64::consts::TAU / 1.25;
    let (size, turn) = (-0.005 * period, (0.8_f64 - 0.005 * 0.005).sqrt() * period);
    let heave = size.exp() * turn.cos();
    let multipliers = orbit.floquet.multipliers.iter();
    let heaving = multipliers.filter(|one| (one.re - heave).abs() < 1e-8);
    assert_eq!(heaving.count(), 2);
}

model! {
    /// What swings about `z` dies away before that has grown.
    struct Drifting {
        state x = 1.0;
        state v = 0.0;
        state z = 1e-4;
        param hold = 1e-9 where hold >= 0.0;
        friction F = Coulomb { level: hold } opposing v - 1.0;
        der(x) = v;
        der(v) = z - x - 0.4 * v + F;
        der(z) = 0.1 * z;
    }
}

/// Its last swing was small beside where it has come: it was called settled there, at 1e8 and more.
#[test]
fn what_swings_no_more_but_grows_has_not_settled() {
    let system = System::of::<Drifting, _>();
    let orbit = system.orbit(&Case::declared(system.info(), Dynamics::Exact));
    let said = orbit.unwrap_err().to_string();
    assert!(said.contains("grows without bound"), "{said}");
}

model! {
    /// A servo that hunts: an integrating controller against friction on fixed ground.
    struct Hunt {
        state x = 0.1;
        state v = 0.0;
        state z = 0.0;
        friction F = Gaussian { static_level: 1.0, kinetic_level: 0.6, speed: 0.05, viscous: 0.0 } opposing v;
        der(x) = v;
        der(v) = F - 4.0 * x - 3.0 * z - 2.0 * v;
        der(z) = x;
    }
}

/// Where it is least it sticks, while the controller winds up: one orbit was told from different places of that, and one of
/// them counted beside the place at which it comes to rest.
#[test]
fn an_orbit_that_rests_where_it_is_least_begins_as_it_comes_to_rest() {
    let system = System::of::<Hunt, _>();
    for (x, z) in [(0.1, 0.0), (0.05, 0.2)] {
        let mut case = Case::declared(system.info(), Dynamics::Exact);
        case.start = Some(vec![x, 0.0, z]);
        let orbit = system.orbit(&case).unwrap();
        assert_eq!(orbit.period_count, 1);
        // As it comes to rest: it then sticks for six seconds, in which this falls by 0.5.
        let from = orbit.state[2];
        assert!((from - 0.261_021_2).abs() < 1e-6, "{x}: {from}");
    }
}
