//! From Rust expressions to formulas: numbers, names, arithmetic and smooth functions.

use proc_macro2::Ident;
use quote::{ToTokens, quote};
use syn::{
    BinOp, Expr, ExprBinary, ExprCall, ExprLit, ExprMethodCall, ExprPath, ExprUnary, Lit, UnOp,
};

use crate::errors::Errors;
use crate::parse::Grammar;
use crate::suggest::nearest;
use crate::syntax::{Formula, Kind, Number, Operator};

/// The functions of one argument.
const FUNCTIONS: [&str; 15] = [
    "acos", "acosh", "asin", "asinh", "atan", "atanh", "cos", "cosh", "exp", "ln", "sin", "sinh",
    "sqrt", "tan", "tanh",
];

/// Functions that people write, and that have a corner or a jump.
const KINKS: [&str; 17] = [
    "abs",
    "ceil",
    "clamp",
    "copysign",
    "floor",
    "fract",
    "heaviside",
    "max",
    "min",
    "rem_euclid",
    "round",
    "saturate",
    "sgn",
    "sign",
    "signum",
    "step",
    "trunc",
];

const ONLY: &str =
    "a formula is made of numbers, names, `+ - * /`, parentheses and functions such as `sin(x)`";

/// Reads an expression; where something is wrong, a number stands in its place.
pub(crate) fn formula(expression: &Expr, grammar: Grammar, errors: &mut Errors) -> Formula {
    let mut arithmetic = Arithmetic { grammar, errors };
    arithmetic.read(expression)
}

/// The value of a literal.
pub(crate) fn number(literal: &Lit) -> syn::Result<Number> {
    let (digits, suffix) = match literal {
        Lit::Int(whole) => (whole.base10_digits().to_owned(), whole.suffix().to_owned()),
        Lit::Float(real) => (real.base10_digits().to_owned(), real.suffix().to_owned()),
        _ => {
            return Err(syn::Error::new_spanned(
                literal,
                "expected a number such as `1.0`",
            ));
        }
    };
    if !matches!(suffix.as_str(), "" | "f64") {
        let message =
            format!("`{digits}{suffix}` is no number; a product is written `{digits} * {suffix}`");
        return Err(syn::Error::new_spanned(literal, message));
    }
    match digits.parse() {
        Ok(value) if f64::is_finite(value) => Ok(Number {
            value,
            source: literal.to_token_stream(),
        }),
        _ => Err(syn::Error::new_spanned(
            literal,
            "this number is too large for an `f64`",
        )),
    }
}

struct Arithmetic<'a> {
    grammar: Grammar,
    errors: &'a mut Errors,
}

