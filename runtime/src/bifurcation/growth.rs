//! How motions beside a steady one grow: eigenvalues of an equilibrium and multipliers of an orbit alike.

use nalgebra::Complex;

use super::stability::Stability;

/// One direction beside an equilibrium or an orbit.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Growth {
    /// Re λ of an eigenvalue, ln |μ| of a multiplier.
    pub rate: f64,
    /// Im λ or arg μ.
    pub turn: f64,
    /// The rate is known to this: one that is no larger has no sign.
    pub error: f64,
    /// The sign that the rate had last on the way here, where it has none: 0 if it never had one.
    before: f64,
}

impl Growth {
    /// The exponent λ, or ln μ, and its error: a pair that is one real number as far as that tells does not turn.
    #[must_use]
    pub fn new(exponent: Complex<f64>, error: f64) -> Self {
        let turns = exponent.im.abs() > error;
        Self {
            rate: exponent.re,
            turn: if turns { exponent.im } else { 0.0 },
            error,
            before: 0.0,
        }
    }

    /// Whether it neither grows nor decays, as far as its error tells.
    #[must_use]
    pub fn is_marginal(&self) -> bool {
        self.rate.abs() <= self.error
    }

    /// 1 where it grows, −1 where it decays, 0 where that cannot be told.
    fn sign(&self) -> f64 {
        if self.is_marginal() {
            0.0
        } else {
            self.rate.signum()
        }
    }
}

/// All directions: what grows fastest first, a pair in the order of the sign of its imaginary part.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Growths(Vec<Growth>);

impl Growths {
    /// In their order; what is marginal has one rate for all, zero, and the fastest turn comes first.
    #[must_use]
    pub fn new(mut all: Vec<Growth>) -> Self {
        let rate = |one: &Growth| if one.is_marginal() { 0.0 } else { one.rate };
        all.sort_by(|a, b| {
            let turns = b.turn.abs().total_cmp(&a.turn.abs());
            rate(b).total_cmp(&rate(a)).then(turns)
        });
        // Equal pairs stay pairs.
        let (mut upper, mut lower) = (Vec::new(), Vec::new());
        for one in &all {
            if one.turn < 0.0 {
                &mut lower
            } else {
                &mut upper
            }
            .push(*one);
        }
        let mut lower = lower.into_iter();
        let couple = |one: Growth| {
            let other = if one.turn > 0.0 { lower.next() } else { None };
            [Some(one), other]
        };
        Self(upper.into_iter().flat_map(couple).flatten().collect())
    }

    /// One after the other.
    pub fn iter(&self) -> impl Iterator<Item = &Growth> {
        self.0.iter()
    }

    /// Direction k.
    #[must_use]
    pub fn get(&self, k: usize) -> Option<&Growth> {
        self.0.get(k)
    }

    /// How many grow.
    #[must_use]
    pub fn growing(&self) -> usize {
        self.iter().filter(|one| one.sign() > 0.0).count()
    }

    /// How many neither grow nor decay, as far as their errors tell.
    #[must_use]
    pub fn marginal(&self) -> usize {
        self.iter().filter(|one| one.is_marginal()).count()
    }

    /// What they say together.
    #[must_use]
    pub fn stability(&self) -> Stability {
        if self.growing() > 0 {
            Stability::Unstable
        } else if self.marginal() > 0 {
            Stability::Undecided
        } else {
            Stability::Stable
        }
    }

    /// Remembers for each direction that is marginal which sign it had at the point before.
    pub fn inherit(&mut self, before: &Self) {
        for (one, before) in self.0.iter_mut().zip(&before.0) {
            let sign = before.sign();
            one.before = if sign == 0.0 { before.before } else { sign };
        }
    }

    /// The sign of direction k, or the one that it had last: 0 where it never had one.
    fn side(&self, k: usize) -> f64 {
        self.get(k).map_or(0.0, |one| match one.sign() {
            0.0 => one.before,
            sign => sign,
        })
    }

