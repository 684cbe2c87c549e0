//! The relief valve over the whole range of its inflow.

use std::f64::consts::TAU;

use stickslip::continuation::Kind;
use stickslip::model;
use stickslip::model::Model;
use stickslip::motion::Flow as Motions;
use stickslip::poincare::{Direction, Surface, until};
use stickslip::study::{
    Case, Class, Diagram, Dynamics, Motion, Region, Sampling, Section, Side, Sweep, System,
};
use stickslip_models::friction::Coulomb;
use stickslip_models::press::Rigid;

use crate::impact::{branch, case};
use crate::models::{Valve, flow};

model! {
    /// A poppet that chatters on its seat, with a seal that rubs; its pressure in any unit.
    struct Poppet {
        state x = 1e-3;
        state v = 0.0;
        state p = 0.0;
        param inflow = 4e-4;
        param unit = 1.0 where unit > 0.0;
        press N = Rigid { restitution: 0.3 } closing x;
        friction F = Coulomb { level: 2.0 } opposing v;
        der(x) = v;
        der(v) = (1e-4 * (1.2e6 + unit * p) - 100.0 - 4000.0 * x - 2.0 * v + F + N) / 0.05;
        der(p) = (inflow - 0.012 * x * sqrt(2.0 * (1.2e6 + unit * p) / 850.0)) / 2e-12 / unit;
    }
}

/// The last impacts of a chatter are as slow as 1e-6 m/s, beside pressures that change by 1e8 Pa/s: they are passed in any unit
/// of these.
#[test]
fn slow_impacts_are_none_the_less_impacts() {
    let [pascal, bar] = [1.0, 1e5].map(|unit| {
        let poppet = Poppet {
            unit,
            ..Default::default()
        };
        let mut case = case(&poppet, &[1e-3, 0.0, 0.0]);
        case.accuracy = 1e-9;
        branch::<Poppet, 3>(&case, Poppet::inflow.index, (5e-4, 5.65e-4))
    });
    assert_eq!(
        pascal.ended.word(),
        "reached-end",
        "{}",
        pascal.ended.reason
    );
    let named = |branch: &stickslip::study::BranchRecord| -> Vec<(Kind, f64)> {
        branch.special.iter().map(|one| (one.kind, one.r)).collect()
    };
    let (pascal, bar) = (named(&pascal), named(&bar));
    assert!(
        pascal.len() > 4 && pascal.len() == bar.len(),
        "{pascal:?} {bar:?}"
    );
    for (a, b) in pascal.iter().zip(&bar) {
        assert!(a.0 == b.0 && (a.1 / b.1 - 1.0).abs() < 1e-7, "{a:?} {b:?}");
    }
}

#[test]
fn a_valve_begins_to_flutter_where_its_outflow_is_known_to() {
    let case = Case::declared(Valve::INFO, Dynamics::Exact).following(Valve::q, 9.0..8.0);
    let steady = System::of::<Valve, 3>().equilibria_along(&case).unwrap();
    let hopf = &steady.special[0];
    assert!((hopf.r - 8.491117635183326).abs() < 1e-9);
    assert!((TAU / hopf.period.unwrap() - 3.0907088479743408).abs() < 1e-9);
}

/// Where it grazes, and where orbits that are hit settle, is known from another program: by steps of the fifth order in
/// Newton's method for the cycle that touches, and for the flip of the map from impact to impact.
#[test]
fn its_cycle_grazes_the_seat_and_goes_on_among_orbits_that_are_hit() {
    let valve = Valve {
        q: 8.3,
        ..Default::default()
    };
    let branch = branch::<Valve, 3>(&case(&valve, &[2.0, 0.0, 12.0]), Valve::q.index, (8.3, 5.0));
    let kinds: Vec<Kind> = branch.special.iter().map(|special| special.kind).collect();
    assert_eq!(kinds, [Kind::Grazing, Kind::Flip]);
    let [graze, flip] = [0, 1].map(|i| branch.special[i].r);
    assert!((graze - 7.557210971876742).abs() < 1e-9, "{graze}");
    assert!((flip - 6.0665145398).abs() < 1e-9, "{flip}");
    let mut hit = 0;
    for orbit in &branch.points {
        let q = orbit.r.unwrap();
        let word = if q < graze { "impact(R)" } else { "open(R)" };
        assert_eq!(orbit.word.as_deref(), Some(word), "{q}");
        assert!(
            orbit.min[0] > -1e-9,
            "{q}: through the seat by {}",
            orbit.min[0]
        );
        let unstable = usize::from(flip < q && q < graze);
        assert_eq!(orbit.floquet.unstable, unstable, "{q}");
        hit += usize::from(q < graze);
    }
    assert!(hit > 5, "{hit}");
    let last = branch.points.last().unwrap();
    assert!(
        (last.period - 2.1546994194120).abs() < 1e-9,
        "{}",
        last.period
    );
}

