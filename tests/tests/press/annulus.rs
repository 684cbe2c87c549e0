//! A rotor that rubs on its housing all around: it touches it all along its circle at once.

use stickslip::model;
use stickslip::study::{Case, Kind, System};
use stickslip_models::friction::Coulomb;
use stickslip_models::press::Compliant;
use stickslip_tests::bisected::bisected;

model! {
    /// Jeffcott's rotor in a ring, driven by its unbalance; in units of the rotor without the ring.
    struct Rotor {
        state x = 0.01;
        state y = 0.0;
        state u = 0.0;
        state w = 0.0;
        param zeta = 0.05;
        param e = 0.3;
        param gap = 1.05;
        param mu = 0.02;
        param k = 20.0;
        param omega = 0.6;
        drive phi at omega;
        let r = sqrt(powi(x, 2) + powi(y, 2) + 1e-12);
        press N = Compliant { stiffness: k, damping: 0.0 } closing gap - r;
        friction T = Coulomb { level: mu * N } opposing (x * w - y * u) / r + 10.0 * omega;
        let pull = e * powi(omega, 2);
        der(x) = u;
        der(y) = w;
        der(u) = pull * cos(phi) - 2.0 * zeta * u - x - N * x / r - T * y / r;
        der(w) = pull * sin(phi) - 2.0 * zeta * w - y - N * y / r + T * x / r;
    }
}

/// How far the force of a circle of this radius exceeds that of the unbalance:
/// |(1 − ω² + 2iζω) ρ + (1 + iμ) k (ρ − gap)₊| − e ω².
fn excess(rotor: &Rotor, omega: f64, radius: f64) -> f64 {
    let pressed = rotor.k * (radius - rotor.gap).max(0.0);
    let along = (1.0 - omega * omega) * radius + pressed;
    let across = 2.0 * rotor.zeta * omega * radius + rotor.mu * pressed;
    along.hypot(across) - rotor.e * omega * omega
}

#[test]
fn a_rotor_touches_its_housing_all_around_at_once() {
    let rotor = Rotor::default();
    let touches = bisected(0.6, 1.0, |omega| -excess(&rotor, omega, rotor.gap));
    let system = System::of::<Rotor, _>();
    for [from, to] in [[0.6, 1.3], [1.3, 0.6]] {
        let case = Case::of(&rotor).following(Rotor::omega, from..to);
        let branch = system.branch(&case).unwrap();
        assert_eq!(
            branch.ended.word(),
            "reached-end",
            "{}",
            branch.ended.reason
        );
        let [point] = &branch.special[..] else {
            panic!("{:?}", branch.special)
        };
        assert_eq!(point.kind, Kind::Grazing);
        let (off, error) = ((point.r - touches).abs(), point.error.unwrap());
        assert!(off <= error && error < 1e-5, "{off} {error}");
        for row in &branch.points {
            let omega = row.r.unwrap();
            // Beyond resonance a free circle solves it as well, and one that hardly presses.
            let softest = rotor.k * rotor.gap / (rotor.k + 1.0 - omega * omega);
            let [low, high] = match row.max_abs[0] < rotor.gap {
                true => [0.1, rotor.gap],
                false => [softest.max(rotor.gap), 1.5],
            };
            let radius = bisected(low, high, |radius| excess(&rotor, omega, radius));
            let off = (row.max_abs[0] / radius - 1.0).abs();
            // Both the circle within the ring and the one in it.
            assert!(off < 1e-7, "{omega}: {} for {radius}", row.max_abs[0]);
        }
    }
}
