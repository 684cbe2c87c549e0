//! Orbits beside which there are others: what is held, and what is not taken for it.

use stickslip::field::Design;
use stickslip::field::exact::Mode;
use stickslip::model;
use stickslip::model::Model;
use stickslip::shooting::OrbitError;
use stickslip::study::{Along, Case, Dynamics, Kind, OrbitRecord, StudyError, System};
use stickslip_models::BeltPair;
use stickslip_models::friction::{Coulomb, Jenkins, Stribeck};

model! {
    /// A mass between a spring and a friction damper, driven.
    pub struct Damped {
        state x = 0.0;
        state v = 0.0;
        /// Force in the damper.
        state z = 0.0;
        param level = 5.0 where level > 0.0;
        param grip = 0.5 where grip > 0.0;
        param damping = 0.02 where damping >= 0.0;
        param load = 0.1;
        param omega = 0.4 where omega > 0.0;
        drive phi at omega;
        friction F = Jenkins { stiffness: grip, level: level } opposing v with z;
        der(x) = v;
        der(v) = F - x - damping * v + load * cos(phi);
    }
}

model! {
    /// A mass pushed to and fro over the ground, which holds it nowhere.
    pub struct Pushed {
        state x = 0.3;
        state v = 0.0;
        param level = 1.0 where level >= 0.0;
        param load = 3.0;
        param omega = 0.5 where omega > 0.0;
        drive phi at omega;
        friction F = Coulomb { level: level } opposing v;
        der(x) = v;
        der(v) = F + load * cos(phi);
    }
}

model! {
    /// A body on a leaf spring that rubs more than it bears, on a tyre over a wavy road: both go up and down as one.
    pub struct Stiff {
        state body: m = 0.0;
        state up: m/s = 0.0;
        state wheel: m = 0.0;
        state w: m/s = 0.0;
        param ms: kg = 300.0 where ms > 0.0;
        param mu: kg = 40.0 where mu > 0.0;
        param ks: N/m = 2e4;
        param kt: N/m = 1.8e5 where kt > 0.0;
        param ct: N*s/m = 50.0;
        param rub: N = 300.0 where rub >= 0.0;
        param wave: m = 0.01;
        param omega: rad/s = 8.0 where omega > 0.0;
        drive phi at omega;
        friction F: N = Coulomb { level: rub } opposing up - w;
        der(body) = up;
        der(up) = (F - ks * (body - wheel)) / ms;
        der(wheel) = w;
        der(w) = (kt * (wave * cos(phi) - wheel) - ct * w - F + ks * (body - wheel)) / mu;
    }
}

fn system<M: Model<N>, const N: usize>() -> System {
    System::of::<M, N>()
}

/// |H|, the response of x to the load while the damper is stuck: k = 1 + grip.
fn response(omega: f64) -> f64 {
    0.1 / (1.5 - omega * omega).hypot(0.02 * omega)
}

fn swings_as_it_should(orbit: &OrbitRecord, omega: f64) {
    let swing = 0.5 * (orbit.max[0] - orbit.min[0]);
    let right = response(omega);
    assert!(
        (swing / right - 1.0).abs() < 1e-9,
        "{omega}: {swing} against {right}"
    );
    let [held] = &orbit.held[..] else {
        panic!("{:?}", orbit.held);
    };
    assert!(
        held.conserved && held.combination == "0.5 x - z",
        "{held:?}"
    );
    let now = 0.5 * orbit.state[0] - orbit.state[2];
    assert!((now - held.value).abs() < 1e-9);
    assert_eq!(orbit.floquet.multipliers.len(), 2);
    let size = (-0.01 * orbit.period).exp();
    assert!(
        orbit
            .floquet
            .multipliers
            .iter()
            .all(|mu| (mu.norm() / size - 1.0).abs() < 1e-7)
    );
}

#[test]
fn a_stuck_damper_keeps_its_preload_through_resonance() {
    let system = system::<Damped, 4>();
    // So near to resonance an error of one period is fourteen of the orbit.
    let case = Case {
        accuracy: 1e-11,
        ..Case::declared(Damped::INFO, Dynamics::Smooth)
    };
    let orbit = system.orbit(&case).expect("an orbit");
    swings_as_it_should(&orbit, 0.4);
    let along = Along {
        design: Design::Parameter(Damped::omega.index),
        from: 0.4,
        to: 2.0,
    };
    let case = Case {
        along: Some(along),
        ..case
    };
    let branch = system.branch(&case).expect("a branch");
    assert!(branch.special.is_empty() && branch.points.len() > 20);
    for point in &branch.points {
        swings_as_it_should(point, point.r.expect("along a parameter"));
    }
}

