//! Models that are linear between events: motions in closed form against those of the integrator.

use std::f64::consts::TAU;

use stickslip::flow::{Event, EventKind, ExactFamily, Flow, Passage, Peaks, Want};
use stickslip::integrate::Tolerance;
use stickslip::model;
use stickslip::model::Model;
use stickslip_models::friction::{Coulomb, CoulombStatic, CoulombViscous};
use stickslip_models::press::{Compliant, Hertz};
use stickslip_models::{BeltOscillator, DrillString, ForcedBelt};
use stickslip_tests::random::Random;

model! {
    /// One mass on a belt; without its spring a state more stands still.
    struct One {
        state x: m = 0.0;
        state v: m/s = 0.0;
        param m: kg = 1.0 where m > 0.0;
        param k: N/m = 1.0 where k >= 0.0;
        param c: N*s/m = 0.0 where c >= 0.0;
        param belt: m/s = 0.2;
        param rest: N = 1.2 where rest >= 0.0;
        param level: N = 1.0 where level >= 0.0;
        friction F: N = CoulombStatic { static_level: rest, kinetic_level: level } opposing v - belt;
        der(x) = v;
        der(v) = (F - k * x - c * v) / m;
    }
}

model! {
    /// One mass on a belt that shakes, under a harmonic force.
    struct Shaken {
        state x: m = 0.0;
        state v: m/s = 0.0;
        param m: kg = 1.0 where m > 0.0;
        param k: N/m = 1.0 where k >= 0.0;
        param c: N*s/m = 0.0 where c >= 0.0;
        param shake: m/s = 0.3;
        param level: N = 0.3 where level >= 0.0;
        param load: N = 1.0;
        param omega: rad/s = 1.3 where omega > 0.0;
        drive phi at omega;
        let belt = shake * sin(phi + 0.4);
        friction F: N = Coulomb { level: level } opposing v - belt;
        der(x) = v;
        der(v) = (F - k * x - c * v + load * cos(phi)) / m;
    }
}

model! {
    /// Two masses, one of which rubs the harder the more a third state presses it.
    struct Two {
        state x: m = 0.0;
        state y: m = 0.0;
        state u: m/s = 0.0;
        state v: m/s = 0.0;
        state q: N = 1.0;
        param m: kg = 1.0 where m > 0.0;
        param k: N/m = 1.0 where k >= 0.0;
        param c: N*s/m = 0.0 where c >= 0.0;
        param decay: Hz = 0.3 where decay >= 0.0;
        param belt: m/s = 0.2;
        param mu = 0.3 where mu >= 0.0;
        param level: N = 0.5 where level >= 0.0;
        param viscous: N*s/m = 0.1 where viscous >= 0.0;
        param usual: N = 1.0;
        friction F: N = Coulomb { level: mu * q } opposing u - belt;
        friction G: N = CoulombViscous { level: level, viscous: viscous } opposing v - u;
        der(x) = u;
        der(y) = v;
        der(u) = (F - G - k * (2 * x - y) - c * u) / m;
        der(v) = (G - k * (y - x) - c * v) / m;
        der(q) = decay * (usual - q);
    }
}

model! {
    /// Three masses in a row, all on one belt.
    struct Three {
        state x: m = 0.3;
        state y: m = 0.1;
        state z: m = -0.2;
        state u: m/s = 0.0;
        state v: m/s = 0.0;
        state w: m/s = 0.0;
        param m: kg = 1.0 where m > 0.0;
        param k: N/m = 1.0 where k >= 0.0;
        param c: N*s/m = 0.0 where c >= 0.0;
        param belt: m/s = 0.2;
        param rest: N = 1.2 where rest >= 0.0;
        param level: N = 1.0 where level >= 0.0;
        friction F: N = CoulombStatic { static_level: rest, kinetic_level: level } opposing u - belt;
        friction G: N = Coulomb { level: level } opposing v - belt;
        friction H: N = CoulombStatic { static_level: rest, kinetic_level: level } opposing w - belt;
        der(x) = u;
        der(y) = v;
        der(z) = w;
        der(u) = (F - k * (x - y) - k * x - c * u) / m;
        der(v) = (G - k * (2 * y - x - z) - c * v) / m;
        der(w) = (H - k * (z - y) - c * w) / m;
    }
}

