//! Micro.
use std::hint::black_box;
use std::time::Instant;
use stickslip::field::Field;
use stickslip::field::exact::*;
use stickslip::integrate::explicit::*;
use stickslip::integrate::*;
use stickslip::model::*;
use stickslip_models::{BeltOscillator, BeltPair};
fn time(name: &str, mut f: impl FnMut()) {
    let mut best = f64::INFINITY;
    for _ in 0..200 {
        let c = Instant::now();
        for _ in 0..1000 {
            f();
        }
        best = best.min(c.elapsed().as_secs_f64() / 1000.0);
    }
    println!("{name:30} {:8.1} ns", best * 1e9);
}
fn all<M: Model<N>, const N: usize>(name: &str, model: &M, modes: Modes<M, N>, y: [f64; N]) {
    println!("{name} {modes:?}");
    let system = ExactSystem::new(model, Some(0));
    time("system", || {
        black_box(ExactSystem::new(black_box(model), Some(0)));
    });
    let field = ExactField::new(&system, modes, &y).unwrap();
    time("field", || {
        black_box(ExactField::new(&system, modes, &y).unwrap());
    });
    time("f", || {
        black_box(field.f(black_box(&y)));
    });
    time("linearise", || {
        black_box(field.linearise(black_box(&y)));
    });
    let s = Settings::new(Tolerance {
        relative: 1e-10,
        absolute: 1e-10,
    });
    let mut a = Stepper::new(&field, s, y, 0.0, 1.0).unwrap();
    time("step state", || {
        a.shorten(black_box(0.1)).unwrap();
    });
    let mut b = Stepper::new(&field, s, Motion::from(y), 0.0, 1.0).unwrap();
    time("step motion", || {
        b.shorten(black_box(0.1)).unwrap();
    });
    time("step map", || {
        black_box(b.step_map(black_box(0.1)));
    });
    time("dense", || {
        black_box(b.dense());
    });
}
fn main() {
    let m = |v: [Mode; 1]| Modes::from_fn(|i| v[i]);
    all(
        "belt",
        &BeltOscillator::default(),
        m([Mode::SlideBackward]),
        [0.5, 0.1],
    );
    all(
        "belt",
        &BeltOscillator::default(),
        m([Mode::Stick]),
        [0.5, 0.2],
    );
    let m = |v: [Mode; 2]| Modes::from_fn(|i| v[i]);
    all(
        "pair",
        &BeltPair::default(),
        m([Mode::SlideBackward; 2]),
        [0.5, 0.1, 0.3, 0.1],
    );
    all(
        "pair",
        &BeltPair::default(),
        m([Mode::SlideBackward, Mode::Stick]),
        [0.5, 0.1, 0.3, 0.14],
    );
}
