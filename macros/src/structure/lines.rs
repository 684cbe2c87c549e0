//! The lines that a structure stands for: states, dampings and displacements where it is declared, equations at the end.

use proc_macro2::{Ident, TokenStream, TokenTree};
use quote::{format_ident, quote};
use syn::ext::IdentExt;
use syn::{Attribute, parse_quote};

use super::terms::{group, negative, number, product, rest, sum, times};
use super::{Mode, Quantity, Structure, Structures};
use crate::formula::Formula;
use crate::repeated::Repeated;
use crate::syntax::{Bound, Bounds, Line, Rule, TWELFTHS, Unit, UnitFactor, Value};

/// The states of a mode.
struct Names {
    amplitude: Ident,
    rate: Ident,
}

impl Structure {
    fn names(&self, mode: usize, repeated: &mut Repeated, declares: bool) -> Names {
        let mut element = |what| self.element(what, mode, repeated, declares);
        let (amplitude, rate) = (element("mode"), element("rate"));
        Names { amplitude, rate }
    }

    fn element(&self, what: &str, mode: usize, repeated: &mut Repeated, declares: bool) -> Ident {
        let array = format_ident!("{}_{what}", self.name.unraw(), span = self.name.span());
        repeated.element(&array, mode as i64, declares)
    }

    fn kept(&self) -> impl Iterator<Item = (usize, &Mode)> {
        self.reduced.modes.iter().take(self.kept).enumerate()
    }

    /// Whether a mode has a damping ratio: not if no spring opposes it.
    fn damped(&self, mode: usize) -> bool {
        self.reduced.modes[mode].frequency > 0.0
    }

    /// States and dampings of the modes, displacements and speeds of the points.
    pub(crate) fn declared(&self, repeated: &mut Repeated) -> Vec<Line> {
        let mut lines = Vec::new();
        let (name, si) = (&self.name, self.reduced.si);
        let unit = |source: TokenStream| si.then(|| unit(&source));
        for (k, mode) in self.kept() {
            let Names { amplitude, rate } = self.names(k, repeated, true);
            let what = format!(
                "mode {k} of `{name}`, of angular frequency {:.6e}",
                mode.frequency
            );
            let state = |name: Ident, doc: String, unit| {
                let (docs, number) = (vec![doc_of(&doc)], Some(number(name.span(), 0.0)));
                Line::State(Value {
                    docs,
                    name,
                    unit,
                    number,
                    bounds: None,
                })
            };
            lines.push(state(
                amplitude,
                format!("Amplitude of {what}."),
                unit(quote!(m)),
            ));
            lines.push(state(
                rate,
                format!("Its rate, of {what}."),
                unit(quote!(m / s)),
            ));
            if self.damped(k) {
                for (word, value, most, doc) in [
                    ("damping", mode.damping, None, "Damping ratio"),
                    ("share", 1.0, Some(1.0), "What is kept, 1, or left out, 0,"),
                ] {
                    let (name, doc) = (
                        self.element(word, k, repeated, true),
                        format!("{doc} of {what}."),
                    );
                    let declared = ratio(name, &doc, value, most, unit(quote!(1)));
                    lines.push(Line::Param(declared));
                }
            }
        }
        for (index, point) in self.reduced.points.iter().enumerate() {
            let ident = format_ident!("{}", point.name, span = name.span());
            for (quantity, noun) in [
                (Quantity::Displacement, "Displacement"),
                (Quantity::Speed, "Speed"),
            ] {
                let doc = format!("{noun} of `{name}` at its point `{}`.", point.name);
                let formula = self.measured(index, quantity, repeated);
                lines.push(named(
                    self.at(&ident, quantity),
                    vec![doc_of(&doc)],
                    formula,
                ));
            }
        }
        lines
    }

    /// The displacement or the speed of a point as a sum over the modes.
    fn measured(&self, point: usize, quantity: Quantity, repeated: &mut Repeated) -> Formula {
        let terms = self.kept().map(|(k, mode)| {
            let Names { amplitude, rate } = self.names(k, repeated, false);
            let name = if quantity == Quantity::Speed {
                rate
            } else {
                amplitude
            };
            times(mode.shape[point], &Formula::name(&name))
        });
        sum(terms.collect())
    }