model! {
    /// A mass that bounces on a soft stop under a harmonic force, and rubs on it.
    struct Bouncing {
        state x: m = 0.0;
        state y: m = 0.2;
        state u: m/s = 0.0;
        state v: m/s = 0.0;
        param m: kg = 1.0 where m > 0.0;
        param k: N/m = 1.0 where k >= 0.0;
        param wall: N/m = 12.0 where wall > 0.0;
        param c: N*s/m = 0.3 where c >= 0.0;
        param mu = 0.4 where mu >= 0.0;
        param belt: m/s = 0.3;
        param load: N = 1.0;
        param omega: rad/s = 1.1 where omega > 0.0;
        drive phi at omega;
        press N: N = Compliant { stiffness: wall, damping: c } closing y;
        friction F: N = Coulomb { level: mu * N } opposing u - belt;
        der(x) = u;
        der(y) = v;
        der(u) = (F - k * x) / m;
        der(v) = (N - k * y + load * cos(phi) - 0.3 * load) / m;
    }
}

model! {
    /// A mass under a harmonic force, which carries a light one on a stiff spring; both rub.
    struct Stiff {
        state x: m = 0.0;
        state y: m = 0.0;
        state u: m/s = 0.0;
        state v: m/s = 0.0;
        param heavy: kg = 1.0 where heavy > 0.0;
        param light: kg = 1e-2 where light > 0.0;
        param k: N/m = 1.0 where k >= 0.0;
        param stiff: N/m = 1e4 where stiff >= 0.0;
        param damping: N*s/m = 1.0 where damping >= 0.0;
        param belt: m/s = 0.1;
        param level: N = 0.3 where level >= 0.0;
        param small: N = 0.1 where small >= 0.0;
        param load: N = 1.0;
        param omega: rad/s = 1.3 where omega > 0.0;
        drive phi at omega;
        friction F: N = Coulomb { level: level } opposing u;
        friction G: N = Coulomb { level: small } opposing v - belt;
        der(x) = u;
        der(y) = v;
        der(u) = (F - k * x - stiff * (x - y) - damping * (u - v) + load * cos(phi)) / heavy;
        der(v) = (G - stiff * (y - x) - damping * (v - u)) / light;
    }
}

model! {
    /// A rod of masses under a harmonic force, of which two rub: many states and few contacts.
    struct Rod {
        state x[9]: m = 0.0;
        state v[9]: m/s = 0.0;
        param m: kg = 0.3 where m > 0.0;
        param k: N/m = 40.0 where k >= 0.0;
        param c: N*s/m = 0.3 where c >= 0.0;
        param level: N = 0.3 where level >= 0.0;
        param load: N = 1.0;
        param omega: rad/s = 1.3 where omega > 0.0;
        drive phi at omega;
        friction F: N = Coulomb { level: level } opposing v[2];
        friction G: N = CoulombStatic { static_level: 1.2 * level, kinetic_level: level } opposing v[6];
        for i in 0..9 {
            der(x[i]) = v[i];
        }
        der(v[0]) = (k * (x[1] - 2 * x[0]) + c * (v[1] - 2 * v[0])) / m;
        der(v[1]) = (k * (x[2] + x[0] - 2 * x[1]) + c * (v[2] + v[0] - 2 * v[1])) / m;
        der(v[2]) = (k * (x[3] + x[1] - 2 * x[2]) + c * (v[3] + v[1] - 2 * v[2]) + F) / m;
        for i in 3..6 {
            der(v[i]) = (k * (x[i + 1] + x[i - 1] - 2 * x[i]) + c * (v[i + 1] + v[i - 1] - 2 * v[i])) / m;
        }
        der(v[6]) = (k * (x[7] + x[5] - 2 * x[6]) + c * (v[7] + v[5] - 2 * v[6]) + G) / m;
        der(v[7]) = (k * (x[8] + x[6] - 2 * x[7]) + c * (v[8] + v[6] - 2 * v[7])) / m;
        der(v[8]) = (k * (x[7] - x[8]) + c * (v[7] - v[8]) + load * cos(phi)) / m;
    }
}

