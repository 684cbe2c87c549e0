//! Equilibria that rest on walls, followed until their reaction vanishes.

use stickslip::continuation::Kind;
use stickslip::model;
use stickslip::model::Model;
use stickslip::study::{Case, Dynamics, System};
use stickslip_models::press::Rigid;

model! {
    /// A weight that is held on a round track by a spring, and pushed along it.
    pub(crate) struct Track {
        state x = 1.0;
        state u = 0.0;
        state y = 5.0;
        state v = 0.0;
        param load = 4.0;
        param lift = 1.0;
        param bend = 0.25;
        param c = 0.2;
        param e = 0.5 where 0.0 <= e <= 1.0;
        press R = Rigid { restitution: e } closing y - bend * x * x;
        der(x) = u;
        der(u) = load - x - c * u - 2.0 * bend * x * R;
        der(y) = v;
        der(v) = R + lift - y;
    }
}

/// On the track (1 + 4b²x²) ẍ + 4b² x ẋ² + c ẋ + x + 2bx R = F with R = b x² − L, which vanishes at x = F = √(L/b).
#[test]
fn what_rests_on_a_track_leaves_it_where_the_reaction_vanishes() {
    let system = System::of::<Track, 4>();
    for (lift, bend, c) in [(1.0, 0.25, 0.2), (0.5, 0.25, 3.0), (2.0, 0.4, 0.1)] {
        let track = Track {
            lift,
            bend,
            c,
            ..Default::default()
        };
        let mut case = Case::declared(Track::INFO, Dynamics::Exact);
        case.parameters = track.values().as_ref().to_vec();
        for name in [Track::load.index, Track::lift.index] {
            let along = if name == Track::load.index {
                case.clone().following(Track::load, 4.0..0.5)
            } else {
                case.clone().following(Track::lift, lift..20.0)
            };
            let branch = system.equilibria_along(&along).unwrap();
            assert!(branch.points.len() > 3);
            for point in &branch.points {
                assert_eq!(point.mode.as_deref(), Some("rest(R)"));
                let (x, r) = (point.state[0], point.r.unwrap());
                let (load, lift) = if name == Track::load.index {
                    (r, lift)
                } else {
                    (track.load, r)
                };
                let reaction = bend * x * x - lift;
                assert!(reaction > -1e-9, "{reaction}");
                let balance = x + 2.0 * bend * x * reaction - load;
                assert!(balance.abs() < 1e-10 && (point.state[2] - bend * x * x).abs() < 1e-10);
                let (mass, k) = (
                    1.0 + 4.0 * bend * bend * x * x,
                    1.0 - 2.0 * bend * lift + 6.0 * bend * bend * x * x,
                );
                let [a, b] = point.eigenvalues.as_slice() else {
                    panic!("{:?}", point.eigenvalues);
                };
                // Beside the two zeros of contact, which are one block, eigenvalues have half of the digits of numbers.
                let (sum, product) = ((a + b).re, (a * b).re);
                assert!((sum + c / mass).abs() < 1e-7, "{sum} {}", c / mass);
                assert!((product - k / mass).abs() < 1e-7, "{product} {}", k / mass);
            }
            let expected = if name == Track::load.index {
                (lift / bend).sqrt()
            } else {
                bend * track.load * track.load
            };
            let last = branch.special.last().expect("a threshold");
            assert_eq!(last.kind, Kind::BoundaryEquilibrium);
            assert!((last.r - expected).abs() < 1e-9, "{} {expected}", last.r);
            assert_eq!(
                branch.ended.reason,
                "the reaction of `R` reaches zero, and with it this contact ends"
            );
        }
    }
}
