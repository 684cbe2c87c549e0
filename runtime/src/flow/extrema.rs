//! Extrema of the states along one step: found by the signs of f, polished on the step map.

use super::Extremum;
use crate::field::Linear;
use crate::integrate::Look;

const ITERATIONS: usize = 12;

/// Appends the extrema of every state inside a step of length `length` from `time`.
///
/// `probe` is the step map: state and field at a fraction of the step.
pub(crate) fn extrema<const N: usize>(
    looks: impl Iterator<Item = Look<N>> + Clone,
    time: f64,
    length: f64,
    found: &mut Vec<Extremum<N>>,
    mut probe: impl FnMut(f64) -> Option<([f64; N], Linear<N>)>,
) {
    let already = found.len();
    for index in 0..N {
        let mut last: Option<(Look<N>, f64)> = None;
        for look in looks.clone() {
            let sign = look.sign(index);
            if sign == 0.0 {
                continue;
            }
            if let Some((before, old)) = last
                && old != sign
            {
                let (theta, state) = polish(index, &before, &look, length, &mut probe);
                found.push(Extremum {
                    index,
                    maximum: old > 0.0,
                    time: time + theta * length,
                    state,
                });
            }
            last = Some((look, sign));
        }
    }
    in_time(&mut found[already..]);
}

/// Puts extrema in the order of time. They nearly are: a sort for any list would be compiled for each order N.
pub(crate) fn in_time<const N: usize>(found: &mut [Extremum<N>]) {
    for next in 1..found.len() {
        let earlier = found[..next].iter().rev();
        let later = earlier.take_while(|e| e.time.total_cmp(&found[next].time).is_gt());
        let steps = later.count();
        found[next - steps..=next].rotate_right(1);
    }
}

/// Safeguarded Newton for fⱼ = 0 between two looks of opposite sign.
fn polish<const N: usize>(
    j: usize,
    low: &Look<N>,
    high: &Look<N>,
    length: f64,
    probe: &mut impl FnMut(f64) -> Option<([f64; N], Linear<N>)>,
) -> (f64, [f64; N]) {
    let (mut a, mut b) = ((low.theta, low.linear.f[j]), (high.theta, high.linear.f[j]));
    let mut theta = a.0 - a.1 * (b.0 - a.0) / (b.1 - a.1);
    let mut best = (theta, low.state);
    for _ in 0..ITERATIONS {
        let Some((state, linear)) = probe(theta) else {
            break;
        };
        best = (theta, state);
        let slope = linear.f[j];
        if slope * a.1 > 0.0 {
            a = (theta, slope)
        } else {
            b = (theta, slope)
        }
        let bend: f64 = (0..N).map(|k| linear.jacobian[j][k] * linear.f[k]).sum();
        let newton = -slope / (bend * length);
        // The value is stationary here: what a further move would change.
        if !(0.5 * slope * newton * length).is_normal()
            || (0.5 * slope * newton * length).abs() <= 1e-15 * state[j].abs()
        {
            break;
        }
        let inside = (a.0.min(b.0), a.0.max(b.0));
        theta += newton;
        if !(theta > inside.0 && theta < inside.1) {
            theta = 0.5 * (inside.0 + inside.1);
        }
    }
    best
}
