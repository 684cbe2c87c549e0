//! Event points against Hénon's trick: the relative speed as independent variable, from its value to zero.

use std::ops::ControlFlow;

use stickslip::field::exact::{ExactField, ExactSystem, Modes};
use stickslip::field::{Field, Linear, Work};
use stickslip::flow::exact::ExactFlow;
use stickslip::flow::{EventKind, Flow, Want};
use stickslip::integrate::Tolerance;
use stickslip::integrate::explicit::{Settings, integrate};
use stickslip::model::Model;
use stickslip_models::{BeltOscillator, DrillString};

const TIGHT: Tolerance = Tolerance {
    relative: 1e-13,
    absolute: 1e-13,
};

/// dy/dw = f/ẇ and dt/dw = 1/ẇ, where w is the second state, up to a constant, that grows towards the surface.
struct Turned<'s, M: Model<2>> {
    field: ExactField<'s, M, 2>,
}

impl<M: Model<2>> Field<3> for Turned<'_, M> {
    fn f(&self, y: &[f64; 3]) -> [f64; 3] {
        let f = self.field.f(&[y[0], y[1]]);
        [f[0] / f[1], 1.0, 1.0 / f[1]]
    }

    fn linearise(&self, y: &[f64; 3]) -> Linear<3> {
        Linear {
            f: self.f(y),
            jacobian: [[f64::NAN; 3]; 3],
            design: [f64::NAN; 3],
        }
    }
}

/// The first landing after `start`, against the same point reached by w from shortly before it.
fn lands_where_henon_says<M: Model<2>>(model: &M, start: [f64; 2], belt: f64) {
    let flow = ExactFlow::new(model, None, TIGHT).unwrap();
    let place = flow.place(start).unwrap();
    let passage = flow.advance(&place, 12.0, Want::default()).unwrap();
    let landed = |kind| matches!(kind, EventKind::Landing { .. });
    let landing = passage.events.iter().find(|e| landed(e.kind)).unwrap();
    let before = flow
        .advance(&place, landing.time - 0.2, Want::default())
        .unwrap()
        .end;
    let system = ExactSystem::new(model, None);
    let modes: Modes<M, 2> = before.mode;
    let turned = Turned {
        field: ExactField::new(&system, modes, &before.state).unwrap(),
    };
    let from = [before.state[0], before.state[1], landing.time - 0.2];
    let way = belt - before.state[1];
    let settings = Settings::new(TIGHT);
    let mut work = Work::default();
    let end = integrate(&turned, settings, from, way, &mut work, |_| {
        ControlFlow::Continue(())
    })
    .unwrap();
    assert!(
        (end[0] - landing.state[0]).abs() < 1e-11,
        "{end:?} {landing:?}"
    );
    assert!((end[1] - belt).abs() < 1e-14 && (landing.state[1] - belt).abs() < 1e-14);
    assert!((end[2] - landing.time).abs() < 1e-11, "{end:?} {landing:?}");
}

#[test]
fn landings_are_where_henon_finds_them() {
    for v_dr in [0.1, 0.2, 0.5] {
        let model = BeltOscillator {
            v_dr,
            ..Default::default()
        };
        lands_where_henon_says(&model, [0.9, v_dr], v_dr);
    }
    lands_where_henon_says(&DrillString::default(), [3.0, 4.0], 4.0);
}
