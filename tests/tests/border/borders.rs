//! Where events begin or cease to happen, what continues a branch there, and what hides between its points.

use stickslip::bifurcation::Kind;
use stickslip::continuation::Ending;
use stickslip::model;
use stickslip::study::{Beginning, BranchRecord, Case};
use stickslip_models::friction::{CoulombStatic, Tustin};
use stickslip_models::{BeltPair, DrillString, ForcedBelt};
use stickslip_tests::branches::{branch, named};

model! {
    /// A pendulum on a turning shaft: Froude, after Rayleigh 1877.
    struct Pendulum {
        state angle = 0.0;
        state speed = 0.0;
        param shaft = 3.0;
        friction M = Tustin { static_level: 0.1, kinetic_level: 0.06, speed: 4.0, viscous: 0.0 } opposing speed - shaft;
        der(angle) = speed;
        der(speed) = (M - 0.005 * speed - 0.5 * sin(angle)) / 0.02;
    }
}

model! {
    /// A plate between two belts that run against each other.
    pub(crate) struct Torn {
        state x = 0.2;
        state v = 0.0;
        param above = 1.0;
        param below = 0.7;
        friction A = CoulombStatic { static_level: above, kinetic_level: 0.6 * above } opposing v - 0.3;
        friction B = Tustin { static_level: below, kinetic_level: 0.5 * below, speed: 0.2, viscous: 0.0 } opposing v + 0.2;
        der(x) = v;
        der(v) = A + B - 4 * x;
    }
}

model! {
    /// A mass on rough ground, shaken through its spring: Den Hartog 1931, here with a peak at rest.
    struct Shaken {
        state x = 0.0;
        state v = 0.0;
        param omega = 0.6;
        param held = 0.5;
        param level = 0.2;
        drive phi at omega;
        friction F = CoulombStatic { static_level: held * level / 0.2, kinetic_level: level } opposing v;
        der(x) = v;
        der(v) = cos(phi) - x + F;
    }
}

/// Names in their order, and values to this share of themselves.
fn are(branch: &BranchRecord, wanted: &[(&str, f64)], tolerance: f64) {
    let found = named(branch);
    assert_eq!(found.len(), wanted.len(), "{found:?}");
    for (found, wanted) in found.iter().zip(wanted) {
        assert_eq!(found.0, wanted.0, "{found:?}");
        assert!((found.1 / wanted.1 - 1.0).abs() <= tolerance, "{found:?}");
    }
}

/// Pure slip meets stick-slip in a non-smooth fold: both lie on one side of it. The slip ends where it shrinks to the
/// equilibrium that loses its stability at 4 ln 2.
#[test]
fn a_branch_turns_at_a_graze_and_goes_on_with_the_other_word() {
    let found = branch(&[], Pendulum::shaft, (2.5, 4.0), |_| {});
    let hopf = 4.0 * 2.0_f64.ln();
    are(&found, &[("GS1", 3.060_655_570), ("HB1", hopf)], 1e-9);
    // Its last orbit has a hundredth of the size of the largest: r is off by the square of that.
    let last = found.points.last().expect("points");
    assert!((last.r.expect("a value") / hopf - 1.0).abs() < 1e-3);
    assert!(found.unlocated().is_none(), "{:?}", found.ended);
}

#[test]
fn it_does_so_from_either_side() {
    let back = branch(&[], Pendulum::shaft, (2.5, 4.0), |case| {
        case.beginning = Beginning::Hopf;
    });
    are(&back, &[("GS1", 3.060_655_570)], 1e-9);
    assert_eq!(back.ended.word(), "reached-start");
}

/// ψ' = η and ψ'' = 0 at once: closed form, theory section 8.2.
#[test]
fn the_drill_string_ends_at_its_graze() {
    let found = branch(&[], DrillString::eta, (4.0, 5.0), |_| {});
    let graze = &found.special[0];
    let off = (graze.r - 4.611_989_021_286_665).abs();
    assert_eq!(graze.kind, Kind::GrazingSliding);
    assert!(
        off <= graze.error.expect("an error") && off < 1e-10,
        "{off:e}"
    );
    assert!(matches!(
        found.ended.ending,
        Ending::At(Kind::GrazingSliding, _)
    ));
}

