use super::*;
use crate::examples::{Belt, Pad};
use crate::flow::ExactFamily;
use crate::model::Model;

const ALL: Want = Want {
    path: true,
    factors: true,
    ..Want::SHOT
};

fn family() -> Family {
    let family: ExactFamily<Belt, 2> = ExactFamily {
        model: Belt::default(),
        design: Belt::INFO.parameters.iter().position(|p| p.name == "v_dr"),
        tolerance: Tolerance::for_accuracy(1e-8),
        magnitude: [1.0; 2],
    };
    family.into()
}

/// Three passages, the second of which fails, each from where the one before ended.
fn journey(family: &Family, times: [f64; 3]) -> Vec<Result<Passage, FlowError>> {
    let flow = family.at(0.2).unwrap();
    let mut place = flow.place(&[1.0, 0.0]).unwrap();
    let follow = |time: f64| {
        let passage = flow.advance(&place, time, ALL);
        if let Ok(passage) = &passage {
            place = passage.end.clone();
        }
        passage
    };
    times.into_iter().map(follow).collect()
}

/// What a journey notes if this is known of it.
fn noted(known: &[Vec<u8>], times: [f64; 3]) -> (Vec<Vec<u8>>, String) {
    let notes = Arc::new(Mutex::new(Vec::new()));
    let kept = notes.clone();
    let note = move |record: &[u8]| kept.lock().unwrap().push(record.to_vec());
    let tape = Tape::new(known.to_vec(), Box::new(note));
    let found = format!("{:?}", journey(&family().recorded(&tape), times));
    let notes = notes.lock().unwrap().clone();
    (notes, found)
}

const TIMES: [f64; 3] = [9.0, -1.0, 4.0];

#[test]
fn what_is_known_comes_back_to_the_last_bit() {
    let plain = format!("{:?}", journey(&family(), TIMES));
    let (all, found) = noted(&[], TIMES);
    assert_eq!((all.len(), &found), (3, &plain));
    for known in 1..=3 {
        let (rest, found) = noted(&all[..known], TIMES);
        assert_eq!((rest.as_slice(), &found), (&all[known..], &plain));
    }
}

#[test]
fn what_is_known_is_not_computed_again() {
    let flow = family().at(0.2).unwrap();
    let place = flow.place(&[1.0, 0.0]).unwrap();
    let (all, _) = noted(&[], TIMES);
    let tape = Tape::new(all, Box::new(|_| ()));
    let known = tape.recall(&place, (0.2, TIMES[0], ALL), || {
        Err(FlowError::BadTime { time: 0.0 })
    });
    assert_eq!(known, flow.advance(&place, TIMES[0], ALL));
}

#[test]
fn who_goes_another_way_is_not_misled() {
    let other = [9.0, 3.0, 4.0];
    let (all, _) = noted(&[], TIMES);
    let (rest, found) = noted(&all, other);
    assert_eq!(found, format!("{:?}", journey(&family(), other)));
    assert!(
        rest.is_empty(),
        "they would follow what belongs to another way"
    );
    // A record that is damaged is as good as none.
    let mut damaged = all.clone();
    damaged[0].pop();
    let (_, found) = noted(&damaged, TIMES);
    assert_eq!(found, format!("{:?}", journey(&family(), TIMES)));
}

#[test]
fn what_a_press_holds_is_told_beside_a_tape() {
    let family: ExactFamily<Pad, 3> = ExactFamily {
        model: Pad::default(),
        design: None,
        tolerance: Tolerance::for_accuracy(1e-8),
        magnitude: [1.0; 3],
    };
    let (plain, tape) = (Family::from(family), Tape::new([], Box::new(|_| ())));
    for family in [plain.recorded(&tape), plain] {
        let flow = family.at(0.0).unwrap();
        let modes = flow.loosened(vec![Mode::SlideForward, Mode::Open], &[1.0, 1.0]);
        assert_eq!(modes, [Mode::Loose, Mode::Open]);
    }
}

#[test]
fn what_has_another_shape_is_not_trusted() {
    let (all, plain) = noted(&[], TIMES);
    let flow = family().at(0.2).unwrap();
    let place = flow.place(&[1.0, 0.0]).unwrap();
    let found = flow.advance(&place, TIMES[0], ALL).unwrap();
    let forge = |change: fn(&mut Passage)| {
        let mut forged = found.clone();
        change(&mut forged);
        let record = postcard::to_allocvec(&(&place, (0.2, TIMES[0], ALL), forged)).unwrap();
        let mut known = all.clone();
        known[0] = record;
        known
    };
    let changes: [fn(&mut Passage); 8] = [
        |passage| passage.end.state.push(0.0),
        |passage| passage.end.state[0] = f64::NAN,
        |passage| passage.end.modes.clear(),
        |passage| passage.extrema[0].index = 2,
        |passage| passage.extrema[0].state.clear(),
        |passage| passage.events[0].contact = 1,
        |passage| passage.calm.low.clear(),
        |passage| passage.segments[0].modes.clear(),
    ];
    assert_eq!(noted(&forge(|_| ()), TIMES).1, plain);
    for change in changes {
        assert_eq!(noted(&forge(change), TIMES).1, plain);
    }
}
