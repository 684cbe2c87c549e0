//! From formulas to Rust expressions over a scalar type.
//!
//! Names become fields, so that no constant of the user's can capture them. Constants stay `f64` as long as
//! they meet no scalar: `D op f64` gives the same bits as lifting and carries no derivatives.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::{format_ident, quote};

use crate::arithmetic::whole;
use crate::formula::{Formula, Kind, Number, Operator};

/// How tightly an expression binds; parentheses are written only where needed.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Binding {
    Sum,
    Product,
    Sign,
    Atom,
}

/// An expression: of the scalar type, or of `f64` as long as it is a constant.
#[derive(Clone)]
pub(super) struct Lifted {
    pub(super) tokens: TokenStream,
    binding: Binding,
    pub(super) is_constant: bool,
}

/// Lifts formulas to the type `scalar`, each name to the expression that `quantity` gives for it.
pub(super) struct Lift<'a> {
    pub(super) scalar: TokenStream,
    pub(super) quantity: &'a dyn Fn(&Ident) -> TokenStream,
}

impl Lift<'_> {
    /// The formula as an expression of the scalar type.
    pub(super) fn formula(&self, formula: &Formula) -> TokenStream {
        self.as_scalar(self.lift(formula))
    }

    pub(super) fn as_scalar(&self, lifted: Lifted) -> TokenStream {
        let (tokens, scalar) = (lifted.tokens, &self.scalar);
        if lifted.is_constant {
            quote!(#scalar::from(#tokens))
        } else {
            tokens
        }
    }

    pub(super) fn lift(&self, formula: &Formula) -> Lifted {
        match &formula.kind {
            Kind::Number(number) => constant(literal(number)),
            Kind::Constant(path) => constant(quote!(::core::convert::identity::<f64>(#path))),
            Kind::Name(name) => scalar((self.quantity)(name)),
            Kind::Group(inner) => self.lift(inner),
            Kind::Minus(inner) => negative(self.lift(inner)),
            Kind::Binary(left, operator, right) => {
                self.binary(self.lift(left), *operator, self.lift(right))
            }
            Kind::Call(function, argument) => call(function, self.lift(argument)),
            Kind::Power(base, exponent) => power(self.lift(base), *exponent),
            Kind::RealPower(function, base, exponent) => {
                self.real_power(function, self.lift(base), self.lift(exponent), exponent)
            }
        }
    }

    pub(super) fn binary(&self, left: Lifted, operator: Operator, right: Lifted) -> Lifted {
        let lone_constant = left.is_constant && !right.is_constant;
        match operator {
            Operator::Add | Operator::Multiply if lone_constant => joined(right, operator, left),
            Operator::Subtract if lone_constant => joined(negative(right), Operator::Add, left),
            Operator::Divide if lone_constant => {
                let left = scalar(self.as_scalar(left));
                joined(left, operator, right)
            }
            _ => joined(left, operator, right),
        }
    }

    pub(super) fn real_power(
        &self,
        function: &Ident,
        base: Lifted,
        exponent: Lifted,
        written: &Formula,
    ) -> Lifted {
        if let Some(n) = small_power(written) {
            return power(base, n);
        }
        if exponent.is_constant {
            let is_constant = base.is_constant;
            let (base, exponent) = (base.tokens, exponent.tokens);
            return atom(
                quote!(::stickslip::math::power(#base, #exponent)),
                is_constant,
            );
        }
        let (base, exponent) = (self.as_scalar(base), self.as_scalar(exponent));
        scalar(quote!(::stickslip::math::#function(#base, #exponent)))
    }
}

/// A constant that needs no parentheses.
pub(super) fn constant(tokens: TokenStream) -> Lifted {
    atom(tokens, true)
}

/// A scalar that needs no parentheses.
pub(super) fn scalar(tokens: TokenStream) -> Lifted {
    atom(tokens, false)
}

/// What needs no parentheses.
pub(super) fn atom(tokens: TokenStream, is_constant: bool) -> Lifted {
    Lifted {
        tokens,
        binding: Binding::Atom,
        is_constant,
    }
}

/// The exponent, where it is a whole number for which products are cheap.
pub(super) fn small_power(exponent: &Formula) -> Option<i32> {
    match &exponent.bare().kind {
        Kind::Number(number) => whole(number.value).filter(|n| *n <= 8),
        _ => None,
    }
}

fn literal(number: &Number) -> TokenStream {
    let mut literal = Literal::f64_suffixed(number.value);
    let first = number.source.clone().into_iter().next();
    literal.set_span(first.map_or_else(Span::call_site, |token| token.span()));
    quote!(#literal)
}

/// The expression, in parentheses if it binds less tightly than its place demands.
fn at_least(lifted: &Lifted, demanded: Binding) -> TokenStream {
    let tokens = &lifted.tokens;
    if lifted.binding < demanded {
        quote!((#tokens))
    } else {
        quote!(#tokens)
    }
}

pub(super) fn negative(lifted: Lifted) -> Lifted {
    let inner = match lifted.binding {
        Binding::Product | Binding::Atom => lifted.tokens.clone(),
        Binding::Sum | Binding::Sign => at_least(&lifted, Binding::Atom),
    };
    let binding = lifted.binding.clamp(Binding::Product, Binding::Sign);
    Lifted {
        tokens: quote!(-#inner),
        binding,
        is_constant: lifted.is_constant,
    }
}

fn joined(left: Lifted, operator: Operator, right: Lifted) -> Lifted {
    let (binding, after, sign) = match operator {
        Operator::Add => (Binding::Sum, Binding::Product, quote!(+)),
        Operator::Subtract => (Binding::Sum, Binding::Product, quote!(-)),
        Operator::Multiply => (Binding::Product, Binding::Sign, quote!(*)),
        Operator::Divide => (Binding::Product, Binding::Sign, quote!(/)),
    };
    let is_constant = left.is_constant && right.is_constant;
    let (left, right) = (at_least(&left, binding), at_least(&right, after));
    Lifted {
        tokens: quote!(#left #sign #right),
        binding,
        is_constant,
    }
}

pub(super) fn call(function: &Ident, argument: Lifted) -> Lifted {
    let inside = argument.tokens;
    let call = quote!(::stickslip::math::#function(#inside));
    atom(call, argument.is_constant)
}

/// A whole power as products of squares, the base computed once.
pub(super) fn power(base: Lifted, exponent: i32) -> Lifted {
    let is_constant = base.is_constant;
    if exponent == 0 {
        return constant(quote!(1f64));
    }
    if exponent == 1 {
        return base;
    }
    let product = product_of_squares(&base.tokens, exponent.unsigned_abs());
    let power = if exponent < 0 {
        quote!(#product.recip())
    } else {
        product
    };
    atom(power, is_constant)
}

fn product_of_squares(base: &TokenStream, exponent: u32) -> TokenStream {
    let mut square = format_ident!("__power_1", span = Span::mixed_site());
    let mut lines = quote!(let #square = #base;);
    let mut product: Option<TokenStream> = None;
    for bit in 0..=exponent.ilog2() {
        if bit > 0 {
            let next = format_ident!("__power_{}", 1u32 << bit, span = Span::mixed_site());
            lines.extend(quote!(let #next = #square * #square;));
            square = next;
        }
        if exponent & (1 << bit) != 0 {
            product =
                Some(product.map_or_else(|| quote!(#square), |before| quote!(#before * #square)));
        }
    }
    quote!({ #lines #product })
}

#[cfg(test)]
pub(crate) fn lifted(formula: &Formula) -> TokenStream {
    let lift = Lift {
        scalar: quote!(D),
        quantity: &|name| quote!(#name),
    };
    lift.formula(formula)
}
