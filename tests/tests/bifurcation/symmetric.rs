//! Where a symmetry is lost while another multiplier is large, or that orbits have at every moment.

use stickslip::continuation::Kind;
use stickslip::model;
use stickslip::study::{BranchRecord, Case, System};
use stickslip_models::friction::Coulomb;

model! {
    /// A typical section in quasi-steady flow, with a dry hinge that stiffens.
    struct Aerofoil {
        state alpha = 0.6;
        state w = 0.0;
        state h = 0.0;
        state u = 0.0;
        param U = 2.2 where U > 0.0;
        param off = 0.2;
        param r2 = 0.25 where r2 > 0.0;
        param cubic = 1.0;
        param dry = 0.005 where dry >= 0.0;
        param lift = 0.15;
        friction M = Coulomb { level: dry } opposing w;
        let L = lift * U * U * (alpha + u / U);
        let fh = -L - 0.25 * h - 0.01 * u;
        let fa = 0.2 * L - 0.25 * (alpha + cubic * powi(alpha, 3)) - 0.005 * w + M;
        let det = r2 - off * off;
        der(alpha) = w;
        der(w) = (fa - off * fh) / det;
        der(h) = u;
        der(u) = (r2 * fh - off * fa) / det;
    }
}

model! {
    /// Two metronomes on a board that rubs on the table: after Pantaleone 2002.
    struct Metronomes {
        state p = 0.3;
        state wp = 0.0;
        state q = 0.31;
        state wq = 0.0;
        state x = 0.0;
        state v = 0.0;
        param eps = 0.1 where eps >= 0.0;
        param beta = 0.05 where 0.0 <= beta < 0.5;
        param dry = 0.002 where dry >= 0.0;
        param size = 0.2 where size > 0.0;
        param spring = 0.1;
        param detune = 0.0;
        friction F = Coulomb { level: dry } opposing v;
        let gp = p + eps * (powi(p / size, 2) - 1.0) * wp;
        let gq = q * (1.0 + detune) + eps * (powi(q / size, 2) - 1.0) * wq;
        let acc = (F - spring * x + beta * (gp + gq)) / (1.0 - 2.0 * beta);
        der(p) = wp;
        der(wp) = -gp - acc;
        der(q) = wq;
        der(wq) = -gq - acc;
        der(x) = v;
        der(v) = acc;
    }
}

/// Next to where it is lost, errors of the orbit are those of motions over the distance: at 1e-7 and finer, steps over the
/// point were taken back, and the branch left along the one that has lost it. What is told there is told of the orbit itself.
#[test]
fn a_symmetry_is_lost_beside_a_large_multiplier() {
    for accuracy in [1e-5, 1e-7, 1e-9] {
        let mut case = Case::of(&Aerofoil::default()).following(Aerofoil::U, 3.0..1.0);
        case.parameters[Aerofoil::U.index] = 3.0;
        case.accuracy = accuracy;
        let branch = System::of::<Aerofoil, _>().branch(&case).unwrap();
        let kinds: Vec<Kind> = branch.special.iter().map(|one| one.kind).collect();
        let all = [Kind::Fold, Kind::CrossingSliding, Kind::SymmetryBreaking];
        assert_eq!(kinds, all, "{accuracy:e}");
        let lost = &branch.special[2];
        let (off, error) = ((lost.r - 2.887_676_091_043_6).abs(), lost.error.unwrap());
        assert!(off <= error && error <= accuracy, "{off:e} {error:e}");
        let off = |one: &nalgebra::Complex<f64>| (one - 1.0).norm();
        let nearest = lost.multipliers.iter().map(off).fold(1.0, f64::min);
        assert!(nearest < 1e-5, "{nearest:e} at {accuracy:e}");
        let last = branch.points.last().unwrap();
        let lean = (last.max[0] + last.min[0]).abs() / last.max[0];
        assert!(lean < 1e-4, "{lean:e} at {accuracy:e}");
    }
}

/// Metronomes in step are their own image at once. From wherever a branch comes, errors part it from them near the point, which was
/// told up to 3e-7 apart with errors of 1e-11.
#[test]
fn a_symmetry_that_holds_at_every_moment_is_lost_at_one_place() {
    let lost = |from: f64, to: f64| {
        let mut case = Case::of(&Metronomes::default()).following(Metronomes::beta, from..to);
        case.parameters[Metronomes::beta.index] = from;
        let branch: BranchRecord = System::of::<Metronomes, _>().branch(&case).unwrap();
        let mut special = branch.special.iter();
        let lost = special.find(|one| one.kind == Kind::SymmetryBreaking);
        let lost = lost.unwrap_or_else(|| panic!("{:?}", branch.ended.reason));
        (lost.r, lost.error.unwrap())
    };
    let all = [(0.01, 0.2), (0.2, 0.01), (0.012, 0.05)].map(|(from, to)| lost(from, to));
    for (r, error) in all {
        let off = (r - all[0].0).abs();
        assert!(
            off <= error + all[0].1 && error < 1e-11,
            "{off:e} {error:e}"
        );
    }
}
