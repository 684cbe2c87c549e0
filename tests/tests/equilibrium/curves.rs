//! Curves of folds and Hopf points of equilibria in two parameters, where they and their points of codimension two are known
//! in closed form.

use std::f64::consts::{SQRT_2, TAU};

use stickslip::study::{
    Case, CurveRecord, CurveScope, EquilibriaRecord, Kind, StudyError, System, choose,
};
use stickslip::{friction_law, model};
use stickslip_tests::range::{place, range};

friction_law! {
    /// Friction that falls from 1 at rest to a half.
    pub struct Falling {
        param scale: m/s where scale > 0.0;
        stick = 1.0;
        slip(w) = 0.5 * (1.0 + exp(-w / scale));
    }
}

model! {
    /// At p = q² the rate of small motions passes zero, and that of larger ones is (q − 1/5) x²/4 beside it.
    pub struct Bautin {
        state x = 0.0;
        state v = 0.0;
        param p = -0.5;
        param q = 0.6;
        let square = powi(x, 2);
        der(x) = v;
        der(v) = (p - powi(q, 2) + (q - 0.2) * square - powi(square, 2)) * v - x;
    }
}

model! {
    /// The normal form of Bogdanov and Takens: folds at p = q²/4, Hopf points at p = 0 for q < 0.
    pub struct Takens {
        state x = 0.0;
        state y = 0.0;
        param p = -0.3;
        param q = -1.0;
        der(x) = y;
        der(y) = p + q * x + powi(x, 2) + x * y;
    }
}

model! {
    /// Two oscillators that do not know of each other: their rates pass zero at p = q² and at p = q/2.
    pub struct Pairs {
        state x = 0.0;
        state v = 0.0;
        state u = 0.0;
        state w = 0.0;
        param p = -0.3;
        param q = 0.2;
        let a = p - powi(q, 2) - powi(x, 2) - powi(v, 2);
        let b = p - 0.5 * q - powi(u, 2) - powi(w, 2);
        der(x) = a * x - v;
        der(v) = x + a * v;
        der(u) = b * u - 2.0 * w;
        der(w) = 2.0 * u + b * w;
    }
}

model! {
    /// The rate of small motions passes zero at p = 1 − q, as far as q may be anything.
    pub struct Bounded {
        state x = 0.0;
        state v = 0.0;
        param p = 0.3;
        param q = 0.0 where q >= 0.0;
        der(x) = v;
        der(v) = (p - 1.0 + q - powi(x, 2)) * v - x;
    }
}

model! {
    /// The equilibria s = ±√q, whose pair passes the axis at p = s.
    pub struct Turning {
        state s = 1.0;
        state x = 0.0;
        state v = 0.0;
        param p = 0.5;
        param q = 1.0;
        let a = p - s - powi(x, 2) - powi(v, 2);
        der(s) = q - powi(s, 2);
        der(x) = a * x - v;
        der(v) = x + a * v;
    }
}

model! {
    /// The equilibria of z³ − qz − p = 0, beside which another state decays: folds at p = ±2 (q/3)^{3/2}.
    pub struct Cusp {
        state z = -1.2;
        state u = 0.0;
        param p = -0.6;
        param q = 0.6;
        der(z) = p + q * z - powi(z, 3);
        der(u) = -u;
    }
}

model! {
    /// Two modes that friction couples (Hoffmann, Fischer, Allgaier & Gaul 2002, Wear 253, 721), with two dampers: the pair
    /// passes the axis at μ = 3/4 (1 + 2 c₁ c₂), with the frequency √2.
    pub struct Coupling {
        state x = 0.0;
        state v = 0.0;
        state y = 0.0;
        state w = 0.0;
        param mu = 0.3;
        param c1 = 0.2;
        param c2 = 0.1;
        der(x) = v;
        der(v) = -2.0 * x - (1.0 - 4.0 / 3.0 * mu) * y - c1 * v;
        der(y) = w;
        der(w) = -x - 2.0 * y - c2 * w;
    }
}

