//! Arithmetic of derivatives, each result bound to a name of its own.

use super::{Slope, Slopes, Tangents};
use crate::expand::lift::{Lifted, negative};
use crate::formula::Operator;

impl Tangents<'_> {
    pub(in crate::expand) fn times(&mut self, slope: &Slope, factor: &Lifted) -> Slope {
        Slope::Other(match slope {
            Slope::One => factor.clone(),
            Slope::MinusOne => self.keep(&negative(factor.clone())),
            Slope::Other(slope) => self.join(slope.clone(), Operator::Multiply, factor.clone()),
        })
    }

    pub(in crate::expand) fn negated(&mut self, slope: &Slope) -> Slope {
        match slope {
            Slope::One => Slope::MinusOne,
            Slope::MinusOne => Slope::One,
            Slope::Other(slope) => Slope::Other(self.keep(&negative(slope.clone()))),
        }
    }

    /// Every derivative times the same factor.
    pub(in crate::expand) fn scaled(&mut self, slopes: &Slopes, factor: &Lifted) -> Slopes {
        let scaled = slopes
            .iter()
            .map(|(d, slope)| (*d, self.times(slope, factor)));
        scaled.collect()
    }

    pub(in crate::expand) fn all_negated(&mut self, slopes: &Slopes) -> Slopes {
        let negated = slopes.iter().map(|(d, slope)| (*d, self.negated(slope)));
        negated.collect()
    }

    pub(in crate::expand) fn sum(&mut self, left: Slopes, right: &Slopes) -> Slopes {
        self.joined(left, Operator::Add, right)
    }

    pub(in crate::expand) fn difference(&mut self, left: Slopes, right: &Slopes) -> Slopes {
        self.joined(left, Operator::Subtract, right)
    }

    fn joined(&mut self, mut left: Slopes, operator: Operator, right: &Slopes) -> Slopes {
        for (direction, slope) in right {
            let joined = match left.get(direction) {
                None if operator == Operator::Add => slope.clone(),
                None => self.negated(slope),
                Some(before) => Slope::Other(self.join(before.lifted(), operator, slope.lifted())),
            };
            left.insert(*direction, joined);
        }
        left
    }
}
