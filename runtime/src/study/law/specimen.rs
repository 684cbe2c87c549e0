//! Laws with values for their parameters, to be listed and drawn whatever their types.

use super::characteristic::Characteristic;
use super::hysteresis::{Hysteresis, Shaken};
use super::strike::{Strike, Struck};
use crate::friction::{FrictionLaw, LawInfo, LawParameter};
use crate::memory::{MemoryLaw, MemoryLawInfo};
use crate::model::ParameterError;
use crate::press::{PressLaw, PressLawInfo};

/// A law with values for its parameters: made by [`specimen!`](crate::specimen).
///
/// `L` is what can be asked of it: [`Characteristic`], [`Hysteresis`] of a law with internal state, or [`Strike`] of a law
/// of presses.
pub struct Specimen<L: ?Sized = dyn Characteristic> {
    parameters: &'static [LawParameter],
    /// The parameters in the order in which `build` takes them.
    fields: Vec<&'static str>,
    values: Vec<f64>,
    build: Box<Build<L>>,
}

type Build<L> = dyn Fn(&[f64]) -> Box<L> + Send + Sync;

/// A law of any kind, as a program lists it.
pub enum Shown {
    /// A law without internal state.
    Static(Specimen),
    /// A law with internal state.
    Remembering(Specimen<dyn Hysteresis>),
    /// A law of presses.
    Pressing(Specimen<dyn Strike>),
}

impl From<Specimen> for Shown {
    fn from(specimen: Specimen) -> Self {
        Self::Static(specimen)
    }
}

impl From<Specimen<dyn Hysteresis>> for Shown {
    fn from(specimen: Specimen<dyn Hysteresis>) -> Self {
        Self::Remembering(specimen)
    }
}

impl From<Specimen<dyn Strike>> for Shown {
    fn from(specimen: Specimen<dyn Strike>) -> Self {
        Self::Pressing(specimen)
    }
}

impl Specimen {
    /// The law that `build` makes of its `fields`, with the `values` of these; called by [`specimen!`](crate::specimen).
    #[must_use]
    pub fn new<L: FrictionLaw<f64> + 'static, const N: usize>(
        fields: [&'static str; N],
        values: [f64; N],
        build: fn([f64; N]) -> L,
    ) -> Self {
        let build =
            move |values: &[f64]| -> Box<dyn Characteristic> { Box::new(build(taken(values))) };
        Self::of(L::INFO.parameters, &fields, &values, Box::new(build))
    }

    /// The law as data.
    #[must_use]
    pub fn law(&self) -> &'static LawInfo {
        (self.build)(&self.values).law()
    }
}

impl Specimen<dyn Hysteresis> {
    /// The same of a law with `S` internal states, shown by a swing of this amplitude and speed.
    #[must_use]
    pub fn with_memory<L: MemoryLaw<f64, S> + 'static, const S: usize, const N: usize>(
        fields: [&'static str; N],
        values: [f64; N],
        build: fn([f64; N]) -> L,
        swing: [f64; 2],
    ) -> Self {
        let build = move |values: &[f64]| -> Box<dyn Hysteresis> {
            Box::new(Shaken::<L, L, S>::new(build(taken(values)), Some(swing)))
        };
        Self::of(L::INFO.parameters, &fields, &values, Box::new(build))
    }

    /// The law as data.
    #[must_use]
    pub fn law(&self) -> &'static MemoryLawInfo {
        (self.build)(&self.values).law()
    }
}

impl Specimen<dyn Strike> {
    /// The same of a law of presses, shown by a strike of this depth and speed.
    #[must_use]
    pub fn of_press<L: PressLaw<f64> + 'static, const N: usize>(
        fields: [&'static str; N],
        values: [f64; N],
        build: fn([f64; N]) -> L,
        strike: [f64; 2],
    ) -> Self {
        let build = move |values: &[f64]| -> Box<dyn Strike> {
            Box::new(Struck::<L, L>::new(build(taken(values)), Some(strike)))
        };
        Self::of(L::INFO.parameters, &fields, &values, Box::new(build))
    }

    /// The law as data.
    #[must_use]
    pub fn law(&self) -> &'static PressLawInfo {
        (self.build)(&self.values).law()
    }
}

fn taken<const N: usize>(values: &[f64]) -> [f64; N] {
    std::array::from_fn(|i| values.get(i).copied().unwrap_or(f64::NAN))
}

/// The values of these names; NaN for one that has none.
fn picked<'a>(
    names: impl Iterator<Item = &'a str>,
    values: impl Iterator<Item = (&'a str, f64)> + Clone,
) -> Vec<f64> {
    let value = |name| values.clone().find(|(known, _)| *known == name);
    names
        .map(|name| value(name).map_or(f64::NAN, |(_, value)| value))
        .collect()
}

