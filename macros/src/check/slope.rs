//! Derivatives of formulas, as formulas: the rate of a gap is written by the chain rule.

use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use crate::formula::{Formula, Kind, Number, Operator};

/// The derivative of a formula with respect to a name; `None` where it does not occur.
pub(super) fn slope(formula: &Formula, name: &Ident) -> Option<Formula> {
    let of = |part: &Formula| slope(part, name);
    match &formula.kind {
        Kind::Number(_) | Kind::Constant(_) => None,
        Kind::Name(other) => (other == name).then(|| number(1.0)),
        Kind::Group(inner) => of(inner),
        Kind::Minus(inner) => of(inner).map(negative),
        Kind::Binary(x, Operator::Add, y) => sum(of(x), of(y)),
        Kind::Binary(x, Operator::Subtract, y) => sum(of(x), of(y).map(negative)),
        Kind::Binary(x, Operator::Multiply, y) => {
            let left = of(x).map(|slope| product(slope, y.as_ref().clone()));
            let right = of(y).map(|slope| product(slope, x.as_ref().clone()));
            sum(left, right)
        }
        Kind::Binary(x, Operator::Divide, y) => {
            let falls = of(y).map(|slope| negative(product(slope, quotient(x, y))));
            sum(of(x), falls).map(|top| divided(top, y.as_ref().clone()))
        }
        Kind::Power(base, exponent) => {
            let factor = product(
                number(f64::from(*exponent)),
                whole_power(base, exponent - 1),
            );
            of(base).map(|slope| product(slope, factor))
        }
        Kind::RealPower(_, base, exponent) => {
            let through = of(base).map(|slope| {
                let relative = divided(slope, base.as_ref().clone());
                product(exponent.as_ref().clone(), relative)
            });
            let turned = of(exponent).map(|slope| product(slope, call("ln", base)));
            sum(through, turned).map(|rate| product(rate, formula.clone()))
        }
        Kind::Call(function, x) => {
            of(x).map(|slope| product(slope, outer(&function.to_string(), x)))
        }
    }
}

/// The sum of two formulas, of which either may be absent.
pub(super) fn sum(left: Option<Formula>, right: Option<Formula>) -> Option<Formula> {
    match (left, right) {
        (Some(left), Some(right)) => Some(binary(left, Operator::Add, right)),
        (left, right) => left.or(right),
    }
}

pub(super) fn product(left: Formula, right: Formula) -> Formula {
    match (left.literal(), right.literal()) {
        (Some(1.0), _) => right,
        (_, Some(1.0)) => left,
        (Some(-1.0), _) => negative(right),
        (_, Some(-1.0)) => negative(left),
        _ => binary(left, Operator::Multiply, right),
    }
}

/// The derivative of a function of one argument.
fn outer(function: &str, x: &Formula) -> Formula {
    let one = || number(1.0);
    let square = |x: &Formula| whole_power(x, 2);
    let root = |x: Formula| divided(one(), call("sqrt", &x));
    match function {
        "sin" => call("cos", x),
        "cos" => negative(call("sin", x)),
        "tan" => plus(one(), square(&call("tan", x))),
        "exp" => call("exp", x),
        "ln" => divided(one(), x.clone()),
        "sqrt" => divided(number(0.5), call("sqrt", x)),
        "sinh" => call("cosh", x),
        "cosh" => call("sinh", x),
        "tanh" => minus(one(), square(&call("tanh", x))),
        "asin" => root(minus(one(), square(x))),
        "acos" => negative(root(minus(one(), square(x)))),
        "atan" => divided(one(), plus(one(), square(x))),
        "asinh" => root(plus(one(), square(x))),
        "acosh" => root(minus(square(x), one())),
        // `atanh`; no other function is read in a model.
        _ => divided(one(), minus(one(), square(x))),
    }
}

fn of(kind: Kind) -> Formula {
    let source = TokenStream::new();
    Formula { kind, source }
}

