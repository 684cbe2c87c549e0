//! What a wall that moves carries: contact that lasts all the way round, until it is thrown off.

use stickslip::field::Design;
use stickslip::model;
use stickslip::study::{Along, Case, Dynamics, System};
use stickslip_models::friction::Coulomb;
use stickslip_models::press::Rigid;

model! {
    /// A follower that a spring presses on its cam.
    pub struct Cam {
        state x: m = 0.02;
        state v: m/s = 0.0;
        param m: kg = 0.2 where m > 0.0;
        param k: N/m = 800.0 where k > 0.0;
        param preload: N = 20.0;
        param c: N*s/m = 1.0 where c >= 0.0;
        param lift: m = 0.01;
        param omega: rad/s = 60.0 where omega > 0.0;
        param e: 1 = 0.4 where 0.0 <= e < 1.0;
        drive phi at omega;
        press N: N = Rigid { restitution: e } closing x - lift * cos(phi);
        der(x) = v;
        der(v) = (N - preload - k * x - c * v) / m;
    }
}

model! {
    /// A part on a trough that shakes along a slope: it rubs, is carried along, and hops where the trough falls too fast.
    pub struct Feeder {
        state x: m = 0.0;
        state y: m = 0.001;
        state vx: m/s = 0.0;
        state vy: m/s = 0.0;
        param g: m/s^2 = 9.81;
        param throw: m = 0.0005;
        param omega: rad/s = 150.0 where omega > 0.0;
        param slope: rad = 0.5;
        param mu: 1 = 0.4 where mu >= 0.0;
        param e: 1 = 0.2 where 0.0 <= e < 1.0;
        drive phi at omega;
        press N: m/s^2 = Rigid { restitution: e } closing y - throw * sin(slope) * cos(phi);
        friction F: m/s^2 = Coulomb { level: mu * N } opposing vx + throw * omega * cos(slope) * sin(phi);
        der(x) = vx;
        der(y) = vy;
        der(vx) = F;
        der(vy) = N - g;
    }
}

/// The branch along a parameter, and where the first segment of another mode appears on it.
fn first(
    system: &System,
    parameter: usize,
    from: f64,
    to: f64,
) -> (Vec<stickslip::study::OrbitRecord>, f64) {
    let design = Design::Parameter(parameter);
    let case = Case {
        along: Some(Along { design, from, to }),
        harmonics: vec![1],
        ..Case::declared(system.info(), Dynamics::Exact).at(from)
    };
    let branch = system.branch(&case).unwrap();
    let first = branch
        .special
        .first()
        .unwrap_or_else(|| panic!("{:?}", branch.ended));
    (branch.points, first.r)
}

#[test]
fn a_cam_carries_its_follower_until_the_reaction_vanishes() {
    let (points, lost) = first(&System::of::<Cam, _>(), Cam::omega.index, 60.0, 125.0);
    for orbit in points.iter().filter(|orbit| orbit.r.unwrap() < lost) {
        assert_eq!(orbit.word.as_deref(), Some("rest(N)"));
        let found = &orbit.harmonics.as_ref().unwrap()[0];
        assert!(
            (found.amplitude[0] - 0.01).abs() < 1e-11 && found.phase[0].abs() < 1e-9,
            "{found:?}"
        );
    }
    // ((k − m ω²)² + c² ω²) h² = P², with k = 800, m = 0.2, c = 1, h = 0.01 and P = 20.
    let square = |w: f64| (800.0 - 0.2 * w * w).powi(2) + w * w - 2000.0_f64.powi(2);
    assert!(
        square(lost * (1.0 - 1e-8)) < 0.0 && square(lost * (1.0 + 1e-8)) > 0.0,
        "{lost}"
    );
}

