//! Grazing that changes how motions go on at once: branches turn back there, or lose what made them stable.

use std::f64::consts::TAU;

use stickslip::continuation::Kind;
use stickslip::model;
use stickslip::study::{BranchRecord, Case, Stability, System};
use stickslip_models::friction::Coulomb;
use stickslip_models::press::{Compliant, Rigid};

model! {
    /// A hammer on a slider that gives way: after E. Pavlovskaia, M. Wiercigroch, C. Grebogi, Phys. Rev. E 64 (2001) 056224.
    struct Drill {
        state gap: m = 0.1;
        state v: m/s = 0.0;
        state slider: m/s = 0.0;
        param m: kg = 1.0 where m > 0.0;
        param light: kg = 0.1 where light > 0.0;
        param k: N/m = 100.0 where k > 0.0;
        param c: N*s/m = 2.0 where c >= 0.0;
        param push: N = 0.15;
        param swing: N = 0.3;
        param omega: rad/s = 1.0 where omega > 0.0;
        param level: N = 1.0 where level > 0.0;
        drive phi at omega;
        press P: N = Compliant { stiffness: k, damping: c } closing gap;
        friction F: N = Coulomb { level } opposing slider;
        der(gap) = slider - v;
        der(v) = (push + swing * cos(phi) - P) / m;
        der(slider) = (P + F) / light;
    }
}

/// Where the hammer begins to touch the slider once more, its damper makes the map turn by a finite angle: multipliers 2.63 and
/// about -1 on the two sides, so that both lead back to smaller rates, as good as the other way.
#[test]
fn a_branch_turns_where_a_damped_contact_grazes() {
    let system = System::of::<Drill, _>();
    let beside = Drill {
        omega: 1.01,
        ..Drill::default()
    };
    for accuracy in [1e-5, 1e-8, 1e-9, 1e-11] {
        let case = Case {
            start: Some(vec![0.1560571808, 0.3808364199, 0.0, 0.0]),
            period: Some(TAU / beside.omega),
            accuracy,
            ..Case::of(&beside)
        };
        let branch = system
            .branch(&case.following(Drill::omega, 1.01..1.04))
            .unwrap();
        assert_eq!(
            branch.ended.word(),
            "reached-start",
            "{}",
            branch.ended.reason
        );
        let grazes = &branch.special[0];
        assert_eq!(grazes.kind, Kind::Grazing);
        let off = (grazes.r - 1.021_633_564_06).abs();
        assert!(off <= 10.0 * accuracy, "{off:e} at {accuracy:e}");
        let words = |k: usize| branch.points[k].word.as_deref().map_or(0, str::len);
        let words = [words(0), words(branch.points.len() - 1)];
        assert!(words[0] < words[1], "{words:?}");
    }
}

model! {
    /// A block between two stops on a table that shakes, where it rubs.
    struct Rattle {
        state x: m = 0.0;
        state v: m/s = 0.0;
        param gap: m = 0.01 where gap > 0.0;
        param e = 0.6 where 0.0 <= e <= 1.0;
        param level: m/s^2 = 0.5 where level >= 0.0;
        param swing: m/s^2 = 4.0;
        param omega: rad/s = 20.0 where omega > 0.0;
        drive phi at omega;
        press L: m/s^2 = Rigid { restitution: e } closing gap + x;
        press R: m/s^2 = Rigid { restitution: e } closing gap - x;
        friction F: m/s^2 = Coulomb { level } opposing v;
        der(x) = v;
        der(v) = swing * cos(phi) + F + L - R;
    }
}

fn rattles(from: f64, to: f64) -> BranchRecord {
    let rattle = Rattle {
        omega: from,
        ..Rattle::default()
    };
    let case = Case::of(&rattle).following(Rattle::omega, from..to);
    System::of::<Rattle, _>().branch(&case).unwrap()
}

/// What swings as far to both sides ceases to be stable where it grazes a stop of sliding, and is so again where motions that
/// lean to one side meet it: these lead from the one place to the other, and a step may fall on them.
#[test]
fn a_branch_keeps_its_symmetry_beside_one_that_has_lost_it() {
    let branch = rattles(8.0, 8.7);
    assert_eq!(
        branch.ended.word(),
        "reached-end",
        "{}",
        branch.ended.reason
    );
    for point in &branch.points {
        let lean = (point.max[1] + point.min[1]) / point.max[1];
        assert!(
            lean.abs() < 1e-7,
            "{lean:e} at {}",
            point.r.unwrap_or(f64::NAN)
        );
    }
    let kinds: Vec<_> = branch.special.iter().map(|one| one.kind).collect();
    let [
        Kind::SwitchingSliding,
        Kind::GrazingSliding,
        Kind::SymmetryBreaking,
    ] = kinds[..]
    else {
        panic!("{kinds:?}")
    };
    let [grazes, regained] = [&branch.special[1], &branch.special[2]].map(|one| one.r);
    for point in &branch.points {
        let r = point.r.unwrap_or(f64::NAN);
        let unstable = grazes < r && r < regained;
        assert_eq!(
            point.floquet.stability == Stability::Unstable,
            unstable,
            "at {r}"
        );
    }
}