model! {
    /// Not linear, each term for another reason.
    struct Bent {
        state x: m = 0.0;
        state v: m/s = 0.0;
        param m: kg = 1.0;
        param k: N/m^2 = 1.0;
        param level: N = 1.0 where level >= 0.0;
        friction F: N = Coulomb { level: level } opposing v;
        der(x) = v;
        der(v) = (F - k * x * x) / m;
    }
}

model! {
    /// A force that turns twice with its drive.
    struct Twice {
        state x: m = 0.0;
        state v: m/s = 0.0;
        param m: kg = 1.0;
        param load: N = 1.0;
        param level: N = 1.0 where level >= 0.0;
        param omega: rad/s = 1.1 where omega > 0.0;
        drive phi at omega;
        friction F: N = Coulomb { level: level } opposing v;
        der(x) = v;
        der(v) = (F + load * cos(2 * phi)) / m;
    }
}

model! {
    /// The same force, written as a product.
    struct Product {
        state x: m = 0.0;
        state v: m/s = 0.0;
        param m: kg = 1.0;
        param load: N = 1.0;
        param level: N = 1.0 where level >= 0.0;
        param omega: rad/s = 1.1 where omega > 0.0;
        drive phi at omega;
        let wave = cos(phi);
        friction F: N = Coulomb { level: level } opposing v;
        der(x) = v;
        der(v) = (F + load * wave * wave) / m;
    }
}

model! {
    /// Friction on an arm whose length moves.
    struct Lever {
        state x: m = 0.0;
        state v: m/s = 0.0;
        param m: kg = 1.0;
        param arm: m = 1.0;
        param level: N = 1.0 where level >= 0.0;
        friction F: N = Coulomb { level: level } opposing v;
        der(x) = v;
        der(v) = F * (1.0 + x / arm) / m;
    }
}

model! {
    /// A law that is a product of speed and of what moves.
    struct Thick {
        state x: m = 0.0;
        state v: m/s = 0.0;
        param m: kg = 1.0;
        param level: N = 1.0 where level >= 0.0;
        param slope: N*s/m^2 = 1.0 where slope >= 0.0;
        friction F: N = CoulombViscous { level: level, viscous: slope * x } opposing v;
        der(x) = v;
        der(v) = F / m;
    }
}

model! {
    /// A press that is harder the deeper it is.
    struct Round {
        state x: m = 1.0;
        state v: m/s = 0.0;
        param m: kg = 1.0;
        param load: N = 1.0 where load > 0.0;
        param depth: m = 1.0 where depth > 0.0;
        press N: N = Hertz { load: load, depth: depth } closing x;
        der(x) = v;
        der(v) = N / m;
    }
}

#[test]
fn what_is_linear_is_proven_from_the_declaration() {
    for linear in [
        One::INFO,
        Shaken::INFO,
        Two::INFO,
        Three::INFO,
        Bouncing::INFO,
        Stiff::INFO,
        Rod::INFO,
        DrillString::INFO,
    ] {
        assert!(linear.is_linear(), "{}", linear.name);
    }
    for bent in [
        Bent::INFO,
        Twice::INFO,
        Product::INFO,
        Lever::INFO,
        Thick::INFO,
        Round::INFO,
        BeltOscillator::INFO,
        ForcedBelt::INFO,
    ] {
        assert!(!bent.is_linear(), "{}", bent.name);
    }
}

const WANT: Want = Want {
    extrema: Peaks::All,
    ..Want::DERIVATIVES
};
const ACCURACY: f64 = 1e-10;
/// What the integrator's derivatives err by, relative to the largest of them, and where it steps at the edge of stability: what
/// has died away is left in them. Differences agree with those in closed form there.
const SLOPES: f64 = 1e-6;
const STIFF_SLOPES: f64 = 1e-4;

