//! What is not a formula, and how to write it instead.

use proc_macro2::Ident;
use quote::{ToTokens, quote};
use syn::{Expr, ExprBinary, ExprCall, ExprLit, ExprMethodCall, Lit, Path};

use super::{Arithmetic, FUNCTIONS};
use crate::formula::{Kind, Number, last_word};
use crate::parse::Grammar;
use crate::suggest::nearest;

/// Functions that people write, and that have a corner or a jump.
pub(super) const KINKS: [&str; 17] = [
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

/// What other languages call our functions.
const SYNONYMS: [(&str, &str); 10] = [
    ("arccos", "acos(x)"),
    ("arcsin", "asin(x)"),
    ("arctan", "atan(x)"),
    ("cbrt", "powf(x, 1.0 / 3.0)"),
    ("log", "ln(x)"),
    ("log10", "ln(x) / ln(10.0)"),
    ("log2", "ln(x) / ln(2.0)"),
    ("pow", "powi(x, 2)` or `powf(x, 1.5)"),
    ("recip", "1.0 / x"),
    ("square", "powi(x, 2)"),
];

/// Those that people write for dry friction.
const JUMPS: [&str; 7] = [
    "copysign",
    "heaviside",
    "sgn",
    "sign",
    "signum",
    "step",
    "saturate",
];

/// What comes near a function with a corner.
fn smooth(name: &str) -> &'static str {
    match name {
        "abs" => "`sqrt(powi(x, 2) + powi(e, 2))` comes near |x| for a small e",
        "max" => {
            "`(x + sqrt(powi(x, 2) + powi(e, 2))) / 2` comes near the larger of x and 0 for a small e"
        }
        "min" => {
            "`(x - sqrt(powi(x, 2) + powi(e, 2))) / 2` comes near the smaller of x and 0 for a small e"
        }
        _ => {
            "write what comes near it smoothly, as `sqrt(powi(x, 2) + powi(e, 2))` comes near |x| for a small e"
        }
    }
}

const DER: &str = "`der` stands only on the left of an equation; \
     use what stands on the right of that equation, or give it a name with `let`";

