//! Chains with closed forms.

mod files;

use std::f64::consts::PI;

use super::*;

/// A chain of equal masses and springs, held at its left end and at its right one if `held`.
fn chain(count: u32, held: bool) -> Coefficients {
    let mut entries = Vec::new();
    for i in 0..count {
        let ends = if i + 1 == count && !held { 1.0 } else { 2.0 };
        entries.push((i, i, ends));
        if i > 0 {
            entries.push((i, i - 1, -1.0));
        }
    }
    coefficients(count, entries)
}

fn coefficients(count: u32, entries: Vec<(u32, u32, f64)>) -> Coefficients {
    Coefficients {
        source: Source::default(),
        unknowns: count as usize,
        places: Vec::new(),
        scattered: false,
        whole: false,
        entries,
    }
}

fn unit(count: u32) -> Coefficients {
    coefficients(count, (0..count).map(|i| (i, i, 1.0)).collect())
}

fn point(name: &str, place: &str) -> Point {
    Point {
        name: name.into(),
        place: place.parse().unwrap(),
    }
}

fn near(a: f64, b: f64, relative: f64) {
    assert!((a - b).abs() <= relative * b.abs(), "{a} is not {b}");
}

const METHODS: [Method; 3] = [Method::Free, Method::CraigBampton, Method::Massless];

#[test]
fn frequencies_of_a_chain_are_those_of_its_closed_form() {
    let count = 200;
    let pencil = Pencil::new(&chain(count, true), &unit(count), None).unwrap();
    let structure = reduce(&pencil, &[point("end", "200")], 10, Method::Free).unwrap();
    assert_eq!(structure.modes.len(), 11);
    for (k, mode) in structure.modes.iter().take(10).enumerate() {
        let angle = (k + 1) as f64 * PI / f64::from(2 * (count + 1));
        near(mode.frequency, 2.0 * angle.sin(), 1e-10);
        let norm = (2.0 / f64::from(count + 1)).sqrt();
        near(
            mode.shape[0],
            (norm * (200.0 * 2.0 * angle).sin()).abs(),
            1e-8,
        );
    }
}

/// Unit springs in series: the point at row k gives way by k, and by min(i, k) under a load at i.
#[test]
fn static_displacements_are_exact_by_every_method() {
    let pencil = Pencil::new(&chain(60, false), &unit(60), None).unwrap();
    let points = [point("a", "17"), point("b", "60")];
    for method in METHODS {
        let structure = reduce(&pencil, &points, 6, method).unwrap();
        for (i, k, exact) in [(0, 0, 17.0), (0, 1, 17.0), (1, 1, 60.0)] {
            let modes = structure.modes.iter();
            let sum: f64 = modes
                .map(|mode| mode.shape[i] * mode.shape[k] / mode.frequency.powi(2))
                .sum();
            near(sum + structure.residual[(i, k)], exact, 1e-9);
        }
    }
}

/// All modes kept, nothing is left out.
#[test]
fn a_small_chain_is_reduced_to_itself() {
    let pencil = Pencil::new(&chain(4, true), &unit(4), None).unwrap();
    for method in [Method::Free, Method::Massless] {
        let structure = reduce(&pencil, &[point("a", "2")], 4, method).unwrap();
        assert_eq!(structure.modes.len(), 4);
        assert_eq!(structure.residual[(0, 0)], 0.0);
    }
    let held = reduce(&pencil, &[point("a", "2")], 3, Method::CraigBampton).unwrap();
    for (k, mode) in held.modes.iter().enumerate() {
        near(
            mode.frequency,
            2.0 * ((k + 1) as f64 * PI / 10.0).sin(),
            1e-12,
        );
    }
    let error = reduce(&pencil, &[point("a", "2")], 5, Method::Free).unwrap_err();
    assert_eq!(
        error,
        ReduceError::TooMany {
            wanted: 5,
            there: 4
        }
    );
}

/// A chain that nothing holds moves as a whole, with the frequency 0, not a small one.
#[test]
fn what_is_not_held_has_rigid_modes() {
    let count = 50;
    let mut loose = chain(count, false);
    loose.entries[0].2 = 1.0;
    let pencil = Pencil::new(&loose, &unit(count), None).unwrap();
    let structure = reduce(
        &pencil,
        &[point("a", "1"), point("b", "50")],
        5,
        Method::Free,
    )
    .unwrap();
    assert_eq!(structure.modes[0].frequency, 0.0);
    near(structure.modes[0].shape[0], 1.0 / 50.0_f64.sqrt(), 1e-9);
    for (k, mode) in structure.modes[1..5].iter().enumerate() {
        near(
            mode.frequency,
            2.0 * ((k + 1) as f64 * PI / 100.0).sin(),
            1e-9,
        );
    }
    // Loads that balance: 49 springs in series.
    let apart = |mode: &Mode| (mode.shape[0] - mode.shape[1]).powi(2) / mode.frequency.powi(2);
    near(structure.modes[1..].iter().map(apart).sum(), 49.0, 1e-8);
    let error = reduce(&pencil, &[], 5, Method::CraigBampton).unwrap_err();
    assert_eq!(error, ReduceError::StillLoose);
}

/// Two chains side by side: each frequency twice, and none is missed.
#[test]
fn equal_frequencies_are_all_found() {
    let mut both = chain(40, true);
    let more: Vec<_> = both
        .entries
        .iter()
        .map(|&(i, k, value)| (i + 40, k + 40, value))
        .collect();
    both.entries.extend(more);
    both.unknowns = 80;
    let pencil = Pencil::new(&both, &unit(80), None).unwrap();
    let structure = reduce(&pencil, &[], 8, Method::Massless).unwrap();
    for (k, mode) in structure.modes.iter().enumerate() {
        near(
            mode.frequency,
            2.0 * ((k / 2 + 1) as f64 * PI / 82.0).sin(),
            1e-10,
        );
    }
}