/// Motions of one model at random parameters, from random states; the number of events.
fn compare<M: Model<N>, const N: usize>(
    random: &mut Random,
    (runs, slopes): (usize, f64),
    mut parameters: impl FnMut(&mut Random) -> M,
) -> usize {
    let mut events = 0;
    for run in 0..runs {
        let model = parameters(random);
        let design = run % M::INFO.parameters.len();
        let family = ExactFamily {
            model,
            design: Some(design),
            tolerance: Tolerance::for_accuracy(ACCURACY),
            magnitude: [1.0; N],
        };
        let r = model.values().as_ref()[design];
        let closed = family.at(r).unwrap();
        let integrated = family.at(r).unwrap().integrated();
        let mut state: [f64; N] = random.array(|random| random.real(1.0));
        if let Some(phase) = M::INFO.drive {
            state[phase] = random.between(0.0, TAU);
        }
        let Ok(place) = closed.place(state) else {
            continue;
        };
        let span = random.between(3.0, 12.0);
        let both = [
            closed.advance(&place, span, WANT),
            integrated.advance(&place, span, WANT),
        ];
        let told = format!("{model:?} by {design} from {state:?} for {span}");
        match both {
            [Ok(closed), Ok(integrated)] => {
                events += same(&state, &closed, &integrated, slopes, &told);
            }
            [Err(closed), Err(integrated)] => {
                let kinds = [closed, integrated].map(|error| std::mem::discriminant(&error));
                assert_eq!(kinds[0], kinds[1], "{told}");
            }
            [Ok(_), Err(error)] | [Err(error), Ok(_)] => panic!("{error}: {told}"),
        }
    }
    events
}

/// Holds both motions from this start to the same events, ends and derivatives; how many events there were.
fn same<Mode: Copy + PartialEq + std::fmt::Debug, const N: usize>(
    start: &[f64; N],
    closed: &Passage<N, Mode>,
    integrated: &Passage<N, Mode>,
    allowed: f64,
    told: &str,
) -> usize {
    assert_eq!(closed.work.linearisations, 0, "{told}");
    assert!(integrated.work.linearisations > 0, "{told}");
    let switches = |passage: &Passage<N, Mode>| -> Vec<Event<N>> {
        let all = passage.events.iter();
        let switches = all.filter(|event| !matches!(event.kind, EventKind::Nearest { .. }));
        switches.cloned().collect()
    };
    let (ours, theirs) = (switches(closed), switches(integrated));
    assert_eq!(ours.len(), theirs.len(), "{told}");
    let near = |a: f64, b: f64, allowed: f64| (a - b).abs() <= allowed;
    for (a, b) in ours.iter().zip(&theirs) {
        assert_eq!((a.contact, a.mode), (b.contact, b.mode), "{told}");
        assert!(near(a.time, b.time, 1e-7), "{} {}: {told}", a.time, b.time);
    }
    assert_eq!(closed.end.mode, integrated.end.mode, "{told}");
    for (a, b) in closed.end.state.iter().zip(&integrated.end.state) {
        assert!(near(*a, *b, 1e-7 * (1.0 + b.abs())), "{a} {b}: {told}");
    }
    for index in 0..N {
        for way in [1.0, -1.0] {
            let [one, other] =
                [closed, integrated].map(|passage| farthest(start, passage, index, way));
            assert!(
                near(one, other, 1e-7 * (1.0 + one.abs())),
                "{one} {other}: {told}"
            );
        }
    }
    let slopes = |passage: &Passage<N, Mode>| -> Vec<f64> {
        let derivatives = passage.derivatives.as_ref().unwrap();
        let state = derivatives.state.iter().flatten();
        let rest = derivatives.design.iter().chain(&derivatives.time);
        state.chain(rest).copied().collect()
    };
    let (ours, theirs) = (slopes(closed), slopes(integrated));
    let most = theirs
        .iter()
        .fold(1.0, |most: f64, slope| most.max(slope.abs()));
    for (a, b) in ours.iter().zip(&theirs) {
        assert!(near(*a, *b, allowed * most), "slope {a} {b} {most}: {told}");
    }
    ours.len()
}

/// The largest value of a state, or the smallest with its sign turned.
fn farthest<Mode, const N: usize>(
    start: &[f64; N],
    passage: &Passage<N, Mode>,
    index: usize,
    way: f64,
) -> f64 {
    let extrema = passage
        .extrema
        .iter()
        .filter(|extremum| extremum.index == index);
    let extrema = extrema.map(|extremum| way * extremum.state[index]);
    let ends = f64::max(way * start[index], way * passage.end.state[index]);
    extrema.fold(ends, f64::max)
}

