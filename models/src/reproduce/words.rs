//! Endings, stability and values as the report writes them.

use stickslip::bifurcation::Stability;
use stickslip::field::Work;
use stickslip::study::OrbitRecord;

pub(super) use stickslip::report::numerals::{
    count, decimals, duration, power, scientific, significant,
};

/// Evaluations of the equations, with or without their derivatives.
pub(super) const fn evaluations(work: &Work) -> u64 {
    work.evaluations + work.linearisations
}

/// The power of ten nearest to a size.
pub(super) fn exponent(size: f64) -> i32 {
    size.log10().round() as i32
}

/// How many orbits are stable, and what the others are.
pub(super) fn stability<'a>(orbits: impl IntoIterator<Item = &'a OrbitRecord>) -> String {
    let orbits = orbits.into_iter();
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
