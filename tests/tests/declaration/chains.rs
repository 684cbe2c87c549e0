//! Models declared over an index: the equations that they stand for, and work that follows the band.

use stickslip::field::{Design, Field, SmoothField, Smoothing};
use stickslip::flow::exact::ExactFlow;
use stickslip::flow::{Flow, SmoothFlow, Want};
use stickslip::integrate::Tolerance;
use stickslip::model::Model;
use stickslip_tests::chain::{Chain10, Chain20, Chain100, by_hand};
use stickslip_tests::random::Random;

const SIZE: f64 = 50.0;

fn field<M: Model<N>, const N: usize>(model: &M, design: usize) -> SmoothField<M, N> {
    let smoothing: Smoothing = "arctan:50".parse().expect("a smoothing");
    SmoothField::new(model, Some(smoothing), Design::Parameter(design)).expect("a good smoothing")
}

fn agrees_with_hand<M: Model<N>, const N: usize>(model: &M) {
    let mut random = Random::new(3);
    let field = field(model, 1);
    let parameters = std::array::from_fn(|p| model.values().as_ref()[p]);
    for _ in 0..20 {
        let state: [f64; N] = random.array(|random| random.real(1.0));
        let (mut found, mut expected) = (Vec::new(), Vec::new());
        let rates = field.entries(&state, |i, j, slope| found.push((i, j, slope)));
        let (f, design) = by_hand(parameters, SIZE, &state, |i, j, slope| {
            expected.push((i, j, slope));
        });
        found.sort_by_key(|entry| (entry.0, entry.1));
        expected.sort_by_key(|entry| (entry.0, entry.1));
        assert_eq!(found.len(), expected.len());
        for (a, b) in found.iter().zip(&expected) {
            assert_eq!((a.0, a.1), (b.0, b.1));
            assert!((a.2 - b.2).abs() < 1e-12 * (1.0 + b.2.abs()), "{a:?} {b:?}");
        }
        for i in 0..N {
            assert!((rates.f[i] - f[i]).abs() < 1e-13, "f[{i}]");
            assert!((rates.design[i] - design[i]).abs() < 1e-11, "∂f[{i}]/∂r");
        }
        let whole = field.linearise(&state);
        assert_eq!(whole.f.map(f64::to_bits), rates.f.map(f64::to_bits));
        for (i, j, slope) in found {
            assert_eq!(whole.jacobian[i][j].to_bits(), slope.to_bits());
        }
    }
}

/// What needs more stack than a test has.
fn roomy(work: impl FnOnce() + Send + 'static) {
    let thread = std::thread::Builder::new()
        .stack_size(256 << 20)
        .spawn(work);
    thread.expect("a thread").join().expect("no panic");
}

#[test]
fn equations_over_an_index_are_those_written_by_hand() {
    agrees_with_hand::<Chain10, 20>(&Chain10::default());
    roomy(|| agrees_with_hand::<Chain100, 200>(&Chain100::default()));
}

#[test]
fn equations_read_their_neighbours_only() {
    let read = |row: &[bool; 200]| row.iter().filter(|reads| **reads).count();
    let most = Chain100::SPARSITY.iter().map(read).max();
    assert_eq!(most, Some(4));
    assert_eq!(Chain100::INFO.states[0].name, "x_0");
    assert_eq!(Chain100::INFO.states[199].name, "v_99");
    assert_eq!(Chain100::INFO.contacts.len(), 100);
}

/// Without friction, a chain between walls swings as sin(π (i + 1)/(n + 1)) with ω = 2 √k sin(π/(2 (n + 1))).
#[test]
fn a_chain_without_friction_swings_in_its_modes() {
    let model = Chain10 {
        limit: 0.0,
        ..Chain10::default()
    };
    let angle = std::f64::consts::PI / 11.0;
    let omega = 2.0 * model.k.sqrt() * (0.5 * angle).sin();
    let start: [f64; 20] = std::array::from_fn(|i| {
        if i < 10 {
            (angle * (i + 1) as f64).sin()
        } else {
            0.0
        }
    });
    let flow = SmoothFlow::new(field(&model, 1), Tolerance::for_accuracy(1e-10));
    let place = flow.place(start).expect("a place");
    let period = std::f64::consts::TAU / omega;
    let end = flow
        .advance(&place, period, Want::default())
        .expect("a motion")
        .end;
    for i in 0..20 {
        assert!(
            (end.state[i] - start[i]).abs() < 1e-8,
            "{i}: {}",
            end.state[i]
        );
    }
}

/// Exact friction at twenty contacts, against a smooth copy of it.
#[test]
fn a_chain_moves_with_exact_friction() {
    roomy(|| {
        let model = Chain20::default();
        let start = std::array::from_fn(|i| if i < 20 { 0.1 * (i as f64).sin() } else { 0.0 });
        let exact = ExactFlow::new(&model, None, Tolerance::for_accuracy(1e-8)).expect("a flow");
        let place = exact.place(start).expect("a place");
        let passage = exact
            .advance(&place, 4.0, Want::default())
            .expect("a motion");
        let switches = passage.events.iter().filter(|event| event.kind.is_switch());
        assert!(switches.count() > 20, "most contacts switch");
        let sharp = "tanh:1e5".parse().ok();
        let copy = SmoothField::new(&model, sharp, Design::None).expect("a good smoothing");
        let copy = SmoothFlow::new(copy, Tolerance::for_accuracy(1e-7));
        let place = copy.place(start).expect("a place");
        let end = copy
            .advance(&place, 4.0, Want::default())
            .expect("a motion")
            .end;
        for (a, b) in passage.end.state.iter().zip(end.state) {
            assert!((a - b).abs() < 1e-3, "{a} {b}");
        }
    });
}