#[test]
fn a_part_is_carried_along_and_hops_where_the_trough_falls_faster() {
    let (points, hops) = first(
        &System::of::<Feeder, _>(),
        Feeder::omega.index,
        150.0,
        210.0,
    );
    let right = (9.81 / (0.0005 * 0.5_f64.sin())).sqrt();
    assert!((hops / right - 1.0).abs() < 1e-8, "{hops} {right}");
    for orbit in points.iter().filter(|orbit| orbit.r.unwrap() < hops) {
        let gain = orbit.shift.as_ref().unwrap();
        // Friction has no mean over a period, so that the part moves on by what the mean of its speed is.
        assert!(gain[0] > 5e-4 && gain[1..] == [0.0; 4], "{gain:?}");
        assert!((orbit.max[1] - 0.0005 * 0.5_f64.sin()).abs() < 1e-12);
    }
}

model! {
    /// A valve that its spring presses on a cam, with friction in its guide.
    pub struct Valve {
        state y: m = 0.02;
        state v: m/s = 0.0;
        param m: kg = 0.2 where m > 0.0;
        param k: N/m = 5000.0;
        param preload: N = 80.0;
        param guide: N = 5.0 where guide >= 0.0;
        param lift: m = 0.005;
        param second: m = 0.0005;
        param omega: rad/s = 314.0 where omega > 0.0;
        drive phi at omega;
        press N: N = Rigid { restitution: 0.3 } closing y - lift * (1.0 + cos(phi)) - second * cos(2.0 * phi);
        friction G: N = Coulomb { level: guide } opposing v;
        der(y) = v;
        der(v) = (N + G - preload - k * y) / m;
    }
}

/// At the top of the cam the reaction is least, and there friction turns: from where it does not vanish before that, the valve
/// leaves just when friction lets it. The place is known in closed form, and come to from both sides.
#[test]
fn a_valve_leaves_its_cam_where_friction_turns() {
    let system = System::of::<Valve, _>();
    let top = |omega: f64, lift: f64| {
        0.2 * (lift + 0.002) * omega * omega - 80.0 - 5000.0 * (2.0 * lift + 0.0005)
    };
    let guide = top(314.0, 0.005);
    let lift = (87.5 - 0.0004 * 314.0 * 314.0) / (0.2 * 314.0 * 314.0 - 1e4);
    for (parameter, from, to, left) in [
        (Valve::guide, 5.0, 8.0, guide),
        (Valve::guide, 8.0, 5.0, guide),
        (Valve::lift, 0.005, 0.0045, lift),
    ] {
        let mut case = Case::declared(system.info(), Dynamics::Exact);
        case.parameters[parameter.index] = from;
        let design = Design::Parameter(parameter.index);
        case.along = Some(Along { design, from, to });
        let branch = system.branch(&case).unwrap();
        assert!(branch.ended.is_whole(), "{}", branch.ended.reason);
        let [special] = &branch.special[..] else {
            panic!("{:?} beside {left}", branch.special);
        };
        assert!(
            (special.r / left - 1.0).abs() < 1e-6,
            "{special:?} is not {left}"
        );
    }
}

model! {
    /// A follower on a cam of two harmonics, in a guide that rubs.
    struct Guided {
        state y = 0.0;
        state v = 0.0;
        param m = 0.2 where m > 0.0;
        param h = 0.005;
        param second = 0.0005;
        param guide = 4.0 where guide >= 0.0;
        drive phi at 100.0;
        press R = Rigid { restitution: 0.4 } closing y - h * (1.0 - cos(phi)) + second * cos(3.0 * phi);
        friction F = Coulomb { level: guide } opposing v;
        der(y) = v;
        der(v) = (R + F - 60.0 - 4000.0 * y - v) / m;
    }
}

/// Where the guide rubs the other way the follower keeps still for no time: there are no derivatives, but harmonics.
#[test]
fn harmonics_need_no_derivatives() {
    let (system, mut case) = (System::of::<Guided, _>(), Case::of(&Guided::default()));
    case.harmonics = vec![1, 3];
    let orbit = system.orbit(&case).unwrap();
    let found = orbit.harmonics.as_ref().expect("harmonics");
    for (found, known) in found.iter().zip([0.005, 0.0005]) {
        assert!((found.amplitude[0] / known - 1.0).abs() < 1e-9, "{found:?}");
    }
}
