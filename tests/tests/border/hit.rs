//! Walls that do not give way: an orbit that is hit ever more slowly loses its stability before it only grazes.

use stickslip::bifurcation::Kind;
use stickslip::model;
use stickslip::study::Special;
use stickslip_models::press::Rigid;
use stickslip_tests::branches::branch;

model! {
    /// A clarinet in two modes whose reed beats on its lay, twice a period or once, or not at all.
    struct Clarinet {
        state p[2] = 0.01;
        state w[2] = 0.0;
        state x = -0.4;
        state vx = 0.0;
        param gamma = 0.45;
        press R = Rigid { restitution: 0.0 } closing x + 1.0;
        let sum = p[0] + p[1];
        let dp = gamma - sum;
        let u = 0.35 * (1.0 + x) * dp / powf(dp * dp + 1.0e-4, 0.25);
        der(p[0]) = 0.6366 * u - 0.03 * p[0] - w[0];
        der(w[0]) = p[0];
        der(p[1]) = 0.6366 * u - 0.06 * p[1] - 3.02 * w[1];
        der(w[1]) = 3.02 * p[1];
        der(x) = vx;
        der(vx) = 64.0 * (sum - gamma - x + R) - 4.0 * vx;
    }
}

#[test]
fn flips_beside_grazing_impacts_are_met_from_both_sides() {
    let [up, down] = [(0.4935, 0.496), (0.496, 0.4935)].map(|range| {
        let found = branch::<Clarinet, _>(&[], Clarinet::gamma, range, |_| {});
        assert_eq!(
            found.points.last().unwrap().r,
            Some(range.1),
            "{:?}",
            found.ended
        );
        found.special
    });
    let kinds = |all: &[Special]| all.iter().map(|one| one.kind).collect::<Vec<_>>();
    let pair = [Kind::Grazing, Kind::Flip];
    assert_eq!(kinds(&up), [pair, pair].concat());
    assert_eq!(up.len(), down.len());
    for (a, b) in up.iter().zip(down.iter().rev()) {
        assert_eq!(a.kind, b.kind);
        let errors = a.error.zip(b.error).map(|(a, b)| a + b);
        assert!(
            errors.is_some_and(|errors| (a.r - b.r).abs() <= errors),
            "{} {}",
            a.r,
            b.r
        );
    }
    // Settled motions of another integrator alternate between two cycles at 0.4938425 and at 0.494597, and repeat at 0.4940 and
    // at 0.4950.
    for (pair, doubled, single) in [(&up[..2], 0.4938425, 0.4940), (&up[2..], 0.494597, 0.4950)] {
        let inside = |r: f64| r > pair[0].r && r < pair[1].r;
        assert!(
            inside(doubled) && !inside(single),
            "{} {}",
            pair[0].r,
            pair[1].r
        );
    }
}
