//! What a law with internal state makes of a contact that swings to and fro at constant speed.

use std::borrow::Borrow;
use std::marker::PhantomData;
use std::ops::ControlFlow;

use crate::field::{Field, Linear, Stops, Work};
use crate::integrate::explicit::{Settings, integrate};
use crate::integrate::{IntegrationError, Tolerance};
use crate::memory::{MemoryLaw, MemoryLawInfo};

/// Strokes after the first, half one: two whole loops.
const STROKES: usize = 4;
/// Points of each step that a drawing gets.
const DRAWN: usize = 8;
/// Relative error tolerated in the internal states, for a drawing.
const TOLERANCE: f64 = 1e-9;
/// Powers of two among which an amplitude is looked for.
const EXPONENTS: std::ops::Range<i32> = -60..40;
/// A secant stiffness below this share of the elastic one tells that a law yields.
const YIELDED: f64 = 0.5;
/// Times that amplitude, its loop is plain to see.
const PLAIN: f64 = 2.0;

/// A friction law with internal state at given values of its parameters.
pub trait Hysteresis {
    /// The law as data.
    fn law(&self) -> &'static MemoryLawInfo;

    /// Amplitude and speed of a swing that shows what it remembers, where they are given.
    fn usual(&self) -> Option<[f64; 2]>;

    /// Displacement and force against it, from a contact without memory at 0 to `amplitude`, then to and fro
    /// between that and its negative, at constant `speed` > 0.
    ///
    /// # Errors
    /// The internal states cannot be followed.
    fn swing(&self, amplitude: f64, speed: f64) -> Result<Vec<[f64; 2]>, IntegrationError>;
}

impl dyn Hysteresis + '_ {
    /// An amplitude at which the law has yielded: several times that at which its force falls behind the elastic one, each
    /// swing taking a unit of time; 1 for a law that never yields.
    #[must_use]
    pub fn yielding(&self) -> f64 {
        let stiffness = |exponent: i32| {
            let amplitude = f64::from(exponent).exp2();
            let points = self.swing(amplitude, amplitude).ok()?;
            Some((amplitude, points.last()?[1].abs() / amplitude))
        };
        let mut all = EXPONENTS.filter_map(stiffness);
        let elastic = all.find(|(_, stiffness)| *stiffness > 0.0);
        let yielded = all.find(|(_, stiffness)| {
            elastic.is_some_and(|(_, elastic)| *stiffness < YIELDED * elastic)
        });
        yielded.map_or(1.0, |(amplitude, _)| PLAIN * amplitude)
    }
}

/// A law with `S` internal states, whatever its type.
pub(in crate::study) struct Shaken<B, L, const S: usize> {
    law: B,
    /// Amplitude and speed.
    swing: Option<[f64; 2]>,
    kind: PhantomData<fn() -> L>,
}

impl<B: Borrow<L>, L, const S: usize> Shaken<B, L, S> {
    pub(in crate::study) const fn new(law: B, swing: Option<[f64; 2]>) -> Self {
        Self {
            law,
            swing,
            kind: PhantomData,
        }
    }
}

impl<B: Borrow<L>, L: MemoryLaw<f64, S>, const S: usize> Hysteresis for Shaken<B, L, S> {
    fn law(&self) -> &'static MemoryLawInfo {
        L::INFO
    }

    fn usual(&self) -> Option<[f64; 2]> {
        self.swing
    }

    fn swing(&self, amplitude: f64, speed: f64) -> Result<Vec<[f64; 2]>, IntegrationError> {
        let (mut memory, mut place, mut points) = ([0.0; S], 0.0, Vec::new());
        let law = self.law.borrow();
        let elastic = law.answer(memory, speed).rates;
        let ends = std::iter::once(amplitude)
            .chain((0..STROKES).map(|i| if i % 2 == 0 { -amplitude } else { amplitude }));
        for end in ends {
            let speed = speed.copysign(end - place);
            let mut stroke = Stroke {
                law,
                speed,
                stops: Stops::NONE,
                size: elastic.map(|rate| (rate * amplitude / speed).abs()),
            };
            law.stops(|place, bound| stroke.stops.put(place, bound, 0.0));
            let duration = (end - place) / speed;
            memory = stroke.follow(memory, duration, |time, force| {
                points.push([place + speed * time, force]);
            })?;
            place = end;
        }
        Ok(points)
    }
}

/// The internal states while the contact slides at constant speed.
struct Stroke<'l, L, const S: usize> {
    law: &'l L,
    speed: f64,
    /// The stops of the internal states, and which of these rest.
    stops: Stops<S>,
    /// How far each internal state would go over the amplitude if it never yielded.
    size: [f64; S],
}

