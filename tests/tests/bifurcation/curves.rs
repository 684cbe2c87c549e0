//! Curves of bifurcations in two parameters: where they are known in closed form, and against branches
//! in one parameter at fixed values of the other.

use std::f64::consts::TAU;

use stickslip::model;
use stickslip::model::Model;
use stickslip::study::{
    Along, Beginning, Case, CurveRecord, Dynamics, SpecialCurvePoint, StudyError, System,
};
use stickslip_models::{DrillString, closed_form, systems};
use stickslip_tests::branches::question;
use stickslip_tests::range::place;
use stickslip_tests::rotating::Rotating;

model! {
    /// Bautin's normal form: two circles of radius² (q ± √(q² + 4p))/2 meet in a fold at p = −q²/4.
    pub struct Bautin {
        state x = 1.0;
        state v = 0.0;
        param p = 0.1;
        param q = 1.0;
        let square = powi(x, 2) + powi(v, 2);
        der(x) = x * (p + q * square - powi(square, 2)) - v;
        der(v) = v * (p + q * square - powi(square, 2)) + x;
    }
}

model! {
    /// Circles of radius² 2 + z with z³ − qz − p = 0: they meet in folds at p = ±2 (q/3)^{3/2}, a cusp at p = q = 0.
    pub struct Cusp {
        state x = 1.2;
        state v = 0.0;
        param p = -0.3;
        param q = 0.3;
        let z = powi(x, 2) + powi(v, 2) - 2.0;
        der(x) = x * (p + q * z - powi(z, 3)) - v;
        der(v) = v * (p + q * z - powi(z, 3)) + x;
    }
}

model! {
    /// The unit circle, beside which two states turn half as fast: seen from axes that do the same they obey
    /// U' = (p + d) U − q W, W' = q U + (p − d) W. The multipliers are −exp 2π(p ± √(d² − q²)).
    pub struct Halves {
        state x = 1.0;
        state v = 0.0;
        state u = 0.0;
        state w = 0.0;
        param p = -0.1;
        param q = 0.0;
        param d = 0.05;
        let pull = 1.0 - powi(x, 2) - powi(v, 2);
        der(x) = x * pull - v;
        der(v) = v * pull + x;
        der(u) = p * u + d * (x * u + v * w) - (0.5 + q) * w;
        der(w) = p * w + d * (v * u - x * w) + (0.5 + q) * u;
    }
}

model! {
    /// The unit circle, beside which two states turn by 1.3 + q a time unit and grow at the rate p − q².
    pub struct Torus {
        state x = 1.0;
        state v = 0.0;
        state u = 0.0;
        state w = 0.0;
        param p = -0.1;
        param q = -0.1;
        let rate = p - powi(q, 2);
        der(x) = x * (1.0 - powi(x, 2) - powi(v, 2)) - v;
        der(v) = v * (1.0 - powi(x, 2) - powi(v, 2)) + x;
        der(u) = rate * u - (1.3 + q) * w;
        der(w) = (1.3 + q) * u + rate * w;
    }
}

fn circle(
    model: &System,
    along: (&str, f64, f64),
    and: (&str, f64, f64),
    more: &[(&str, f64)],
) -> Result<CurveRecord, StudyError> {
    let (mut case, scope) = question(model, Dynamics::Smooth, along, and);
    for (name, value) in more {
        case.parameters[place(model, name)] = *value;
    }
    let start = model.info().states.iter().map(|state| state.start);
    (case.start, case.period) = (Some(start.collect()), Some(TAU));
    let curved = model.curve(&case, &scope)?;
    Ok(curved.followed().expect("nobody interrupts it"))
}

fn lies_on(curve: &CurveRecord, expected: impl Fn(f64) -> f64, tolerance: f64) {
    assert!(curve.points.len() > 3, "{} points", curve.points.len());
    for point in &curve.points {
        let value = expected(point.q);
        assert!(
            (point.p - value).abs() <= tolerance,
            "at q = {}: {} and not {value}",
            point.q,
            point.p
        );
        assert!(point.test.abs() < 1e-7, "{}", point.test);
    }
}

#[test]
fn folds_of_bautins_form_lie_on_a_parabola() {
    let curve = circle(
        &System::of::<Bautin, _>(),
        ("p", 0.1, -0.5),
        ("q", 1.0, 0.3),
        &[],
    )
    .unwrap();
    assert_eq!((curve.kind.name(), curve.of.as_str()), ("fold", "LP1"));
    assert_eq!(curve.ended.word(), "reached-end");
    lies_on(&curve, |q| -0.25 * q * q, 1e-8);
}

#[test]
fn a_cusp_is_passed_and_located() {
    let curve = circle(
        &System::of::<Cusp, _>(),
        ("p", -0.3, 0.3),
        ("q", 0.3, -0.3),
        &[],
    )
    .unwrap();
    assert_eq!(
        (curve.kind.name(), curve.ended.word()),
        ("fold", "reached-start")
    );
    for point in &curve.points {
        let expected = 2.0 * (point.q.max(0.0) / 3.0).powf(1.5);
        assert!(
            (point.p.abs() - expected).abs() < 1e-8,
            "{} {}",
            point.p,
            point.q
        );
    }
    let found: Vec<_> = curve.special.iter().map(|s| s.label.as_str()).collect();
    assert_eq!(found, ["CP1"]);
    let cusp = &curve.special[0].point;
    assert!(cusp.p.abs() < 1e-8 && cusp.q.abs() < 1e-6, "{cusp:?}");
}

