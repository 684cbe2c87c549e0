//! Steps allocate nothing: a passage asks the heap for as much as it does however many steps it makes.

use stickslip::field::Design;
use stickslip::flow::{Family, Flow, Place, Want};
use stickslip::model::Model;
use stickslip_tests::on_every_reference_system;
use stickslip_tests::subject::{Subject, TIGHT};

on_every_reference_system! {
    steps_allocate_nothing,
}

fn steps_allocate_nothing<M: Model<N>, const N: usize>(subject: &Subject<M, N>) {
    let (design, value) = subject.designs()[0];
    for design in [design, Design::None] {
        let flow = subject
            .family(design, TIGHT)
            .at(value)
            .expect("a value within bounds");
        for derivatives in [true, false] {
            let want = Want {
                derivatives,
                ..Want::default()
            };
            let ((steps, few), (more_steps, more)) = (
                cost(subject, &flow, 0.5, want),
                cost(subject, &flow, 50.0, want),
            );
            assert!(
                more_steps > steps + 100,
                "{steps} and {more_steps} steps do not differ enough"
            );
            assert_eq!(
                more, few,
                "{steps} steps allocate {few} times, {more_steps} steps {more} times"
            );
        }
    }
}

/// Steps and allocations of one passage.
fn cost<M: Model<N>, F: Flow<N, Mode = ()>, const N: usize>(
    subject: &Subject<M, N>,
    flow: &F,
    time: f64,
    want: Want,
) -> (u64, u64) {
    let from = Place {
        state: subject.start(),
        mode: (),
    };
    let mut steps = 0;
    let counted = allocation_counter::measure(|| {
        let passage = flow
            .advance(&from, time, want)
            .expect("a motion that can be followed");
        steps = passage.work.steps;
    });
    (steps, counted.count_total)
}