    /// The rate of direction k: passes zero where it begins or ceases to grow.
    ///
    /// Where two pairs nearly collide, α = −d ± √(r − c) with a small d, the rate alone is all but vertical where it
    /// vanishes; weighed with the rate of the pair beside it, it is smooth.
    pub(crate) fn crossing(&self, k: usize) -> f64 {
        match self.get(k) {
            Some(one) if one.is_marginal() && one.before != 0.0 => one.before * one.error,
            Some(one) => self.beside(k, one).map_or(one.rate, |other| {
                let other = other.rate.abs();
                one.rate * (other / (one.rate.abs() + other))
            }),
            None => f64::NAN,
        }
    }

    /// The pair that turns most like pair k.
    fn beside(&self, k: usize, one: &Growth) -> Option<&Growth> {
        let others = self.0.iter().enumerate();
        let others = others.filter(|(i, other)| *i != k && other.turn > 0.0 && one.turn > 0.0);
        let apart = |other: &Growth| (other.turn - one.turn).abs();
        let nearest = others.min_by(|(_, a), (_, b)| apart(a).total_cmp(&apart(b)));
        let nearest = nearest.map(|(_, other)| other);
        nearest.filter(|other| other.rate != 0.0)
    }

    /// Whether direction k has a sign at both ends of a step, and is not the second of a pair.
    pub(crate) fn may_cross(ends: [&Self; 2], k: usize) -> bool {
        let first = |all: &Self| all.get(k).is_some_and(|one| one.turn >= 0.0);
        ends.iter().all(|all| all.side(k) != 0.0 && first(all))
    }

    /// Whether direction k turns at an end of a step.
    pub(crate) fn may_turn(ends: [&Self; 2], k: usize) -> bool {
        ends.iter()
            .any(|all| all.get(k).is_some_and(|one| one.turn != 0.0))
    }

    /// Whether the direction beside k has the rate and the turn of k: some symmetry makes them one.
    pub(crate) fn is_double(&self, k: usize) -> bool {
        let Some(one) = self.get(k) else { return false };
        let near = [k.checked_sub(1), Some(k + 1)];
        let mut near = near.into_iter().flatten().filter_map(|k| self.get(k));
        near.any(|other| {
            let error = one.error + other.error;
            (one.rate - other.rate).abs() <= error && (one.turn - other.turn).abs() <= error
        })
    }

    /// (λ₁² − λ₂²)² of the pairs that collide in direction k: positive while both are marginal, negative once they have
    /// left for four of rates ±α, and smooth between.
    pub(crate) fn collision(&self, k: usize) -> f64 {
        match self.get(k) {
            Some(one) if one.is_marginal() => self.nearest(),
            Some(one) => -(4.0 * one.rate * one.turn).powi(2),
            None => f64::NAN,
        }
    }

    /// The least (ω₁² − ω₂²)² of two marginal pairs that are not one as far as their errors tell; 0 if there are none.
    fn nearest(&self) -> f64 {
        let pairs = || {
            self.iter()
                .filter(|one| one.is_marginal() && one.turn > 0.0)
        };
        let apart = |(a, b): (&Growth, &Growth)| {
            let apart = (a.turn - b.turn).abs();
            (apart > a.error + b.error).then_some(apart * (a.turn + b.turn))
        };
        let all = pairs().enumerate();
        let all = all.flat_map(|(i, a)| pairs().skip(i + 1).map(move |b| (a, b)));
        let least = all.filter_map(apart).min_by(f64::total_cmp);
        least.map_or(0.0, |least| least * least)
    }

    /// Whether two marginal pairs at one end of a step are four of rates ±α at its other one, direction k the first.
    pub(crate) fn may_collide([from, to]: [&Self; 2], k: usize) -> bool {
        let marginal = |all: &Self| all.get(k).is_some_and(Growth::is_marginal);
        marginal(from) && to.is_of_four(k) || marginal(to) && from.is_of_four(k)
    }

