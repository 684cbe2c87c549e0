//! Den Hartog's oscillator with two stops in a turn, piece by piece in closed form; without stops it is in `smooth::driven`.

use std::f64::consts::TAU;

use stickslip::model;
use stickslip::study::{Case, OrbitRecord, System};
use stickslip_models::friction::Coulomb;
use stickslip_tests::bisected::bisected;

model! {
    /// A mass on rough ground under a harmonic force: Den Hartog 1931, in units of the force and the static deflection.
    pub struct Hartog {
        state x: 1 = 1.0;
        state v: 1 = 0.0;
        param beta: 1 = 0.6 where beta > 0.0;
        param level: 1 = 0.2 where level >= 0.0;
        drive phi at beta;
        friction F: 1 = Coulomb { level } opposing v;
        der(x) = v;
        der(v) = cos(phi) - x + F;
    }
}

fn response(beta: f64, level: f64) -> OrbitRecord {
    let case = Case {
        accuracy: 1e-11,
        ..Case::of(&Hartog { beta, level })
    };
    System::of::<Hartog, _>().orbit(&case).expect("a response")
}

#[track_caller]
fn close(found: f64, expected: f64, tolerance: f64, what: &str) {
    let off = (found - expected).abs();
    assert!(off <= tolerance, "{what}: {found} instead of {expected}");
}

/// Half a turn with one stop: the mass rests at X until cos φ₁ = X − F, and slides back as
/// x = V cos φ + F + a cos t + b sin t, φ = φ₁ + β t.
struct Slide {
    beta: f64,
    level: f64,
    release: f64,
    a: f64,
    b: f64,
}

impl Slide {
    fn from(place: f64, beta: f64, level: f64) -> Self {
        let release = (place - level).acos();
        let response = 1.0 / (1.0 - beta * beta);
        Self {
            beta,
            level,
            release,
            a: place - response * release.cos() - level,
            b: response * beta * release.sin(),
        }
    }

    fn at(&self, time: f64) -> [f64; 2] {
        let response = 1.0 / (1.0 - self.beta * self.beta);
        let (sin, cos) = time.sin_cos();
        let (turned_sin, turned_cos) = (self.release + self.beta * time).sin_cos();
        [
            response * turned_cos + self.level + self.a * cos + self.b * sin,
            -response * self.beta * turned_sin - self.a * sin + self.b * cos,
        ]
    }

    /// When it comes to rest again, and where.
    fn rest(&self) -> (f64, f64) {
        let step = 1e-3;
        let steps = (1..).map(|i| step * f64::from(i));
        let mut beyond = steps.skip_while(|time| self.at(*time)[1] < 0.0);
        let until = beyond.next().expect("a spring turns it back");
        let time = bisected(until - step, until, |time| self.at(time)[1]);
        (time, self.at(time)[0])
    }
}

/// The place of the stops is where half a turn leads to the opposite one; what is left of an error of it after a turn is the
/// square of what half a turn leaves, and speeds are forgotten.
#[test]
fn with_two_stops_the_response_is_its_closed_form() {
    for (beta, level, between) in [
        (0.3, 0.5, [0.6, 1.0]),
        (0.3, 0.7, [0.5, 0.9]),
        (0.5, 0.8, [0.8, 1.2]),
        (0.6, 0.9, [0.6, 0.9]),
    ] {
        let what = format!("β = {beta}, F = {level}");
        let half = |place: f64| Slide::from(place, beta, level).rest();
        let off = |place: f64| half(place).1 + place;
        let place = bisected(between[0], between[1], off);
        let orbit = response(beta, level);
        close(orbit.period, TAU / beta, 1e-11, &what);
        close(orbit.max[0], place, 1e-9, &what);
        close(orbit.min[0], -place, 1e-9, &what);
        let stops = orbit.word.as_deref();
        assert_eq!(stops, Some("stick(F) slip-(F) stick(F) slip+(F)"), "{what}");
        let slope = (half(place + 1e-5).1 - half(place - 1e-5).1) / 2e-5;
        let multipliers = &orbit.floquet.multipliers;
        close(multipliers[0].norm(), slope * slope, 1e-6, &what);
        assert_eq!(multipliers[1].norm(), 0.0, "{what}");
        assert_eq!(orbit.floquet.stability.name(), "stable", "{what}");
    }
}
