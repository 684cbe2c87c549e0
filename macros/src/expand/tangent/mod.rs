//! Forward differentiation while the macro runs: only derivatives that can differ from zero become code.
//!
//! Each operation becomes one binding, in the order of the formula, so that values have the bits of the formula
//! evaluated at once.

mod slopes;

use std::collections::{BTreeMap, HashMap};

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{ToTokens, format_ident, quote};

use super::lift::{Lift, Lifted, atom, call, constant, negative, power, scalar, small_power};
use crate::formula::{Formula, Kind, Operator};

/// A derivative; that of a name by itself costs nothing.
#[derive(Clone)]
pub(super) enum Slope {
    One,
    MinusOne,
    Other(Lifted),
}

/// The derivatives of a quantity in each direction in which it can change.
pub(super) type Slopes = BTreeMap<usize, Slope>;

/// A bound value with its derivatives.
#[derive(Clone)]
pub(super) struct Quantity {
    pub(super) value: Lifted,
    pub(super) slopes: Slopes,
}

/// Differentiates formulas, each name having the derivatives that are known for it.
pub(super) struct Tangents<'a> {
    pub(super) lift: Lift<'a>,
    pub(super) known: HashMap<&'a Ident, Slopes>,
    /// The lines so far, with the name that each binds.
    lines: Vec<(Option<Ident>, TokenStream)>,
    bound: usize,
}

/// Most lines that stand side by side. A binding is a scope within that of the last one, and a compiler that notes them for
/// debuggers goes through them by recursion: thousands overflow its stack.
const BLOCK: usize = 64;

impl Slope {
    /// An expression that is a name or a field.
    pub(super) fn of(atom: TokenStream) -> Self {
        Self::Other(scalar(atom))
    }

    fn lifted(&self) -> Lifted {
        match self {
            Self::One => constant(quote!(1f64)),
            Self::MinusOne => negative(constant(quote!(1f64))),
            Self::Other(slope) => slope.clone(),
        }
    }
}

impl<'a> Tangents<'a> {
    pub(super) fn new(lift: Lift<'a>, known: HashMap<&'a Ident, Slopes>) -> Self {
        Self {
            lift,
            known,
            lines: Vec::new(),
            bound: 0,
        }
    }

    /// The formula with its derivatives.
    pub(super) fn formula(&mut self, formula: &Formula) -> Quantity {
        match &formula.kind {
            Kind::Number(_) | Kind::Constant(_) => fixed(self.lift.lift(formula)),
            Kind::Name(name) => Quantity {
                value: self.lift.lift(formula),
                slopes: self.known.get(name).cloned().unwrap_or_default(),
            },
            Kind::Group(inner) => self.formula(inner),
            Kind::Minus(inner) => {
                let inner = self.formula(inner);
                self.minus(&inner)
            }
            Kind::Binary(left, operator, right) => {
                let (left, right) = (self.formula(left), self.formula(right));
                self.binary(&left, *operator, &right)
            }
            Kind::Call(function, argument) => {
                let argument = self.formula(argument);
                self.call(function, &argument)
            }
            Kind::Power(base, exponent) => {
                let base = self.formula(base);
                self.power(base, *exponent)
            }
            Kind::RealPower(function, base, exponent) => {
                let (base, power) = (self.formula(base), self.formula(exponent));
                self.real_power(function, base, &power, exponent)
            }
        }
    }

    /// The value as an expression of the scalar type.
    pub(super) fn value(&self, quantity: &Quantity) -> TokenStream {
        self.lift.as_scalar(quantity.value.clone())
    }

    /// The derivative in a direction as an expression of the scalar type.
    pub(super) fn slope(&self, slopes: &Slopes, direction: usize) -> TokenStream {
        let slope = slopes.get(&direction).map(Slope::lifted);
        let slope = slope.unwrap_or_else(|| constant(quote!(0f64)));
        self.lift.as_scalar(slope)
    }