impl Arithmetic<'_> {
    fn read(&mut self, expression: &Expr) -> Formula {
        let kind = self.kind(expression);
        let source = expression.to_token_stream();
        Formula { kind, source }
    }

    fn boxed(&mut self, expression: &Expr) -> Box<Formula> {
        Box::new(self.read(expression))
    }

    fn kind(&mut self, expression: &Expr) -> Kind {
        match expression {
            Expr::Lit(ExprLit { lit, .. }) => self.literal(lit),
            Expr::Path(path) => self.path(path),
            Expr::Paren(inner) => Kind::Group(self.boxed(&inner.expr)),
            Expr::Group(inner) => self.kind(&inner.expr),
            Expr::Unary(unary) => self.unary(unary),
            Expr::Binary(binary) => self.binary(binary),
            Expr::Call(call) => self.call(call),
            Expr::MethodCall(call) => self.method(call),
            Expr::If(_) | Expr::Match(_) => self.branch(expression),
            _ => self.refuse(expression, ONLY),
        }
    }

    /// Reports a mistake; the number that stands for it is never expanded.
    fn refuse(&mut self, place: impl ToTokens, message: impl std::fmt::Display) -> Kind {
        self.errors.at(place, message);
        Kind::Number(Number {
            value: 0.0,
            source: quote!(0),
        })
    }

    fn literal(&mut self, literal: &Lit) -> Kind {
        number(literal).map_or_else(|error| self.refuse(literal, error), Kind::Number)
    }

    fn path(&mut self, path: &ExprPath) -> Kind {
        if path.qself.is_some() {
            return self.refuse(path, ONLY);
        }
        match path.path.get_ident() {
            Some(name) => Kind::Name(name.clone()),
            None => Kind::Constant(path.path.clone()),
        }
    }

    fn unary(&mut self, unary: &ExprUnary) -> Kind {
        match unary.op {
            UnOp::Neg(_) => Kind::Minus(self.boxed(&unary.expr)),
            UnOp::Deref(_) => self.refuse(unary, "write a power as `powi(x, 2)`, not with `**`"),
            _ => self.branch(unary),
        }
    }

    fn binary(&mut self, binary: &ExprBinary) -> Kind {
        let operator = match binary.op {
            BinOp::Add(_) => Operator::Add,
            BinOp::Sub(_) => Operator::Subtract,
            BinOp::Mul(_) => Operator::Multiply,
            BinOp::Div(_) => Operator::Divide,
            BinOp::BitXor(_) => return self.exclusive_or(binary),
            BinOp::Rem(_) => return self.kink("%", binary.op),
            BinOp::Lt(_)
            | BinOp::Le(_)
            | BinOp::Gt(_)
            | BinOp::Ge(_)
            | BinOp::Eq(_)
            | BinOp::Ne(_)
            | BinOp::And(_)
            | BinOp::Or(_) => return self.branch(binary),
            _ => return self.refuse(binary, ONLY),
        };
        let (left, right) = (self.boxed(&binary.left), self.boxed(&binary.right));
        Kind::Binary(left, operator, right)
    }

    fn exclusive_or(&mut self, binary: &ExprBinary) -> Kind {
        let (base, exponent) = (last_factor(&binary.left), first_factor(&binary.right));
        let function = if is_whole(exponent) { "powi" } else { "powf" };
        let written = format!("{function}({}, {})", tidy(base), tidy(exponent));
        self.refuse(
            binary.op,
            format!("`^` is exclusive-or in Rust; write a power as `{written}`"),
        )
    }

    fn branch(&mut self, place: impl ToTokens) -> Kind {
        let way_out = match self.grammar {
            Grammar::Model => "put the jump in a `friction` line",
            Grammar::Law => "a law is one formula for all sliding speeds `s > 0`, and one for rest",
        };
        self.refuse(
            place,
            format!(
                "equations must be smooth: a branch has a jump that no switch declares; {way_out}"
            ),
        )
    }

    fn kink(&mut self, name: &str, place: impl ToTokens) -> Kind {
        let message = match self.grammar {
            Grammar::Model => format!(
                "`{name}` is not smooth, and no switch is declared for its kink; \
                 write dry friction as `friction F = Law {{ .. }} opposing speed;`"
            ),
            Grammar::Law => format!(
                "`{name}` is not smooth; a law needs neither magnitude nor sign: \
                 the sliding speed is positive, and the force opposes it"
            ),
        };
        self.refuse(place, message)
    }

    fn call(&mut self, call: &ExprCall) -> Kind {
        let Expr::Path(ExprPath {
            path, qself: None, ..
        }) = call.func.as_ref()
        else {
            return self.refuse(call, "a product is written with `*`");
        };
        let Some(function) = path.get_ident() else {
            let last = path
                .segments
                .last()
                .map(|segment| segment.ident.to_string());
            let short = last.unwrap_or_default();
            return self.refuse(
                path,
                format!("functions have no path in a formula: write `{short}(..)`"),
            );
        };
        let arguments: Vec<Formula> = call
            .args
            .iter()
            .map(|argument| self.read(argument))
            .collect();
        let name = function.to_string();
        match (name.as_str(), arguments.as_slice()) {
            (known, [x]) if FUNCTIONS.contains(&known) => {
                Kind::Call(function.clone(), Box::new(x.clone()))
            }
            ("powi", [base, exponent]) => self.power(base, exponent),
            ("powf", [base, exponent]) => Kind::RealPower(
                function.clone(),
                Box::new(base.clone()),
                Box::new(exponent.clone()),
            ),
            (known, _) if FUNCTIONS.contains(&known) => {
                self.refuse(call, format!("`{known}` takes one argument: `{known}(x)`"))
            }
            ("powi", _) => self.refuse(call, "`powi` takes a base and a whole number: `powi(x, 2)`"),
            ("powf", _) => self.refuse(call, "`powf` takes a base and an exponent: `powf(x, 1.5)`"),
            ("der", _) => self.refuse(
                call,
                "`der` stands only on the left of an equation; a rate is a state or a `let` of its own",
            ),
            (kink, _) if KINKS.contains(&kink) => self.kink(kink, function),
            _ => self.unknown_function(function),
        }
    }

    fn power(&mut self, base: &Formula, exponent: &Formula) -> Kind {
        match whole_number(exponent) {
            Some(whole) => Kind::Power(Box::new(base.clone()), whole),
            None => self.refuse(
                exponent,
                "the exponent of `powi` is a whole number such as 2; other powers are written `powf(x, 1.5)`",
            ),
        }
    }

    fn unknown_function(&mut self, function: &Ident) -> Kind {
        let name = function.to_string();
        let known = FUNCTIONS.into_iter().chain(["powi", "powf"]);
        let advice = match nearest(&name, known) {
            Some(near) => format!("did you mean `{near}`?"),
            None => format!(
                "there are {}, powi and powf; a product is written with `*`",
                FUNCTIONS.join(", ")
            ),
        };
        self.refuse(function, format!("unknown function `{name}`; {advice}"))
    }

    fn method(&mut self, call: &ExprMethodCall) -> Kind {
        let name = call.method.to_string();
        if KINKS.contains(&name.as_str()) {
            return self.kink(&name, &call.method);
        }
        let receiver = tidy(&call.receiver);
        let written: Vec<String> = std::iter::once(receiver.clone())
            .chain(call.args.iter().map(tidy))
            .collect();
        let (given, arguments) = (tidy(call), written.join(", "));
        self.refuse(
            call,
            format!("write functions as in a formula: `{name}({arguments})`, not `{given}`"),
        )
    }
}

