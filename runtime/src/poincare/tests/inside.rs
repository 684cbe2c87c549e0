use std::f64::consts::{PI, TAU};

use super::horizon::smooth;
use crate::motion::Flow;
use crate::poincare::*;
use crate::{friction_law, model};

model! {
    /// Its rate vanishes twice within a small part of a step: no error makes steps of polynomials short.
    struct Parabola {
        state y = 0.0;
        state tau = 0.0;
        param middle = 37.3;
        param width = 0.1;
        der(y) = powi(tau - middle, 2) - width * width;
        der(tau) = 1.0 + 0.0 * y;
    }
}

#[test]
fn turns_that_hide_in_a_step_are_found() {
    for width in [0.1, 0.03] {
        let model = Parabola {
            width,
            ..Parabola::default()
        };
        let flow = smooth(&model);
        let turns = Section {
            surface: Surface::Rate(0),
            direction: Direction::Both,
        };
        let place = Flow::place(&flow, &[0.0, 0.0]).unwrap();
        let met = until(&flow, place, turns, 100.0).unwrap();
        let times: Vec<f64> = met.points.iter().map(|point| point.time).collect();
        assert_eq!(times.len(), 2, "{times:?}");
        // Where a state is extremal, its value tells the time to half of the digits only.
        for (time, side) in times.iter().zip([-1.0, 1.0]) {
            assert!((time - 37.3 - side * width).abs() < 1e-5, "{times:?}");
        }
    }
}

friction_law! {
    struct Slider {
        state z: N;
        param stiffness: N/m where stiffness > 0.0;
        param level: N where level > 0.0;
        der(z) = stiffness * w;
        stop z at level;
        force(w) = z;
    }
}

model! {
    /// x = sin t, and a spring that slips at 0.3 along with it.
    struct Dragged {
        state x = 0.0;
        state v = 1.0;
        state z = 0.0;
        param weight = 1e-12;
        friction F = Slider { stiffness: 1.0, level: 0.3 } opposing v with z;
        der(x) = v;
        der(v) = -x + weight * F;
    }
}

/// A state that rises, rests on its stop and falls goes through a level below it twice, wherever passages end.
#[test]
fn levels_below_a_stop_are_met_on_both_sides_of_it() {
    let flow = smooth(&Dragged::default());
    let place = Flow::place(&flow, &[0.0, 1.0, 0.0]).unwrap();
    let z = |value| Section {
        surface: Surface::Level { state: 2, value },
        direction: Direction::Both,
    };
    let met = until(&flow, place.clone(), z(0.1), 10.0 * TAU).unwrap();
    let ups = (0..11).map(|k| match k {
        0 => f64::asin(0.1),
        k => f64::from(k) * TAU - f64::asin(0.6),
    });
    let downs = (0..10).map(|k| f64::from(k) * TAU + PI - f64::asin(0.8));
    let mut expected: Vec<f64> = ups.chain(downs).collect();
    expected.sort_by(f64::total_cmp);
    let times: Vec<f64> = met.points.iter().map(|point| point.time).collect();
    assert_eq!(times.len(), expected.len(), "{times:?}");
    assert!(
        times
            .iter()
            .zip(&expected)
            .all(|(a, b)| (a - b).abs() < 1e-6),
        "{times:?}"
    );
    let turns = Section {
        surface: Surface::Rate(2),
        direction: Direction::Down,
    };
    let met = until(&flow, place, turns, 3.0 * TAU).unwrap();
    assert_eq!(met.points.len(), 3, "{met:?}");
    assert!(
        (met.points[0].time - f64::asin(0.3)).abs() < 1e-6,
        "{met:?}"
    );
}
