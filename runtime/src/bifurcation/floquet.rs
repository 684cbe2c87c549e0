//! Multipliers of a periodic orbit, from its section map.

use nalgebra::{Complex, DMatrix, DVector};

use super::Kind;
use super::exponents::exponents;
use super::growth::{Growth, Growths};
use super::stability::Stability;
use crate::linear::{Eigenvalue, eigenvalues};
use crate::motion::Factor;

/// Moduli below this share of the largest entry of the section map are not resolved by it.
const RESOLVED: f64 = 1e-9;
/// Errors of the section map that are allowed for.
const MARGIN: f64 = 10.0;

/// Multipliers of the section map: the trivial one is projected out and only measures accuracy.
#[derive(Debug, Clone, PartialEq)]
pub struct Floquet {
    /// The n − 1 multipliers but for those of neutral directions, largest modulus first; 0 where they underflow.
    pub multipliers: Vec<Complex<f64>>,
    /// Natural logarithms of their moduli; `None` for an exact zero, or where they cannot be known.
    pub log_moduli: Vec<Option<f64>>,
    /// ‖Φf − f‖ / ‖f‖: how far the trivial multiplier is from 1.
    pub trivial_error: f64,
    /// The verdict.
    pub stability: Stability,
    /// Number of multipliers outside the unit circle, beyond their errors.
    pub unstable: usize,
    /// Their logarithms with their errors, fastest growth first.
    pub growths: Growths,
}

/// Judges an orbit from its monodromy matrix `monodromy`, the velocity `velocity` at its start,
/// ∫ tr J dt where det Φ follows from it (`trace`), the number of multipliers that are zero
/// because contacts stick, and the relative accuracy of Φ. `factors` of Φ, where given, tell apart what
/// underflows in their product. As many multipliers as directions are `neutral`, those nearest to 1, are left out.
#[must_use]
pub fn floquet(
    monodromy: &DMatrix<f64>,
    velocity: &DVector<f64>,
    trace: Option<f64>,
    zeros: usize,
    factors: &[Factor],
    neutral: usize,
    accuracy: f64,
) -> Floquet {
    let trivial_error = (monodromy * velocity - velocity).norm() / velocity.norm();
    let section = section_map(monodromy, velocity);
    let size = section.amax();
    let uncertainty = MARGIN * accuracy.max(trivial_error) * size.max(1.0);
    let mut all = eigenvalues(&section);
    let order = |a: &Eigenvalue, b: &Eigenvalue| {
        let (a, b) = (a.value, b.value);
        b.norm().total_cmp(&a.norm()).then(b.im.total_cmp(&a.im))
    };
    let aside = |one: &Eigenvalue| (one.value - 1.0).norm();
    all.sort_by(|a, b| aside(a).total_cmp(&aside(b)));
    all.drain(..neutral.min(all.len()));
    all.sort_by(order);
    let errors = all.iter().map(|one| one.error(0.0) + uncertainty);
    let errors: Vec<f64> = errors.collect();
    let mut found: Vec<Complex<f64>> = all.iter().map(|one| one.value).collect();
    let zeros = zeros.min(found.len());
    let live = found.len() - zeros;
    found[live..].fill(Complex::new(0.0, 0.0));
    let floor = RESOLVED.max(trivial_error) * size.max(f64::MIN_POSITIVE);
    let mut logs: Vec<Option<f64>> = found
        .iter()
        .map(|multiplier| (multiplier.norm() > floor).then(|| multiplier.norm().ln()))
        .collect();
    if zeros == 0
        && let Some(trace) = trace
    {
        supplement(&mut found, &mut logs, trace, factors);
    }
    let growth = |(multiplier, error): (&Complex<f64>, &f64)| growth(*multiplier, *error);
    let growths = Growths::new(found.iter().zip(&errors).map(growth).collect());
    Floquet {
        multipliers: found,
        log_moduli: logs,
        trivial_error,
        stability: growths.stability(),
        unstable: growths.growing(),
        growths,
    }
}

impl Floquet {
    /// How many multipliers are outside the unit circle beside those that pass it at a special point of this kind, if this
    /// is one; `None` where that cannot be told.
    #[must_use]
    pub fn growing_beside(&self, kind: Kind) -> Option<usize> {
        let one = Complex::new(1.0, 0.0);
        let all = self.multipliers.iter().filter(|mu| mu.norm() > 0.0);
        let nearest = |off: &dyn Fn(&Complex<f64>) -> f64| {
            let nearest = all.clone().min_by(|a, b| off(a).total_cmp(&off(b)));
            nearest.map(|mu| mu.norm().ln())
        };
        let passing = match kind {
            Kind::Fold | Kind::BranchPoint | Kind::SymmetryBreaking => {
                nearest(&|mu| (mu - one).norm())
            }
            Kind::Flip => nearest(&|mu| (mu + one).norm()),
            Kind::Torus => nearest(&|mu| {
                if mu.im == 0.0 {
                    f64::INFINITY
                } else {
                    mu.norm().ln().abs()
                }
            }),
            _ => None,
        }?;
        let (beside, own): (Vec<&Growth>, Vec<&Growth>) =
            self.growths.iter().partition(|one| one.rate != passing);
        let certain =
            own.len() == kind.jump()? as usize && !beside.iter().any(|one| one.is_marginal());
        certain.then(|| beside.iter().filter(|one| one.rate > 0.0).count())
    }
}

