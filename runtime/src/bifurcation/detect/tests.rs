use nalgebra::Complex;

use super::*;
use crate::bifurcation::{Floquet, Margin};

/// An orbit of which only the multipliers count.
#[derive(Debug, Clone)]
struct Orbit {
    r: f64,
    floquet: Floquet,
}

impl Watched for Orbit {
    fn r(&self) -> f64 {
        self.r
    }

    fn period(&self) -> f64 {
        1.0
    }

    fn slope(&self) -> f64 {
        1.0
    }

    fn floquet(&self) -> &Floquet {
        &self.floquet
    }

    fn same_word(&self, _other: &Self) -> bool {
        true
    }

    fn word_length(&self) -> usize {
        0
    }

    fn asymmetry(&self) -> f64 {
        f64::INFINITY
    }

    fn near_misses(&self) -> Vec<Margin> {
        Vec::new()
    }

    fn close_calls(&self) -> Vec<Margin> {
        Vec::new()
    }
}

/// A branch along r from 0 to 1 with these multipliers; between its ends it can be looked at as far as `known`.
struct Along {
    multipliers: fn(f64) -> [f64; 2],
    known: bool,
}

impl Along {
    fn orbit(&self, r: f64) -> Orbit {
        let multipliers = (self.multipliers)(r);
        let unstable = multipliers.iter().filter(|mu| mu.abs() > 1.0).count();
        Orbit {
            r,
            floquet: Floquet {
                multipliers: multipliers.map(|mu| Complex::new(mu, 0.0)).to_vec(),
                log_moduli: multipliers.map(|mu| Some(mu.abs().ln())).to_vec(),
                trivial_error: 0.0,
                stability: if multipliers.iter().any(|mu| (mu.abs() - 1.0).abs() < 1e-9) {
                    Stability::Undecided
                } else if unstable == 0 {
                    Stability::Stable
                } else {
                    Stability::Unstable
                },
                unstable,
            },
        }
    }

    fn findings(mut self) -> Findings<Orbit> {
        let ends = [0.0, 1.0].map(|r| self.orbit(r));
        detect(&mut self, &ends[0], &ends[1], 1e-9)
    }
}

impl Path for Along {
    type Point = Orbit;
    type Error = &'static str;

    fn at(&mut self, share: f64) -> Result<Orbit, &'static str> {
        self.known
            .then(|| self.orbit(share))
            .ok_or("nobody knows what lies here")
    }
}

/// Two flips on one step leave the sign of the test function as it was: only the count tells. Halving meets both exactly.
fn twice(r: f64) -> [f64; 2] {
    [-0.9 - 0.2 * r, -0.85 - 0.2 * r]
}

#[test]
fn two_flips_on_one_step_are_found_by_their_count() {
    let found = Along {
        multipliers: twice,
        known: true,
    };
    let found = found.findings();
    assert!(found.unexplained.is_empty(), "{:?}", found.unexplained);
    let flips: Vec<(Kind, f64)> = found.located.iter().map(|at| (at.kind, at.r)).collect();
    assert_eq!(flips.len(), 2, "{flips:?}");
    for ((kind, r), expected) in flips.into_iter().zip([0.5, 0.75]) {
        assert_eq!(kind, Kind::Flip);
        assert!((r - expected).abs() < 1e-8, "{r}, not {expected}");
    }
}

#[test]
fn a_change_that_cannot_be_looked_into_is_reported() {
    let found = Along {
        multipliers: twice,
        known: false,
    };
    let found = found.findings();
    assert!(found.located.is_empty(), "{:?}", found.located);
    let [change] = found.unexplained.as_slice() else {
        panic!("{:?}", found.unexplained);
    };
    assert_eq!((change.between, change.unstable), ([0.0, 1.0], [0, 2]));
    assert_eq!(change.reason, "nobody knows what lies here");
}
