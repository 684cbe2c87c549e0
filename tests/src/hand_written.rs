//! The reference systems written by hand in plain `f64`: f, its Jacobian and its derivatives with respect to
//! every parameter, with the tangents of the thesis's appendix B.
//!
//! States and parameters stand in the order in which the models declare them. Friction is smoothed as in the
//! thesis: (3.6) on the belts, (4.7) at the bit. Tests compare with generated derivatives, benchmarks with
//! their cost.

use std::f64::consts::PI;

/// A right-hand side and its derivatives at one state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Linearised<const N: usize, const P: usize> {
    /// f.
    pub f: [f64; N],
    /// ∂fᵢ/∂xⱼ in row i and column j.
    pub jacobian: [[f64; N]; N],
    /// ∂f/∂p for each parameter p.
    pub by_parameter: [[f64; N]; P],
}

impl<const N: usize, const P: usize> Linearised<N, P> {
    /// Applies a function to every number.
    #[must_use]
    pub fn map(self, function: impl Fn(f64) -> f64 + Copy) -> Self {
        Self {
            f: self.f.map(function),
            jacobian: self.jacobian.map(|row| row.map(function)),
            by_parameter: self.by_parameter.map(|column| column.map(function)),
        }
    }
}

/// The Van der Pol equation (3.1): states x, v; parameter nu.
#[inline]
#[must_use]
pub fn van_der_pol([nu]: [f64; 1], [x, v]: [f64; 2]) -> Linearised<2, 1> {
    let damping = x * x - 1.0;
    Linearised {
        f: [v, -nu * damping * v - x],
        jacobian: [[0.0, 1.0], [-2.0 * nu * x * v - 1.0, -nu * damping]],
        by_parameter: [[0.0, -damping * v]],
    }
}

/// The friction force of a belt on a mass, smoothed by (3.6), and its derivatives.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BeltForce {
    /// The force itself: -TFORCE of appendix B.
    pub force: f64,
    /// Its derivative with respect to the relative speed: -SPDAMP of appendix B.
    pub by_speed: f64,
    /// Its derivative with respect to the largest static force.
    pub by_limit: f64,
    /// Its derivative with respect to the rate of weakening.
    pub by_decay: f64,
}

/// The force at the relative speed `speed`, where `eps` is the size of the smoothing (ndsptr.f).
#[inline]
#[must_use]
pub fn belt_force(limit: f64, decay: f64, eps: f64, speed: f64) -> BeltForce {
    let sign = 1.0f64.copysign(speed);
    let weakening = 1.0 / (1.0 + decay * speed.abs());
    let switch = 2.0 / PI * (eps * speed).atan();
    let switch_rate = 2.0 / PI * eps / (1.0 + (eps * speed) * (eps * speed));
    let unit_force = switch * weakening;
    let unit_damping = switch_rate * weakening - decay * switch * sign * weakening * weakening;
    BeltForce {
        force: -limit * unit_force,
        by_speed: -limit * unit_damping,
        by_limit: -unit_force,
        by_decay: limit * switch * speed.abs() * weakening * weakening,
    }
}

/// One mass on a belt, section 3.2: states x, v; parameters m, k, v_dr, F_s, delta.
#[inline]
#[must_use]
pub fn belt_oscillator(
    [m, k, v_dr, limit, delta]: [f64; 5],
    eps: f64,
    [x, v]: [f64; 2],
) -> Linearised<2, 5> {
    let friction = belt_force(limit, delta, eps, v - v_dr);
    let acceleration = (friction.force - k * x) / m;
    Linearised {
        f: [v, acceleration],
        jacobian: [[0.0, 1.0], [-k / m, friction.by_speed / m]],
        by_parameter: [
            [0.0, -acceleration / m],
            [0.0, -x / m],
            [0.0, -friction.by_speed / m],
            [0.0, friction.by_limit / m],
            [0.0, friction.by_decay / m],
        ],
    }
}

/// Two masses on one belt (3.10): states x1, v1, x2, v2; parameters alpha, beta, gamma, v_dr.
#[inline]
#[must_use]
pub fn belt_pair(
    [alpha, beta, gamma, v_dr]: [f64; 4],
    eps: f64,
    [x1, v1, x2, v2]: [f64; 4],
) -> Linearised<4, 4> {
    let first = belt_force(1.0, gamma, eps, v1 - v_dr);
    let second = belt_force(beta, gamma, eps, v2 - v_dr);
    let stretch = x1 - x2;
    let coupling = alpha * stretch;
    Linearised {
        f: [
            v1,
            -x1 - coupling + first.force,
            v2,
            -x2 + coupling + second.force,
        ],
        jacobian: [
            [0.0, 1.0, 0.0, 0.0],
            [-1.0 - alpha, first.by_speed, alpha, 0.0],
            [0.0, 0.0, 0.0, 1.0],
            [alpha, 0.0, -1.0 - alpha, second.by_speed],
        ],
        by_parameter: [
            [0.0, -stretch, 0.0, stretch],
            [0.0, 0.0, 0.0, second.by_limit],
            [0.0, first.by_decay, 0.0, second.by_decay],
            [0.0, -first.by_speed, 0.0, -second.by_speed],
        ],
    }
}

/// A drill string (4.6) with the quartic (4.7) of width `eps`: states psi, omega; parameters eta, theta,
/// kinetic, zeta (ndspro.f).
#[inline]
#[must_use]
pub fn drill_string(
    [eta, theta, _kinetic, zeta]: [f64; 4],
    eps: f64,
    [psi, omega]: [f64; 2],
) -> Linearised<2, 4> {
    let slower = omega - eta;
    let above = slower + 4.0 * eps;
    let (mut bump, mut bump_rate) = (0.0, 0.0);
    if above > 0.0 {
        let scale = 27.0 * (eps * eps) * (eps * eps);
        bump = slower * (above * above * above) / scale;
        bump_rate = 4.0 * (slower + eps) * (above * above) / scale;
    }
    Linearised {
        f: [omega, -2.0 * zeta * omega - psi - theta * bump],
        jacobian: [[0.0, 1.0], [-1.0, -2.0 * zeta - theta * bump_rate]],
        by_parameter: [
            [0.0, theta * bump_rate],
            [0.0, -bump],
            [0.0, 0.0],
            [0.0, -2.0 * omega],
        ],
    }
}