    /// The equations of the modes under the loads that lines have put at the points.
    pub(crate) fn equations(&self, structures: &Structures, repeated: &mut Repeated) -> Vec<Line> {
        let mut lines = Vec::new();
        for (k, mode) in self.kept() {
            let names = self.names(k, repeated, false);
            let Names { amplitude, rate } = &names;
            lines.push(derivative(amplitude.clone(), Formula::name(rate)));
            let mut terms = Vec::new();
            if self.damped(k) {
                let damping = self.element("damping", k, repeated, false);
                let damped = product(&Formula::name(&damping), &Formula::name(rate));
                terms.push(times(-mode.frequency.powi(2), &Formula::name(amplitude)));
                terms.push(times(-2.0 * mode.frequency, &damped));
            }
            terms.extend(self.loads(mode, structures));
            let whole = sum(terms);
            let rated = if self.damped(k) {
                let share = Formula::name(&self.element("share", k, repeated, false));
                self.shared(&share, whole, &names)
            } else {
                whole
            };
            lines.push(derivative(rate.clone(), rated));
        }
        lines
    }

    /// What the loads at the points do to a mode.
    fn loads(&self, mode: &Mode, structures: &Structures) -> Vec<Formula> {
        let points = self.reduced.points.iter().zip(&mode.shape);
        let terms = points
            .filter(|(_, shape)| **shape != 0.0)
            .filter_map(|(point, shape)| {
                let load = self.at(&format_ident!("{}", point.name), Quantity::Load);
                let mut loads = structures.loads.iter();
                let load = loads.find(|known| known.name == load)?;
                Some(times(*shape, &Formula::name(&load.name)))
            });
        terms.collect()
    }

    /// The rate of a mode that is kept in this share: one that is left out takes no load and, so that no step has to be as
    /// short as its period, comes to rest as slowly as the lowest one swings.
    fn shared(
        &self,
        share: &Formula,
        whole: Formula,
        Names { amplitude, rate }: &Names,
    ) -> Formula {
        let elastic = self.kept().map(|(_, mode)| mode.frequency);
        let lowest = elastic
            .filter(|one| *one > 0.0)
            .fold(f64::INFINITY, f64::min);
        let resting = sum(vec![
            times(lowest.powi(2), &Formula::name(amplitude)),
            times(lowest, &Formula::name(rate)),
        ]);
        let kept = product(share, &group(whole));
        let left = product(&rest(share), &group(resting));
        sum(vec![kept, negative(left)])
    }

    /// The units of what is displaced, where they are known.
    pub(crate) fn units(&self) -> Vec<(Ident, Unit)> {
        let points = self.reduced.points.iter().filter(|_| self.reduced.si);
        let units = points.flat_map(|point| {
            let ident = format_ident!("{}", point.name);
            let [displacement, speed] = match point.turns {
                true => [quote!(rad), quote!(rad / s)],
                false => [quote!(m), quote!(m / s)],
            };
            let of = |quantity, source: TokenStream| (self.at(&ident, quantity), unit(&source));
            [
                of(Quantity::Displacement, displacement),
                of(Quantity::Speed, speed),
            ]
        });
        units.collect()
    }
}

fn doc_of(text: &str) -> Attribute {
    parse_quote!(#[doc = #text])
}

/// A parameter that is not negative, and not above `most`.
fn ratio(name: Ident, doc: &str, value: f64, most: Option<f64>, unit: Option<Unit>) -> Value {
    let bound = |value| Bound {
        number: number(name.span(), value),
        inclusive: true,
    };
    let bounds = Bounds {
        source: quote!(#name >= 0.0),
        name: name.clone(),
        lower: Some(bound(0.0)),
        upper: most.map(bound),
    };
    Value {
        docs: vec![doc_of(doc)],
        number: Some(number(name.span(), value)),
        name,
        unit,
        bounds: Some(bounds),
    }
}

pub(crate) fn named(name: Ident, docs: Vec<Attribute>, formula: Formula) -> Line {
    Line::Let(rule("let", name, docs, formula))
}

fn derivative(name: Ident, formula: Formula) -> Line {
    Line::Derivative(rule("der", name, Vec::new(), formula))
}

fn rule(word: &str, name: Ident, docs: Vec<Attribute>, formula: Formula) -> Rule {
    let word = Ident::new(word, name.span());
    Rule {
        docs,
        word,
        name,
        rate: None,
        formula,
    }
}

/// A unit of metres and seconds, as it is written.
fn unit(source: &TokenStream) -> Unit {
    let mut divides = false;
    let mut factors = Vec::new();
    for token in source.clone() {
        match token {
            TokenTree::Punct(_) => divides = true,
            TokenTree::Ident(symbol) => factors.push(UnitFactor {
                symbol,
                twelfths: TWELFTHS,
                divides,
            }),
            _ => {}
        }
    }
    Unit {
        factors,
        source: source.clone(),
    }
}
