//! How many modes a scene needs, against brute force.

use std::ops::ControlFlow;

use stickslip::model::Model;
use stickslip::study::{Case, Lack, ModesNeed, System, Topic};

use super::brute::{answer, errors, needed};
use super::models::{Bridge, Cantilever, Chain, Graded, Rod, ShortRod};

/// What the first structure needs; nothing else is asked.
fn modes(system: &System, case: &Case) -> ModesNeed {
    let record = system.needs_watched(case, &|topic| match topic {
        Topic::Contacts => ControlFlow::Break(()),
        _ => ControlFlow::Continue(()),
    });
    record.expect("an answer").modes.swap_remove(0)
}

/// As many modes as a scan shows to be needed, or one or two more, never fewer.
fn as_many_as_needed<M: Model<N>, const N: usize>() {
    let (system, case) = (System::of::<M, N>(), Case::of(&M::default()));
    let errors = errors(&system, &case);
    for accuracy in [1e-2, 1e-3, 1e-4] {
        let asked = Case {
            accuracy,
            ..case.clone()
        };
        let found = modes(&system, &asked);
        let (name, wanted) = (system.info().name, needed(&errors, accuracy));
        let count = found.needed.expect("all modes suffice");
        println!(
            "{name} to {accuracy:e}: {count} of {}, by brute force {wanted}: {errors:?}",
            found.kept
        );
        assert!(
            (wanted..=wanted + 2).contains(&count),
            "{name} to {accuracy:e}: {count}, not {wanted}"
        );
        assert!(found.error <= accuracy);
    }
}

#[test]
fn a_chain_needs_what_a_scan_shows() {
    as_many_as_needed::<Chain, _>();
}

#[test]
#[ignore = "long"]
fn other_structures_need_what_a_scan_shows() {
    as_many_as_needed::<Graded, _>();
    as_many_as_needed::<Cantilever, _>();
    as_many_as_needed::<Bridge, _>();
    as_many_as_needed::<Rod, _>();
}

#[test]
#[ignore = "long"]
fn modes_without_a_share_are_as_if_they_were_not_kept() {
    let short = Case::of(&ShortRod::default());
    let short = answer(&System::of::<ShortRod, _>(), &short).expect("an orbit");
    let whole = System::of::<Rod, _>();
    let mut thin = Case::of(&Rod::default());
    for mode in &whole.info().structures[0].modes[4..] {
        thin.parameters[mode.share.unwrap()] = 0.0;
    }
    let [thin, whole] =
        [thin, Case::of(&Rod::default())].map(|case| answer(&whole, &case).expect("an orbit"));
    for ((thin, short), whole) in thin.iter().zip(&short).zip(&whole) {
        for end in [0, 1] {
            assert!(
                (thin[end] - short[end]).abs() < 1e-7,
                "{thin:?} is not {short:?}"
            );
            assert!(
                (thin[end] - whole[end]).abs() > 1e-5,
                "{thin:?} is {whole:?}"
            );
        }
    }
}

#[test]
#[ignore = "long"]
fn what_is_left_out_of_the_file_is_told() {
    let system = System::of::<ShortRod, _>();
    let case = Case {
        accuracy: 1e-4,
        ..Case::of(&ShortRod::default())
    };
    let record = system.needs(&case).expect("an answer");
    let [
        Lack::Modes {
            kept: 4,
            there: 6,
            error,
            next: Some(next),
            ..
        },
    ] = record.lacks[..]
    else {
        panic!("{:?}", record.lacks);
    };
    // The truth is the rod with six modes.
    let all = System::of::<Rod, _>();
    let true_error = errors(&all, &Case::of(&Rod::default()))[3];
    assert!(
        (0.2..5.0).contains(&(error / true_error)),
        "{error:e} is not {true_error:e}"
    );
    assert!((next - 4.5 * std::f64::consts::PI).abs() < 1e-12);
}