model! {
    /// A mass on a belt with falling friction slides evenly without vibration above v_d = ½ ln(1/(2ξ)).
    pub struct Sliding {
        state x = 0.0;
        state v = 0.0;
        param v_d = 1.6;
        param xi = 0.05;
        friction F = Falling { scale: 0.5 } opposing v - v_d;
        der(x) = v;
        der(v) = F - x - 2.0 * xi * v;
    }
}

type Range<'a> = (&'a str, f64, f64);

fn curve(
    model: &System,
    along: Range<'_>,
    and: Range<'_>,
    of: &str,
) -> Result<CurveRecord<EquilibriaRecord>, StudyError> {
    let mut case = Case::declared(model.info(), choose(model.info(), None, 1e-9).dynamics);
    let second = range(model, and.0, and.1, and.2);
    case.parameters[place(model, and.0)] = and.1;
    let first = range(model, along.0, along.1, along.2);
    case.along = Some(first);
    let scope = CurveScope {
        and: second,
        of: Some(of.to_owned()),
    };
    let curve = model.equilibria_curve(&case.at(first.from), &scope)?;
    Ok(curve.followed().expect("nobody interrupts it"))
}

fn lies_on(curve: &CurveRecord<EquilibriaRecord>, expected: impl Fn(f64) -> f64, tolerance: f64) {
    assert!(curve.points.len() > 3, "{} points", curve.points.len());
    for point in &curve.points {
        let (value, q) = (expected(point.q), point.q);
        let off = (point.p - value).abs();
        assert!(off <= tolerance, "at q = {q}: {} and not {value}", point.p);
    }
}

/// Its points of codimension two.
fn special(curve: &CurveRecord<EquilibriaRecord>) -> Vec<(Kind, [f64; 2])> {
    let all = curve.special.iter();
    all.map(|one| (one.kind, [one.point.p, one.point.q]))
        .collect()
}

fn only(curve: &CurveRecord<EquilibriaRecord>, kind: Kind, at: [f64; 2], tolerance: f64) {
    let [(found, place)] = special(curve)[..] else {
        panic!("{:?}", special(curve));
    };
    let off = (0..2).map(|k| (place[k] - at[k]).abs()).fold(0.0, f64::max);
    assert!(found == kind && off <= tolerance, "{found} at {place:?}");
}

#[test]
fn an_onset_turns_from_hard_to_soft_where_its_coefficient_vanishes() {
    let model = System::of::<Bautin, _>();
    let found = curve(&model, ("p", -0.5, 1.0), ("q", 0.6, -0.3), "HB1").unwrap();
    lies_on(&found, |q| q * q, 1e-11);
    only(&found, Kind::GeneralizedHopf, [0.04, 0.2], 1e-7);
    for point in &found.points {
        let (l1, error) = (point.l1.unwrap(), point.l1_error.unwrap());
        let off = (l1 - 0.25 * (point.q - 0.2)).abs();
        assert!(off <= 2.0 * error + 1e-12 && error < 1e-6, "{off} {error}");
        let onset = if point.q > 0.2 { "hard" } else { "soft" };
        assert!(point.onset == Some(onset) || error > l1.abs());
        assert!((point.period.unwrap() / TAU - 1.0).abs() < 1e-10);
    }
}

#[test]
fn hopf_points_end_where_their_frequency_vanishes() {
    let model = System::of::<Takens, _>();
    let found = curve(&model, ("p", -0.3, 0.2), ("q", -1.0, 1.0), "HB1").unwrap();
    lies_on(&found, |_| 0.0, 1e-9);
    only(&found, Kind::BogdanovTakens, [0.0, 0.0], 1e-7);
    assert_eq!(found.ended.word(), "bogdanov-takens");
}

