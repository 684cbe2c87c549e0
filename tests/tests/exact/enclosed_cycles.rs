//! Exact orbits of piecewise-linear systems against a rigorous enclosure of their closed form.
//!
//! The slip ends at the first root of a transcendental equation. Interval arithmetic shows where a root lies (the
//! function changes its sign and rises throughout), and that there is none before it.

use stickslip::math::enclosure::Enclosure;
use stickslip::math::interval::Interval;
use stickslip::scalar::Scalar;
use stickslip::shooting::{Guess, certify, closest};
use stickslip_models::DrillString;
use stickslip_models::closed_form::{CoulombBelt, Cycle, Ringdown, drill_string};
use stickslip_tests::exact;

/// A number that encloses, with no derivatives.
type E = Enclosure<0>;

fn exactly(value: f64) -> E {
    E::from(value)
}

fn between(low: f64, high: f64) -> E {
    E::constant(Interval::new(low, high))
}

/// Period and extrema, enclosed.
struct EnclosedCycle {
    period: Interval,
    max: Interval,
    min: Interval,
}

/// The only root of `f`, which rises, near `guess`.
fn root(f: impl Fn(E) -> E, slope: impl Fn(E) -> E, guess: f64) -> E {
    let mut reach = f64::EPSILON * guess;
    for _ in 0..40 {
        let (low, high) = (guess - reach, guess + reach);
        if f(exactly(low)) < 0.0 && f(exactly(high)) > 0.0 {
            let root = between(low, high);
            assert!(slope(root) > 0.0, "{root} holds more than one root");
            return root;
        }
        reach *= 2.0;
    }
    panic!("no root near {guess}");
}

/// Whether `f` is below zero from `low` to `high`.
fn is_negative(f: &impl Fn(E) -> E, low: f64, high: f64, depth: u32) -> bool {
    let middle = 0.5 * (low + high);
    f(between(low, high)) < 0.0
        || (depth > 0
            && is_negative(f, low, middle, depth - 1)
            && is_negative(f, middle, high, depth - 1))
}

/// The cycle that the numbers of `near` come from: z = x − centre slips as `slip`, in units of time 1/`frequency`.
fn enclose(slip: &Ringdown<E>, centre: E, frequency: E, near: &Cycle) -> EnclosedCycle {
    let unit = frequency.value.middle();
    let short = |time: E| slip.rate(time) - slip.rate;
    let end = root(short, |time| slip.acceleration(time), near.slip * unit);
    // At first the mass becomes slower than the belt, stays so, and just before the end becomes faster all the time.
    let first = 1e-3 * near.slip * unit;
    let last = (1.0 - 1e-6) * near.slip * unit;
    assert!(slip.acceleration(between(0.0, first)) < 0.0);
    assert!(is_negative(&short, first, last, 40));
    assert!(slip.acceleration(between(last, end.value.high())) > 0.0);
    let landing = slip.position(end);
    let stick = (slip.position - landing) / (slip.rate * frequency);
    // The rate falls through zero at the maximum, and rises through it at the minimum.
    let plain = Ringdown {
        damping: slip.damping.value.middle(),
        position: slip.position.value.middle(),
        rate: slip.rate.value.middle(),
    };
    let highest = plain.slope().first_zero();
    let lowest = highest + plain.half_period();
    let max = root(|t| -slip.rate(t), |t| -slip.acceleration(t), highest);
    let min = root(|t| slip.rate(t), |t| slip.acceleration(t), lowest);
    EnclosedCycle {
        period: (end / frequency + stick).value,
        max: (centre + slip.position(max)).value,
        min: (centre + slip.position(min)).value,
    }
}

fn drill(model: &DrillString, near: &Cycle) -> EnclosedCycle {
    let [zeta, eta, theta] = [model.zeta, model.eta, model.theta].map(exactly);
    let slip = Ringdown {
        damping: zeta,
        position: theta - zeta * eta * 2.0,
        rate: eta,
    };
    enclose(&slip, exactly(0.0), exactly(1.0), near)
}

