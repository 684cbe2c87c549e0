//! A wall that a sweep moves past where the motion was.

use stickslip::model;
use stickslip::poincare::Section;
use stickslip::study::{Along, Case, Diagram, Dynamics, Motion, Sweep, System};
use stickslip_models::press::Rigid;

model! {
    /// A mass that is pushed to a wall by more than it is shaken.
    struct Pushed {
        state x = 0.0;
        state v = 0.0;
        param gap = 1.0 where gap > 0.0;
        drive phi at 2.0;
        press R = Rigid { restitution: 0.0 } closing gap - x;
        der(x) = v;
        der(v) = 3.0 + cos(phi) - x - 0.1 * v - R;
    }
}

/// Where no motion can begin where the one before ended, it begins as the first did: all values but the first were lost.
#[test]
fn a_sweep_goes_on_past_where_a_wall_comes_nearer() {
    let system = System::of::<Pushed, _>();
    let mut case = Case::declared(system.info(), Dynamics::Exact);
    let design = stickslip::field::Design::Parameter(Pushed::gap.index);
    case.along = Some(Along {
        design,
        from: 0.5,
        to: 1.0,
    });
    let diagram = Diagram {
        section: Section::usual(system.info().drive),
        sweep: Sweep::Down,
        values: 6,
        settle: 40,
        points: 4,
        lyapunov: None,
    };
    let found = system.diagram(&case, &diagram).unwrap();
    for slice in &found.sweeps[0].slices {
        assert!(!matches!(slice.motion, Motion::Failed(_)), "{slice:?}");
        assert!((slice.max[0] - slice.r).abs() < 1e-12, "{slice:?}");
    }
}
