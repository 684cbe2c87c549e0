//! A search says on what it is working.

use std::sync::{Arc, Mutex};

use stickslip::study::{Case, Dynamics};
use stickslip_models::systems;

#[test]
fn a_search_names_its_starts() {
    let heard = Arc::new(Mutex::new(Vec::new()));
    let kept: Arc<Mutex<Vec<String>>> = heard.clone();
    let system = systems::belt_pair();
    let telling = system.telling(Arc::new(move |words: &str| {
        kept.lock().unwrap().push(words.to_owned());
    }));
    let mut case = Case::declared(system.info(), Dynamics::Exact);
    assert_eq!(telling.orbit(&case), system.orbit(&case));
    assert!(heard.lock().unwrap()[0].contains("(1 of "));
    case.start = Some(vec![0.5, 0.0, 0.1, 0.0]);
    case.period = Some(11.0);
    let _ = telling.orbit(&case);
    let last = heard.lock().unwrap().last().cloned().unwrap();
    assert!(
        last.contains("x1 = 0.5") && last.contains("the period 11"),
        "{last}"
    );
}