impl<L: MemoryLaw<f64, S>, const S: usize> Stroke<'_, L, S> {
    /// The force against the motion: positive where the speed is.
    fn force(&self, memory: &[f64; S]) -> f64 {
        -self.law.answer(*memory, self.speed).force
    }

    /// Follows the internal states; `see` is given times and forces.
    fn follow(
        &mut self,
        mut memory: [f64; S],
        duration: f64,
        mut see: impl FnMut(f64, f64),
    ) -> Result<[f64; S], IntegrationError> {
        let rates = self.free(&memory);
        self.stops = self.stops.settled(&mut memory, |_, _, i| rates[i]).stops;
        see(0.0, self.force(&memory));
        let mut time = 0.0;
        while time < duration {
            (time, memory, self.stops) = self.stretch(memory, (time, duration), &mut see)?;
        }
        Ok(memory)
    }

    /// Time, memory and modes where a stop is met or left, or at the end.
    fn stretch(
        &self,
        from: [f64; S],
        (since, until): (f64, f64),
        see: &mut impl FnMut(f64, f64),
    ) -> Result<(f64, [f64; S], Stops<S>), IntegrationError> {
        let settings = Settings {
            stiff_steps: u32::MAX,
            ..Settings::new(Tolerance::both(TOLERANCE))
        };
        let (mut work, mut switched) = (Work::default(), None);
        let end = integrate(self, settings, from, until - since, &mut work, |step| {
            let (time, length, dense) = (since + step.time(), step.length(), step.dense());
            for k in 1..=DRAWN {
                let theta = k as f64 / DRAWN as f64;
                see(time + theta * length, self.force(&dense.state(theta)));
            }
            let Some(guard) = step.fallen() else {
                return ControlFlow::Continue(());
            };
            let mut memory = *step.end();
            let rates = self.free(&memory);
            let settled = self.stops.switched(&mut memory, guard, &rates);
            switched = Some((time + length, memory, settled.stops));
            ControlFlow::Break(())
        })?;
        Ok(switched.unwrap_or((until, end, self.stops)))
    }

    /// The rates of free internal states.
    fn free(&self, memory: &[f64; S]) -> [f64; S] {
        self.law.answer(*memory, self.speed).rates
    }
}

impl<L: MemoryLaw<f64, S>, const S: usize> Field<S> for Stroke<'_, L, S> {
    fn f(&self, memory: &[f64; S]) -> [f64; S] {
        let mut rates = self.free(memory);
        self.stops.hold(&mut rates);
        rates
    }

    fn linearise(&self, memory: &[f64; S]) -> Linear<S> {
        let rates = self.law.slopes(self.law, *memory, self.speed).rates;
        let rests = |i: usize| self.stops.rests(i);
        Linear {
            f: self.f(memory),
            jacobian: std::array::from_fn(|i| {
                if rests(i) {
                    [0.0; S]
                } else {
                    rates[i].by_memory
                }
            }),
            design: [0.0; S],
        }
    }

    fn corners(&self) -> usize {
        self.stops.guards()
    }

    fn kink(&self, index: usize, memory: &[f64; S]) -> f64 {
        self.stops.guard(index, memory, |i| self.free(memory)[i])
    }

    fn guard(&self, index: usize) -> Option<f64> {
        self.stops.terms(index)
    }

    fn scale(&self, _: &[f64; S], tolerance: &Tolerance) -> [f64; S] {
        self.size.map(|size| tolerance.of(size))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examples::{Dahl, Jenkins};

    #[test]
    fn the_loop_of_dahl_is_the_one_in_closed_form() {
        let (stiffness, level, amplitude) = (1e4, 2.0, 5e-4);
        let law = Shaken::<_, Dahl<f64>, 1>::new(Dahl { stiffness, level }, None);
        let points = law.swing(amplitude, 1e-3).unwrap();
        // From rest, F = F_c (1 − e^{−σ₀ x/F_c}).
        let virgin = points.iter().take_while(|[x, _]| *x < amplitude);
        for [x, force] in virgin.copied() {
            let exact = -level * (-stiffness * x / level).exp_m1();
            assert!((force - exact).abs() < 1e-8 * level, "at {x}: {force}");
        }
        // Whole loops repeat, and are symmetric: their force at the ends is F_c tanh(σ₀ X/F_c).
        let last = points.last().unwrap();
        let exact = level * (stiffness * amplitude / level).tanh();
        assert!((last[1] - exact).abs() < 1e-8 * level, "{last:?} {exact}");
    }

    #[test]
    fn the_loop_of_jenkins_is_a_parallelogram() {
        let (stiffness, level, amplitude) = (1e4, 2.0, 5e-4);
        let law = Shaken::<_, Jenkins<f64>, 1>::new(Jenkins { stiffness, level }, None);
        let points = law.swing(amplitude, 1e-3).unwrap();
        let virgin = points.iter().take_while(|[x, _]| *x < amplitude);
        for [x, force] in virgin.copied() {
            assert!((force - (stiffness * x).min(level)).abs() < 1e-9 * level);
        }
        assert_eq!(points.last().unwrap()[1], level);
        // The last two strokes, once round: twice the area between them by the shoelace formula.
        let turns: Vec<usize> = (1..points.len())
            .filter(|&i| points[i][0] == points[i - 1][0] && i > 1)
            .collect();
        let cycle = &points[turns[turns.len() - 2]..];
        let twice: f64 = cycle
            .windows(2)
            .map(|pair| (pair[1][0] - pair[0][0]) * (pair[0][1] + pair[1][1]))
            .sum();
        let area = 4.0 * level * (amplitude - level / stiffness);
        assert!((0.5 * twice - area).abs() < 1e-9 * area, "{twice} {area}");
    }
}
