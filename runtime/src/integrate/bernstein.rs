//! Polynomials inside a step, in Bernstein form.

use std::sync::LazyLock;

/// Highest degree: that of the dense output.
pub(super) const DEGREE: usize = 7;

/// A polynomial on [0, 1] in Bernstein form: Σ βⱼ C(d,j) θʲ (1−θ)ᵈ⁻ʲ.
///
/// It lies in the convex hull of its coefficients, so that coefficients of one sign exclude a root.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Bernstein {
    pub(super) coefficients: [f64; DEGREE + 1],
    pub(super) degree: usize,
}

impl Bernstein {
    /// Nodes on [0, 1] from whose values [`Bernstein::interpolate`] builds a polynomial (Chebyshev-Lobatto).
    #[must_use]
    pub fn nodes() -> [f64; DEGREE + 1] {
        crate::scalar::filled(|i| {
            let half = 0.5 * std::f64::consts::PI * i as f64 / DEGREE as f64;
            half.sin().powi(2)
        })
    }

    /// From its coefficients; at most eight are taken.
    #[must_use]
    pub fn new(coefficients: &[f64]) -> Self {
        let mut all = [0.0; DEGREE + 1];
        for (place, c) in all.iter_mut().zip(coefficients) {
            *place = *c;
        }
        let degree = coefficients.len().clamp(1, DEGREE + 1) - 1;
        Self {
            coefficients: all,
            degree,
        }
    }

    /// From the nested form of the dense output, whose term k multiplies θ^(k/2+1) (1−θ)^((k+1)/2).
    pub(super) fn from_nested(value: f64, terms: [f64; DEGREE]) -> Self {
        let mut coefficients = [value; DEGREE + 1];
        for (term, nested) in terms.iter().zip(&NESTED) {
            for (c, weight) in coefficients.iter_mut().zip(nested) {
                *c += term * weight;
            }
        }
        Self {
            coefficients,
            degree: DEGREE,
        }
    }

    /// The polynomial of degree 7 with these values at [`Bernstein::nodes`].
    #[must_use]
    pub fn interpolate(values: &[f64; DEGREE + 1]) -> Self {
        let mut coefficients = [0.0; DEGREE + 1];
        for (value, cardinal) in values.iter().zip(&*CARDINAL) {
            for (c, weight) in coefficients.iter_mut().zip(cardinal) {
                *c += value * weight;
            }
        }
        Self {
            coefficients,
            degree: DEGREE,
        }
    }

    /// The polynomial that is 1 at the node of this index and 0 at the others.
    fn cardinal(index: usize) -> Self {
        let nodes = Self::nodes();
        let others = || (0..=DEGREE).filter(|&k| k != index).map(|k| nodes[k]);
        let scale: f64 = others().map(|node| nodes[index] - node).product();
        others().fold(Self::new(&[1.0 / scale]), |product, node| {
            product.times_linear(node)
        })
    }

    /// p (θ − root).
    fn times_linear(&self, root: f64) -> Self {
        let degree = self.degree + 1;
        let mut coefficients = [0.0; DEGREE + 1];
        for j in 0..=self.degree {
            let (up, down) = ((j + 1) as f64, (degree - j) as f64);
            let c = self.coefficients[j] / degree as f64;
            coefficients[j] -= c * down * root;
            coefficients[j + 1] += c * up * (1.0 - root);
        }
        Self {
            coefficients,
            degree,
        }
    }

    /// The coefficients.
    #[must_use]
    pub fn coefficients(&self) -> &[f64] {
        &self.coefficients[..=self.degree]
    }

    /// The value at θ.
    #[must_use]
    pub fn value(&self, theta: f64) -> f64 {
        self.value_and_slope(theta).0
    }

    pub(super) fn value_and_slope(&self, theta: f64) -> (f64, f64) {
        let mut c = self.coefficients;
        let mut slope = 0.0;
        for level in (1..=self.degree).rev() {
            if level == 1 {
                slope = self.degree as f64 * (c[1] - c[0]);
            }
            for j in 0..level {
                c[j] += theta * (c[j + 1] - c[j]);
            }
        }
        (c[0], slope)
    }

    /// The derivative with respect to θ.
    #[must_use]
    pub fn derivative(&self) -> Self {
        let mut slope = Self::new(&[0.0; DEGREE + 1]);
        slope.degree = self.degree.saturating_sub(1);
        for j in 0..self.degree {
            slope.coefficients[j] =
                self.degree as f64 * (self.coefficients[j + 1] - self.coefficients[j]);
        }
        slope
    }