impl Arithmetic<'_> {
    /// Reports a mistake; the number that stands for it is never expanded.
    pub(super) fn refuse(&mut self, place: impl ToTokens, message: impl std::fmt::Display) -> Kind {
        self.errors.at(place, message);
        self.refused()
    }

    /// What stands for a mistake that is reported.
    pub(super) fn refused(&self) -> Kind {
        Kind::Number(Number {
            value: 0.0,
            source: quote!(0),
        })
    }

    /// What formulas of other languages hold, and ours do not.
    pub(super) fn foreign(&mut self, expression: &Expr) -> Kind {
        let (written, way_out) = match expression {
            Expr::Closure(_) => return self.kink("abs", expression),
            Expr::Cast(cast) => {
                let inner = tidy(bare(&cast.expr));
                (
                    tidy(expression),
                    format!("every number is an `f64`, so write `{inner}`"),
                )
            }
            Expr::Block(_) => (tidy(expression), "write `( .. )`, not `{ .. }`".to_owned()),
            Expr::Array(_) => (tidy(expression), "write `( .. )`, not `[ .. ]`".to_owned()),
            Expr::Reference(reference) => {
                let inner = tidy(bare(&reference.expr));
                (tidy(expression), format!("write `{inner}`, without `&`"))
            }
            _ => return self.no_formula(expression),
        };
        self.refuse(expression, format!("`{written}` is no formula: {way_out}"))
    }

    pub(super) fn no_formula(&mut self, place: impl ToTokens) -> Kind {
        let written = tidy(&place);
        self.refuse(
            place,
            format!(
                "`{written}` is no formula: that is made of numbers, names, `+ - * /`, parentheses and functions such as \
                 `sin(x)`"
            ),
        )
    }

    pub(super) fn exclusive_or(&mut self, binary: &ExprBinary) -> Kind {
        let (base, exponent) = (bare(last_factor(&binary.left)), first_factor(&binary.right));
        let function = if is_whole(exponent) { "powi" } else { "powf" };
        let written = format!("{function}({}, {})", tidy(base), tidy(exponent));
        self.refuse(
            binary.op,
            format!("`^` is exclusive-or in Rust; write a power as `{written}`"),
        )
    }

    pub(super) fn branch(&mut self, place: impl ToTokens) -> Kind {
        let way_out = match self.grammar {
            Grammar::Model => {
                "a jump of dry friction is a `friction` line, a wall or a gap is a `press` line: \
                 `press N = Law { .. } closing gap;`"
            }
            Grammar::Press => {
                "a law of presses is one formula for all depths; that it never pulls is seen to where it is used"
            }
            Grammar::Law => "a law is one formula for all sliding speeds `s > 0`, and one for rest",
            Grammar::Memory => {
                "`abs(x)` and `sign(x)` may stand in a law with internal state, and their kinks are declared by that"
            }
        };
        self.refuse(
            place,
            format!(
                "equations must be smooth: a branch has a jump that no switch declares; {way_out}"
            ),
        )
    }

    pub(super) fn kink(&mut self, name: &str, place: impl ToTokens) -> Kind {
        let message = match self.grammar {
            Grammar::Model if JUMPS.contains(&name) => format!(
                "`{name}` is not smooth, and no switch is declared for its jump; \
                 write dry friction as `friction F = Law {{ .. }} opposing speed;`, a wall or a gap as \
                 `press N = Law {{ .. }} closing gap;`"
            ),
            Grammar::Model => format!(
                "`{name}` is not smooth, and no switch is declared for its kink; dry friction is a `friction` line, \
                 a wall or a gap is a `press` line: `press N = Law {{ .. }} closing gap;`; elsewhere {}",
                smooth(name)
            ),
            Grammar::Press => format!(
                "`{name}` is not smooth; a law of presses needs no largest and no magnitude: \
                 the depth is positive, and that the force never pulls is seen to where the law is used"
            ),
            Grammar::Law => format!(
                "`{name}` is not smooth; a law needs neither magnitude nor sign: \
                 the sliding speed is positive, and the force opposes it"
            ),
            Grammar::Memory => format!(
                "`{name}` is not known here; write it with `abs`, whose kinks are found: \
                 the larger of x and y is `(x + y + abs(x - y)) / 2`, the sign of the speed `w` is `sign(w)`"
            ),
        };
        self.refuse(place, message)
    }

    pub(super) fn path_of_function(&mut self, path: &Path) -> Kind {
        let name = last_word(path);
        self.refuse(
            path,
            format!("functions have no path in a formula: write `{name}(x)`"),
        )
    }

    /// A function with too few or too many arguments, or no function of ours.
    pub(super) fn wrong_call(&mut self, call: &ExprCall, function: &Ident) -> Kind {
        let name = function.to_string();
        match name.as_str() {
            known if FUNCTIONS.iter().any(|(name, _)| *name == known) => {
                self.refuse(call, format!("`{known}` takes one argument: `{known}(x)`"))
            }
            "powi" => self.refuse(call, "`powi` takes a base and a whole number: `powi(x, 2)`"),
            "powf" => self.refuse(call, "`powf` takes a base and an exponent: `powf(x, 1.5)`"),
            "abs" | "sign" if self.grammar == Grammar::Memory => {
                self.refuse(call, format!("`{name}` takes one argument: `{name}(x)`"))
            }
            "der" => self.refuse(call, DER),
            kink if KINKS.contains(&kink) => self.kink(kink, function),
            _ => self.unknown_function(function),
        }
    }

    fn unknown_function(&mut self, function: &Ident) -> Kind {
        let name = function.to_string();
        let known = FUNCTIONS.into_iter().map(|(name, _)| name);
        let known = known.chain(["powi", "powf"]);
        let advice = match SYNONYMS.iter().find(|(other, _)| *other == name) {
            Some((_, ours)) => format!("write `{ours}`"),
            None => match nearest(&name, known.clone()) {
                Some(near) => format!("did you mean `{near}`?"),
                None => {
                    let known: Vec<&str> = known.collect();
                    let known = known.join(", ");
                    format!("a product is written with `*`, and the functions are {known}")
                }
            },
        };
        self.refuse(function, format!("unknown function `{name}`; {advice}"))
    }

    pub(super) fn method(&mut self, call: &ExprMethodCall) -> Kind {
        let name = call.method.to_string();
        if KINKS.contains(&name.as_str()) {
            return self.kink(&name, &call.method);
        }
        let operands = std::iter::once(call.receiver.as_ref()).chain(&call.args);
        let operands: Vec<String> = operands.map(|operand| tidy(bare(operand))).collect();
        let (given, arguments) = (tidy(call), operands.join(", "));
        self.refuse(
            call,
            format!("write functions as in a formula: `{name}({arguments})`, not `{given}`"),
        )
    }
}

/// An expression without the parentheses around it.
fn bare(expression: &Expr) -> &Expr {
    match expression {
        Expr::Paren(inner) => bare(&inner.expr),
        _ => expression,
    }
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
