//! What friction carries along gets on where it lets go.

use stickslip::continuation::Kind;
use stickslip::field::Design;
use stickslip::model;
use stickslip::study::{Along, Case, Dynamics, System};
use stickslip_models::friction::Coulomb;

model! {
    /// A load on a table that is shaken, pulled back by a weight.
    pub struct Ferried {
        state v: m/s = 0.0;
        state way: m = 0.0;
        param mass: kg = 2.0 where mass > 0.0;
        param shake: m = 0.01;
        param omega: rad/s = 10.0 where omega > 0.0;
        param weight: N = 1.0;
        param level: N = 5.0 where level >= 0.0;
        drive phi at omega;
        friction F: N = Coulomb { level: level } opposing v - shake * omega * cos(phi);
        der(v) = (F - weight) / mass;
        der(way) = v;
    }
}

/// It is held up to m a ω² = level − weight, wherever it is, and beyond gets on by the same way each time: one branch, from
/// whichever end it is followed.
#[test]
fn a_load_that_is_held_gets_on_where_it_slips() {
    let system = System::of::<Ferried, _>();
    let branch = |from: f64, to: f64| {
        let design = Design::Parameter(Ferried::shake.index);
        let case = Case {
            along: Some(Along { design, from, to }),
            ..Case::declared(system.info(), Dynamics::Exact).at(from)
        };
        system.branch(&case).unwrap()
    };
    let (there, back) = (branch(0.01, 0.05), branch(0.05, 0.01));
    for found in [&there, &back] {
        assert!(found.ended.is_whole(), "{}", found.ended.reason);
        let added = found
            .special
            .iter()
            .filter(|one| one.kind == Kind::AddingSliding);
        let added: Vec<f64> = added.map(|one| one.r).collect();
        assert!(
            added.iter().any(|r| (r / 0.02 - 1.0).abs() < 1e-8),
            "{added:?}"
        );
    }
    let [far, near] = [there.points.last().unwrap(), &back.points[0]];
    let gain = |orbit: &stickslip::study::OrbitRecord| orbit.shift.as_ref().unwrap()[1];
    assert!(gain(far) < -1e-3 && (gain(far) / gain(near) - 1.0).abs() < 1e-8);
}
