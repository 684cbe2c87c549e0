//! Laws of contacts that press and let go: the force of a penetration and of the rate at which it grows.

use crate::friction::{LawParameter, straight};
use crate::scalar::Scalar;

/// A law of a contact that presses, at given values of its parameters.
///
/// With d the penetration and v its rate, the force is force(d, v) while that is positive and d is, and none otherwise:
/// a contact never pulls, and it opens when the force has fallen to zero, which with a damper is before the gap opens.
/// A law that does not give way has no force of its own but a rebound: there the contact is hit and flies off again.
/// Declared with `press_law!`.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a law of contacts that press",
    label = "this is not declared with `press_law!`",
    note = "a press is used as `press N: N = Law {{ .. }} closing gap;`, and a law of friction as `friction F: N = Law {{ .. }} opposing speed;`"
)]
pub trait PressLaw<D: Scalar> {
    /// What is known about the law without its parameters.
    const INFO: &'static PressLawInfo;

    /// The force at the penetration `depth` > 0 that grows at `rate`.
    fn force(&self, depth: D, rate: D) -> D;

    /// The same with its derivatives; `along` holds the derivative of each field.
    fn slopes(&self, along: &Self, depth: D, rate: D) -> PressSlopes<D>;

    /// The speed at which a contact that does not give way parts after an approach at `speed` > 0.
    #[inline]
    fn rebound(&self, _speed: D) -> D {
        D::from(0.0)
    }

    /// The same with its derivative as the fields of the law move; `along` holds the derivative of each.
    #[inline]
    fn rebound_along(&self, _along: &Self, _speed: D) -> [D; 2] {
        [D::from(0.0); 2]
    }

    /// Calls `visit` with the number of each parameter, in the order of declaration, and its value.
    #[inline]
    fn fields(&self, _visit: impl FnMut(usize, D)) {}
}

/// The force of a press with its derivatives; the value has the bits of the law's own function.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct PressSlopes<D> {
    /// The force.
    pub force: D,
    /// Its derivative with respect to the penetration.
    pub by_depth: D,
    /// Its derivative with respect to the rate of the penetration.
    pub by_rate: D,
    /// Its derivative as the fields of the law move.
    pub along: D,
}

/// A law of contacts that press as data.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PressLawInfo {
    /// Name of the struct.
    pub name: &'static str,
    /// Documentation as written.
    pub doc: &'static str,
    /// Parameters in the order of declaration.
    pub parameters: &'static [LawParameter],
    /// `let` lines in the order of declaration: name and right side, as written.
    pub abbreviations: &'static [(&'static str, &'static str)],
    /// What it says.
    pub formula: PressFormula,
    /// The pairs of what moves, depth, rate and fields by their names, of which the force holds more than a sum.
    pub bends: &'static [(&'static str, &'static str)],
}

/// The formula of a law of contacts that press.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PressFormula {
    /// It gives way: a force of depth and rate.
    Compliant {
        /// Name of the penetration in the formula.
        depth: &'static str,
        /// Name of its rate in the formula.
        rate: &'static str,
        /// The right side of `force(d, v) = ...`, as written.
        force: &'static str,
    },
    /// It does not: an impact turns the speed of approach into one of departure.
    Rigid {
        /// Name of the speed of approach in the formula.
        speed: &'static str,
        /// The right side of `rebound(v) = ...`, as written.
        rebound: &'static str,
    },
}

impl PressLawInfo {
    /// The lines of the law, as written.
    #[must_use]
    pub fn lines(&self) -> Vec<String> {
        let lets = self.abbreviations.iter();
        let lets = lets.map(|(name, formula)| format!("{name} = {formula}"));
        let (head, formula) = self.line();
        lets.chain([format!("{head} = {formula}")]).collect()
    }

    /// Both sides of its formula, as written.
    pub(crate) fn line(&self) -> (String, &'static str) {
        match self.formula {
            PressFormula::Compliant { depth, rate, force } => {
                (format!("force({depth}, {rate})"), force)
            }
            PressFormula::Rigid { speed, rebound } => (format!("rebound({speed})"), rebound),
        }
    }