    /// More often than this it does not turn (Descartes' rule for its slope); slopes of at most this size are none.
    #[must_use]
    pub fn most_turns(&self, noise: f64) -> usize {
        let (mut last, mut turns) = (0.0, 0);
        for pair in self.coefficients().windows(2) {
            let slope = self.degree as f64 * (pair[1] - pair[0]);
            if slope.abs() > noise {
                turns += usize::from(last * slope < 0.0);
                last = slope;
            }
        }
        turns
    }

    /// How far the parabola that fits at θ, where p falls, goes on to fall: p'²/2p''; infinite if p'' ≤ 0.
    #[must_use]
    pub fn depth(&self, theta: f64) -> f64 {
        let (slope, bend) = self.derivative().value_and_slope(theta);
        if bend > 0.0 {
            0.5 * slope * slope / bend
        } else {
            f64::INFINITY
        }
    }

    /// p(θ)/θⁿ, its lowest n coefficients taken for zero: they vanish where a motion departs from a surface.
    #[must_use]
    pub fn deflated(&self, order: usize) -> Self {
        let mut p = *self;
        for _ in 0..order.min(self.degree) {
            let degree = p.degree;
            for j in 1..=degree {
                p.coefficients[j - 1] = p.coefficients[j] * degree as f64 / j as f64;
            }
            p.coefficients[degree] = 0.0;
            p.degree = degree - 1;
        }
        p
    }

    /// The polynomial p + by.
    #[must_use]
    pub fn raised(&self, by: f64) -> Self {
        let mut raised = *self;
        for c in &mut raised.coefficients[..=self.degree] {
            *c += by;
        }
        raised
    }

    /// The sum with another one of the same degree.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        let pairs = self.coefficients.iter().zip(&other.coefficients);
        let mut sum = *self;
        for (c, (a, b)) in sum.coefficients.iter_mut().zip(pairs) {
            *c = a + b;
        }
        sum
    }

    /// The polynomial −p.
    #[must_use]
    pub fn negated(&self) -> Self {
        let coefficients = self.coefficients.map(|c| -c);
        Self {
            coefficients,
            degree: self.degree,
        }
    }

    /// The polynomial with coefficients of at most this size, which are rounding errors, set to zero.
    #[must_use]
    pub fn without_noise(&self, size: f64) -> Self {
        let coefficients = self
            .coefficients
            .map(|c| if c.abs() <= size { 0.0 } else { c });
        Self {
            coefficients,
            degree: self.degree,
        }
    }

    /// A lower bound of the polynomial on [0, 1].
    #[must_use]
    pub fn lower_bound(&self) -> f64 {
        let lower = |least: f64, c: &f64| if *c < least { *c } else { least };
        self.coefficients().iter().fold(f64::INFINITY, lower)
    }

    /// An upper bound of |p| on [0, 1].
    #[must_use]
    pub fn magnitude(&self) -> f64 {
        // Of all places, as beyond the degree there are zeros: a loop of known length.
        let higher = |most: f64, c: &f64| if c.abs() > most { c.abs() } else { most };
        self.coefficients.iter().fold(0.0, higher)
    }
}

/// Bernstein coefficients of the basis of the dense output.
const NESTED: [[f64; DEGREE + 1]; DEGREE] = nested();

/// Bernstein coefficients of the polynomials that are 1 at one node and 0 at the others.
static CARDINAL: LazyLock<[[f64; DEGREE + 1]; DEGREE + 1]> =
    LazyLock::new(|| crate::scalar::filled(|i| Bernstein::cardinal(i).coefficients));

const fn nested() -> [[f64; DEGREE + 1]; DEGREE] {
    let mut all = [[0.0; DEGREE + 1]; DEGREE];
    let mut k = 0;
    while k < DEGREE {
        let (a, b) = (k / 2 + 1, k.div_ceil(2));
        let spare = DEGREE - a - b;
        let mut j = 0;
        while j <= spare {
            all[k][a + j] = binomial(spare, j) / binomial(DEGREE, a + j);
            j += 1;
        }
        k += 1;
    }
    all
}

/// C(n, k) for the small n at hand.
const fn binomial(n: usize, k: usize) -> f64 {
    let (mut c, mut i) = (1.0, 0);
    while i < k {
        c *= (n - i) as f64 / (i + 1) as f64;
        i += 1;
    }
    c
}
