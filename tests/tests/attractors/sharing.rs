//! What is found depends neither on threads, nor on shares, nor on their order.

use std::collections::BTreeMap;
use std::ops::ControlFlow;

use stickslip::field::Design;
use stickslip::study::{
    Along, AttractorsRecord, Case, Dynamics, Fate, Item, List, Sampling, Share, System,
};

use crate::models::FrictionOscillator;
use crate::shares::region;

const STARTS: usize = 200;
const VALUES: usize = 3;

fn found(list: &List<Fate>) -> (AttractorsRecord, BTreeMap<usize, Fate>) {
    let system = System::of::<FrictionOscillator, _>();
    let design = Design::Parameter(FrictionOscillator::v_d.index);
    let case = Case {
        along: Some(Along {
            design,
            from: 1.1,
            to: 1.5,
        }),
        ..Case::declared(system.info(), Dynamics::Exact)
    };
    let region = region(system.info(), &[("x", -2.0, 2.0), ("v", 0.0, 2.0)]);
    let sampling = Sampling {
        values: VALUES,
        ..Sampling::of(region, STARTS)
    };
    let seen = std::sync::Mutex::new(BTreeMap::new());
    let watch = |item: Item<'_, Fate>| {
        seen.lock().unwrap().insert(item.number, item.found.clone());
        ControlFlow::Continue(())
    };
    let record = system
        .attractors_watched(&case, &sampling, list, &watch)
        .unwrap();
    (record, seen.into_inner().unwrap())
}

#[test]
fn shares_add_up_to_the_whole() {
    let list = List {
        threads: Some(2),
        ..List::default()
    };
    let (whole, items) = found(&list);
    let mut known = BTreeMap::new();
    for number in [4, 2, 1, 3] {
        let share = Share::new(number, 4).unwrap();
        known.extend(
            found(&List {
                share,
                threads: Some(1),
                ..list.clone()
            })
            .1,
        );
    }
    assert_eq!(known, items);
    let (merged, _) = found(&List {
        known,
        closed: true,
        ..list
    });
    assert_eq!(merged, whole);
}