/// The exponent `2` or `-2`.
fn whole_number(formula: &Formula) -> Option<i32> {
    match &formula.bare().kind {
        Kind::Number(number) => whole(number.value),
        Kind::Minus(inner) => whole_number(inner).map(|n| -n),
        _ => None,
    }
}

/// A whole number that an exponent may be.
pub(crate) fn whole(value: f64) -> Option<i32> {
    let limit = f64::from(1 << 15);
    #[allow(clippy::cast_possible_truncation)]
    (value.fract() == 0.0 && value.abs() <= limit).then_some(value as i32)
}

/// What a reader takes `^` to bind to on its left: the last factor.
fn last_factor(expression: &Expr) -> &Expr {
    match expression {
        Expr::Binary(binary) => last_factor(&binary.right),
        Expr::Unary(unary) => last_factor(&unary.expr),
        _ => expression,
    }
}

fn first_factor(expression: &Expr) -> &Expr {
    match expression {
        Expr::Binary(binary) => first_factor(&binary.left),
        _ => expression,
    }
}

fn is_whole(expression: &Expr) -> bool {
    matches!(
        expression,
        Expr::Lit(ExprLit {
            lit: Lit::Int(_),
            ..
        })
    )
}

/// An expression as text, for a message.
fn tidy(expression: impl ToTokens) -> String {
    let mut text = expression.to_token_stream().to_string();
    for (spaced, tight) in [
        (" . ", "."),
        (" (", "("),
        ("( ", "("),
        (" )", ")"),
        (" ,", ","),
        (" :: ", "::"),
    ] {
        text = text.replace(spaced, tight);
    }
    for operator in ["+", "-", "*", "/", "="] {
        text = text.replace(&format!("{operator}("), &format!("{operator} ("));
    }
    text
}
