//! Steps allocate nothing: a passage asks the heap for as much as it does however many steps it makes.

use stickslip::field::{Design, SmoothField};
use stickslip::flow::{Flow, Place, SmoothFlow, Want};
use stickslip::model;
use stickslip::model::Model;
use stickslip_models::friction::Jenkins;
use stickslip_tests::on_every_reference_system;
use stickslip_tests::subject::{Subject, TIGHT};

on_every_reference_system! {
    steps_allocate_nothing,
}

fn steps_allocate_nothing<M: Model<N>, const N: usize>(subject: &Subject<M, N>) {
    let (design, value) = subject.designs()[0];
    for design in [design, Design::None] {
        let flow = subject
            .smooth(design, TIGHT)
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

model! {
    /// A contact that is swung: its spring meets its stops twice a round.
    struct Swung {
        state c = 1.0;
        state s = 0.0;
        state z = 0.0;
        param level = 0.5;
        friction F = Jenkins { stiffness: 1.0, level } opposing c with z;
        let force = F;
        der(c) = -s;
        der(s) = c;
    }
}

/// Neither do the instants at which a stop is met or left.
#[test]
fn stops_allocate_nothing() {
    let field = SmoothField::new(&Swung::default(), None, Design::None).expect("nothing to smooth");
    let flow = SmoothFlow::new(field, TIGHT);
    for derivatives in [true, false] {
        let want = Want {
            derivatives,
            ..Want::default()
        };
        let allocations = |time: f64| {
            let from = flow.place([1.0, 0.0, 0.0]).expect("a place");
            let measured = allocation_counter::measure(|| {
                flow.advance(&from, time, want).expect("a motion");
            });
            measured.count_total
        };
        assert_eq!(allocations(200.0), allocations(20.0));
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
