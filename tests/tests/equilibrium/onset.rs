//! Hopf points: whether motions begin softly or hard, by the first Lyapunov coefficient in closed form and by the amplitude
//! of the motions.

use stickslip::model;
use stickslip::study::{Beginning, Case, Dynamics, Kind, SpecialEquilibrium, System};
use stickslip_tests::range::{place, range};

model! {
    /// Bautin's normal form about (1, 2): |z|' = (p + q |z|² − |z|⁴) |z|.
    pub struct Form {
        state x = 1.0;
        state y = 2.0;
        param p = -0.1;
        param q = 1.0;
        let a = x - 1.0;
        let b = y - 2.0;
        let square = powi(a, 2) + powi(b, 2);
        der(x) = a * (p + q * square - powi(square, 2)) - 2.0 * b;
        der(y) = b * (p + q * square - powi(square, 2)) + 2.0 * a;
    }
}

model! {
    /// Rosenzweig and MacArthur's prey and predator: quadratic and cubic terms both matter. Its Hopf point is at
    /// K = (1 + d/(c − d)) + d/(c − d), and soft.
    pub struct Prey {
        state x = 0.5;
        state y = 0.7;
        param K = 1.5 where K > 0.0;
        param d = 0.3;
        param c = 1.0;
        der(x) = x * (1.0 - x / K) - x * y / (1.0 + x);
        der(y) = y * (c * x / (1.0 + x) - d);
    }
}

model! {
    /// A fast third state is driven by the square of the first, and drives it: it makes the onset hard where e > 15 k / 11.
    pub struct Slaved {
        state x = 0.0;
        state v = 0.0;
        state w = 0.0;
        param mu = -0.1;
        param k = 1.0;
        param e = 0.0;
        der(x) = v;
        der(v) = mu * v - x - k * powi(v, 3) + e * v * w;
        der(w) = powi(v, 2) - w;
    }
}

fn hopf(
    system: &System,
    (name, from, to): (&str, f64, f64),
    more: &[(&str, f64)],
) -> SpecialEquilibrium {
    let mut case = Case::declared(system.info(), Dynamics::Smooth);
    for (name, value) in more {
        case.parameters[place(system, name)] = *value;
    }
    let along = range(system, name, from, to);
    case.along = Some(along);
    let branch = system.equilibria_along(&case.at(from)).unwrap();
    let mut found = branch
        .special
        .into_iter()
        .filter(|one| one.kind == Kind::Hopf);
    found.next().unwrap()
}

#[test]
fn the_coefficient_of_bautins_form_is_that_of_its_cube() {
    let system = System::of::<Form, _>();
    for (q, onset) in [(1.0, "hard"), (-0.3, "soft")] {
        let found = hopf(&system, ("p", -0.1, 0.1), &[("q", q)]);
        let (l1, error) = (found.l1.unwrap(), found.l1_error.unwrap());
        // With z of length 1, |x| is √2 |z|; time is counted in radians of a motion at ω = 2.
        let expected = 2.0 * q / 2.0;
        assert!(
            (l1 - expected).abs() <= error && error < 1e-7,
            "{l1} ± {error}"
        );
        assert_eq!(found.onset, Some(onset));
    }
    let degenerate = hopf(&system, ("p", -0.1, 0.1), &[("q", 0.0)]);
    assert!(degenerate.l1.unwrap().abs() <= degenerate.l1_error.unwrap());
    assert_eq!(degenerate.onset, None);
}

#[test]
fn a_state_that_follows_the_square_makes_the_onset_hard() {
    // Averaged over x = r cos t: r' = (μ/2 − 3 k r²/8) r + e <v² w>/r with w = r² (1/2 − cos(2t − θ)/(2 √5)), tan θ = 2.
    let system = System::of::<Slaved, _>();
    for e in [0.0, 1.0, 1.4, 2.0] {
        let found = hopf(&system, ("mu", -0.1, 0.1), &[("e", e)]);
        let cube = -3.0 / 8.0 + e * (0.25 + 1.0 / 40.0);
        let (l1, error) = (found.l1.unwrap(), found.l1_error.unwrap());
        assert!(
            (l1 - 2.0 * cube).abs() <= error.max(1e-9) && error < 1e-6,
            "{e}: {l1} ± {error}, not {}",
            2.0 * cube
        );
        assert_eq!(found.onset, Some(if cube < 0.0 { "soft" } else { "hard" }));
    }
}

#[test]
fn the_coefficient_is_that_of_the_growing_motions() {
    let system = System::of::<Prey, _>();
    let found = hopf(&system, ("K", 1.5, 3.0), &[]);
    let rest = 0.3 / 0.7;
    assert!((found.r - 1.0 - 2.0 * rest).abs() < 1e-9, "{}", found.r);
    let (l1, onset) = (found.l1.unwrap(), found.onset);
    assert_eq!(onset, Some("soft"), "{l1} {:?}", found.l1_error);
    let mut case = Case::declared(system.info(), Dynamics::Smooth);
    case.along = Some(range(&system, "K", 1.5, 3.0));
    case.beginning = Beginning::Hopf;
    let branch = system.branch(&case.at(1.5)).unwrap();
    // The real part of the eigenvalues grows by α' per K; then |z|² = −α' (K − K₀)/(ω l₁), with |x| = 2 |z| |q₁|.
    let rate = |k: f64| 0.5 * (1.0 - 2.0 * rest / k - (1.0 - rest / k) / (1.0 + rest));
    let slope = (rate(found.r + 1e-5) - rate(found.r - 1e-5)) / 2e-5;
    let omega = std::f64::consts::TAU / found.period.unwrap();
    // (A − iω) q = 0 with A₁₁ = 0, A₁₂ = −x/(1 + x): q₂ = −iω (1 + x)/x q₁.
    let ratio = omega * (1.0 + rest) / rest;
    let first = 1.0 / (1.0 + ratio * ratio).sqrt();
    let near = branch.points.iter().filter(|point| {
        let off = point.r.unwrap() - found.r;
        off > 1e-4 && off < 2e-3
    });
    let mut count = 0;
    for point in near {
        let off = point.r.unwrap() - found.r;
        let half = 0.5 * (point.max[0] - point.min[0]);
        let square = (half / (2.0 * first)).powi(2);
        let seen = -slope * off / (omega * square);
        assert!((seen / l1 - 1.0).abs() < 30.0 * off, "{off}: {seen} {l1}");
        count += 1;
    }
    assert!(
        count > 0,
        "{:?}",
        branch
            .points
            .iter()
            .take(5)
            .map(|p| p.r)
            .collect::<Vec<_>>()
    );
}