/// Undamped, critically damped and strongly damped, and without a spring: equal eigenvalues and zeros.
fn spring(random: &mut Random, m: f64) -> (f64, f64) {
    let k = random.positive(0.2, 5.0);
    match (4.0 * random.unit()) as usize {
        0 => (k, 0.0),
        1 => (k, 2.0 * (k * m).sqrt()),
        2 => (k, random.between(3.0, 20.0) * (k * m).sqrt()),
        _ => (0.0, if random.unit() < 0.5 { 0.0 } else { k }),
    }
}

#[test]
fn one_contact() {
    let mut random = Random::new(11);
    let events = compare(&mut random, (200, SLOPES), |random| {
        let m = random.positive(0.5, 2.0);
        let (k, c) = spring(random, m);
        let level = random.between(0.1, 1.0);
        One {
            m,
            k,
            c,
            belt: random.real(0.5),
            rest: level * random.between(1.0, 1.5),
            level,
        }
    });
    assert!(events > 100, "{events}");
}

#[test]
fn one_contact_on_a_belt_that_shakes() {
    let mut random = Random::new(12);
    let events = compare(&mut random, (200, SLOPES), |random| {
        let m = random.positive(0.5, 2.0);
        let (k, c) = spring(random, m);
        Shaken {
            m,
            k,
            c,
            shake: random.real(0.5),
            level: random.between(0.1, 1.0),
            load: random.real(1.5),
            omega: random.between(0.3, 3.0),
        }
    });
    assert!(events > 300, "{events}");
}

#[test]
fn two_contacts() {
    let mut random = Random::new(13);
    let events = compare(&mut random, (200, SLOPES), |random| {
        let m = random.positive(0.5, 2.0);
        let (k, c) = spring(random, m);
        Two {
            m,
            k,
            c,
            decay: random.between(0.0, 1.0),
            belt: random.real(0.5),
            mu: random.between(0.1, 0.6),
            level: random.between(0.1, 0.6),
            viscous: random.between(0.0, 0.5),
            usual: random.between(1.0, 2.0),
        }
    });
    assert!(events > 200, "{events}");
}

#[test]
fn three_contacts() {
    let mut random = Random::new(14);
    let events = compare(&mut random, (150, SLOPES), |random| {
        let m = random.positive(0.5, 2.0);
        let (k, c) = spring(random, m);
        let level = random.between(0.1, 0.5);
        Three {
            m,
            k,
            c,
            belt: random.real(0.3),
            rest: level * random.between(1.0, 1.5),
            level,
        }
    });
    assert!(events > 300, "{events}");
}

#[test]
fn a_press_and_a_contact_under_it() {
    let mut random = Random::new(15);
    let events = compare(&mut random, (150, SLOPES), |random| Bouncing {
        m: random.positive(0.5, 2.0),
        k: random.between(0.0, 2.0),
        wall: random.positive(3.0, 100.0),
        c: random.between(0.0, 1.0),
        mu: random.between(0.1, 0.6),
        belt: random.real(0.5),
        load: random.real(1.5),
        omega: random.between(0.5, 2.0),
    });
    assert!(events > 300, "{events}");
}

/// Steps are doubled once the light mass has come to what the spring makes of it.
#[test]
fn what_is_fast_dies_away() {
    let mut random = Random::new(16);
    let events = compare(&mut random, (100, STIFF_SLOPES), |random| {
        let (light, stiff) = (random.positive(1e-2, 1e-1), random.positive(1e2, 1e4));
        Stiff {
            heavy: 1.0,
            light,
            k: random.positive(0.2, 5.0),
            stiff,
            damping: random.between(0.02, 3.0) * (light * stiff).sqrt(),
            belt: random.real(0.3),
            level: random.between(0.1, 0.6),
            small: random.between(0.01, 0.2),
            load: random.real(1.5),
            omega: random.between(0.3, 3.0),
        }
    });
    assert!(events > 300, "{events}");
}

#[test]
fn many_states_and_two_contacts() {
    let mut random = Random::new(17);
    let events = compare(&mut random, (60, SLOPES), |random| Rod {
        m: random.positive(0.1, 1.0),
        k: random.positive(10.0, 200.0),
        c: random.between(0.05, 2.0),
        level: random.between(0.05, 0.6),
        load: random.real(2.0),
        omega: random.between(0.3, 3.0),
    });
    assert!(events > 300, "{events}");
}
