//! Grazing that changes how motions go on at once: branches turn back there, or lose what made them stable.

use std::f64::consts::TAU;

use stickslip::continuation::Kind;
use stickslip::model;
use stickslip::study::{BranchRecord, Case, Stability, System};
use stickslip_models::ForcedBelt;
use stickslip_models::friction::Coulomb;
use stickslip_models::press::{Compliant, Rigid};
use stickslip_tests::branches::branch;
use stickslip_tests::row::Row;

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
    for accuracy in [1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-11] {
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

/// While all three ride on the belt, what holds the middle one does not change. Where it has come to its limit just as the first
/// one comes to rest, it lets go before that or long after: r turns there at once, and no orbit is found at the border itself.
/// It lies where both legs meet, as far as the error says, from whichever of them it is come to.
#[test]
fn a_corner_lies_where_both_legs_meet() {
    let late = (
        0.621_745_722_944_648_7,
        12.422_708_204_738_987,
        [
            0.592_022_981_120_347,
            0.735_914_618_936_845,
            0.619_357_409_637_891_4,
            0.0,
            -0.197_102_737_348_308_2,
            -0.250_300_665_264_905_63,
        ],
    );
    let early = (
        0.621_772_082_401_938_5,
        12.422_569_820_356_228,
        [
            0.592_087_278_725_914_6,
            0.735_967_568_402_315_3,
            0.619_268_774_483_833_1,
            0.0,
            -0.196_940_249_126_571_96,
            -0.250_476_498_140_612_57,
        ],
    );
    for accuracy in [1e-8, 1e-9, 1e-10, 1e-11] {
        for (second, period, start) in [late, early] {
            let row = Row {
                k: 1.146_694_827_260_293_3,
                v_dr: 0.083_970_762_645_534_55,
                limit: 0.948_037_569_634_431_6,
                decay: 0.972_140_851_939_593_3,
                second,
                third: 0.715_123_918_221_198_1,
            };
            let case = Case {
                start: Some(start.to_vec()),
                period: Some(period),
                accuracy,
                ..Case::of(&row)
            };
            let branch = System::of::<Row, _>()
                .branch(&case.following(Row::second, second..0.63))
                .unwrap();
            let reason = &branch.ended.reason;
            assert_eq!(branch.ended.word(), "reached-start", "{reason}");
            let [corner] = &branch.special[..] else {
                panic!("{:?}", branch.special)
            };
            assert_eq!(corner.kind, Kind::VanishingSegment);
            // From seven starts at 1e-11 and 1e-12: all within 4e-13.
            let off = (corner.r - 0.621_960_558_473_6).abs();
            let error = corner.error.unwrap();
            assert!(off <= error, "{off:e} beyond {error:e} at {accuracy:e}");
            assert!(error <= 1e-9 + 3.0 * accuracy, "{error:e} at {accuracy:e}");
        }
    }
}

/// A multiplier jumps past −1 where an orbit begins to stick: one that goes around twice meets it there, and in no flip beside.
#[test]
fn both_halves_become_one_where_a_multiplier_jumps() {
    let given = [
        (ForcedBelt::k, 1.636_137_950_292_862_6),
        (ForcedBelt::v_dr, 0.937_972_756_322_390_7),
        (ForcedBelt::load, 1.215_043_432_988_217),
        (ForcedBelt::omega, 0.581_260_349_222_660_1),
        (ForcedBelt::F_s, 1.285_352_412_723_217),
        (ForcedBelt::delta, 0.546_558_548_825_322_5),
    ];
    let range = (1.627_933_861_771_606_1, 2.833_476_485_124_183_6);
    for accuracy in [1e-8, 4e-9, 2.182_131_376_280_945_2e-9, 1e-9] {
        let found = branch(&given, ForcedBelt::m, range, |case| {
            case.accuracy = accuracy
        });
        let last = found.special.last().expect("where they meet");
        assert_eq!(last.kind, Kind::GrazingSliding, "{accuracy:e}");
        // At 1e-10 and 1e-11.
        let off = (last.r - 1.628_796_665_579_2).abs();
        assert!(
            off <= last.error.expect("an error"),
            "{accuracy:e}: {off:e}"
        );
    }
}
