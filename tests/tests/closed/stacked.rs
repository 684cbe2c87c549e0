//! What rides on a block that slides to and fro: friction holds it without a trace of rounding errors, anywhere.

use std::f64::consts::{FRAC_PI_2, PI};

use stickslip::model;
use stickslip::study::{Case, Stability, System};
use stickslip_models::friction::Coulomb;

model! {
    /// Two blocks, one on the other, on ground that shakes.
    struct Stacked {
        state low: m = 0.0;
        state low_speed: m/s = 0.0;
        state slide: m = 0.0;
        state slide_speed: m/s = 0.0;
        param lower: kg = 3.0e3 where lower > 0.0;
        param upper: kg = 1.1e3 where upper > 0.0;
        param gravity: m/s^2 = 9.81;
        param mu: 1 = 0.12 where mu >= 0.0;
        param shake: m/s^2 = 3.0;
        param omega: rad/s = 8.0 where omega > 0.0;
        drive phi at omega;
        friction F: N = Coulomb { level: mu * (lower + upper) * gravity } opposing low_speed;
        friction G: N = Coulomb { level: 2.0 * mu * upper * gravity } opposing slide_speed;
        let below = (F - G) / lower;
        let above = G / upper;
        der(low) = low_speed;
        der(low_speed) = below - shake * cos(phi);
        der(slide) = slide_speed;
        der(slide_speed) = above - below;
    }
}

/// The pair turns at the phase −a with sin a = π μ g/(2 A), where its speed has been to one side for half a turn.
#[test]
fn a_block_that_rides_on_another_one_stays_where_it_is() {
    let stacked = Stacked::default();
    let found = System::of::<Stacked, _>().orbit(&Case::of(&stacked));
    let orbit = found.expect("an orbit");
    let grip = stacked.mu * stacked.gravity;
    let turn = (FRAC_PI_2 * grip / stacked.shake).asin();
    let speed = grip * (turn - FRAC_PI_2) / stacked.omega;
    assert!((orbit.period - 2.0 * PI / stacked.omega).abs() < 1e-12);
    assert!(
        (orbit.state[1] / speed - 1.0).abs() < 1e-9,
        "{:?}",
        orbit.state
    );
    assert_eq!(orbit.word.as_deref(), Some("slip-(F) slip+(F)"));
    // One of the two places is as good as any other, and so is the other one.
    assert_eq!(orbit.held.len(), 2);
    assert_eq!(orbit.floquet.stability, Stability::Stable);
    assert_eq!(orbit.max[2], orbit.min[2]);
}