#[test]
fn damping_becomes_a_ratio() {
    let mut damping = chain(30, true);
    damping.entries.iter_mut().for_each(|entry| entry.2 *= 0.02);
    let pencil = Pencil::new(&chain(30, true), &unit(30), Some(&damping)).unwrap();
    let structure = reduce(&pencil, &[point("a", "7")], 3, Method::CraigBampton).unwrap();
    for mode in &structure.modes {
        near(mode.damping, 0.01 * mode.frequency, 1e-9);
    }
    assert!(structure.coupling < 1e-9);
}

#[test]
fn units_become_those_of_the_si() {
    let pencil = Pencil::new(&chain(30, true), &unit(30), None).unwrap();
    let points = [point("a", "7")];
    let structure = reduce(&pencil, &points, 3, Method::Massless).unwrap();
    let si = structure.clone().in_si("mm-t-s".parse().unwrap());
    near(si.modes[0].frequency, structure.modes[0].frequency, 1e-15);
    // A unit load of 1 N/mm on one of 1 mm: 1e3 N/m.
    near(
        si.residual[(0, 0)],
        structure.residual[(0, 0)] * 1e-3,
        1e-14,
    );
    assert!("mm-t".parse::<Scale>().is_err());
    assert!(
        "mm-t-h"
            .parse::<Scale>()
            .unwrap_err()
            .contains("`h` is no unit of time")
    );
}

#[test]
fn what_is_no_structure_is_refused() {
    let refused = |stiffness: &Coefficients, mass: &Coefficients| {
        let pencil = Pencil::new(stiffness, mass, None)?;
        reduce(&pencil, &[point("a", "2")], 2, Method::Free)
    };
    let good = (chain(8, true), unit(8));
    assert!(refused(&good.0, &good.1).is_ok());
    let edit = |from: &Coefficients, index: usize, value: f64| {
        let mut one = from.clone();
        one.entries[index].2 = value;
        one
    };
    let error = refused(&edit(&good.0, 3, -4.0), &good.1).unwrap_err();
    assert!(
        matches!(
            error,
            ReduceError::Indefinite {
                matrix: "stiffness",
                ..
            }
        ),
        "{error}"
    );
    let error = refused(&good.0, &edit(&good.1, 3, -1.0)).unwrap_err();
    assert!(
        matches!(
            error,
            ReduceError::Indefinite {
                matrix: "mass",
                negative: 1
            }
        ),
        "{error}"
    );
    let error = refused(&good.0, &unit(7)).unwrap_err();
    assert_eq!(
        error,
        ReduceError::Sizes {
            stiffness: 8,
            matrix: "mass",
            unknowns: 7
        }
    );
    let mut empty = good.1.clone();
    empty.entries.clear();
    let error = refused(&good.0, &empty).unwrap_err();
    assert!(
        matches!(error, ReduceError::Empty { matrix: "mass", .. }),
        "{error}"
    );
    let mut asymmetric = good.0.clone();
    asymmetric.entries.push((0, 1, -2.0));
    let error = refused(&asymmetric, &good.1).unwrap_err();
    assert!(
        matches!(
            error,
            ReduceError::Asymmetric {
                matrix: "stiffness",
                ..
            }
        ),
        "{error}"
    );
    let mut twice = good.0.clone();
    twice.entries.push((0, 0, 2.0));
    let error = refused(&twice, &good.1).unwrap_err();
    assert!(matches!(error, ReduceError::Repeated { .. }), "{error}");
    let mut loose = good.clone();
    (loose.0.unknowns, loose.1.unknowns) = (9, 9);
    let error = refused(&loose.0, &loose.1).unwrap_err();
    assert_eq!(
        error,
        ReduceError::Loose {
            place: "row 9".into()
        }
    );
}

/// A mass on a spring beside an unknown with stiffness only.
#[test]
fn unknowns_without_mass_have_no_mode() {
    let mut mass = unit(6);
    mass.entries.truncate(5);
    let pencil = Pencil::new(&chain(6, false), &mass, None).unwrap();
    let structure = reduce(&pencil, &[point("a", "6")], 5, Method::Massless).unwrap();
    near(structure.modes[0].frequency, 2.0 * (PI / 22.0).sin(), 1e-10);
    near(structure.residual[(0, 0)], 1.0, 1e-9);
    let error = reduce(&pencil, &[], 6, Method::Free).unwrap_err();
    assert_eq!(
        error,
        ReduceError::TooMany {
            wanted: 6,
            there: 5
        }
    );
}

#[test]
fn points_are_places() {
    assert_eq!(
        "871:y".parse(),
        Ok(Place {
            node: 871,
            direction: 2
        })
    );
    assert_eq!(
        "871:RZ".parse(),
        Ok(Place {
            node: 871,
            direction: 6
        })
    );
    assert_eq!(
        "871:3".parse(),
        Ok(Place {
            node: 871,
            direction: 3
        })
    );
    assert_eq!("12".parse::<Place>().unwrap().to_string(), "12");
    for word in ["", "y", "1:w", "1:0", "-1:x", "1:"] {
        assert!(word.parse::<Place>().is_err(), "{word}");
    }
    let pencil = Pencil::new(&chain(8, true), &unit(8), None).unwrap();
    let twice = [point("a", "2"), point("b", "2")];
    let error = reduce(&pencil, &twice, 2, Method::Free).unwrap_err();
    assert!(matches!(error, ReduceError::Twice { .. }), "{error}");
    let error = reduce(&pencil, &[point("a", "9")], 2, Method::Free).unwrap_err();
    assert!(error.to_string().contains("a row from 1 to 8"), "{error}");
}