#[test]
fn flips_lie_on_their_line_and_meet_in_a_resonance() {
    let curve = circle(
        &System::of::<Halves, _>(),
        ("p", -0.1, 0.1),
        ("d", 0.05, -0.05),
        &[],
    )
    .unwrap();
    assert_eq!(
        (curve.kind.name(), curve.ended.word()),
        ("flip", "reached-end")
    );
    lies_on(&curve, |d| -d, 1e-8);
    let found: Vec<_> = curve.special.iter().map(|s| s.label.as_str()).collect();
    assert_eq!(found, ["R2-1"]);
    assert!(curve.special[0].point.q.abs() < 1e-7);
}

#[test]
fn torus_points_lie_on_a_parabola_with_their_resonances() {
    let curve = circle(
        &System::of::<Torus, _>(),
        ("p", -0.1, 0.2),
        ("q", -0.1, 0.1),
        &[],
    )
    .unwrap();
    assert_eq!(
        (curve.kind.name(), curve.ended.word()),
        ("torus", "reached-end")
    );
    lies_on(&curve, |q| q * q, 1e-8);
    let found: Vec<_> = curve
        .special
        .iter()
        .map(|s| (s.label.as_str(), s.point.q))
        .collect();
    let expected = [("R4-1", -0.05), ("R3-1", 4.0 / 3.0 - 1.3)];
    assert_eq!(found.len(), 2, "{found:?}");
    for ((label, q), (name, value)) in found.iter().zip(expected) {
        assert_eq!(*label, name);
        assert!((q - value).abs() < 1e-7, "{label}: {q}");
    }
}

/// For |q| < d the pair is real, its product 1 all the same: a neutral saddle, where no torus is born.
#[test]
fn a_torus_curve_ends_where_it_becomes_a_neutral_saddle() {
    let more = [("d", 0.2)];
    let model = System::of::<Halves, _>();
    let curve = circle(&model, ("p", -0.1, 0.1), ("q", 0.3, 0.1), &more).unwrap();
    assert_eq!(
        (curve.kind.name(), curve.ended.word()),
        ("torus", "resonance-1-2")
    );
    assert!(curve.ended.is_located());
    lies_on(&curve, |_| 0.0, 1e-8);
    let last = curve.points.last().unwrap();
    assert!((last.q - 0.2).abs() < 1e-6, "{}", last.q);
    // From within, the branch passes that saddle at p = 0, and there is nothing to be followed.
    let within = circle(&model, ("p", -0.1, 0.1), ("q", 0.1, 0.15), &more);
    assert!(
        matches!(&within, Err(StudyError::NoSpecial { labels, .. }) if labels.is_empty()),
        "{within:?}"
    );
}

/// Friction: the flips of the belt pair against branches in v_dr alone, at other values of gamma.
#[test]
#[ignore = "long"]
fn flips_of_the_belt_pair_agree_with_branches_in_one_parameter() {
    let model = systems::belt_pair();
    let copy = Dynamics::Smoothed("tanh:1e4".parse().unwrap());
    for (dynamics, tolerance) in [(Dynamics::Exact, 1e-7), (copy, 1e-6)] {
        let (mut case, scope) =
            question(&model, dynamics, ("v_dr", 0.12, 0.2), ("gamma", 3.0, 2.7));
        case.start = Some(vec![-0.5976, 0.0, -0.4604, -0.1607]);
        let curve = model.curve(&case, &scope).unwrap().followed().unwrap();
        assert_eq!(
            (curve.kind.name(), curve.ended.word()),
            ("flip", "reached-end"),
            "{}",
            curve.ended.reason
        );
        for point in [curve.points.len() / 2, curve.points.len() - 1].map(|i| &curve.points[i]) {
            let mut alone = case.clone();
            alone.along = Some(scope.and);
            alone = alone.at(point.q);
            alone.start = Some(point.state.clone());
            alone.period = None;
            alone.along = Some(Along {
                from: point.p - 5e-3,
                to: point.p + 2e-3,
                ..case.along.unwrap()
            });
            alone = alone.at(point.p - 5e-3);
            let branch = model.branch(&alone).unwrap();
            let flip = branch
                .special
                .iter()
                .find(|s| s.kind.name() == "flip")
                .expect("a flip");
            let off = (flip.r / point.p - 1.0).abs();
            assert!(
                off < tolerance,
                "gamma = {}: {} and {}",
                point.q,
                flip.r,
                point.p
            );
        }
    }
}