fn coulomb(model: &CoulombBelt, near: &Cycle) -> EnclosedCycle {
    let [m, k, belt] = [model.mass, model.stiffness, model.belt].map(exactly);
    let [top, kinetic] = [model.static_force, model.kinetic_force].map(exactly);
    let frequency = root_of(k / m);
    let slip = Ringdown {
        damping: exactly(0.0),
        position: (top - kinetic) / k,
        rate: belt / frequency,
    };
    enclose(&slip, kinetic / k, frequency, near)
}

fn root_of<D: Scalar>(x: D) -> D {
    x.sqrt()
}

/// An enclosure no wider than this share holds the closed form evaluated in doubles, but for its own rounding.
fn holds(enclosed: Interval, value: f64, width: f64) {
    let size = enclosed.magnitude();
    assert!(
        enclosed.high() - enclosed.low() <= width * size,
        "{enclosed:?}"
    );
    let off = (enclosed.middle() - value).abs();
    assert!(off <= width * size, "{value} in {enclosed:?}");
}

#[test]
fn the_closed_forms_lie_where_they_are_enclosed() {
    for eta in [0.3, 1.0, 2.0, 4.0, 4.6] {
        for zeta in [0.0, 0.05, 0.3] {
            let model = DrillString {
                eta,
                zeta,
                ..Default::default()
            };
            let Some(near) = drill_string(&model) else {
                continue;
            };
            let enclosed = drill(&model, &near);
            holds(enclosed.period, near.period(), 1e-12);
            holds(enclosed.max, near.max, 1e-12);
            holds(enclosed.min, near.min, 1e-12);
        }
    }
    for (stiffness, belt, static_force) in [(1.0, 0.2, 1.5), (7.0, 1.0, 3.0), (0.01, 0.02, 1.1)] {
        let model = CoulombBelt {
            mass: 2.0,
            stiffness,
            belt,
            static_force,
            kinetic_force: 1.0,
        };
        let near = model.cycle().expect("a cycle");
        let enclosed = coulomb(&model, &near);
        holds(enclosed.period, near.period(), 1e-12);
        holds(enclosed.max, near.max, 1e-12);
        holds(enclosed.min, near.min, 1e-12);
    }
}

/// What is computed is as near to the enclosure as its error estimate says, and as its certificate does.
#[test]
fn computed_orbits_reach_their_enclosures() {
    for eta in [0.3, 1.0, 4.0, 4.6] {
        for accuracy in [1e-7, 1e-10] {
            let model = DrillString {
                eta,
                ..Default::default()
            };
            let near = drill_string(&model).expect("a cycle");
            let enclosed = drill(&model, &near);
            let family = exact::family(model, accuracy).into();
            let search = exact::search(&[near.release, eta], accuracy);
            let orbit = closest(&family, 0.0, &search).expect("an orbit");
            let within = |found: f64, truth: Interval, radius: f64| {
                let computed = Interval::around(found, radius);
                assert!(
                    truth.is_inside(computed),
                    "{truth:?} in {computed:?}, eta = {eta}, {accuracy:e}"
                );
            };
            let estimate = orbit.error_estimate;
            within(orbit.period, enclosed.period, estimate * orbit.period);
            within(
                orbit.max[0],
                enclosed.max,
                estimate * near.max.abs().max(near.min.abs()),
            );
            within(
                orbit.min[0],
                enclosed.min,
                estimate * near.max.abs().max(near.min.abs()),
            );
            let guess = Guess {
                place: orbit.heading.start.clone(),
                period: orbit.period,
                magnitude: orbit.magnitude(),
                pins: Vec::new(),
                shift: None,
                division: None,
            };
            let certificate = certify(&family, 0.0, &guess, accuracy).expect("a certificate");
            within(
                certificate.period,
                enclosed.period,
                certificate.period_radius,
            );
            within(
                certificate.start[0],
                enclosed.min,
                certificate.state_radius[0],
            );
        }
    }
}