/// ln μ, real where the multiplier is, whatever its sign; its error is to the rate as that of μ to its way to the circle.
fn growth(multiplier: Complex<f64>, error: f64) -> Growth {
    let (size, real) = (multiplier.norm(), multiplier.im == 0.0);
    let turn = if real { 0.0 } else { multiplier.arg() };
    let (rate, way) = (size.ln(), size - 1.0);
    let slope = if way == 0.0 { 1.0 } else { rate / way };
    let error = if size > 0.0 { error * slope } else { 0.0 };
    Growth::new(Complex::new(rate, turn), error)
}

/// DP = Qᵀ Φ Q with Q an orthonormal basis of the complement of f, which is normal to the section.
fn section_map(phi: &DMatrix<f64>, f: &DVector<f64>) -> DMatrix<f64> {
    let n = f.len();
    // Householder's reflection that carries the first axis to f: its other columns span the complement.
    let mut normal = f / f.norm();
    normal[0] += if normal[0] >= 0.0 { 1.0 } else { -1.0 };
    let reflection =
        DMatrix::identity(n, n) - 2.0 / normal.norm_squared() * &normal * normal.transpose();
    let basis = reflection.columns(1, n - 1);
    basis.transpose() * phi * basis
}

/// Liouville: the logarithms of all moduli add up to ∫ tr J. What the product of Φ cannot resolve
/// is told apart by the factors, and their sum made to agree.
fn supplement(
    found: &mut [Complex<f64>],
    logs: &mut [Option<f64>],
    trace: f64,
    factors: &[Factor],
) {
    if found.len() == 1 {
        // One multiplier besides the trivial one: Liouville is exact and never worse.
        logs[0] = Some(trace);
        found[0] = Complex::new(trace.exp(), 0.0);
        return;
    }
    let known = logs.iter().take_while(|log| log.is_some()).count();
    let missing = logs.len() - known;
    let rest = trace - logs.iter().flatten().sum::<f64>();
    let shares = match missing {
        0 => return,
        1 => vec![rest],
        _ if factors.is_empty() => Vec::new(),
        _ => {
            let all = exponents(factors);
            let small = &all[all.len() - missing..];
            let sum: f64 = small.iter().sum();
            small.iter().map(|log| log * rest / sum).collect()
        }
    };
    for (i, multiplier) in found.iter_mut().enumerate().skip(known) {
        logs[i] = shares.get(i - known).copied();
        let size = logs[i].map_or(0.0, f64::exp);
        let signed = if size > 0.0 {
            size.copysign(multiplier.re)
        } else {
            0.0
        };
        *multiplier = Complex::new(signed, 0.0);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_trivial_multiplier_is_projected_out() {
        // Eigenvalues 1 (along f), −0.5 and 2.
        let change =
            DMatrix::from_row_slice(3, 3, &[1.0, 0.3, -0.2, 0.5, 1.0, 0.1, -1.0, 0.4, 2.0]);
        let diagonal = DMatrix::from_diagonal(&DVector::from_vec(vec![1.0, -0.5, 2.0]));
        let phi = &change * diagonal * change.clone().try_inverse().unwrap();
        let velocity = change.column(0).into_owned();
        let verdict = floquet(&phi, &velocity, None, 0, &[], 0, 1e-12);
        assert!((verdict.multipliers[0].re - 2.0).abs() < 1e-13);
        assert!((verdict.multipliers[1].re + 0.5).abs() < 1e-13);
        assert!(verdict.trivial_error < 1e-14);
        assert_eq!(
            (verdict.stability, verdict.unstable),
            (Stability::Unstable, 1)
        );
    }

    #[test]
    fn what_underflows_is_known_by_its_logarithm() {
        let verdict = floquet(
            &DMatrix::from_row_slice(2, 2, &[1.0, 3.0, 0.0, 0.0]),
            &DVector::from_vec(vec![1.0, 0.0]),
            Some(-29_000.0),
            0,
            &[],
            0,
            1e-12,
        );
        assert_eq!(verdict.multipliers[0].norm(), 0.0);
        assert_eq!(verdict.log_moduli, [Some(-29_000.0)]);
        assert_eq!(verdict.stability, Stability::Stable);
    }

    #[test]
    fn what_passes_is_told_from_what_grows_beside_it() {
        let diagonal = |all: [f64; 4]| {
            let phi = DMatrix::from_diagonal(&DVector::from_row_slice(&all));
            let along = DVector::from_vec(vec![1.0, 0.0, 0.0, 0.0]);
            floquet(&phi, &along, None, 0, &[], 0, 1e-12)
        };
        let fold = diagonal([1.0, 1.0 + 1e-6, -3.0, 0.2]);
        assert_eq!(fold.growing_beside(Kind::Fold), Some(1));
        assert_eq!(fold.growing_beside(Kind::GrazingSliding), None);
        let both = diagonal([1.0, 1.0 + 1e-6, -1.0, 0.2]);
        assert_eq!(both.growing_beside(Kind::Fold), None, "another is marginal");
    }

    #[test]
    fn too_close_to_the_circle_is_undecided() {
        let verdict = floquet(
            &DMatrix::from_row_slice(2, 2, &[1.0, 0.0, 0.0, 1.0 + 1e-9]),
            &DVector::from_vec(vec![1.0, 0.0]),
            None,
            0,
            &[],
            0,
            1e-8,
        );
        assert_eq!(verdict.stability, Stability::Undecided);
    }
}