#[test]
fn what_lies_anywhere_is_held_where_it_is() {
    let system = system::<Pushed, 3>();
    let orbit = system
        .orbit(&Case::declared(Pushed::INFO, Dynamics::Exact))
        .expect("an orbit");
    let [held] = &orbit.held[..] else {
        panic!("{:?}", orbit.held);
    };
    assert!(!held.conserved && held.combination == "x", "{held:?}");
    assert!((orbit.state[0] - held.value).abs() < 1e-8, "{held:?}");
    assert_eq!(
        orbit.floquet.stability,
        stickslip::bifurcation::Stability::Stable
    );
}

/// Two masses swing against each other a million times while they swing together once: they come back to where they were but
/// for 1e-11 of their swing, and set off with the slow motion all the same.
#[test]
fn what_sets_off_slowly_is_no_family_of_orbits() {
    let model = system::<BeltPair, 4>();
    let mut case = Case::declared(model.info(), Dynamics::Exact);
    case.parameters[BeltPair::alpha.index] = 1e12;
    let error = model.orbit(&case).expect_err("no orbit attracts");
    let settles = matches!(error, StudyError::Orbit(OrbitError::NotSettled { .. }));
    assert!(settles, "{error}");
}

/// Where the body turns, all rates of the difference vanish but for rounding: it is conserved all the same.
#[test]
fn a_stuck_spring_keeps_what_it_carries_where_everything_turns() {
    let orbit = system::<Stiff, 5>()
        .orbit(&Case::declared(Stiff::INFO, Dynamics::Exact))
        .expect("an orbit");
    let [held] = &orbit.held[..] else {
        panic!("{:?}", orbit.held);
    };
    assert!(
        held.conserved && held.combination == "body - wheel",
        "{held:?}"
    );
    let swing = 1.8e5 * 0.01 / (1.8e5 - 340.0 * 64.0_f64).hypot(50.0 * 8.0);
    assert!((orbit.max[2] / swing - 1.0).abs() < 1e-8, "{:?}", orbit.max);
    assert!(orbit.error_estimate < 1e-7, "{orbit:?}");
}

model! {
    /// A drum that an imbalance shakes, and struts that rub hold: what they hold adds up to rounding only.
    pub struct Drum {
        state x: m = 0.0;
        state v: m/s = 0.0;
        param m: kg = 40.0 where m > 0.0;
        param k: N/m = 16000.0;
        param c: N*s/m = 20.0;
        param rub: N = 78.0 where rub >= 0.0;
        param e: kg*m = 0.2;
        param omega: rad/s = 5.0 where omega > 0.0;
        drive phi at omega;
        friction F: N = Coulomb { level: rub } opposing v;
        der(x) = v;
        der(v) = (F - k * x - c * v + e * powi(omega, 2) * cos(phi)) / m;
    }
}

/// Struts hold it up to e ω² = 78 N, at 19.7 rad/s.
#[test]
fn what_friction_holds_is_followed_though_only_rounding_moves_it() {
    let system = system::<Drum, 3>();
    let mut case = Case::declared(Drum::INFO, Dynamics::Exact);
    case.along = Some(Along {
        design: Design::Parameter(Drum::omega.index),
        from: 5.0,
        to: 19.0,
    });
    let branch = system.branch(&case).expect("a branch");
    assert!(branch.ended.is_whole(), "{}", branch.ended.reason);
    for orbit in &branch.points {
        assert!(orbit.error_estimate < 1e-8, "{orbit:?}");
        // Where friction bears as much the one way as the other, as far as the orbit is known.
        let held = 78.0 / 16000.0;
        assert!(
            orbit.max[0].abs() < orbit.error_estimate * held,
            "{orbit:?}"
        );
        assert!(orbit.max[1].abs() < 1e-20, "{orbit:?}");
    }
}

model! {
    /// A wagon on wedges, which rub the more, the deeper it sinks, on a wavy track.
    pub struct Wedge {
        state y: m = 0.0;
        state v: m/s = 0.0;
        param k: 1/s^2 = 100.0;
        param c: 1/s = 0.2;
        param mu = 0.15 where mu >= 0.0;
        param rest: m = 0.1;
        param wave: m = 0.02;
        param omega: rad/s = 6.0 where omega > 0.0;
        drive phi at omega;
        friction F: m/s^2 = Coulomb { level: mu * k * (rest + y) } opposing v;
        der(y) = v;
        der(v) = F - k * (y - wave * sin(phi)) - c * v;
    }
}

