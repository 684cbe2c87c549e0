//! The exact flow against reference digits: periods, extrema, and orbits that close on themselves.

use stickslip::field::exact::Modes;
use stickslip::flow::exact::ExactFlow;
use stickslip::flow::{EventKind, Flow, Passage, Place, Want};
use stickslip::integrate::Tolerance;
use stickslip::model::Model;
use stickslip_models::{BeltOscillator, BeltPair, DrillString};

const TIGHT: Tolerance = Tolerance {
    relative: 1e-12,
    absolute: 1e-12,
};
const EXTREMA: Want = Want::EXTREMA;

const DERIVATIVES: Want = Want {
    derivatives: true,
    ..EXTREMA
};

/// One period from release to release, after a motion that began at rest on the belt.
struct Orbit<M: Model<N>, const N: usize> {
    start: Place<N, Modes<M, N>>,
    period: f64,
    passage: Passage<N, Modes<M, N>>,
}

fn releases<const N: usize, Mode>(passage: &Passage<N, Mode>) -> Vec<(f64, [f64; N])> {
    let released = |kind| matches!(kind, EventKind::Release { .. });
    let of = passage.events.iter().filter(|event| released(event.kind));
    of.map(|event| (event.time, event.state)).collect()
}

/// With one contact the return map is constant: two releases after any rest on the belt are a period.
fn superstable<M: Model<N>, const N: usize>(model: &M, from: [f64; N], time: f64) -> Orbit<M, N> {
    let flow = ExactFlow::new(model, None, TIGHT).unwrap();
    let long = flow
        .advance(&flow.place(from).unwrap(), time, EXTREMA)
        .unwrap();
    let found = releases(&long);
    let [.., (before, state), (after, _)] = found[..] else {
        panic!("{found:?}");
    };
    let start = flow.place(state).unwrap();
    let period = after - before;
    let passage = flow.advance(&start, period, EXTREMA).unwrap();
    Orbit {
        start,
        period,
        passage,
    }
}

fn extreme<const N: usize, Mode>(passage: &Passage<N, Mode>, index: usize, sign: f64) -> f64 {
    let of = passage.extrema.iter().filter(|e| e.index == index);
    sign * of
        .map(|e| sign * e.state[index])
        .fold(f64::NEG_INFINITY, f64::max)
}

fn assert_near(value: f64, reference: f64, tolerance: f64, what: &str) {
    let error = (value - reference).abs();
    assert!(
        error <= tolerance * reference.abs(),
        "{what}: {value} is off {reference} by {error:e}"
    );
}

#[test]
fn belt_oscillator_has_the_reference_period_and_extrema() {
    let references = [
        (
            0.05,
            28.933_508_365_051_118,
            1.032_296_137_058_152,
            -0.230_212_411_254_459_2,
        ),
        (
            0.1,
            17.865_990_246_422_36,
            1.065_421_363_469_625_2,
            -0.363_111_738_250_033_2,
        ),
        (
            0.15,
            13.996_134_342_062_943,
            1.099_321_053_808_122_6,
            -0.466_858_674_729_311_7,
        ),
        (
            0.2,
            12.001_031_294_830_579,
            1.133_944_676_441_656_8,
            -0.555_432_690_060_231_5,
        ),
        (
            0.5,
            8.282_743_522_678_173,
            1.354_505_602_980_898_4,
            -0.960_648_224_982_391_6,
        ),
        (
            1.0,
            7.042_687_095_460_494,
            1.757_059_035_587_62,
            -1.495_410_888_721_655_7,
        ),
    ];
    for (v_dr, period, max, min) in references {
        let model = BeltOscillator {
            v_dr,
            ..Default::default()
        };
        let orbit = superstable(&model, [0.0, v_dr], 100.0);
        assert_near(orbit.period, period, 1e-10, "period");
        assert_near(extreme(&orbit.passage, 0, 1.0), max, 1e-10, "max x");
        assert_near(extreme(&orbit.passage, 0, -1.0), min, 1e-9, "min x");
        // On the fastest belt the mass overtakes it before it sticks.
        let fastest = extreme(&orbit.passage, 1, 1.0);
        assert!(if v_dr < 1.0 {
            (fastest - v_dr).abs() < 1e-15
        } else {
            fastest > v_dr
        });
    }
}

