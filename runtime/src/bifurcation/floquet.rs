//! Multipliers of a periodic orbit, from its section map.

use nalgebra::{Complex, DMatrix, DVector};

use super::Kind;
use super::exponents::exponents;
use super::growth::{Growth, Growths};
use super::liouville::{Told, agree};
use super::stability::Stability;
use crate::flow::Determinant;
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
    /// What each multiplier may be off by.
    errors: Vec<f64>,
}

impl Floquet {
    /// max |μ|: what a disturbance grows to in one period.
    pub(crate) fn growth(&self) -> f64 {
        let sizes = self.multipliers.iter().map(|one| one.norm());
        sizes.fold(0.0, f64::max)
    }

    /// The multipliers but for those of which nothing is known: beside a large one Φ does not resolve them, and nothing else
    /// tells them, so that their digits are noise.
    pub(super) fn known(&self) -> Vec<Complex<f64>> {
        let all = self
            .multipliers
            .iter()
            .zip(&self.log_moduli)
            .zip(&self.errors);
        let known = all.filter(|((_, log), error)| log.is_some() || **error < 1.0);
        known.map(|((mu, _), _)| *mu).collect()
    }

    /// Whether a multiplier is 1 as far as its error tells.
    pub(crate) fn may_be_one(&self) -> bool {
        let mut all = self.multipliers.iter().zip(&self.errors);
        all.any(|(mu, error)| (mu - 1.0).norm() <= *error)
    }

    /// min |1 − μ|, at most 1: the share of a disturbance along the section that is gone after one period.
    pub(crate) fn pull(&self) -> f64 {
        let shares = self.multipliers.iter().map(|one| (one - 1.0).norm());
        shares.fold(1.0, f64::min).max(f64::EPSILON)
    }
}

/// Judges an orbit from its monodromy matrix `monodromy`, the velocity `velocity` at its start,
/// det Φ where it is known apart from Φ (`determinant`), the number of multipliers that are zero
/// because contacts stick, and the relative accuracy of Φ. `factors` of Φ, where given, tell apart what
/// underflows in their product. As many multipliers as directions are `neutral`, those nearest to 1, are left out.
#[must_use]
pub fn floquet(
    monodromy: &DMatrix<f64>,
    velocity: &DVector<f64>,
    determinant: Option<Determinant>,
    zeros: usize,
    factors: &[Factor],
    neutral: usize,
    accuracy: f64,
) -> Floquet {
    let trivial_error = (monodromy * velocity - velocity).norm() / velocity.norm();
    let section = section_map(monodromy, velocity);
    let size = section.amax();
    // What Φ makes of the velocity it is off by, too.
    let off = MARGIN * trivial_error.max(accuracy * size.max(1.0));
    let mut all = eigenvalues(&section);
    let order = |a: &Eigenvalue, b: &Eigenvalue| {
        let (a, b) = (a.value, b.value);
        b.norm().total_cmp(&a.norm()).then(b.im.total_cmp(&a.im))
    };
    let aside = |one: &Eigenvalue| (one.value - 1.0).norm();
    all.sort_by(|a, b| aside(a).total_cmp(&aside(b)));
    all.drain(..neutral.min(all.len()));
    all.sort_by(order);
    let floor = trivial_error.max(RESOLVED * size.max(f64::MIN_POSITIVE));
    let mut told = told(&all, floor, off);
    let flat = determinant.is_some_and(Determinant::is_zero);
    let zeros = zeros.max(usize::from(flat)).min(told.len());
    let live = told.len() - zeros;
    told[live..].fill(Told::ZERO);
    if let (0, Some(determinant)) = (zeros, determinant) {
        let exponents = || exponents(factors, 1 + neutral);
        agree(&mut told, (determinant, MARGIN * accuracy), exponents);
    }
    let growths = Growths::new(told.iter().map(Told::growth).collect());
    Floquet {
        multipliers: told.iter().map(|one| one.value).collect(),
        log_moduli: told.iter().map(|one| one.log).collect(),
        trivial_error,
        stability: growths.stability(),
        unstable: growths.growing(),
        growths,
        errors: told.iter().map(|one| one.error).collect(),
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

/// What a Φ that is off by as much tells of multipliers, those up to `floor` not resolved.
fn told(all: &[Eigenvalue], floor: f64, off: f64) -> Vec<Told> {
    let mut told: Vec<Told> = Vec::with_capacity(all.len());
    for one in all {
        let size = one.value.norm();
        // A conjugate pair stays one.
        let pair = told.last().filter(|other| other.value == one.value.conj());
        told.push(Told {
            value: one.value,
            log: (size > floor).then(|| size.ln()),
            loose: pair.map_or(one.condition / size, |other| other.loose),
            error: one.moved(off),
        });
    }
    told
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
            Some(Determinant::grown(-29_000.0)),
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
