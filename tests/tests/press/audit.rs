//! Energy through contacts: a missed event would make some, or lose it.

use stickslip::flow::exact::ExactFlow;
use stickslip::flow::{Flow, Want};
use stickslip::integrate::Tolerance;
use stickslip::model::Model;
use stickslip_tests::random::Random;

use crate::models::{Ball, Bilinear, Ramp};

/// Energy before and after a motion.
fn through<M: Model<N>, const N: usize>(
    model: &M,
    start: [f64; N],
    time: f64,
    energy: impl Fn(&[f64; N]) -> f64,
) -> (f64, f64) {
    let flow = ExactFlow::new(model, None, Tolerance::for_accuracy(1e-11)).unwrap();
    let place = flow.place(start).unwrap();
    let passage = flow.advance(&place, time, Want::default());
    let passage = passage.unwrap_or_else(|error| panic!("{model:?} from {start:?}: {error}"));
    (energy(&start), energy(&passage.end.state))
}

fn springs(random: &mut Random) {
    let damped = random.unit() < 0.5;
    let model = Bilinear {
        mass: random.positive(0.1, 10.0),
        k: random.positive(0.1, 10.0),
        wall: random.positive(0.1, 1e4),
        c: if damped {
            random.positive(1e-3, 10.0)
        } else {
            0.0
        },
        gap: random.real(0.5),
    };
    let energy = |[x, v]: &[f64; 2]| {
        let depth = (-x - model.gap).max(0.0);
        0.5 * (model.mass * v * v + model.k * x * x + model.wall * depth * depth)
    };
    // Where a damper is, what the wall still holds when it lets go is lost: the motion begins and ends in the open.
    let start = [random.between(-model.gap, 2.0), random.real(3.0)];
    let (before, after) = through(&model, start, random.between(0.0, 30.0), energy);
    assert!(
        after <= before * (1.0 + 1e-6),
        "{model:?} from {start:?}: {before} {after}"
    );
    assert!(
        damped || after >= before * (1.0 - 1e-6),
        "{model:?} from {start:?}: {before} {after}"
    );
}

fn round_walls(random: &mut Random) {
    let model = Ball {
        left: random.positive(0.3, 300.0),
        right: random.positive(0.3, 300.0),
        curve: 0.0,
    };
    let bent = |load: f64, depth: f64| 0.4 * load * 0.2 * (depth.max(0.0) / 0.2).powf(2.5);
    let energy = |[x, v]: &[f64; 2]| {
        0.5 * v * v + 0.25 * x * x + bent(model.left, -0.5 - x) + bent(model.right, x - 0.7)
    };
    let start = [random.between(-0.8, 1.0), random.real(3.0)];
    let (before, after) = through(&model, start, random.between(0.0, 20.0), energy);
    assert!(
        (after - before).abs() < 1e-6 * before,
        "{model:?} from {start:?}: {before} {after}"
    );
}

/// A block that bounces, rests and rubs on a ramp: impacts and friction only take energy.
fn ramps(random: &mut Random) {
    let model = Ramp {
        shake: 0.0,
        e: random.between(0.0, 0.95),
        mu: random.between(0.0, 1.0),
        slope: random.real(0.6),
        wide: random.positive(0.5, 2.0),
        belt: 0.0,
        k: random.positive(0.1, 10.0),
        ..Default::default()
    };
    let energy = |[x, u, y, v, _]: &[f64; 5]| {
        0.5 * (model.wide * u * u + v * v + model.k * x * x) + model.g * y
    };
    let x = random.real(1.0);
    let high = model.slope * x + random.between(0.0, 1.0);
    let start = [x, random.real(2.0), high, random.real(2.0), 0.0];
    let flow = ExactFlow::new(&model, None, Tolerance::for_accuracy(1e-11)).unwrap();
    let place = flow.place(start).unwrap();
    let passage = flow.advance(
        &place,
        random.between(0.0, 20.0),
        Want {
            path: true,
            ..Want::default()
        },
    );
    let passage = passage.unwrap_or_else(|error| panic!("{model:?} from {start:?}: {error}"));
    let mut before = energy(&start);
    let size = 1.0 + before.abs();
    for sample in &passage.path {
        let mut after = energy(&sample.state);
        if after > before + 1e-8 * size {
            // Between the ends of steps a polynomial stands for the motion: the motion itself has to tell.
            let until = flow.advance(&place, sample.time, Want::default());
            after = energy(&until.unwrap().end.state);
        }
        assert!(
            after <= before + 1e-8 * size,
            "{model:?} from {start:?}: {before} {after} at {}",
            sample.time
        );
        let gap = sample.state[2] - model.slope * sample.state[0];
        assert!(gap > -1e-9, "{model:?} from {start:?}: {gap}");
        before = before.min(after);
    }
}

#[test]
fn energy_never_grows() {
    let mut random = Random::new(1788);
    for _ in 0..500 {
        springs(&mut random);
        round_walls(&mut random);
        ramps(&mut random);
    }
}

#[test]
#[ignore = "long"]
fn energy_never_grows_in_ten_thousand_motions() {
    let mut random = Random::new(1882);
    for _ in 0..4_000 {
        springs(&mut random);
        round_walls(&mut random);
        ramps(&mut random);
    }
}
