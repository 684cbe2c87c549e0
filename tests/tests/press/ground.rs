//! A wall beside a mass that rubs on the ground: where it is only touched, friction turns as well.

use stickslip::continuation::Kind;
use stickslip::field::Design;
use stickslip::model;
use stickslip::model::Model as _;
use stickslip::study::{Along, Case, Dynamics, System};
use stickslip_models::friction::Coulomb;
use stickslip_models::press::Rigid;

model! {
    /// A friction pendulum bearing in a moat, shaken by the ground.
    pub struct Bearing {
        state x: m = 0.0;
        state v: m/s = 0.0;
        param radius: m = 2.0 where radius > 0.0;
        param mu = 0.05 where mu >= 0.0;
        param quake: m/s^2 = 1.5;
        param moat: m = 0.25;
        param e = 0.5 where 0.0 <= e <= 1.0;
        param omega: rad/s = 3.0 where omega > 0.0;
        drive phi at omega;
        press W: m/s^2 = Rigid { restitution: e } closing moat - x;
        friction F: m/s^2 = Coulomb { level: mu * 9.81 } opposing v;
        der(x) = v;
        der(v) = F - W - 9.81 / radius * x - quake * cos(phi);
    }
}

/// Den Hartog's mass touches the wall where its swing is as wide as the moat, whichever of them is changed; from there on it
/// swings free, until the quake is what friction can bear.
#[test]
fn a_branch_leaves_a_wall_at_which_friction_turns() {
    let system = System::of::<Bearing, _>();
    for (parameter, to, held) in [
        (Bearing::quake, 0.1, 0.05 * 9.81),
        (Bearing::mu, 0.3, 1.5 / 9.81),
    ] {
        let mut case = Case::declared(Bearing::INFO, Dynamics::Exact);
        let (design, from) = (
            Design::Parameter(parameter.index),
            case.parameters[parameter.index],
        );
        case.along = Some(Along { design, from, to });
        let branch = system.branch(&case).unwrap();
        assert!(branch.ended.is_whole(), "{}", branch.ended.reason);
        let graze = branch.special.iter().find(|one| one.kind == Kind::Grazing);
        let graze = graze.expect("a grazing");

        let mut free = Case::declared(Bearing::INFO, Dynamics::Exact);
        free.parameters[Bearing::moat.index] = 1.0;
        free.parameters[parameter.index] = graze.r;
        let swing = system.orbit(&free).unwrap().max[0];
        assert!((swing - 0.25).abs() < 1e-8, "{swing} at {graze:?}");

        let last = branch.special.last().unwrap();
        assert!((last.r / held - 1.0).abs() < 1e-5, "{last:?}");
    }
}

/// Where it swings free, its wall is nearest just where friction turns: the branch comes to the same grazing from there, turns
/// at the same fold, and goes on among the orbits that hit.
#[test]
fn a_branch_comes_to_a_wall_at_which_friction_turns() {
    let system = System::of::<Bearing, _>();
    let met = [[0.6, 1.5], [1.5, 0.6]].map(|[from, to]| {
        let mut case = Case::declared(Bearing::INFO, Dynamics::Exact);
        case.parameters[Bearing::quake.index] = from;
        let design = Design::Parameter(Bearing::quake.index);
        case.along = Some(Along { design, from, to });
        let branch = system.branch(&case).unwrap();
        assert!(branch.ended.is_whole(), "{}", branch.ended.reason);
        [Kind::Grazing, Kind::Fold, Kind::CrossingSliding].map(|kind| {
            let special = branch.special.iter().find(|one| one.kind == kind);
            special.map_or(f64::NAN, |one| one.r)
        })
    });
    for (there, back) in met[0].into_iter().zip(met[1]) {
        assert!((there - back).abs() < 1e-8, "{met:?}");
    }
}
