//! The relief valve over the whole range of its inflow.

use stickslip::model::Model;
use stickslip::study::{Case, Diagram, Dynamics, Motion, Section, Sweep, System};

use crate::models::Valve;

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
