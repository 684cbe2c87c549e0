//! The relief valve over the whole range of its inflow.

use std::f64::consts::TAU;

use stickslip::continuation::Kind;
use stickslip::model::Model;
use stickslip::study::{Case, Diagram, Dynamics, Motion, Section, Sweep, System};

use crate::impact::{branch, case};
use crate::models::Valve;

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