/// Where friction drops at release, what would be brief is not: orbits on both sides end at the graze.
#[test]
fn where_friction_drops_both_sides_end() {
    for range in [(0.7, 0.4), (0.5, 0.7)] {
        let found = branch(&[], Torn::below, range, |_| {});
        are(&found, &[("GS1", 0.552_828_349_2)], 1e-9);
        assert!(matches!(
            found.ended.ending,
            Ending::At(Kind::GrazingSliding, _)
        ));
    }
    let found = branch(&[], Torn::above, (0.3, 0.1), |_| {});
    are(&found, &[("SS1", 0.168_454_065_2)], 1e-9);
    assert!(matches!(
        found.ended.ending,
        Ending::At(Kind::SwitchingSliding, _)
    ));
}

/// Both halves of a symmetric orbit come to their border at once. Den Hartog 1931: of continuous sliding, with the amplitude
/// c and T = π/ω, s = −f sin T / (ω (1 + cos T)) and c² + s² = (1 − ω²)⁻²; at its turning points the ground would have to
/// hold c ω², and does so from the limit at rest on, for a moment.
#[test]
fn both_halves_of_a_symmetric_orbit_begin_to_stick() {
    let held = |omega: f64| {
        let turn = std::f64::consts::PI / omega;
        let s = 0.2 * turn.sin() / (omega * (1.0 + turn.cos()));
        omega.powi(2) * ((1.0 - omega * omega).powi(-2) - s * s).sqrt()
    };
    let (mut low, mut high) = (0.55_f64, 0.62);
    while high - low > 1e-15 {
        let middle = 0.5 * (low + high);
        if held(middle) < 0.5 {
            low = middle;
        } else {
            high = middle;
        }
    }
    let found = branch(&[], Shaken::omega, (0.65, 0.55), |_| {});
    are(&found, &[("CS1", high)], 1e-11);
    assert_eq!(found.ended.word(), "reached-end");
    let last = found.points.last().expect("points");
    let word = last.word.as_deref().unwrap_or_default();
    assert_eq!(word.matches("stick").count(), 2, "{word}");
}

/// What holds the mass is asked for most at the phases 0 and π. With L for the level, 6/5 L at rest and ω = 1/2, it slides
/// from −c at the phase 0 as x = A cos t + 4/3 cos t/2 − L to rest at c where cos t/2 = −1/(3 A): 2 L = 4/3 − 2/(9 A) with
/// A = L − 4/3 − c. It lets go just at the peak where 6/5 L = 1 + c: 0.4 L² + 0.4 L = 2/3. There its multiplier has no bound;
/// without the peak of the load it would stay where it is.
#[test]
fn friction_that_lets_go_at_the_peak_of_a_load_ends_a_branch() {
    let given = [(Shaken::omega, 0.5), (Shaken::held, 0.24)];
    let found = branch(&given, Shaken::level, (0.5, 1.2), |_| {});
    let last = (0.16_f64 + 16.0 / 15.0).sqrt() / 0.8 - 0.5;
    are(
        &found,
        &[("LP1", 8.0_f64.sqrt() / 3.0), ("AS1", last)],
        1e-9,
    );
    assert_eq!(found.ended.word(), "adding-sliding");
    assert!(found.ended.is_located(), "{}", found.ended.reason);
}

/// Two flips lie between two points of the branch, whatever the accuracy.
#[test]
fn what_happens_twice_between_two_points_is_found() {
    let given = [
        (BeltPair::alpha, 3.208_017_608_827_265_4),
        (BeltPair::beta, 1.710_209_920_927_483),
        (BeltPair::v_dr, 0.420_199_554_794_428_05),
    ];
    for accuracy in [1e-8, 1e-9] {
        let range = (2.351_025_402_267_82, 3.996_743_183_855_293_6);
        let found = branch(&given, BeltPair::gamma, range, |case| {
            case.accuracy = accuracy
        });
        let names: Vec<&str> = named(&found).iter().map(|one| one.0).collect();
        assert_eq!(names, ["PD1", "PD2", "LP1", "VS1"]);
    }
}

/// A graze, not the stretch that vanishes in it.
#[test]
fn a_border_has_one_name_at_any_accuracy() {
    let given = [
        (BeltPair::alpha, 0.711_408_620_962_197_3),
        (BeltPair::gamma, 3.580_942_874_123_65),
        (BeltPair::v_dr, 0.595_723_590_952_109_9),
    ];
    for accuracy in [1e-7, 1e-9] {
        let range = (2.7, 2.8);
        let found = branch(&given, BeltPair::beta, range, |case| {
            case.accuracy = accuracy
        });
        let graze = found
            .special
            .iter()
            .find(|one| one.kind == Kind::GrazingSliding);
        assert!((graze.expect("a graze").r - 2.792_766_338).abs() < 1e-8);
    }
}

