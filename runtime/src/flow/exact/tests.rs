use super::*;
use crate::examples::{Belt, Pair, Parallel, Sledges, Wrong};
use crate::field::exact::ContactError;
use crate::flow::EventKind;
use Mode::{SlideBackward, SlideForward, Stick};

const TIGHT: Tolerance = Tolerance {
    relative: 1e-11,
    absolute: 1e-11,
};
const ALL: Want = Want {
    path: true,
    factors: true,
    ..Want::SHOT
};

fn flow<M: Model<N>, const N: usize>(model: &M) -> ExactFlow<M, N> {
    ExactFlow::new(model, None, TIGHT).unwrap()
}

#[test]
fn places_stick_where_they_can() {
    let belt = flow(&Belt::default());
    let mode = |state| belt.place(state).unwrap().mode.as_slice()[0];
    assert_eq!(mode([0.5, 0.2]), Stick);
    assert_eq!(mode([0.5, 0.1 + 0.1]), Stick);
    assert_eq!(mode([0.5, 0.2 + 1e-12]), SlideForward);
    assert_eq!(mode([0.5, 0.1]), SlideBackward);
    // The spring is stronger than friction, or just about to be.
    assert_eq!(mode([1.5, 0.2]), SlideBackward);
    assert_eq!(mode([-1.5, 0.2]), SlideForward);
    assert_eq!(mode([1.0, 0.2]), SlideBackward);
    assert_eq!(mode([-1.0, 0.2]), Stick);
}

#[test]
fn one_contact_at_a_time_breaks_loose_where_friction_drops() {
    // Both sledges are overloaded; letting the lower go relieves the upper.
    let sledges = flow(&Sledges::default());
    let place = sledges.place([2.5, 0.3, 0.1, 0.3]).unwrap();
    assert_eq!(place.mode.as_slice(), [SlideBackward, Stick]);
    let pair = flow(&Pair::default());
    let place = pair.place([2.0, 0.14, -2.0, 0.14]).unwrap();
    assert_eq!(place.mode.as_slice(), [SlideBackward, SlideForward]);
}

#[test]
fn what_may_stick_or_cross_follows_the_rule() {
    let model = Belt {
        peak: 1.3,
        v_dr: 1.0,
        ..Belt::default()
    };
    // Released from the belt, the mass stops again where 1 < |λ| < 1.3.
    let kinds = |arrival| {
        let flow = flow(&model).with_arrival(arrival);
        let start = flow.place([-1.25, 0.99]).unwrap();
        let passage = flow.advance(&start, 0.2, ALL).unwrap();
        passage
            .events
            .iter()
            .map(|e| (e.kind, e.mode))
            .collect::<Vec<_>>()
    };
    let stuck = kinds(Arrival::Stick);
    assert!(
        matches!(
            stuck[..],
            [
                (
                    EventKind::Landing {
                        ambiguous: true,
                        ..
                    },
                    Stick
                ),
                ..
            ]
        ),
        "{stuck:?}"
    );
    let crossed = kinds(Arrival::Cross);
    assert!(
        matches!(
            crossed[..],
            [
                (
                    EventKind::Crossing {
                        ambiguous: true,
                        ..
                    },
                    SlideForward
                ),
                ..
            ]
        ),
        "{crossed:?}"
    );
}

#[test]
fn a_passage_may_end_and_begin_at_an_event() {
    let belt = flow(&Belt::default());
    let start = belt.place([0.0, 0.2]).unwrap();
    let release = belt.advance(&start, 5.0, ALL).unwrap();
    let whole = belt.advance(&start, 9.0, ALL).unwrap();
    let rest = belt.advance(&release.end, 4.0, ALL).unwrap();
    for (a, b) in whole.end.state.iter().zip(rest.end.state) {
        assert!((a - b).abs() < 1e-10, "{a} {b}");
    }
    let nothing = belt.advance(&start, 0.0, ALL).unwrap();
    assert_eq!(nothing.end, start);
    assert_eq!(nothing.segments.len(), 1);
}