/// One orbit, whatever it begins with: an impact is its minimum, and no pressure so large that nothing else moves at first.
#[test]
fn all_starts_settle_on_the_one_chatter() {
    let poppet = Poppet {
        inflow: 1e-3,
        ..Default::default()
    };
    let mut case = case(&poppet, &[1e-3, 0.0, 0.0]);
    case.accuracy = 1e-9;
    let system = System::of::<Poppet, 3>();
    let side = |state: usize, low: f64, high: f64| Side { state, low, high };
    let sides = vec![side(0, 0.0, 2e-3), side(1, -1.0, 1.0)];
    let sampling = Sampling::of(Region { sides }, 10);
    let found = &system.attractors(&case, &sampling).unwrap().surveys[0].found;
    assert_eq!(found.len(), 1, "{found:?}");
    assert_eq!(
        (found[0].attractor.class, found[0].count),
        (Class::Orbit, 10)
    );

    let diagram = Diagram {
        section: Section::default(),
        sweep: Sweep::Up,
        values: 2,
        settle: 150,
        points: 32,
        lyapunov: None,
    };
    let along = case.following(Poppet::inflow, 1e-3..1.05e-3);
    let record = system.diagram(&along, &diagram).unwrap();
    for slice in &record.sweeps[0].slices {
        assert_eq!(slice.motion, Motion::Periodic(1), "{}", slice.r);
    }
}

/// The speed passes zero twice in each round: smoothly where the poppet turns, and in a jump at its seat, where it is met behind
/// the impact.
#[test]
fn a_speed_of_zero_is_met_in_a_jump_and_within_rounding() {
    let poppet = Poppet {
        inflow: 1e-3,
        ..Default::default()
    };
    let flow = flow(&poppet, None);
    let level = Section {
        surface: Surface::Level {
            state: 1,
            value: 0.0,
        },
        direction: Direction::Both,
    };
    let place = Motions::place(&flow, &[1e-3, 0.0, 0.0]).unwrap();
    let met = until(&flow, place, level, 0.2).unwrap();
    let (up, down): (Vec<_>, Vec<_>) = met.points.iter().partition(|one| one.rising);
    assert!(
        up.len() > 20 && up.len().abs_diff(down.len()) <= 1,
        "{}",
        up.len()
    );
    assert!(down.iter().all(|one| one.state[1].abs() < 1e-12));
    assert!(
        up.iter()
            .skip(3)
            .all(|one| one.state[0].abs() < 1e-9 && one.state[1] > 0.5)
    );
}

/// From rest above its Hopf point over the cycle to the chatter of small inflows: at every value a motion that was followed,
/// and never one through the seat.
#[test]
fn a_diagram_of_the_valve_has_every_value() {
    let case = Case::declared(Valve::INFO, Dynamics::Exact).following(Valve::q, 0.2..10.0);
    let diagram = Diagram {
        section: Section::default(),
        sweep: Sweep::Down,
        values: 50,
        settle: 150,
        points: 32,
        lyapunov: None,
    };
    let record = System::of::<Valve, 3>().diagram(&case, &diagram).unwrap();
    assert_eq!((record.missing, record.sweeps[0].slices.len()), (0, 50));
    for slice in &record.sweeps[0].slices {
        let (q, motion) = (slice.r, &slice.motion);
        assert!(
            !matches!(motion, Motion::Failed(_) | Motion::Elsewhere),
            "{q}: {motion:?}"
        );
        assert!(
            slice.min[0] > -1e-9,
            "{q}: through the seat by {}",
            slice.min[0]
        );
        // The cycle grazes at 7.557210972.
        if q > 9.0 {
            assert_eq!(*motion, Motion::Rest, "{q}");
        } else if (7.6..7.9).contains(&q) {
            assert_eq!(*motion, Motion::Periodic(1), "{q}");
            assert!(slice.min[0] > 0.0, "{q}");
        } else if q < 7.5 {
            assert!(slice.min[0] < 1e-9, "{q}: {} above the seat", slice.min[0]);
        }
    }
}
