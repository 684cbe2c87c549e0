//! Differences between values on both sides of a place, or on the one that has any.

/// The ends of a difference: places beside one with what is known there, or from there on where one side has nothing, as beyond
/// the bound of a parameter.
///
/// # Errors
/// That of the last place, if neither side has anything.
pub(crate) fn ends<T, E>(
    here: (f64, T),
    beside: [(f64, Result<T, E>); 2],
) -> Result<[(f64, T); 2], E> {
    match beside {
        [(_, Err(_)), (x, Ok(value))] | [(x, Ok(value)), (_, Err(_))] => Ok([here, (x, value)]),
        [(a, low), (b, high)] => Ok([(a, low?), (b, high?)]),
    }
}

#[cfg(test)]
mod tests {
    use super::ends;

    #[test]
    fn a_bound_leaves_one_side() {
        let at = |x: f64| (x, if x >= 0.0 { Ok(2.0 * x) } else { Err(()) });
        let slope = |x: f64| {
            let [(a, low), (b, high)] = ends((x, 2.0 * x), [at(x - 0.1), at(x + 0.1)]).unwrap();
            (high - low) / (b - a)
        };
        assert!((slope(0.0) - 2.0).abs() < 1e-12 && (slope(1.0) - 2.0).abs() < 1e-12);
        assert!(ends((-1.0, 0.0), [at(-1.1), at(-0.9)]).is_err());
    }
}
