//! What a motion says of its rates: along them its curve is drawn.

use stickslip::model::Model;
use stickslip::study::{Case, Dynamics, System, Trajectory};
use stickslip_models::BeltOscillator;

use crate::models::Hammer;

fn motion<M: Model<N>, const N: usize>(time: f64) -> Trajectory {
    let case = Case::declared(M::INFO, Dynamics::Exact);
    System::of::<M, N>().motion(&case, time).unwrap()
}

/// Rates are those of the states: the trapezoidal rule gives back the steps, but across what jumps.
fn follows_its_rates(motion: &Trajectory) {
    assert_eq!(motion.rates.len(), motion.times.len());
    for (i, pair) in motion.times.windows(2).enumerate() {
        let step = pair[1] - pair[0];
        let rates = motion.rates[i][1].iter().zip(&motion.rates[i + 1][0]);
        let states = motion.states[i].iter().zip(&motion.states[i + 1]);
        for ((leaves, comes), (from, to)) in rates.zip(states) {
            let (mean, moved) = (0.5 * (leaves + comes), to - from);
            let jumps = step == 0.0 && mean.is_nan();
            assert!(
                jumps || (moved - mean * step).abs() < 1e-3,
                "{i}: {moved} {mean} {step}"
            );
        }
    }
}

#[test]
fn an_impact_has_rates_on_its_outer_sides_only() {
    let motion = motion::<Hammer, _>(20.0);
    follows_its_rates(&motion);
    let jumps = motion.times.windows(2).zip(motion.rates.windows(2));
    let mut impacts = 0;
    for (_, rates) in jumps.filter(|(times, _)| times[0] == times[1]) {
        assert!(rates[0][0][0].is_finite() && rates[0][1][0].is_nan());
        assert!(rates[1][0][0].is_nan() && rates[1][1][0].is_finite());
        impacts += 1;
    }
    assert!(impacts > 1, "{impacts}");
}

#[test]
fn where_a_mass_begins_to_stick_its_rate_jumps() {
    let motion = motion::<BeltOscillator, _>(20.0);
    follows_its_rates(&motion);
    let jump = |[comes, goes]: &[Vec<f64>; 2]| (comes[1] - goes[1]).abs() > 0.1;
    // It sticks twice; where it lets go, the spring holds just what friction does, and nothing jumps.
    assert_eq!(motion.rates.iter().filter(|rates| jump(rates)).count(), 2);
}
