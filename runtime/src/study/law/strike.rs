//! What a law of presses makes of a contact that strikes and comes back.

use std::borrow::Borrow;
use std::f64::consts::PI;
use std::marker::PhantomData;

use crate::press::{PressLaw, PressLawInfo, pressing};

/// Points of a strike.
const POINTS: usize = 200;

/// A law of presses at given values of its parameters.
pub trait Strike {
    /// The law as data.
    fn law(&self) -> &'static PressLawInfo;

    /// Depth and speed of a strike that shows the law, where they are given.
    fn usual(&self) -> Option<[f64; 2]>;

    /// Depth and force of a strike to `depth` and back, half a sine that begins at `speed`.
    fn strike(&self, depth: f64, speed: f64) -> Vec<[f64; 2]>;
}

/// A law of presses, whatever its type.
pub(in crate::study) struct Struck<B, L> {
    law: B,
    /// Depth and speed.
    strike: Option<[f64; 2]>,
    kind: PhantomData<fn() -> L>,
}

impl<B: Borrow<L>, L> Struck<B, L> {
    pub(in crate::study) const fn new(law: B, strike: Option<[f64; 2]>) -> Self {
        Self {
            law,
            strike,
            kind: PhantomData,
        }
    }
}

impl<B: Borrow<L>, L: PressLaw<f64>> Strike for Struck<B, L> {
    fn law(&self) -> &'static PressLawInfo {
        L::INFO
    }

    fn usual(&self) -> Option<[f64; 2]> {
        self.strike
    }

    fn strike(&self, depth: f64, speed: f64) -> Vec<[f64; 2]> {
        let law = self.law.borrow();
        let point = |k: usize| {
            let (sine, cosine) = (PI * k as f64 / POINTS as f64).sin_cos();
            let at = depth * sine;
            [at, pressing(law, -at, -speed * cosine)]
        };
        (0..=POINTS).map(point).collect()
    }
}
