//! Certificates of orbits: the truth lies within their radii, and what is no orbit gets none.

use stickslip::flow::SmoothFamily;
use stickslip::integrate::Tolerance;
use stickslip::model::Model;
use stickslip::motion::Family;
use stickslip::shooting::{Certificate, Guess, Orbit, Search, Uncertified, certify, closest};
use stickslip_models::closed_form::{CoulombBelt, Cycle, drill_string};
use stickslip_models::friction::CoulombStatic;
use stickslip_models::{DrillString, VanDerPol};
use stickslip_tests::exact::search;
use stickslip_tests::random::Random;
use stickslip_tests::subject::Subject;
use stickslip_tests::{exact, on_every_reference_system};

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

stickslip::model! {
    /// A mass on a spring without friction: every motion is periodic.
    pub struct Pendulum {
        state x = 1.0;
        state v = 0.0;
        der(x) = v;
        der(v) = -x;
    }
}

on_every_reference_system! {
    a_tighter_run_lies_within_the_radii,
}

type Found = (Orbit, Guess, Result<Certificate, Uncertified>);

fn computed(orbit: &Orbit) -> Guess {
    Guess {
        place: orbit.heading.start.clone(),
        period: orbit.period,
        magnitude: orbit.magnitude(),
        pins: Vec::new(),
        shift: None,
        division: None,
    }
}

/// The orbit from `start` and what is known of it.
fn found(family: &Family, start: &[f64], accuracy: f64) -> Found {
    let orbit = closest(family, 0.0, &search(start, accuracy)).expect("an orbit");
    let guess = computed(&orbit);
    let certificate = certify(family, 0.0, &guess, accuracy);
    (orbit, guess, certificate)
}

fn exact<M: Model<N>, const N: usize>(model: M) -> Family {
    exact::family(model, 1e-9).into()
}

fn smooth<M: Model<N>, const N: usize>(model: M) -> Family {
    let family = SmoothFamily {
        model,
        smoothing: None,
        design: Default::default(),
        tolerance: Tolerance::for_accuracy(1e-9),
        magnitude: [1.0; N],
    };
    family.into()
}

/// The true start and period lie within the radii, which are not larger than `most`, of the period relative to it.
fn holds(certificate: &Certificate, start: &[f64], period: f64, most: f64) {
    for (j, &truth) in start.iter().enumerate() {
        let (off, radius) = (
            (certificate.start[j] - truth).abs(),
            certificate.state_radius[j],
        );
        assert!(off <= radius, "state {j} is {off:e} off: {certificate:?}");
        assert!(radius <= most, "state {j}: {certificate:?}");
    }
    let off = (certificate.period - period).abs();
    assert!(
        off <= certificate.period_radius,
        "the period is {off:e} off: {certificate:?}"
    );
    assert!(
        certificate.period_radius <= most * period,
        "{certificate:?}"
    );
    assert!(certificate.constants.h <= 0.5, "{certificate:?}");
}

fn drill(eta: f64) -> DrillString {
    DrillString {
        eta,
        ..Default::default()
    }
}

#[test]
fn the_drill_strings_closed_form_lies_within_the_radii() {
    for accuracy in [1e-6, 1e-9, 1e-11] {
        for eta in [0.3, 1.0, 2.0, 4.0, 4.6] {
            let truth = drill_string(&drill(eta)).expect("a cycle");
            let (_, _, certificate) = found(&exact(drill(eta)), &[truth.release, eta], accuracy);
            let certificate = certificate.expect("a certificate");
            holds(
                &certificate,
                &[truth.min, 0.0],
                truth.period(),
                1e4 * accuracy,
            );
        }
    }
}