impl<L: ?Sized> Specimen<L> {
    fn of(
        parameters: &'static [LawParameter],
        fields: &[&'static str],
        values: &[f64],
        build: Box<Build<L>>,
    ) -> Self {
        Self {
            parameters,
            fields: fields.to_vec(),
            values: values.to_vec(),
            build,
        }
    }

    /// The law's parameters.
    #[must_use]
    pub fn parameters(&self) -> &'static [LawParameter] {
        self.parameters
    }

    /// The values of the law's parameters, in the order of their declaration.
    #[must_use]
    pub fn values(&self) -> Vec<f64> {
        let declared = self.parameters.iter().map(|declared| declared.name);
        let values = self.fields.iter().copied().zip(self.values.iter().copied());
        picked(declared, values)
    }

    /// The law at other values of its parameters, in the order of their declaration.
    ///
    /// # Errors
    /// A value is not finite, or out of its bounds.
    pub fn at(&self, values: &[f64]) -> Result<Box<L>, ParameterError> {
        for (declared, &value) in self.parameters.iter().zip(values) {
            declared.check(value)?;
        }
        let declared = self.parameters.iter().map(|declared| declared.name);
        let values = declared.zip(values.iter().copied());
        Ok((self.build)(&picked(self.fields.iter().copied(), values)))
    }
}

/// A law with typical values of its parameters: `specimen!(Weakening { limit: 1.0, decay: 3.0 })`.
///
/// A law with internal state has a swing that shows its hysteresis as well, its amplitude and its speed:
/// `specimen!(Dahl { stiffness: 1e4, level: 1.0 } swinging 5e-4 at 1e-3)`. A law of presses has a strike, its depth and its
/// speed: `specimen!(Hertz { load: 1.0, depth: 1e-5 } striking 2e-5 at 0.1)`.
///
/// ```
/// use stickslip::{friction_law, specimen};
///
/// friction_law! {
///     /// The same force at rest and at any sliding speed.
///     pub struct Dry {
///         /// That force.
///         param level: N where level >= 0.0;
///         stick = level;
///         slip(s) = level;
///     }
/// }
///
/// let dry = specimen!(Dry { level: 2.0 });
/// assert_eq!(dry.at(&[3.0]).unwrap().sliding(0.1), 3.0);
/// assert!(dry.at(&[-3.0]).is_err());
/// ```
#[macro_export]
macro_rules! specimen {
    ($law:ident { $($field:ident: $value:expr),* $(,)? }) => {
        $crate::study::Specimen::new(
            [$(::core::stringify!($field)),*],
            [$($value),*],
            |[$($field),*]| $law { $($field),* },
        )
    };
    ($law:ident { $($field:ident: $value:expr),* $(,)? } swinging $amplitude:literal at $speed:literal) => {
        $crate::study::Specimen::with_memory(
            [$(::core::stringify!($field)),*],
            [$($value),*],
            |[$($field),*]| $law { $($field),* },
            [$amplitude, $speed],
        )
    };
    ($law:ident { $($field:ident: $value:expr),* $(,)? } striking $depth:literal at $speed:literal) => {
        $crate::study::Specimen::of_press(
            [$(::core::stringify!($field)),*],
            [$($value),*],
            |[$($field),*]| $law { $($field),* },
            [$depth, $speed],
        )
    };
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::examples::Weakening;

    fn weakening() -> Specimen {
        // Not in the order of declaration.
        crate::specimen!(Weakening {
            decay: 3.0,
            limit: 1.0,
            peak: 1.5,
        })
    }

    #[test]
    fn values_stand_in_the_order_of_declaration() {
        assert_eq!(weakening().values(), [1.5, 1.0, 3.0]);
        let law = weakening().at(&[2.5, 2.0, 1.0]).unwrap();
        assert_eq!((law.at_rest(), law.sliding(1.0)), (2.5, 1.0));
    }

    #[test]
    fn bounds_are_kept() {
        let message = |values| weakening().at(values).err().unwrap().to_string();
        assert!(message(&[1.5, -1.0, 3.0]).contains("limit >= 0"));
        assert!(message(&[1.5, 1.0, f64::NAN]).contains("decay"));
    }

    #[test]
    fn copies_have_the_sign_of_the_exact_force() {
        let law = weakening().at(&[1.0, 1.0, 3.0]).unwrap();
        let smoothing = "tanh:1e3".parse().unwrap();
        assert!((law.copied(smoothing, 0.5) - law.sliding(0.5)).abs() < 1e-12);
        assert!((law.copied(smoothing, -0.5) + law.sliding(0.5)).abs() < 1e-12);
        assert_eq!(law.accepts(smoothing), Ok(()));
        let refused = law.accepts("quartic:1e-2".parse().unwrap()).unwrap_err();
        assert!(
            refused.to_string().contains("`Weakening` has none"),
            "{refused}"
        );
    }
}