/// Where it is held it can be at several places, but only at y = 0 are both ways as far from letting go: up to
/// μ = wave / rest. Slides that vanish there end at that place, and begin from it.
#[test]
fn what_is_held_lets_go_where_slides_vanish() {
    let system = system::<Wedge, 3>();
    for (from, to) in [(0.15, 0.3), (0.3, 0.15)] {
        let mut case = Case::declared(Wedge::INFO, Dynamics::Exact).at(from);
        case.along = Some(Along {
            design: Design::Parameter(Wedge::mu.index),
            from,
            to,
        });
        let branch = system.branch(&case).expect("a branch");
        assert!(branch.ended.is_whole(), "{}", branch.ended.reason);
        let gone = branch.special.iter();
        let gone: Vec<_> = gone
            .filter(|one| one.kind == Kind::VanishingSegment)
            .collect();
        let [one] = gone[..] else {
            panic!("{:?}", branch.special);
        };
        let (off, error) = ((one.r - 0.2).abs(), one.error.unwrap());
        assert!(off < 1e-9 && off <= error, "{} ± {error}", one.r);
    }
}

model! {
    /// The head of a pantograph on a wire, on a frame that rubs in its guide more than it bears.
    pub struct Head {
        state h: m = 0.0;
        state v: m/s = 0.0;
        state frame: m = 0.05;
        state w: m/s = 0.0;
        param dry: N = 40.0 where dry >= 0.0;
        param load: N = 10.0;
        param omega: rad/s = 7.0 where omega > 0.0;
        drive phi at omega;
        friction F: N = Coulomb { level: dry } opposing w;
        der(h) = v;
        der(v) = (7e3 * (frame - h) + 130.0 * (w - v) - 3.6e3 * h + load * cos(phi)) / 9.0;
        der(frame) = w;
        der(w) = (110.0 + F - 7e3 * (frame - h) - 130.0 * (w - v)) / 17.0;
    }
}

/// Against fixed ground a speed is its own only term: that one of 1e-50 is what was left where a contact stuck, only the mode
/// tells that was saved with it. One that moves does not stick because that is said of it.
#[test]
fn an_orbit_that_is_held_is_found_again_from_what_was_saved() {
    let system = system::<Head, 5>();
    let case = Case::declared(Head::INFO, Dynamics::Exact);
    let orbit = system.orbit(&case).unwrap();
    assert_eq!(orbit.modes, [Mode::Stick]);
    let from = |w: f64, modes: &[Mode]| {
        let mut start = orbit.state.clone();
        start[3] = w;
        Case {
            start: Some(start),
            modes: modes.to_vec(),
            period: Some(orbit.period),
            ..case.clone()
        }
    };
    for left in [2.7e-50, -8.8e-47, 1e-19] {
        // What slides comes to rest at once: it may be found from its calmest place all the same, and nothing else may.
        let unknown = system.orbit(&from(left, &[]));
        let again = system.orbit(&from(left, &orbit.modes)).unwrap();
        for found in unknown.iter().chain([&again]) {
            assert!((found.max[0] / orbit.max[0] - 1.0).abs() < 1e-9);
        }
    }
    for modes in [&[][..], &orbit.modes] {
        let motion = system.motion(&from(0.1, modes), 1e-3).unwrap();
        assert_eq!(motion.states[0][3], 0.1);
    }
}

model! {
    /// A servo axis under integral control: it hunts, but where friction hardly drops less and less each time.
    pub struct Hunting {
        state x: m = 0.01;
        state v: m/s = 0.0;
        state z: m*s = 0.0;
        param mass: kg = 1.0;
        param kp: N/m = 100.0;
        param ki: N/m/s = 200.0;
        param kd: N*s/m = 5.0;
        param peak: N = 1.1;
        friction F: N = Stribeck { static_level: peak, kinetic_level: 1.0, speed: 0.01, exponent: 2.0, viscous: 0.5 } opposing v;
        der(x) = v;
        der(v) = (F - kp * x - ki * z - kd * v) / mass;
        der(z) = x;
    }
}

/// Each slip leaves a fifth of the way to x = 0, where friction bears all that it can: F = ki z.
#[test]
fn what_hunts_ever_less_comes_to_rest() {
    let system = system::<Hunting, _>();
    let case = Case::declared(system.info(), Dynamics::Exact);
    let Err(StudyError::Orbit(OrbitError::Equilibrium { state })) = system.orbit(&case) else {
        panic!("{:?}", system.orbit(&case));
    };
    let off = [state[0], state[1], state[2].abs() - 1.1 / 200.0];
    assert!(off.iter().all(|off| off.abs() < 1e-8), "{off:?}");
}
