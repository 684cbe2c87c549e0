//! The slow manifold on which a smooth copy creeps where the exact contact sticks (theory 7.1).

use num_dual::Dual64;

use crate::field::{Kernel, Smoothing};

/// z with φ(z) = `share` of a sign type, for |share| < 1; u ≤ 1 with u (4 − u)³/27 = `share` of a bump, for share ≤ 1.
pub(super) fn inverse(kernel: Kernel, share: f64) -> f64 {
    match kernel {
        Kernel::Arctan => (std::f64::consts::FRAC_PI_2 * share).tan(),
        Kernel::Tanh => share.atanh(),
        Kernel::Algebraic => share / (1.0 - share * share).sqrt(),
        Kernel::Cubic | Kernel::Quintic => root(share, (-1.0, 1.0), |z| kernel.sign(z)),
        Kernel::Quartic => root(share.min(1.0), (-1.0, 1.0), |u| bump(Dual64::from(u)).re),
    }
}

/// u (4 − u)³/27: the share of the static peak at the scaled speed u.
fn bump(u: Dual64) -> Dual64 {
    let rest = -u + 4.0;
    u * rest * rest * rest / 27.0
}

/// The root of a rising function by bisection.
fn root(value: f64, (mut low, mut high): (f64, f64), f: impl Fn(f64) -> f64) -> f64 {
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        *(if f(middle) < value {
            &mut low
        } else {
            &mut high
        }) = middle;
    }
    0.5 * (low + high)
}

/// Beyond this the copy's force is the exact one, in units of the layer; ∞ where it only tends to it.
pub(super) fn edge(kernel: Kernel) -> Option<f64> {
    match kernel {
        Kernel::Cubic | Kernel::Quintic => Some(1.0),
        Kernel::Quartic => Some(4.0),
        Kernel::Arctan | Kernel::Tanh | Kernel::Algebraic => None,
    }
}

/// The speed with which the copy creeps under the sticking force `force`: −φ⁻¹(λ/stick)/ε, at most `cap` in units of
/// the layer.
pub(super) fn creep(smoothing: &Smoothing, force: f64, stick: f64, slip: f64, cap: f64) -> f64 {
    let kernel = smoothing.kernel;
    let z = if kernel.is_bump() {
        inverse(kernel, (-force - slip) / (stick - slip))
    } else {
        -inverse(kernel, (force / stick).clamp(-1.0, 1.0))
    };
    z.clamp(-cap, cap) / smoothing.sharpness()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn inverses_undo_the_kernels() {
        for kernel in Kernel::ALL {
            for share in [-0.7, -0.2, 0.3, 0.9] {
                let z = inverse(kernel, share);
                let back = if kernel.is_bump() {
                    bump(Dual64::from(z)).re
                } else {
                    kernel.sign(z)
                };
                assert!((back - share).abs() < 1e-12, "{kernel} {share} {back}");
            }
        }
    }
}
