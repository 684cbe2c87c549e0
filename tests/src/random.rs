//! Random numbers that are the same on every machine and in every run.

/// A sequence of random numbers: SplitMix64.
#[derive(Debug, Clone)]
pub struct Random(u64);

impl Random {
    /// The sequence of this seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// Uniform in [0, 1).
    pub fn unit(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64
    }

    /// Uniform between two numbers.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Uniform between -limit and limit.
    pub fn real(&mut self, limit: f64) -> f64 {
        limit * (2.0 * self.unit() - 1.0)
    }

    /// Uniform in the logarithm.
    pub fn positive(&mut self, low: f64, high: f64) -> f64 {
        low * (high / low).powf(self.unit())
    }

    /// Uniform in the logarithm of its magnitude, with either sign.
    pub fn signed(&mut self, low: f64, high: f64) -> f64 {
        let magnitude = self.positive(low, high);
        if self.unit() < 0.5 {
            -magnitude
        } else {
            magnitude
        }
    }

    /// Each element from the function.
    pub fn array<const LENGTH: usize>(
        &mut self,
        mut element: impl FnMut(&mut Self) -> f64,
    ) -> [f64; LENGTH] {
        std::array::from_fn(|_| element(self))
    }
}
