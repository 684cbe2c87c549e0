//! From Rust expressions to formulas: numbers, names, arithmetic and smooth functions.

mod index;
mod number;
mod point;
mod refusal;

use proc_macro2::Ident;
use quote::ToTokens;
use syn::{BinOp, Expr, ExprBinary, ExprCall, ExprIndex, ExprLit, ExprPath, ExprUnary, Lit, UnOp};

pub(crate) use self::index::index;
pub(crate) use self::number::{number, whole};

use crate::errors::Errors;
use crate::formula::{Formula, Kind, Operator};
use crate::parse::Grammar;
use crate::repeated::Repeated;
use crate::structure::Structures;

type Function = (&'static str, fn(f64) -> f64);

/// The functions of one argument.
const FUNCTIONS: [Function; 15] = [
    ("acos", f64::acos),
    ("acosh", f64::acosh),
    ("asin", f64::asin),
    ("asinh", f64::asinh),
    ("atan", f64::atan),
    ("atanh", f64::atanh),
    ("cos", f64::cos),
    ("cosh", f64::cosh),
    ("exp", f64::exp),
    ("ln", f64::ln),
    ("sin", f64::sin),
    ("sinh", f64::sinh),
    ("sqrt", f64::sqrt),
    ("tan", f64::tan),
    ("tanh", f64::tanh),
];

/// Functions with a kink, for laws with internal state.
pub(crate) const CORNERS: [&str; 2] = ["abs", "sign"];

/// The value of a function of one argument.
pub(crate) fn apply(function: &Ident, x: f64) -> f64 {
    match FUNCTIONS.iter().find(|(name, _)| function == name) {
        Some((_, value)) => value(x),
        None if function == "sign" => 1.0_f64.copysign(x),
        None => x.abs(),
    }
}

const WHOLE: &str = "the exponent of `powi` is a whole number such as 2; \
     other powers are written `powf(x, 1.5)`";

/// Reads expressions; where something is wrong, a number stands in its place.
pub(crate) struct Arithmetic<'a> {
    pub(crate) grammar: Grammar,
    pub(crate) repeated: &'a mut Repeated,
    pub(crate) structures: &'a Structures,
    pub(crate) errors: &'a mut Errors,
}

impl Arithmetic<'_> {
    pub(crate) fn read(&mut self, expression: &Expr) -> Formula {
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
            Expr::Group(inner) => self.pasted(&inner.expr),
            Expr::Unary(unary) => self.unary(unary),
            Expr::Binary(binary) => self.binary(binary),
            Expr::Call(call) => self.call(call),
            Expr::MethodCall(call) => self.method(call),
            Expr::Index(element) => self.element(element),
            Expr::Field(field) => self.point(field),
            Expr::If(_) | Expr::Match(_) => self.branch(expression),
            _ => self.foreign(expression),
        }
    }

    fn literal(&mut self, literal: &Lit) -> Kind {
        match literal {
            Lit::Int(_) | Lit::Float(_) => match number(literal) {
                Ok(number) => Kind::Number(number),
                Err(error) => self.refuse(literal, error),
            },
            _ => self.no_formula(literal),
        }
    }

    /// What another macro has pasted binds as if it stood in parentheses.
    fn pasted(&mut self, expression: &Expr) -> Kind {
        match expression {
            Expr::Binary(_) | Expr::Unary(_) => Kind::Group(self.boxed(expression)),
            _ => self.kind(expression),
        }
    }

    fn path(&mut self, path: &ExprPath) -> Kind {
        if path.qself.is_some() {
            return self.no_formula(path);
        }
        match path.path.get_ident() {
            Some(name) => Kind::Name(name.clone()),
            None => Kind::Constant(path.path.clone()),
        }
    }

    /// `x[i + 1]`
    fn element(&mut self, element: &ExprIndex) -> Kind {
        let Expr::Path(ExprPath {
            path, qself: None, ..
        }) = element.expr.as_ref()
        else {
            return self.no_formula(element);
        };
        let Some(array) = path.get_ident() else {
            return self.no_formula(element);
        };
        match index(&element.index) {
            Ok(index) => Kind::Name(self.repeated.element(array, index, false)),
            Err(error) => {
                self.errors.add(error);
                self.refused()
            }
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
            _ => return self.no_formula(binary),
        };
        let (left, right) = (self.boxed(&binary.left), self.boxed(&binary.right));
        Kind::Binary(left, operator, right)
    }

    fn call(&mut self, call: &ExprCall) -> Kind {
        let Expr::Path(ExprPath {
            path, qself: None, ..
        }) = call.func.as_ref()
        else {
            return self.refuse(call, "a product is written with `*`");
        };
        let Some(function) = path.get_ident() else {
            return self.path_of_function(path);
        };
        if let Some(speed) = self.speed(function, call) {
            return speed;
        }
        let arguments: Vec<Formula> = call.args.iter().map(|given| self.read(given)).collect();
        match arguments.as_slice() {
            [x] if self.knows(function) => Kind::Call(function.clone(), Box::new(x.clone())),
            [base, exponent] if function == "powi" => self.power(base, exponent),
            [base, exponent] if function == "powf" => {
                let (base, exponent) = (Box::new(base.clone()), Box::new(exponent.clone()));
                Kind::RealPower(function.clone(), base, exponent)
            }
            _ => self.wrong_call(call, function),
        }
    }

    /// Whether this is a function of one argument here.
    fn knows(&self, function: &Ident) -> bool {
        let corner = self.grammar == Grammar::Memory && CORNERS.iter().any(|name| function == name);
        corner || FUNCTIONS.iter().any(|(name, _)| function == name)
    }

    fn power(&mut self, base: &Formula, exponent: &Formula) -> Kind {
        match exponent.literal().and_then(whole) {
            Some(whole) => Kind::Power(Box::new(base.clone()), whole),
            None => self.refuse(exponent, WHOLE),
        }
    }
}
