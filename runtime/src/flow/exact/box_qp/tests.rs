use super::*;
use crate::examples::{Pair, Plates};
use crate::field::exact::{ExactSystem, Mode, Modes};
use crate::model::Model;

/// Uniform in [-1, 1).
fn roll(random: &mut fastrand::Rng) -> f64 {
    2.0 * random.f64() - 1.0
}

/// Random rates and limits; G is that of the model, or full and positive definite.
fn on_random_problems<M: Model<N>, const N: usize>(count: u32, judge: impl Fn(&BoxProblem)) {
    let mut random = fastrand::Rng::with_seed(7);
    let system = ExactSystem::new(&M::default(), None);
    let all = Modes::from_fn(|_| Mode::Stick);
    for run in 0..count {
        let affine = system.affine(&[0.0; N], &all);
        let contacts = affine.rate.as_ref().len();
        let rows = affine.compliance.as_ref().iter();
        let mut problem = BoxProblem {
            compliance: rows.map(|row| row.as_ref().to_vec()).collect(),
            rate: (0..contacts).map(|_| 4.0 * roll(&mut random)).collect(),
            limit: (0..contacts).map(|_| 1.0 + roll(&mut random)).collect(),
        };
        if run % 2 == 0 {
            let factor: Vec<f64> = (0..contacts * contacts)
                .map(|_| roll(&mut random))
                .collect();
            let product = |i: usize, j: usize| -> f64 {
                (0..contacts)
                    .map(|k| factor[i * contacts + k] * factor[j * contacts + k])
                    .sum()
            };
            let entry = |i: usize, j: usize| product(i, j) + if i == j { 0.3 } else { 0.0 };
            let row = |i: usize| (0..contacts).map(|j| entry(i, j)).collect();
            problem.compliance = (0..contacts).map(row).collect();
        }
        judge(&problem);
    }
}

#[test]
fn combinations_meet_the_conditions() {
    on_random_problems::<Pair, 4>(200, |problem| {
        assert!(problem.violation(&problem.bound_signs()) < 1e-13);
    });
}

#[test]
fn iteration_finds_the_same_contacts_at_their_limits() {
    on_random_problems::<Plates, 7>(40, |problem| {
        let (iterated, tried) = (problem.bound_signs(), problem.enumerate());
        assert_eq!(iterated, tried);
        assert!(problem.violation(&iterated) < 1e-12);
    });
}
