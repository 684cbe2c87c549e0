//! Numbers and endings as the report writes them.

use std::time::Duration;

use stickslip::bifurcation::Stability;
use stickslip::field::Work;
use stickslip::shooting::Orbit;

use super::follow::End;

/// `value` with this many decimals, and a true minus sign.
pub(super) fn decimals(value: f64, count: usize) -> String {
    format!("{value:.count$}").replace('-', "−")
}

/// `value` as m × 10ⁿ, m with this many decimals.
pub(super) fn scientific(value: f64, count: usize) -> String {
    let text = format!("{value:.count$e}").replace('-', "−");
    match text.split_once('e') {
        Some((mantissa, exponent)) => format!("{mantissa} × 10^{{{exponent}}}"),
        None => text,
    }
}

/// `value` with this many significant digits.
pub(super) fn significant(value: f64, count: i32) -> String {
    let digits = count - 1 - value.abs().max(1e-300).log10().floor() as i32;
    decimals(value, digits.max(0) as usize)
}

/// Evaluations of the equations, with or without their derivatives.
pub(super) const fn evaluations(work: &Work) -> u64 {
    work.evaluations + work.linearisations
}

/// The power of ten nearest to a size.
pub(super) fn exponent(size: f64) -> i32 {
    size.log10().round() as i32
}

/// 10 to this power.
pub(super) fn power(exponent: i32) -> String {
    if exponent == 0 {
        "1".to_owned()
    } else {
        format!("10^{{{exponent}}}").replace('-', "−")
    }
}

/// A duration in the unit that suits it.
pub(super) fn duration(time: Duration) -> String {
    let seconds = time.as_secs_f64();
    if seconds >= 1.0 {
        format!("{seconds:.1} s")
    } else if seconds >= 0.01 {
        format!("{:.0} ms", 1e3 * seconds)
    } else if seconds >= 0.001 {
        format!("{:.1} ms", 1e3 * seconds)
    } else {
        format!("{:.0} µs", 1e6 * seconds)
    }
}

/// A count, its thousands set apart by thin spaces.
pub(super) fn count(number: u64) -> String {
    let digits = number.to_string();
    let mut out = String::new();
    for (i, digit) in digits.chars().enumerate() {
        if i > 0 && (digits.len() - i).is_multiple_of(3) {
            out.push('\u{202f}');
        }
        out.push(digit);
    }
    out
}

/// Where a branch along `name` ends, and why.
pub(super) fn ending(end: &End, name: &str) -> String {
    match end {
        End::Reached(r) => format!("{name} = {}: end of the range", short(*r)),
        End::Vanishes(r) => {
            format!("{name} = {}: shrinks to the equilibrium", short(*r))
        }
        End::Folds(r) => format!("{name} = {}: meets an unstable cycle (fold)", short(*r)),
        End::GaveUp(r) => format!("{name} = {}: steps become too small", short(*r)),
    }
}

/// How many orbits are stable, and what the others are.
pub(super) fn stability<'a, const N: usize>(
    orbits: impl Iterator<Item = &'a Orbit<N, ()>>,
) -> String {
    let all: Vec<Stability> = orbits.map(|orbit| orbit.floquet.stability).collect();
    let of = |kind| all.iter().filter(|stability| **stability == kind).count();
    let stable = of(Stability::Stable);
    if stable == all.len() {
        return format!("all {stable} orbits stable");
    }
    let others = [
        (of(Stability::Undecided), "undecided"),
        (of(Stability::Unstable), "unstable"),
    ];
    let others = others.iter().filter(|(number, _)| *number > 0);
    others.fold(format!("{stable} stable"), |text, (number, word)| {
        format!("{text}, {number} {word}")
    })
}

/// `value` with five significant digits at most.
pub(super) fn short(value: f64) -> String {
    let digits = (4 - value.abs().max(1e-300).log10().floor() as i32).max(0) as usize;
    let text = decimals(value, digits);
    if text.contains('.') {
        text.trim_end_matches('0').trim_end_matches('.').to_owned()
    } else {
        text
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_read_well() {
        assert_eq!(decimals(-0.5, 2), "−0.50");
        assert_eq!(scientific(8.597e-4, 3), "8.597 × 10^{−4}");
        assert_eq!(significant(0.0861, 2), "0.086");
        assert_eq!(significant(11.02, 2), "11");
        assert_eq!(power(-3), "10^{−3}");
        assert_eq!(count(1_234_567), "1\u{202f}234\u{202f}567");
        assert_eq!(short(0.001_463_077), "0.0014631");
        assert_eq!(short(15.0), "15");
    }
}
