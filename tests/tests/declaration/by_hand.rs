//! The models of the compile-time benchmark: declared and written by hand they are one.

#[allow(dead_code, missing_docs, non_snake_case, unreachable_pub)]
mod hand {
    include!("../../benches/compile/hand.rs");
    include!("../../benches/compile/use.rs");
}

#[allow(dead_code, unreachable_pub)]
mod declared {
    include!("../../benches/compile/declared.rs");
    include!("../../benches/compile/use.rs");
}

#[test]
fn the_benchmarked_models_are_one() {
    for state in [[1.0, 0.1], [0.5, 0.2], [-3.0, 4.0]] {
        let (declared, hand) = (declared::evaluated(state), hand::evaluated(state));
        assert_eq!(declared.0, hand.0);
        let slopes = [declared.1, hand.1].map(|at| (at.jacobian, at.design));
        let [by_macro, by_hand] = slopes.map(|(jacobian, design)| {
            let entries = jacobian.as_flattened().iter().chain(&design);
            entries.copied().collect::<Vec<f64>>()
        });
        for (a, b) in by_macro.iter().zip(&by_hand) {
            assert!((a - b).abs() <= 1e-14 * b.abs(), "{by_macro:?} {by_hand:?}");
        }
    }
}