#[test]
fn the_closed_form_of_a_mass_on_a_belt_lies_within_the_radii() {
    for (k, v_dr) in [(1.0, 0.5), (4.0, 0.1), (0.3, 2.0)] {
        let belt = CoulombBelt {
            mass: 1.0,
            stiffness: k,
            belt: v_dr,
            static_force: 1.5,
            kinetic_force: 1.0,
        };
        let truth = belt.cycle().expect("a cycle");
        let model = Slider {
            k,
            v_dr,
            ..Default::default()
        };
        let (_, _, certificate) = found(&exact(model), &[truth.release, v_dr], 1e-9);
        let certificate = certificate.expect("a certificate");
        holds(&certificate, &[truth.min, 0.0], truth.period(), 1e-6);
    }
}

/// A certificate, if there is an orbit, and the true cycle.
type Asked = (Option<Result<Certificate, Uncertified>>, Cycle);

fn random_drill(dice: &mut Random, accuracy: f64) -> Option<Asked> {
    let model = DrillString {
        eta: dice.positive(0.1, 10.0),
        theta: dice.positive(0.3, 10.0),
        zeta: dice.positive(1e-3, 0.5),
        ..Default::default()
    };
    let truth = drill_string(&model)?;
    let answer = sought(&exact(model), &[truth.release, model.eta], accuracy);
    Some((answer, truth))
}

fn random_slider(dice: &mut Random, accuracy: f64) -> Option<Asked> {
    let belt = CoulombBelt {
        mass: 1.0,
        stiffness: dice.positive(0.1, 10.0),
        belt: dice.positive(0.01, 3.0),
        static_force: 1.0 + dice.positive(0.01, 3.0),
        kinetic_force: 1.0,
    };
    let model = Slider {
        k: belt.stiffness,
        v_dr: belt.belt,
        F_s: belt.static_force,
        ..Default::default()
    };
    let truth = belt.cycle()?;
    let answer = sought(&exact(model), &[truth.release, belt.belt], accuracy);
    Some((answer, truth))
}

/// Over random systems at random accuracies: no certificate lies, and few are refused.
fn none_lies(systems: usize, random: impl Fn(&mut Random, f64) -> Option<Asked>) {
    let mut dice = Random::new(11);
    let (mut asked, mut given) = (0, 0);
    for _ in 0..systems {
        let accuracy = dice.positive(1e-12, 1e-4);
        let Some((Some(answer), truth)) = random(&mut dice, accuracy) else {
            continue;
        };
        asked += 1;
        if let Ok(certificate) = answer {
            holds(&certificate, &[truth.min, 0.0], truth.period(), 1e-2);
            given += 1;
        }
    }
    println!("{given} of {asked} of {systems}");
    assert!(
        2 * asked > systems && 100 * given > 95 * asked,
        "{given} of {asked}"
    );
}

#[test]
fn no_certificate_of_some_random_orbits_lies() {
    none_lies(12, random_drill);
    none_lies(12, random_slider);
}

#[test]
#[ignore = "long"]
fn no_certificate_of_a_random_drill_string_lies() {
    none_lies(150, random_drill);
}

#[test]
#[ignore = "long"]
fn no_certificate_of_a_random_mass_on_a_belt_lies() {
    none_lies(150, random_slider);
}

/// The certificate of the orbit from `start`, if there is one.
fn sought(
    family: &Family,
    start: &[f64],
    accuracy: f64,
) -> Option<Result<Certificate, Uncertified>> {
    let orbit = closest(family, 0.0, &search(start, accuracy)).ok()?;
    Some(certify(family, 0.0, &computed(&orbit), accuracy))
}

/// The amplitude and period of Van der Pol's oscillator, known to more digits than a double has.
#[test]
fn van_der_pols_orbit_lies_within_the_radii() {
    for accuracy in [1e-6, 1e-9, 1e-11] {
        let (_, _, certificate) = found(&smooth(VanDerPol::default()), &[2.0, 0.0], accuracy);
        let start = [-2.008_619_860_874_843, 0.0];
        let certificate = certificate.expect("a certificate");
        holds(&certificate, &start, 6.663_286_859_323_13, 1e4 * accuracy);
    }
}