#[test]
fn drill_string_has_the_reference_period_and_extrema() {
    let references = [
        (
            1.0,
            11.227_385_281_133_795,
            4.218_318_521_525_419,
            -3.604_417_739_119_201,
        ),
        (
            2.0,
            7.778_677_129_419_936,
            4.458_358_079_058_265,
            -3.809_523_833_997_190_4,
        ),
        (
            3.0,
            6.863_509_243_572_147,
            4.879_746_797_306_287,
            -4.169_586_964_300_771,
        ),
        (
            4.0,
            6.530_582_884_211_251,
            5.435_517_873_613_732,
            -4.644_475_504_867_291,
        ),
    ];
    for (eta, period, max, min) in references {
        let model = DrillString {
            eta,
            ..Default::default()
        };
        let orbit = superstable(&model, [0.0, eta], 100.0);
        assert_near(orbit.period, period, 1e-10, "period");
        assert_near(extreme(&orbit.passage, 0, 1.0), max, 1e-10, "max psi");
        assert_near(extreme(&orbit.passage, 0, -1.0), min, 1e-9, "min psi");
    }
}

#[test]
fn orbits_close_over_the_reference_period() {
    let model = BeltOscillator::default();
    let orbit = superstable(&model, [0.0, 0.2], 60.0);
    let flow = ExactFlow::new(&model, None, TIGHT).unwrap();
    // Away from the events, so that the ends need not lie on the same side of one.
    let start = flow
        .advance(&orbit.start, 1.7, Want::default())
        .unwrap()
        .end;
    let end = flow
        .advance(&start, 12.001_031_294_830_579, Want::default())
        .unwrap()
        .end;
    assert_eq!(start.mode, end.mode);
    for (a, b) in start.state.iter().zip(&end.state) {
        assert!((a - b).abs() < 1e-10, "{a} {b}");
    }
}

#[test]
fn fast_belts_never_let_the_mass_stick() {
    let model = BeltOscillator {
        v_dr: 10.0,
        ..Default::default()
    };
    let flow = ExactFlow::new(&model, None, TIGHT).unwrap();
    let start = flow.place([10.4, 0.0]).unwrap();
    let settled = flow.advance(&start, 400.0, EXTREMA).unwrap();
    let last = settled
        .extrema
        .iter()
        .rev()
        .find(|e| e.index == 0 && e.maximum)
        .unwrap();
    assert_near(last.state[0], 10.456_316_938_687_793, 1e-9, "max x");
}

/// The pair's orbit in phase, by settling onto it.
#[test]
fn belt_pair_settles_on_the_reference_orbit() {
    let model = BeltPair::default();
    let flow = ExactFlow::new(&model, None, TIGHT).unwrap();
    let period = 16.144_400_423_177_643;
    let mut place = flow.place([-0.5976, 0.0, -0.4604, -0.1607]).unwrap();
    place = flow
        .advance(&place, 250.0 * period, Want::default())
        .unwrap()
        .end;
    let passage = flow.advance(&place, period, DERIVATIVES).unwrap();
    for (a, b) in place.state.iter().zip(&passage.end.state) {
        assert!((a - b).abs() < 1e-8, "{a} {b}");
    }
    // Both masses stick together for a while: Φ has rank 2, with the multipliers 1 and μ.
    let derivatives = passage.derivatives.as_ref().unwrap();
    let trace: f64 = (0..4).map(|i| derivatives.state[i][i]).sum();
    assert_near(trace - 1.0, -0.896_378_150_579_442_5, 1e-6, "multiplier");
    let max_abs = |i| extreme(&passage, i, 1.0).max(-extreme(&passage, i, -1.0));
    assert_near(max_abs(0), 1.205_037_704_473_456, 1e-8, "max |x1|");
    assert_near(max_abs(2), 1.261_435_646_507_299_6, 1e-8, "max |x2|");
}
