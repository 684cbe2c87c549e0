//! Extents of states, from their extrema and the ends of steps: the same whichever extrema are asked for.

use stickslip::flow::exact::ExactFlow;
use stickslip::flow::{Flow, Passage, Peaks, Want};
use stickslip::integrate::Tolerance;
use stickslip::model::Model;
use stickslip_models::{BeltOscillator, BeltPair, DrillString, ForcedBelt};
use stickslip_tests::random::Random;

/// Starts of each model, and the time for which it is followed from there.
const STARTS: usize = 20;
const TIME: f64 = 60.0;

fn extents<Mode, const N: usize>(passage: &Passage<N, Mode>) -> [[f64; 2]; N] {
    let ends = |j: usize| [passage.calm.low[j], passage.calm.high[j]];
    let mut all: [[f64; 2]; N] = std::array::from_fn(ends);
    for one in &passage.extrema {
        let ([low, high], value) = (&mut all[one.index], one.state[one.index]);
        (*low, *high) = (low.min(value), high.max(value));
    }
    all
}

fn agree<M: Model<N>, const N: usize>() {
    let flow = ExactFlow::new(&M::default(), None, Tolerance::for_accuracy(1e-9)).unwrap();
    let mut dice = Random::new(11);
    let mut saved = 0;
    for _ in 0..STARTS {
        let start = M::INFO.states.iter().map(|state| state.start);
        let start: Vec<f64> = start.map(|y| y + dice.between(-0.5, 0.5)).collect();
        let from = flow.place(start.try_into().unwrap()).unwrap();
        let asked = |extrema| {
            let want = Want {
                extrema,
                ..Want::default()
            };
            flow.advance(&from, TIME, want).unwrap()
        };
        let (all, few) = (asked(Peaks::All), asked(Peaks::Extent(1)));
        assert_eq!(extents(&all), extents(&few), "{}", M::INFO.name);
        let of_one = |passage: &Passage<N, _>| -> Vec<f64> {
            let own = passage.extrema.iter().filter(|one| one.index == 1);
            own.map(|one| one.time).collect()
        };
        assert_eq!(of_one(&all), of_one(&few), "{}", M::INFO.name);
        saved += all.extrema.len() - few.extrema.len();
    }
    assert!(saved > STARTS, "{}: {saved}", M::INFO.name);
}

#[test]
fn extents_are_the_same_from_few_extrema() {
    agree::<BeltOscillator, 2>();
    agree::<BeltPair, 4>();
    agree::<DrillString, 2>();
    agree::<ForcedBelt, 3>();
}