    /// What its formula reads beside its parameters, at a gap that stands still.
    pub(crate) fn at_rest(&self, gap: f64) -> Vec<(&'static str, f64)> {
        match self.formula {
            PressFormula::Compliant { depth, rate, .. } => vec![(depth, gap.abs()), (rate, 0.0)],
            PressFormula::Rigid { speed, .. } => vec![(speed, 0.0)],
        }
    }

    /// Whether the force is an affine function of depth, rate and these fields.
    #[must_use]
    pub fn is_straight(&self, moving: &[&str]) -> bool {
        straight(self.parameters, self.bends, moving)
    }

    /// Whether the contact does not give way.
    #[must_use]
    pub const fn is_rigid(&self) -> bool {
        matches!(self.formula, PressFormula::Rigid { .. })
    }
}

/// A penetration so small that no force comes of it, as far as numbers tell, and still a positive one.
const TOUCH: f64 = 1e-100;

/// What a closed press says at one instant.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pressed<D> {
    /// Its force as the law has it, continued smoothly to where the gap is open.
    pub(crate) force: D,
    /// A function with the sign of that force, which vanishes with a slope.
    pub(crate) hold: D,
    /// The magnitude of the terms of that function.
    pub(crate) terms: f64,
}

impl<D: Scalar> Pressed<D> {
    /// At a gap, negative where the contact is closed, and its rate.
    ///
    /// Where the force vanishes at no depth whatever the rate is, as that of Hertz does, it is divided by what it is at
    /// rate zero: then it vanishes only with its damper.
    #[inline]
    pub(crate) fn new<L: PressLaw<D>>(law: &L, gap: D, gap_rate: D) -> Self {
        let (depth, rate) = (-gap, -gap_rate);
        let (zero, one) = (D::from(0.0), D::from(1.0));
        let force = continued(law, depth, rate);
        let touch = law.force(D::from(TOUCH), zero);
        let ends_with_gap = law.force(zero, one).re() == 0.0 && touch.re() > 0.0;
        if ends_with_gap {
            let inside = if depth.re() > TOUCH {
                depth
            } else {
                D::from(TOUCH)
            };
            let hold = law.force(inside, rate) / law.force(inside, zero);
            return Self {
                force,
                hold,
                terms: 1.0 + (hold.re() - 1.0).abs(),
            };
        }
        let spring = continued(law, depth, zero).re();
        Self {
            force,
            hold: force,
            terms: spring.abs() + (force.re() - spring).abs(),
        }
    }
}

/// The force, continued to depths < 0 by reflection in the point (0, force at depth 0): stages that overshoot the
/// surface then meet neither a kink in the first derivative nor a root of a negative number.
#[inline]
fn continued<D: Scalar, L: PressLaw<D>>(law: &L, depth: D, rate: D) -> D {
    if depth.re() >= 0.0 {
        law.force(depth, rate)
    } else {
        law.force(D::from(0.0), rate) * 2.0 - law.force(-depth, rate)
    }
}

/// The force of a press where no mode decides it: as the law says while the gap is closed, and never pulling.
#[inline]
pub(crate) fn pressing<D: Scalar, L: PressLaw<D>>(law: &L, gap: D, gap_rate: D) -> D {
    if gap.re() < 0.0 {
        let force = law.force(-gap, -gap_rate);
        if force.re() > 0.0 {
            return force;
        }
    }
    D::from(0.0)
}

/// The same with its derivatives by the gap and by its rate.
#[inline]
pub(crate) fn pressing_slopes<L: PressLaw<f64>>(
    law: &L,
    along: &L,
    gap: f64,
    gap_rate: f64,
) -> GapSlopes {
    let slopes = law.slopes(along, -gap, -gap_rate);
    if gap < 0.0 && slopes.force > 0.0 {
        GapSlopes {
            force: slopes.force,
            by_gap: -slopes.by_depth,
            by_rate: -slopes.by_rate,
            along: slopes.along,
            by_design: 0.0,
        }
    } else {
        GapSlopes::default()
    }
}

/// The force of a press as a rule decides it, with its derivatives.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct GapSlopes {
    /// The force.
    pub force: f64,
    /// Its derivative with respect to the gap.
    pub by_gap: f64,
    /// Its derivative with respect to the rate of the gap.
    pub by_rate: f64,
    /// Its derivative as the fields of the law move, the gap held.
    pub along: f64,
    /// Its derivative with respect to the design variable where the rule itself depends on it.
    pub by_design: f64,
}
