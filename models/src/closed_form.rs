//! Motions in closed form, but for one root: an independent truth for the numerical ones.
//!
//! While a mass on a spring slips with constant friction it is a damped oscillator. A cycle sticks until
//! the spring is as strong as friction at rest, slips until the mass is as fast as the belt again, and sticks. The
//! formulas are there for enclosures as well.

use stickslip::scalar::Scalar;

use crate::DrillString;

/// z'' + 2ζz' + z = 0 from z(0), z'(0), for 0 ≤ ζ < 1: thesis (4.11) and (4.12).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ringdown<D = f64> {
    /// Damping ratio ζ.
    pub damping: D,
    /// z(0).
    pub position: D,
    /// z'(0).
    pub rate: D,
}

impl<D: Scalar> Ringdown<D> {
    /// z(τ): thesis (4.11).
    #[must_use]
    pub fn position(&self, time: D) -> D {
        let frequency = self.frequency();
        let (sin, cos) = (frequency * time).sin_cos();
        let sine_part = (self.rate + self.damping * self.position) / frequency;
        (-self.damping * time).exp() * (self.position * cos + sine_part * sin)
    }

    /// z'(τ): thesis (4.12).
    #[must_use]
    pub fn rate(&self, time: D) -> D {
        self.slope().position(time)
    }

    /// z''(τ).
    #[must_use]
    pub fn acceleration(&self, time: D) -> D {
        self.slope().rate(time)
    }

    /// The motion of z', which obeys the same equation.
    #[must_use]
    pub fn slope(&self) -> Self {
        Self {
            damping: self.damping,
            position: self.rate,
            rate: -(self.damping * self.rate * 2.0) - self.position,
        }
    }

    fn frequency(&self) -> D {
        (-(self.damping * self.damping) + 1.0).sqrt()
    }
}

impl Ringdown {
    /// First τ > 0 with z(τ) = 0; the next follow at distances [`Ringdown::half_period`].
    #[must_use]
    pub fn first_zero(&self) -> f64 {
        let sine_part = (self.rate + self.damping * self.position) / self.frequency();
        let angle = (-self.position / sine_part).atan();
        let half = std::f64::consts::PI;
        (if angle > 0.0 { angle } else { angle + half }) / self.frequency()
    }

    /// Half the period of the damped oscillation.
    #[must_use]
    pub fn half_period(&self) -> f64 {
        std::f64::consts::PI / self.frequency()
    }

    /// First τ > 0 at which z' is what it was at τ = 0, after it has been less; `None` if it never is again.
    fn return_of_rate(&self) -> Option<f64> {
        let slowest = self.slope().slope().first_zero();
        let fastest = slowest + self.half_period();
        let short = |time: f64| self.rate(time) - self.rate;
        if self.acceleration(0.0) >= 0.0 || short(fastest) <= 0.0 {
            return None;
        }
        let (mut low, mut high) = (slowest, fastest);
        let mut time = 0.5 * (low + high);
        for _ in 0..100 {
            let lack = short(time);
            *(if lack < 0.0 { &mut low } else { &mut high }) = time;
            let newton = time - lack / self.acceleration(time);
            let next = if low < newton && newton < high {
                newton
            } else {
                0.5 * (low + high)
            };
            if next == time || high - low <= f64::EPSILON * high {
                break;
            }
            time = next;
        }
        Some(time)
    }
}

/// A periodic motion that sticks once and slips once.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cycle {
    /// Position at which the mass breaks loose.
    pub release: f64,
    /// Position at which it sticks again.
    pub landing: f64,
    /// Duration of the slip.
    pub slip: f64,
    /// Duration of the stick.
    pub stick: f64,
    /// Largest position.
    pub max: f64,
    /// Smallest position.
    pub min: f64,
}

impl Cycle {
    /// Duration of both.
    #[must_use]
    pub fn period(&self) -> f64 {
        self.slip + self.stick
    }

    /// From the slip as a ringdown of z = (x − centre) in units of time 1/`frequency`, released with the
    /// speed of the belt.
    fn of(slip: &Ringdown, centre: f64, frequency: f64) -> Option<Self> {
        let duration = slip.return_of_rate()?;
        let highest = slip.slope().first_zero();
        let lowest = highest + slip.half_period();
        let (release, landing) = (slip.position, slip.position(duration));
        Some(Self {
            release: centre + release,
            landing: centre + landing,
            slip: duration / frequency,
            stick: (release - landing) / (slip.rate * frequency),
            max: centre + slip.position(highest),
            min: centre + slip.position(lowest),
        })
    }
}

/// The cycle of the drill string: thesis section 4.2. `None` if the bit, once loose, never sticks again,
/// or for ζ ≥ 1.
#[must_use]
pub fn drill_string(model: &DrillString) -> Option<Cycle> {
    if model.zeta >= 1.0 {
        return None;
    }
    let slip = Ringdown {
        damping: model.zeta,
        position: model.theta - 2.0 * model.zeta * model.eta,
        rate: model.eta,
    };
    Cycle::of(&slip, 0.0, 1.0)
}

/// A mass on a belt with Coulomb's law and a larger force at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct CoulombBelt {
    /// Mass.
    pub mass: f64,
    /// Spring stiffness.
    pub stiffness: f64,
    /// Speed of the belt, > 0.
    pub belt: f64,
    /// Largest force at rest.
    pub static_force: f64,
    /// Force while sliding, below the static one.
    pub kinetic_force: f64,
}

impl CoulombBelt {
    /// Its cycle; `None` if there is none.
    #[must_use]
    pub fn cycle(&self) -> Option<Cycle> {
        let frequency = (self.stiffness / self.mass).sqrt();
        let slip = Ringdown {
            damping: 0.0,
            position: (self.static_force - self.kinetic_force) / self.stiffness,
            rate: self.belt / frequency,
        };
        Cycle::of(&slip, self.kinetic_force / self.stiffness, frequency)
    }
}