fn a_tighter_run_lies_within_the_radii<M: Model<N>, const N: usize>(subject: &Subject<M, N>) {
    let family = subject.family(Default::default(), Tolerance::for_accuracy(1e-9));
    let (rough, _, certificate) = found(&family, &subject.start(), 1e-7);
    let certificate = certificate.expect("a certificate");
    let again = Search {
        period: Some(rough.period),
        ..search(&rough.place.state, 1e-11)
    };
    let tight = closest(&family, 0.0, &again).expect("an orbit");
    let start = tight.heading.start.state;
    holds(&certificate, &start, tight.period, 1e-3);
}

/// The largest table speed at which the bit still sticks: there it only just does.
fn grazing_speed() -> f64 {
    let (mut sticks, mut slides) = (4.0_f64, 6.0_f64);
    for _ in 0..100 {
        let middle = 0.5 * (sticks + slides);
        if drill_string(&drill(middle)).is_some() {
            sticks = middle;
        } else {
            slides = middle;
        }
    }
    sticks
}

/// Next to grazing, derivatives change ever faster; where the bit lands in one part of a ball and misses in another,
/// there is no certificate.
#[test]
fn next_to_grazing_a_start_that_is_off_is_refused() {
    let limit = grazing_speed();
    let mut before = 0.0;
    for distance in [1e-2, 1e-4, 1e-6] {
        let eta = limit - distance;
        let truth = drill_string(&drill(eta)).expect("a cycle");
        let family = exact(drill(eta));
        let (_, right, certificate) = found(&family, &[truth.release, eta], 1e-9);
        let certificate = certificate.expect("a certificate");
        holds(&certificate, &[truth.min, 0.0], truth.period(), 1e-3);
        assert!(
            certificate.constants.lipschitz > 0.9 * before,
            "{certificate:?}"
        );
        before = certificate.constants.lipschitz;
        let mut wrong = right;
        wrong.place.state[0] += 10.0 * distance;
        let answer = certify(&family, 0.0, &wrong, 1e-9);
        assert!(
            matches!(answer, Err(Uncertified::WordChanges { radius }) if radius > distance),
            "{answer:?}"
        );
    }
    assert!(before > 1e3, "{before}");
}

/// A start that is off by more than the integration is: its radii reach the true orbit, or there are none.
#[test]
fn what_is_no_orbit_has_no_small_certificate() {
    let truth = drill_string(&drill(4.0)).expect("a cycle");
    let family = exact(drill(4.0));
    let (_, right, _) = found(&family, &[truth.release, 4.0], 1e-9);
    let mut refused = 0;
    for off in [1e-8, 1e-6, 1e-4, 1e-2, 0.1, 0.5, 2.0] {
        let mut wrong = right.clone();
        wrong.place.state[0] += off;
        wrong.period += 0.3 * off;
        match certify(&family, 0.0, &wrong, 1e-9) {
            Ok(certificate) => {
                holds(&certificate, &[truth.min, 0.0], truth.period(), 3.0 * off);
                assert!(certificate.state_radius[0] > off, "{certificate:?}");
                assert!(off < 0.1, "{certificate:?}");
            }
            Err(reason) => {
                println!("{off:e}: {reason}");
                refused += 1;
            }
        }
    }
    assert!(refused >= 2);
}

/// One of a family of orbits is not isolated, and so is not certified.
#[test]
fn a_family_of_orbits_is_singular() {
    let family = smooth(Pendulum::default());
    let flow = family.at(0.0).expect("a flow");
    let guess = Guess {
        place: flow.place(&[-1.0, 0.0]).expect("a place"),
        period: std::f64::consts::TAU,
        magnitude: vec![1.0; 2],
        pins: Vec::new(),
        shift: None,
        division: None,
    };
    let answer = certify(&family, 0.0, &guess, 1e-9);
    assert!(
        matches!(answer, Err(Uncertified::Singular { .. })),
        "{answer:?}"
    );
}
