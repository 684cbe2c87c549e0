//! A part that hops along a vibrating track: friction under a chatter that turns before that ends.

use stickslip::model;
use stickslip::model::Model as _;
use stickslip::study::{Case, Dynamics, System};
use stickslip_models::friction::Coulomb;
use stickslip_models::press::Rigid;

model! {
    /// A part on a track that shakes it up and along, seen at a whole phase.
    pub struct Feeder {
        state y: m = 2e-4;
        state vy: m/s = 0.0;
        state vx: m/s = 0.0;
        param m: kg = 0.05 where m > 0.0;
        param g: m/s^2 = 9.81;
        param mu = 0.3 where mu >= 0.0;
        param e = 0.2 where 0.0 <= e <= 1.0;
        param along: m = 4e-4;
        param up: m = 1.2e-4;
        param slope = 0.05;
        param omega: rad/s = 314.0 where omega > 0.0;
        drive phi at omega;
        press N: N = Rigid { restitution: e } closing y - up * cos(phi);
        friction F: N = Coulomb { level: mu * N } opposing vx + along * omega * sin(phi);
        der(y) = vy;
        der(vy) = N / m - g;
        der(vx) = F / m - slope * g;
    }
}

/// Flights are parabolas, and impulses are Coulomb's: from impact to impact by hand, at frequencies at which the part sticks
/// in one of the last. A chatter that ended where the part went one way gave 0.011 772 741 for the first.
#[test]
fn a_chatter_is_followed_until_friction_under_it_keeps_its_way() {
    for (omega, right) in [(347.45, 0.011_767_921_1), (347.47, 0.011_533_224_5)] {
        let mut case = Case::declared(Feeder::INFO, Dynamics::Exact);
        case.parameters[Feeder::omega.index] = omega;
        let orbit = System::of::<Feeder, _>().orbit(&case).unwrap();
        assert!((orbit.state[2] - right).abs() < 1e-8, "{orbit:?}");
    }
}
