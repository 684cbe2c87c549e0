//! A bell and its clapper, which rubs in its bearing: it meets both sides of the bell just where friction turns.

use stickslip::continuation::Kind;
use stickslip::model;
use stickslip::study::{Case, System};
use stickslip_models::friction::Coulomb;
use stickslip_models::press::Rigid;

model! {
    /// A bell that is swung, and its clapper, which rubs in its bearing.
    struct Bell {
        state a = 0.0;
        state wa = 0.0;
        state b = 0.0;
        state wb = 0.0;
        param torque = 0.2;
        param omega = 0.9 where omega > 0.0;
        param lim = 0.5 where lim > 0.0;
        param e = 0.5 where 0.0 <= e <= 1.0;
        param I = 10.0 where I > 0.0;
        param dry = 0.01 where dry >= 0.0;
        drive phi at omega;
        press P = Rigid { restitution: e } closing lim - (b - a);
        press Q = Rigid { restitution: e } closing lim + (b - a);
        friction F = Coulomb { level: dry } opposing wb - wa;
        der(a) = wa;
        der(wa) = (torque * I * cos(phi) - I * sin(a) - 0.05 * I * wa - F + P - Q) / I;
        der(b) = wb;
        der(wb) = F - 1.3 * sin(b) - 0.02 * wb - P + Q;
    }
}

/// Beyond the graze errors grow at each slow impact, at once, a thousand times: to divide the orbit there again and again left no place to begin
/// it from. The orbit at 0.08336 was closed by Newton's method on motions of an event-driven Runge-Kutta method.
#[test]
fn a_branch_goes_on_beyond_a_slow_impact() {
    for accuracy in [1e-5, 1e-9] {
        let mut case = Case::of(&Bell::default()).following(Bell::torque, 0.083..0.1);
        case.parameters[Bell::torque.index] = 0.083;
        case.accuracy = accuracy;
        let branch = System::of::<Bell, _>().branch(&case).unwrap();
        let reason = &branch.ended.reason;
        assert_eq!(branch.ended.word(), "reached-end", "{reason}");
        let found: Vec<(Kind, f64)> = branch.special.iter().map(|one| (one.kind, one.r)).collect();
        let [(Kind::Grazing, r)] = found[..] else {
            panic!("{found:?} at {accuracy:e}")
        };
        assert!((r - 0.083_328_090_143).abs() <= accuracy, "{r}");
    }
    let hit = Bell {
        torque: 0.08336,
        ..Bell::default()
    };
    let case = Case {
        start: Some(vec![
            0.480_897_74,
            0.127_844_57,
            0.008_911_21,
            -0.021_342_78,
            0.0,
        ]),
        period: Some(6.981_317_008),
        ..Case::of(&hit)
    };
    let orbit = System::of::<Bell, _>().orbit(&case).unwrap();
    for (found, known) in orbit.state.iter().zip(case.start.unwrap()) {
        assert!((found - known).abs() < 2e-8, "{found} {known}");
    }
}