fn number(value: f64) -> Formula {
    let source = quote!(#value);
    let kind = Kind::Number(Number {
        value: value.abs(),
        source: source.clone(),
    });
    let plain = Formula { kind, source };
    if value < 0.0 { negative(plain) } else { plain }
}

fn negative(x: Formula) -> Formula {
    of(Kind::Minus(Box::new(x)))
}

fn binary(left: Formula, operator: Operator, right: Formula) -> Formula {
    of(Kind::Binary(Box::new(left), operator, Box::new(right)))
}

fn plus(left: Formula, right: Formula) -> Formula {
    binary(left, Operator::Add, right)
}

fn minus(left: Formula, right: Formula) -> Formula {
    binary(left, Operator::Subtract, right)
}

fn divided(left: Formula, right: Formula) -> Formula {
    binary(left, Operator::Divide, right)
}

fn quotient(x: &Formula, y: &Formula) -> Formula {
    divided(x.clone(), y.clone())
}

fn whole_power(base: &Formula, exponent: i32) -> Formula {
    of(Kind::Power(Box::new(base.clone()), exponent))
}

fn call(function: &str, x: &Formula) -> Formula {
    let function = Ident::new(function, Span::call_site());
    of(Kind::Call(function, Box::new(x.clone())))
}

#[cfg(test)]
mod tests {
    use proc_macro2::{Ident, Span};

    use super::slope;
    use crate::arithmetic::Arithmetic;
    use crate::errors::Errors;
    use crate::formula::{Formula, Kind, Operator};
    use crate::parse::Grammar;
    use crate::repeated::Repeated;
    use crate::structure::Structures;

    fn formula(text: &str) -> Formula {
        let (mut repeated, mut errors) = (Repeated::default(), Errors::new());
        let mut arithmetic = Arithmetic {
            grammar: Grammar::Model,
            repeated: &mut repeated,
            structures: &Structures::default(),
            errors: &mut errors,
        };
        let read = arithmetic.read(&syn::parse_str(text).unwrap());
        errors.finish().unwrap();
        read
    }

    fn value(formula: &Formula, x: f64) -> f64 {
        let of = |part: &Formula| value(part, x);
        match &formula.kind {
            Kind::Number(number) => number.value,
            Kind::Constant(_) => unreachable!(),
            Kind::Name(_) => x,
            Kind::Group(inner) => of(inner),
            Kind::Minus(inner) => -of(inner),
            Kind::Binary(x, Operator::Add, y) => of(x) + of(y),
            Kind::Binary(x, Operator::Subtract, y) => of(x) - of(y),
            Kind::Binary(x, Operator::Multiply, y) => of(x) * of(y),
            Kind::Binary(x, Operator::Divide, y) => of(x) / of(y),
            Kind::Power(x, exponent) => of(x).powi(*exponent),
            Kind::RealPower(_, x, y) => of(x).powf(of(y)),
            Kind::Call(function, x) => crate::arithmetic::apply(function, of(x)),
        }
    }

    #[test]
    fn slopes_are_those_of_central_differences() {
        let x = Ident::new("x", Span::call_site());
        let functions = "acos asin asinh atan atanh cos cosh exp ln sin sinh sqrt tan tanh";
        let calls = functions.split(' ').map(|f| format!("{f}(0.3 + x * x)"));
        let others = [
            "acosh(1.5 + x)",
            "powi(x, 3) - powi(x, -2) / (1.0 + x)",
            "powf(1.0 + x, 1.5) * powf(2.0, x)",
            "-(3.0 - 2.0 * x) / (x * x + 4.0)",
        ];
        for text in calls.chain(others.map(str::to_owned)) {
            let (formula, at, step) = (formula(&text), 0.4, 1e-5);
            let found = value(&slope(&formula, &x).unwrap(), at);
            let difference = value(&formula, at + step) - value(&formula, at - step);
            let error = found - difference / (2.0 * step);
            assert!(error.abs() < 1e-8 * found.abs().max(1.0), "{text}: {error}");
        }
        assert!(slope(&formula("y + 3.0"), &x).is_none());
    }
}