#[test]
fn and_wherever_the_branch_begins() {
    let given = [
        (ForcedBelt::load, 0.583_067_466_710_392_6),
        (ForcedBelt::omega, 2.566_938_402_816_220_8),
    ];
    let range = (0.404_839_980_351_467_84, 0.484_711_560_430_643_23);
    let begun = |case: &mut Case| {
        case.start = Some(vec![-0.067_039_776_766_480_9, range.0, 0.0]);
        case.period = Some(7.343_205_392_407_811);
    };
    for found in [
        branch(&given, ForcedBelt::v_dr, range, |_| {}),
        branch(&given, ForcedBelt::v_dr, range, begun),
    ] {
        are(&found, &[("AS1", 0.439_150_537)], 1e-8);
    }
}

/// A branch goes on beyond grazes, however far its range reaches.
#[test]
#[ignore = "long"]
fn the_far_end_does_not_end_a_branch() {
    let given = [
        (BeltPair::beta, 2.121_951_799_017_579_4),
        (BeltPair::gamma, 0.809_664_431_253_427_8),
        (BeltPair::v_dr, 0.459_373_410_681_666_9),
    ];
    let [short, long] = [2.0, 3.0].map(|to| {
        let range = (1.569_761_613_824_973, to);
        branch(&given, BeltPair::alpha, range, |_| {})
    });
    assert_eq!(short.special.len(), 16);
    are(&long, &named(&short), 1e-8);
}

/// A border just behind a step is none of those that the step passes, although the same words part there.
#[test]
fn a_border_behind_a_step_is_not_met_again() {
    let given = [
        (ForcedBelt::m, 1.870_362_111_198_435_2),
        (ForcedBelt::k, 0.796_581_830_163_898_9),
        (ForcedBelt::v_dr, 0.845_015_326_449_204_2),
        (ForcedBelt::load, 0.588_667_602_535_177_4),
        (ForcedBelt::omega, 1.237_001_796_844_239_5),
        (ForcedBelt::delta, 0.539_826_869_581_500_6),
    ];
    let range = (0.500_819_283_228_994_3, 0.294_596_765_438_363_44);
    let found = branch(&given, ForcedBelt::F_s, range, |case| case.accuracy = 1e-9);
    let wanted = [
        ("AS1", 0.415_809_651_16),
        ("GS1", 0.410_713_699_11),
        ("LP1", 0.410_696_398_93),
    ];
    are(&found, &wanted, 1e-9);
    assert_eq!(found.ended.word(), "reached-start");
}

/// Where an orbit grazes, its multiplier jumps from −3.48 to 0.45: the orbits that double there end at that border (Feigin
/// 1970), and one of them is not taken for the orbit that it doubles, however near.
#[test]
fn orbits_that_double_at_a_graze_end_at_it() {
    let given = [
        (ForcedBelt::m, 2.292_613_429_066_069_6),
        (ForcedBelt::k, 0.450_087_240_649_464_2),
        (ForcedBelt::load, 1.183_216_605_846_751_3),
        (ForcedBelt::omega, 0.633_042_873_764_591),
        (ForcedBelt::F_s, 2.331_536_529_386_831),
        (ForcedBelt::delta, 0.465_138_375_280_926_66),
    ];
    let range = (1.232_733_487_703_264_3, 1.236);
    let turn = std::f64::consts::TAU / given[3].1;
    let [single, double] = [
        ([2.103_509_16, -0.494_674_908, 0.0], 2.0 * turn),
        (
            [2.103_526_646_624_812, -0.494_673_384_419_252_5, 0.0],
            4.0 * turn,
        ),
    ]
    .map(|(start, period)| {
        branch(&given, ForcedBelt::v_dr, range, |case| {
            case.accuracy = 1e-9;
            case.start = Some(start.to_vec());
            case.period = Some(period);
        })
    });
    are(&single, &[("GS1", 1.232_738_623_852)], 1e-10);
    are(&double, &named(&single), 1e-10);
    assert_eq!(double.ended.word(), "grazing-sliding");
    assert!((double.points[0].period / single.points[0].period - 2.0).abs() < 1e-9);
    assert!((double.special[0].period / turn - 2.0).abs() < 1e-9);
}