#[test]
fn segments_path_and_extrema_tell_the_same_story() {
    let belt = flow(&Belt::default());
    let start = belt.place([0.0, 0.2]).unwrap();
    let passage = belt.advance(&start, 26.0, ALL).unwrap();
    let modes: Vec<_> = passage
        .segments
        .iter()
        .map(|s| s.mode.as_slice()[0])
        .collect();
    assert_eq!(modes, [Stick, SlideBackward, Stick, SlideBackward, Stick]);
    let total: f64 = passage.segments.iter().map(|s| s.duration).sum();
    assert!((total - 26.0).abs() < 1e-13);
    let highest = passage
        .path
        .iter()
        .map(|s| s.state[0])
        .fold(f64::MIN, f64::max);
    let maxima: Vec<_> = passage
        .extrema
        .iter()
        .filter(|e| e.index == 0 && e.maximum)
        .collect();
    assert_eq!(maxima.len(), 2);
    assert!(highest <= maxima[0].state[0] + 1e-12 && highest > maxima[0].state[0] - 1e-3);
    assert!(
        maxima[0].state[1].abs() < 1e-12,
        "the speed vanishes where x is largest"
    );
    assert!(passage.path.windows(2).all(|w| w[0].time < w[1].time));
    assert!(passage.events.windows(2).all(|w| w[0].time <= w[1].time));
}

#[test]
fn near_misses_are_noted() {
    // Below the belt's speed all the time: |w| has a minimum in every period of the sliding oscillation.
    let model = Belt {
        decay: 0.0,
        ..Belt::default()
    };
    let belt = flow(&model);
    let start = belt.place([1.19, 0.0]).unwrap();
    let passage = belt.advance(&start, 6.2, ALL).unwrap();
    let margins: Vec<f64> = passage
        .events
        .iter()
        .filter_map(|e| match e.kind {
            EventKind::Nearest { margin } => Some(margin),
            _ => None,
        })
        .collect();
    assert_eq!(margins.len(), 1, "{:?}", passage.events);
    assert!((margins[0] - 0.01).abs() < 1e-9, "{margins:?}");
}

#[test]
fn a_sign_error_and_ambiguous_forces_are_refused() {
    let refused = ExactFlow::new(&Wrong::default(), None, TIGHT).err();
    let wrong = ContactError::NotOpposing {
        contact: Wrong::INFO.contact_id(0),
        compliance: -1.0,
    };
    assert_eq!(refused, Some(FlowError::Contact(wrong)));
    let parallel = flow(&Parallel::default());
    let outcome = parallel.place([0.3, 0.0]).err();
    let singular = ContactError::Singular {
        contacts: [0, 1].map(|i| Parallel::INFO.contact_id(i)).to_vec(),
    };
    assert_eq!(outcome, Some(FlowError::Contact(singular)));
}

#[test]
fn bad_questions_have_typed_answers() {
    let belt = flow(&Belt::default());
    let start = belt.place([0.0, 0.2]).unwrap();
    for time in [-1.0, f64::NAN, f64::INFINITY] {
        let outcome = belt.advance(&start, time, ALL);
        assert!(matches!(outcome, Err(FlowError::BadTime { .. })));
    }
    for state in [[f64::NAN, 0.0], [0.0, f64::INFINITY]] {
        let outcome = belt
            .place(state)
            .and_then(|place| belt.advance(&place, 1.0, ALL));
        assert!(outcome.is_err(), "{outcome:?}");
    }
    let wrong_side = Place {
        state: [0.0, 0.5],
        mode: Modes::from_fn(|_| SlideBackward),
    };
    let outcome = belt.advance(&wrong_side, 1.0, ALL);
    assert!(
        matches!(outcome, Err(FlowError::InconsistentMode { contact, .. }) if contact == 0),
        "{outcome:?}"
    );
    let negative = Belt {
        m: -1.0,
        ..Belt::default()
    };
    assert!(matches!(
        ExactFlow::new(&negative, None, TIGHT),
        Err(FlowError::Parameter(_))
    ));
}

#[test]
fn velocity_is_that_of_the_mode() {
    let belt = flow(&Belt::default());
    let stuck = belt.place([0.5, 0.2]).unwrap();
    let velocity = belt.velocity(&stuck).unwrap();
    assert_eq!(velocity.f, [0.2, 0.0]);
    assert_eq!(velocity.jacobian, [[0.0, 1.0], [0.0, 0.0]]);
}