#[test]
fn folds_of_equilibria_lie_on_a_parabola_and_meet_hopf_points() {
    let model = System::of::<Takens, _>();
    let found = curve(&model, ("p", -0.3, 0.5), ("q", -1.0, 1.0), "LP1").unwrap();
    lies_on(&found, |q| 0.25 * q * q, 1e-9);
    assert!(found.points.iter().all(|point| point.period.is_none()));
    // At p = 0 the equilibria x = 0 and x = −q cross there, too.
    let kinds = special(&found).iter().map(|one| one.0).collect::<Vec<_>>();
    assert_eq!(kinds, [Kind::BogdanovTakens, Kind::Exchange]);
    for (_, [p, q]) in special(&found) {
        assert!(p.abs() < 1e-12 && q.abs() < 1e-7, "{p} {q}");
    }
}

#[test]
fn a_pair_is_followed_through_another_one() {
    let model = System::of::<Pairs, _>();
    let found = curve(&model, ("p", -0.3, 1.0), ("q", 0.2, 0.9), "HB1").unwrap();
    lies_on(&found, |q| q * q, 1e-10);
    only(&found, Kind::DoubleHopf, [0.25, 0.5], 1e-8);
}

#[test]
fn hopf_points_turn_where_the_equilibrium_does() {
    let model = System::of::<Turning, _>();
    let found = curve(&model, ("p", 2.0, -2.0), ("q", 1.0, -1.0), "HB1").unwrap();
    for point in &found.points {
        assert!((point.p * point.p - point.q).abs() < 1e-10);
    }
    only(&found, Kind::ZeroHopf, [0.0, 0.0], 1e-7);
}

#[test]
fn folds_of_equilibria_meet_in_a_cusp() {
    let model = System::of::<Cusp, _>();
    let found = curve(&model, ("p", -0.6, 0.6), ("q", 0.6, -0.5), "LP1").unwrap();
    for point in &found.points {
        let expected = 2.0 * (point.q / 3.0).powf(1.5);
        assert!((point.p.abs() - expected).abs() < 1e-9, "{point:?}");
    }
    only(&found, Kind::Cusp, [0.0, 0.0], 1e-6);
}

#[test]
fn dampers_move_where_modes_couple() {
    let model = System::of::<Coupling, _>();
    let found = curve(&model, ("mu", 0.3, 1.5), ("c1", 0.02, 2.0), "HB1").unwrap();
    lies_on(&found, |c1| 0.75 * (1.0 + 0.2 * c1), 1e-10);
    for point in &found.points {
        assert!((TAU / point.period.unwrap() / SQRT_2 - 1.0).abs() < 1e-10);
    }
    assert_eq!(found.ended.word(), "reached-end");
}

#[test]
fn even_sliding_ends_where_the_belt_stops() {
    let model = System::of::<Sliding, _>();
    let found = curve(&model, ("v_d", 1.6, 0.01), ("xi", 0.05, 0.7), "HB1").unwrap();
    lies_on(&found, |xi| 0.5 * (0.5 / xi).ln(), 1e-9);
    assert!(found.points.iter().all(|point| point.onset == Some("hard")));
    assert_eq!(found.ended.word(), "left-range");
}

#[test]
fn a_boundary_of_sliding_is_not_followed() {
    let model = System::of::<Sliding, _>();
    let error = curve(&model, ("v_d", 1.6, 0.01), ("xi", 0.05, 0.4), "LP1").unwrap_err();
    assert!(matches!(error, StudyError::NoSpecial { .. }), "{error}");
}

/// What a curve needs of the motions beside one that lies on a bound, it takes from the side on which there are any.
#[test]
fn a_curve_begins_and_ends_at_a_bound() {
    let model = System::of::<Bounded, _>();
    for (from, to) in [(0.0, 0.5), (0.5, 0.0)] {
        let found = curve(&model, ("p", 0.3, 1.5), ("q", from, to), "HB1").unwrap();
        lies_on(&found, |q| 1.0 - q, 1e-9);
        assert_eq!(found.ended.word(), "reached-end");
    }
}