    /// Binds an expression to a name of its own.
    pub(super) fn bind(&mut self, expression: impl ToTokens) -> Ident {
        let name = format_ident!("__t{}", self.bound, span = Span::mixed_site());
        self.bound += 1;
        let line = quote!(let #name = #expression;);
        self.lines.push((Some(name.clone()), line));
        name
    }

    /// Gives a value to a place.
    pub(super) fn assign(&mut self, place: &TokenStream, value: &TokenStream) {
        self.lines.push((None, quote!(#place = #value;)));
    }

    /// All lines, many of them in blocks.
    pub(super) fn lines(&self) -> TokenStream {
        let lines = |of: &[(Option<Ident>, TokenStream)]| -> TokenStream {
            of.iter().map(|(_, line)| line.clone()).collect()
        };
        if self.lines.len() <= BLOCK {
            return lines(&self.lines);
        }
        let blocks = self.lines.chunks(BLOCK).map(|block| {
            let names: Vec<&Ident> = block.iter().filter_map(|(name, _)| name.as_ref()).collect();
            let lines = lines(block);
            quote!(let (#(#names,)*) = { #lines (#(#names,)*) };)
        });
        blocks.collect()
    }

    fn keep(&mut self, lifted: &Lifted) -> Lifted {
        let name = self.bind(&lifted.tokens);
        atom(name.into_token_stream(), lifted.is_constant)
    }

    fn join(&mut self, left: Lifted, operator: Operator, right: Lifted) -> Lifted {
        let joined = self.lift.binary(left, operator, right);
        self.keep(&joined)
    }

    fn minus(&mut self, inner: &Quantity) -> Quantity {
        let value = negative(inner.value.clone());
        if value.is_constant {
            return fixed(value);
        }
        Quantity {
            value: self.keep(&value),
            slopes: self.all_negated(&inner.slopes),
        }
    }

    fn binary(&mut self, left: &Quantity, operator: Operator, right: &Quantity) -> Quantity {
        let (x, y) = (left.value.clone(), right.value.clone());
        let value = self.join(x, operator, y);
        let slopes = match operator {
            Operator::Add => self.sum(left.slopes.clone(), &right.slopes),
            Operator::Subtract => self.difference(left.slopes.clone(), &right.slopes),
            Operator::Multiply => {
                let by_left = self.scaled(&left.slopes, &right.value);
                let by_right = self.scaled(&right.slopes, &left.value);
                self.sum(by_left, &by_right)
            }
            Operator::Divide => self.quotient(left, right, &value),
        };
        Quantity { value, slopes }
    }

    /// q = x/y: q' = (x' - q y')/y.
    fn quotient(&mut self, left: &Quantity, right: &Quantity, value: &Lifted) -> Slopes {
        if left.slopes.is_empty() && right.slopes.is_empty() {
            return Slopes::new();
        }
        let one = constant(quote!(1f64));
        let inverse = self.join(one, Operator::Divide, right.value.clone());
        let moved = self.scaled(&right.slopes, value);
        let numerator = self.difference(left.slopes.clone(), &moved);
        self.scaled(&numerator, &inverse)
    }

    fn call(&mut self, function: &Ident, argument: &Quantity) -> Quantity {
        let value = call(function, argument.value.clone());
        let value = self.keep(&value);
        if argument.slopes.is_empty() {
            return fixed(value);
        }
        let (x, y) = (&argument.value.tokens, &value.tokens);
        let rate = self.rate(&quote!(#function(#x, #y)));
        let slopes = self.scaled(&argument.slopes, &rate);
        Quantity { value, slopes }
    }

    fn rate(&mut self, call: &TokenStream) -> Lifted {
        self.keep(&scalar(quote!(::stickslip::math::slope::#call)))
    }

    fn power(&mut self, base: Quantity, exponent: i32) -> Quantity {
        if exponent == 1 {
            return base;
        }
        let value = power(base.value.clone(), exponent);
        let value = self.keep(&value);
        if exponent == 0 || base.slopes.is_empty() {
            return fixed(value);
        }
        let factor = Literal::f64_suffixed(f64::from(exponent.unsigned_abs()));
        let factor = constant(quote!(#factor));
        let factor = if exponent < 0 {
            negative(factor)
        } else {
            factor
        };
        let rate = if exponent > 0 {
            let lower = power(base.value.clone(), exponent - 1);
            self.join(lower, Operator::Multiply, factor)
        } else {
            let raised = self.join(value.clone(), Operator::Multiply, factor);
            self.join(raised, Operator::Divide, base.value.clone())
        };
        let slopes = self.scaled(&base.slopes, &rate);
        Quantity { value, slopes }
    }

    fn real_power(
        &mut self,
        function: &Ident,
        base: Quantity,
        exponent: &Quantity,
        written: &Formula,
    ) -> Quantity {
        if let Some(n) = small_power(written) {
            return self.power(base, n);
        }
        let (x, p) = (base.value.clone(), exponent.value.clone());
        let value = self.lift.real_power(function, x, p, written);
        let value = self.keep(&value);
        if base.slopes.is_empty() && exponent.slopes.is_empty() {
            return fixed(value);
        }
        let (p, y) = (&exponent.value.tokens, &value.tokens);
        if exponent.value.is_constant {
            let x = &base.value.tokens;
            let rate = self.rate(&quote!(power(#x, #p, #y)));
            let slopes = self.scaled(&base.slopes, &rate);
            return Quantity { value, slopes };
        }
        let x = self.value(&base);
        let mut slopes = Slopes::new();
        for (part, rate) in [
            (&base, quote!(powf_by_base)),
            (exponent, quote!(powf_by_exponent)),
        ] {
            if !part.slopes.is_empty() {
                let rate = self.rate(&quote!(#rate(#x, #p, #y)));
                let scaled = self.scaled(&part.slopes, &rate);
                slopes = self.sum(slopes, &scaled);
            }
        }
        Quantity { value, slopes }
    }
}

fn fixed(value: Lifted) -> Quantity {
    Quantity {
        value,
        slopes: Slopes::new(),
    }
}