    /// λ² of a pair that meets its conjugate in direction k, but for its sign: positive while it is marginal, negative
    /// once it has left for two real ones ±α.
    pub(crate) fn divergence(&self, k: usize) -> f64 {
        match self.get(k) {
            Some(one) if one.is_marginal() => {
                let marginal = self.iter().filter(|one| one.is_marginal());
                let least = marginal.map(|one| one.turn.abs()).min_by(f64::total_cmp);
                least.map_or(0.0, |turn| turn * turn)
            }
            Some(one) => -(one.rate * one.rate),
            None => f64::NAN,
        }
    }

    /// Whether marginal pairs at one end of a step are real ones ±α at its other one, direction k among them.
    pub(crate) fn may_diverge([from, to]: [&Self; 2], k: usize) -> bool {
        let marginal = |all: &Self| all.get(k).is_some_and(Growth::is_marginal);
        let real = |all: &Self| {
            let turn = all.get(k).map(|one| one.turn);
            turn == Some(0.0) && all.is_opposed(k)
        };
        marginal(from) && real(to) || marginal(to) && real(from)
    }

    fn is_of_four(&self, k: usize) -> bool {
        self.get(k).is_some_and(|one| one.turn > 0.0) && self.is_opposed(k)
    }

    /// Whether direction k grows as fast as another one decays that turns as it does.
    fn is_opposed(&self, k: usize) -> bool {
        let Some(one) = self.get(k) else { return false };
        let opposite = |other: &Growth| {
            let error = one.error + other.error;
            (one.rate + other.rate).abs() <= error && (one.turn - other.turn).abs() <= error
        };
        one.sign() > 0.0 && self.iter().any(opposite)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn growths(all: &[(f64, f64)]) -> Growths {
        let one = |(re, im): &(f64, f64)| Growth::new(Complex::new(*re, *im), 1e-12);
        Growths::new(all.iter().map(one).collect())
    }

    #[test]
    fn what_is_marginal_takes_its_sign_from_where_it_came() {
        let before = growths(&[(-0.1, 1.0), (-0.1, -1.0)]);
        let mut at = growths(&[(1e-13, 1.0), (1e-13, -1.0)]);
        let after = growths(&[(0.1, 1.0), (0.1, -1.0)]);
        assert!(!Growths::may_cross([&at, &after], 0), "never had a sign");
        at.inherit(&before);
        assert!(Growths::may_cross([&at, &after], 0));
        assert!(
            !Growths::may_cross([&at, &after], 1),
            "the second of a pair"
        );
        assert!(at.crossing(0) < 0.0 && after.crossing(0) > 0.0);
        assert_eq!((at.growing(), at.marginal()), (0, 2));
        assert_eq!(at.stability(), Stability::Undecided);
    }

    #[test]
    fn two_pairs_collide_where_their_distance_changes_its_sign() {
        let centre = |a: f64, b: f64| growths(&[(0.0, a), (0.0, -a), (0.0, b), (0.0, -b)]);
        let four = |re: f64, im: f64| growths(&[(re, im), (re, -im), (-re, im), (-re, -im)]);
        let ends = [&centre(1.0, 1.2), &four(0.1, 1.1)];
        assert!(Growths::may_collide(ends, 0));
        assert!(!Growths::may_collide(ends, 1));
        assert!(ends[0].collision(0) > 0.0 && ends[1].collision(0) < 0.0);
        // Pairs that are one by symmetry do not collide.
        assert_eq!(centre(1.0, 1.0).collision(0), 0.0);
    }

    #[test]
    fn equal_pairs_stay_pairs() {
        let all = growths(&[(-1.0, -2.0), (-1.0, 2.0), (-1.0, -2.0), (-1.0, 2.0)]);
        let turns: Vec<f64> = all.iter().map(|one| one.turn).collect();
        assert_eq!(turns, [2.0, -2.0, 2.0, -2.0]);
        assert!(!all.is_double(0) || all.get(1).is_some());
    }
}
