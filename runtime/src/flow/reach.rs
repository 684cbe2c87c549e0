//! Where the laws of a model hold: the bounds of their fields, at a state and along a step.

use crate::friction::{ContactRule, FrictionLaw, LawParameter};
use crate::integrate::event::Bernstein;
use crate::memory::{Answer, MemoryLaw};
use crate::model::{Model, ModelInfo};

/// Rounding error of a margin relative to its terms.
const NOISE: f64 = 128.0 * f64::EPSILON;
/// Halvings of a step, or of a part of it: all digits of its length.
const HALVINGS: usize = 60;

/// A field of a law that is out of its bounds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Beyond {
    /// The force whose law it is.
    pub(crate) force: &'static str,
    /// The law.
    pub(crate) law: &'static str,
    /// The field and its bounds.
    pub(crate) field: &'static LawParameter,
    /// Its value.
    pub(crate) value: f64,
    /// Whether it comes to its bound there, from inside.
    pub(crate) passes: bool,
}

/// The first field of a law that is out of its bounds at a state.
pub(crate) fn beyond<M: Model<N>, const N: usize>(
    params: &M::Params<f64>,
    state: [f64; N],
) -> Option<Beyond> {
    let mut found = None;
    each::<M, N>(params, state, &mut |one| {
        if found.is_none() && !one.field.bounds.contain(one.value) {
            found = Some(one);
        }
    });
    found
}

/// Where on a step, `at` its states from 0 to 1, a field first leaves its bounds, and which.
pub(crate) fn leaves<M: Model<N>, const N: usize>(
    params: &M::Params<f64>,
    at: &dyn Fn(f64) -> [f64; N],
) -> Option<(f64, Beyond)> {
    if !M::INFO.moving {
        return None;
    }
    first_out(&|theta| {
        let mut fields = Vec::new();
        each::<M, N>(params, at(theta), &mut |one| fields.push(one));
        fields
    })
}

/// The first of the fields that a function shows of a place on a step to leave its bounds, and where.
fn first_out(fields: &dyn Fn(f64) -> Vec<Beyond>) -> Option<(f64, Beyond)> {
    let margins = |theta: f64| -> Vec<f64> {
        let fields = fields(theta);
        fields
            .iter()
            .flat_map(ends)
            .map(|(margin, _)| margin)
            .collect()
    };
    let rows = Bernstein::nodes().map(margins);
    let fall = |slot: usize| {
        let values = rows.each_ref().map(|row| row[slot]);
        let margin = Bernstein::interpolate(&values);
        let heard = margin.without_noise(NOISE * margin.magnitude());
        heard.first_fall()
    };
    let falls = (0..rows[0].len()).filter_map(|slot| Some((slot, fall(slot)?)));
    let (slot, (theta, until)) = falls.min_by(|a, b| a.1.0.total_cmp(&b.1.0))?;
    let theta = sharpened(|theta| margins(theta)[slot], [0.0, theta, until])?;
    let each_end = |one: Beyond| ends(&one).map(move |(_, bound)| (one, bound));
    let (out, bound) = fields(theta).into_iter().flat_map(each_end).nth(slot)?;
    let out = Beyond {
        value: bound,
        passes: true,
        ..out
    };
    Some((theta, out))
}

/// The zero before `until` at which a function that is positive at `from` falls; `None` if it does not.
fn sharpened(value: impl Fn(f64) -> f64, [from, theta, until]: [f64; 3]) -> Option<f64> {
    let (mut low, mut high) = (from, until);
    if value(theta) < 0.0 {
        high = theta;
    } else {
        low = theta;
    }
    if value(high) >= 0.0 {
        return None;
    }
    for _ in 0..HALVINGS {
        let middle = 0.5 * (low + high);
        if value(middle) < 0.0 {
            high = middle;
        } else {
            low = middle;
        }
    }
    Some(high)
}

/// How far a field is inside each of its bounds, and that bound.
fn ends(one: &Beyond) -> impl Iterator<Item = (f64, f64)> + use<> {
    let (value, bounds) = (one.value, one.field.bounds);
    let lower = bounds.lower.map(|end| (value - end.value, end.value));
    let upper = bounds.upper.map(|end| (end.value - value, end.value));
    lower.into_iter().chain(upper)
}

fn each<M: Model<N>, const N: usize>(
    params: &M::Params<f64>,
    state: [f64; N],
    visit: &mut dyn FnMut(Beyond),
) {
    let model = M::INFO;
    let _ = M::rhs(params, state, &mut Fields { model, visit });
}

/// Shows the fields of each law; the forces of contacts are zero.
struct Fields<'v> {
    model: &'static ModelInfo,
    visit: &'v mut dyn FnMut(Beyond),
}

impl ContactRule<f64> for Fields<'_> {
    fn force<L: FrictionLaw<f64>>(&mut self, contact: usize, law: &L, _speed: f64) -> f64 {
        let (force, parameters) = (self.model.contacts[contact].name, L::INFO.parameters);
        law.fields(|i, value| {
            (self.visit)(Beyond {
                force,
                law: L::INFO.name,
                field: &parameters[i],
                value,
                passes: false,
            });
        });
        0.0
    }

    fn recall<L: MemoryLaw<f64, S>, const S: usize>(
        &mut self,
        element: usize,
        law: &L,
        memory: [f64; S],
        speed: f64,
    ) -> Answer<f64, S> {
        let (force, parameters) = (self.model.memories[element].name, L::INFO.parameters);
        law.fields(|i, value| {
            (self.visit)(Beyond {
                force,
                law: L::INFO.name,
                field: &parameters[i],
                value,
                passes: false,
            });
        });
        law.answer(memory, speed)
    }
}