/// Where the exact drill string's cycle ends: the bit, once loose, just reaches the table's speed again.
#[test]
fn the_drill_strings_graze_follows_its_closed_form() {
    let model = systems::drill_string();
    for (name, from, to) in [
        ("zeta", 0.05, 0.12),
        ("zeta", 0.05, 0.02),
        ("theta", 4.2, 2.0),
    ] {
        let (case, scope) = question(&model, Dynamics::Exact, ("eta", 4.0, 6.0), (name, from, to));
        let wide = Case {
            along: Some(Along {
                from: 4.0,
                to: 40.0,
                ..case.along.unwrap()
            }),
            ..case.clone()
        };
        let question = if to < from && name == "theta" {
            case
        } else {
            wide
        };
        let curve = model.curve(&question, &scope).unwrap().followed().unwrap();
        assert_eq!(
            (curve.kind.name(), curve.of.as_str()),
            ("grazing-sliding", "GS1")
        );
        assert!(curve.ended.is_located(), "{}", curve.ended.reason);
        let first = curve.points[0].p;
        assert!(
            (first / 4.611_989_021_286_665 - 1.0).abs() < 1e-9,
            "{first}"
        );
        for point in &curve.points {
            let mut bit = DrillString {
                eta: point.p,
                ..Default::default()
            };
            *(if name == "zeta" {
                &mut bit.zeta
            } else {
                &mut bit.theta
            }) = point.q;
            let sticks = |share: f64| {
                let at = DrillString {
                    eta: share * point.p,
                    ..bit
                };
                closed_form::drill_string(&at).is_some()
            };
            assert!(
                sticks(1.0 - 1e-8) && !sticks(1.0 + 1e-8),
                "{name} = {}",
                point.q
            );
            if name == "theta" {
                assert!((point.p / point.q / (first / 4.2) - 1.0).abs() < 1e-9);
            }
            assert!((point.state[0] + 2.0 * bit.zeta * point.p).abs() < 1e-7);
        }
    }
}

/// Where s (d + (s − 1)²)² is stationary: 5 s² − 6 s + 1 + d = 0. At the larger one a closed branch of s over Ω appears while F
/// grows, at the smaller one it joins the branch of weak response.
fn stationary(d: f64) -> [(f64, f64); 2] {
    [1.0, -1.0].map(|sign: f64| {
        let s = (3.0 + sign * (4.0 - 5.0 * d).sqrt()) / 5.0;
        (1.0 + 0.1 * s, s.sqrt() * (d + (s - 1.0).powi(2)))
    })
}

/// The special points of folds of the oscillator, from where it responds strongly.
fn folds(of: &str, along: (&str, f64, f64), and: (&str, f64, f64)) -> Vec<SpecialCurvePoint> {
    let model = System::of::<Rotating, _>();
    let (mut case, mut scope) = question(&model, Dynamics::Smooth, along, and);
    let middle = 0.5 * (along.1 + along.2);
    case = case.at(middle);
    case.beginning = Beginning::At(middle);
    scope.of = Some(of.to_owned());
    case.period = Some(TAU / case.parameters[Rotating::omega.index]);
    let curve = model.curve(&case, &scope).unwrap().followed().unwrap();
    assert_eq!(curve.kind.name(), "fold");
    curve.special
}

/// The only point of a kind, with the name of that along which branches meet there.
fn only(special: &[SpecialCurvePoint], label: &str) -> (&'static str, [f64; 2]) {
    let of_kind = |one: &&SpecialCurvePoint| one.label[..2] == label[..2];
    let found: Vec<_> = special.iter().filter(of_kind).collect();
    let [one] = found[..] else {
        panic!("{special:?}");
    };
    let along = one.branches.expect("what it is a special point of");
    (along.name(Rotating::INFO), [one.point.p, one.point.q])
}

#[test]
fn an_isola_is_born_and_merges_where_its_closed_form_says() {
    let [(omega, force), (joined, strong)] = stationary(0.152);
    let near = |[a, b]: [f64; 2], [c, d]: [f64; 2]| (a - c).abs() < 1e-8 && (b - d).abs() < 1e-8;
    let born = folds("LP1", ("omega", 0.6, 1.6), ("F", 0.25, 0.1));
    let (along, at) = only(&born, "IC1");
    assert!(
        along == "omega" && near(at, [omega, force]),
        "{along} {at:?}"
    );
    assert!(born.iter().all(|one| one.label != "BX1"));
    let merges = folds("LP1", ("omega", 0.5, 1.7), ("F", 0.25, 0.5));
    let (along, at) = only(&merges, "BX1");
    assert!(
        along == "omega" && near(at, [joined, strong]),
        "{along} {at:?}"
    );
    assert!(merges.iter().all(|one| one.label != "IC1"));
}

#[test]
fn a_birth_is_seen_whatever_variable_is_named_first() {
    let [(omega, force), _] = stationary(0.152);
    let born = folds("LP2", ("F", 0.1, 0.4), ("omega", 1.1, 1.05));
    let (along, [p, q]) = only(&born, "IC1");
    assert_eq!(along, "omega");
    assert!(
        (p - force).abs() < 1e-8 && (q - omega).abs() < 1e-7,
        "{p} {q}"
    );
}
