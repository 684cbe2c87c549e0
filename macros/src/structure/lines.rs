//! The lines that a structure stands for: states, dampings and displacements where it is declared, equations at the end.

use proc_macro2::{Ident, Literal, Punct, Spacing, TokenStream, TokenTree};
use quote::{ToTokens, format_ident, quote};
use syn::ext::IdentExt;
use syn::{Attribute, parse_quote};

use super::{Mode, Quantity, Structure, Structures};
use crate::formula::{Formula, Kind, Number, Operator};
use crate::repeated::Repeated;
use crate::syntax::{Bound, Bounds, Line, Rule, Unit, UnitFactor, Value};

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
                let damping = self.element("damping", k, repeated, true);
                let doc = format!("Damping ratio of {what}.");
                lines.push(Line::Param(ratio(
                    damping,
                    &doc,
                    mode.damping,
                    unit(quote!(1)),
                )));
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
            let Names { amplitude, rate } = self.names(k, repeated, false);
            lines.push(derivative(amplitude.clone(), Formula::name(&rate)));
            let mut terms = Vec::new();
            if self.damped(k) {
                let damping = self.element("damping", k, repeated, false);
                let damped = product(&Formula::name(&damping), &Formula::name(&rate));
                terms.push(times(-mode.frequency.powi(2), &Formula::name(&amplitude)));
                terms.push(times(-2.0 * mode.frequency, &damped));
            }
            for (index, point) in self.reduced.points.iter().enumerate() {
                let ident = format_ident!("{}", point.name);
                let load = self.at(&ident, Quantity::Load);
                let mut loads = structures.loads.iter();
                if let Some(load) = loads.find(|known| known.name == load)
                    && mode.shape[index] != 0.0
                {
                    terms.push(times(mode.shape[index], &Formula::name(&load.name)));
                }
            }
            lines.push(derivative(rate, sum(terms)));
        }
        lines
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

fn ratio(name: Ident, doc: &str, value: f64, unit: Option<Unit>) -> Value {
    let zero = number(name.span(), 0.0);
    let bounds = Bounds {
        source: quote!(#name >= 0.0),
        name: name.clone(),
        lower: Some(Bound {
            number: zero,
            inclusive: true,
        }),
        upper: None,
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
                exponent: 1,
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

/// A number that is not negative.
pub(crate) fn number(span: proc_macro2::Span, value: f64) -> Number {
    let text = format!("{value:e}");
    let mut literal: Literal = text
        .parse()
        .unwrap_or_else(|_| Literal::f64_unsuffixed(value));
    literal.set_span(span);
    Number {
        value,
        source: literal.into_token_stream(),
    }
}

fn times(factor: f64, of: &Formula) -> Formula {
    let number = number(proc_macro2::Span::call_site(), factor.abs());
    let source = number.source.clone();
    let product = product(
        &Formula {
            kind: Kind::Number(number),
            source,
        },
        of,
    );
    if factor < 0.0 {
        let source = joined(&TokenStream::new(), '-', &product.source);
        return Formula {
            kind: Kind::Minus(Box::new(product)),
            source,
        };
    }
    product
}

fn product(left: &Formula, right: &Formula) -> Formula {
    binary(left.clone(), Operator::Multiply, '*', right.clone())
}

/// The sum of all terms; 0 if there are none.
fn sum(terms: Vec<Formula>) -> Formula {
    let all = terms.into_iter().reduce(|left, right| match right.kind {
        Kind::Minus(right) => binary(left, Operator::Subtract, '-', *right),
        _ => binary(left, Operator::Add, '+', right),
    });
    all.unwrap_or_else(|| {
        let zero = number(proc_macro2::Span::call_site(), 0.0);
        let source = zero.source.clone();
        Formula {
            kind: Kind::Number(zero),
            source,
        }
    })
}

fn binary(left: Formula, operator: Operator, mark: char, right: Formula) -> Formula {
    let source = joined(&left.source, mark, &right.source);
    Formula {
        kind: Kind::Binary(Box::new(left), operator, Box::new(right)),
        source,
    }
}

fn joined(left: &TokenStream, mark: char, right: &TokenStream) -> TokenStream {
    let mark = Punct::new(mark, Spacing::Alone);
    quote!(#left #mark #right)
}
