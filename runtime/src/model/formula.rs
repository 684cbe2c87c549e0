//! Formulas as written, read once more to find which part of them is not finite.

/// A part of a formula that is not finite although what it is made of is.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Part {
    /// As written.
    pub(super) text: String,
    /// What it comes to.
    pub(super) value: f64,
    /// What it is made of.
    pub(super) arguments: Vec<f64>,
}

/// The value of a formula, if all of its names have one, or the first part of it that is not finite.
///
/// `None` as well for what is no formula as models have them.
pub(super) fn evaluate(
    text: &str,
    name: &dyn Fn(&str) -> Option<f64>,
) -> Result<Option<f64>, Part> {
    let mut reader = Reader {
        text,
        at: 0,
        name,
        part: None,
    };
    let value = reader.sum();
    let whole = reader.rest().is_empty();
    match reader.part {
        Some(part) => Err(part),
        None => Ok(value.flatten().filter(|_| whole)),
    }
}

/// A value that is known, one that is not, or no formula.
type Read = Option<Option<f64>>;

struct Reader<'a> {
    text: &'a str,
    at: usize,
    name: &'a dyn Fn(&str) -> Option<f64>,
    part: Option<Part>,
}

impl<'a> Reader<'a> {
    fn rest(&mut self) -> &'a str {
        let rest = self.text[self.at..].trim_start();
        self.at = self.text.len() - rest.len();
        rest
    }

    fn take(&mut self, token: char) -> bool {
        let found = self.rest().starts_with(token);
        if found {
            self.at += token.len_utf8();
        }
        found
    }

    /// Notes the part that begins at `from` if it is the first that is not finite.
    fn made(
        &mut self,
        from: usize,
        arguments: &[Option<f64>],
        make: impl Fn(&[f64]) -> f64,
    ) -> Option<f64> {
        let arguments: Vec<f64> = arguments.iter().copied().collect::<Option<_>>()?;
        let value = make(&arguments);
        if value.is_finite() {
            return Some(value);
        }
        if self.part.is_none() {
            self.part = Some(Part {
                text: self.text[from..self.at].trim().to_owned(),
                value,
                arguments,
            });
        }
        None
    }

    fn sum(&mut self) -> Read {
        let from = self.start();
        let mut left = self.product()?;
        loop {
            let sign = if self.take('+') {
                1.0
            } else if self.take('-') {
                -1.0
            } else {
                return Some(left);
            };
            let right = self.product()?;
            left = self.made(from, &[left, right], |both| both[0] + sign * both[1]);
        }
    }

    fn product(&mut self) -> Read {
        let from = self.start();
        let mut left = self.unary()?;
        loop {
            if self.take('*') {
                let right = self.unary()?;
                left = self.made(from, &[left, right], |both| both[0] * both[1]);
            } else if self.take('/') {
                let right = self.unary()?;
                left = self.made(from, &[left, right], |both| both[0] / both[1]);
            } else {
                return Some(left);
            }
        }
    }

    fn unary(&mut self) -> Read {
        if self.take('-') {
            let value = self.unary()?;
            return Some(value.map(|value| -value));
        }
        if self.take('(') {
            let value = self.sum()?;
            return self.take(')').then_some(value);
        }
        let from = self.start();
        let word = self.word()?;
        if word.starts_with(|c: char| c.is_ascii_digit()) {
            return number(word).map(Some);
        }
        if !self.take('(') {
            let constant = word.rsplit("::").next().filter(|_| word.contains("::"));
            return Some(constant.map_or_else(|| (self.name)(word), of_name));
        }
        let mut arguments = vec![self.sum()?];
        while self.take(',') {
            arguments.push(self.sum()?);
        }
        if !self.take(')') {
            return None;
        }
        let function = function(word)?;
        Some(self.made(from, &arguments, |all| {
            function(all[0], all.get(1).copied().unwrap_or(0.0))
        }))
    }

    fn start(&mut self) -> usize {
        self.rest();
        self.at
    }

    /// A name, with its path, or a number, with the sign of its exponent.
    fn word(&mut self) -> Option<&'a str> {
        let rest = self.rest();
        let numeric = rest.starts_with(|c: char| c.is_ascii_digit());
        let mut last = ' ';
        let end = rest.find(|c: char| {
            let signed = numeric && matches!(last, 'e' | 'E') && matches!(c, '+' | '-');
            let inside = c.is_alphanumeric() || c == '_' || c == '#' || signed;
            let more = if numeric { c == '.' } else { c == ':' };
            last = c;
            !(inside || more)
        });
        let word = &rest[..end.unwrap_or(rest.len())];
        self.at += word.len();
        (!word.is_empty()).then_some(word)
    }
}

fn number(word: &str) -> Option<f64> {
    let digits = word.replace('_', "");
    digits.trim_end_matches("f64").parse().ok()
}

fn of_name(constant: &str) -> Option<f64> {
    use std::f64::consts::{E, FRAC_PI_2, FRAC_PI_4, LN_2, PI, SQRT_2, TAU};
    Some(match constant {
        "PI" => PI,
        "TAU" => TAU,
        "E" => E,
        "SQRT_2" => SQRT_2,
        "LN_2" => LN_2,
        "FRAC_PI_2" => FRAC_PI_2,
        "FRAC_PI_4" => FRAC_PI_4,
        _ => return None,
    })
}

fn function(name: &str) -> Option<fn(f64, f64) -> f64> {
    Some(match name {
        "abs" => |x, _| x.abs(),
        "acos" => |x, _| x.acos(),
        "acosh" => |x, _| x.acosh(),
        "asin" => |x, _| x.asin(),
        "asinh" => |x, _| x.asinh(),
        "atan" => |x, _| x.atan(),
        "atanh" => |x, _| x.atanh(),
        "cos" => |x, _| x.cos(),
        "cosh" => |x, _| x.cosh(),
        "exp" => |x, _| x.exp(),
        "ln" => |x, _| x.ln(),
        "powf" | "powi" => f64::powf,
        "sign" => |x, _| if x == 0.0 { 0.0 } else { x.signum() },
        "sin" => |x, _| x.sin(),
        "sinh" => |x, _| x.sinh(),
        "sqrt" => |x, _| x.sqrt(),
        "tan" => |x, _| x.tan(),
        "tanh" => |x, _| x.tanh(),
        _ => return None,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(text: &str) -> Result<Option<f64>, Part> {
        evaluate(text, &|name| match name {
            "x" => Some(2.0),
            "v" => Some(0.0),
            "w" => Some(-3.0),
            _ => None,
        })
    }

    #[test]
    fn formulas_come_to_what_they_say() {
        for (text, value) in [
            ("-x * x + 3 * (x - 1e-1) / 2.0f64", -4.0 + 1.5 * 1.9),
            ("powi(w, 2) - powf(x, -1.0)", 8.5),
            ("2.5e+1 - -x - 1_000.0", -973.0),
            ("sin(std::f64::consts::PI / 2.0)", 1.0),
            ("abs(w) + sign(w) - sign(v)", 2.0),
        ] {
            let found = told(text).unwrap().unwrap();
            assert!((found - value).abs() < 1e-12, "{text}: {found}");
        }
        assert_eq!(told("x + F / v"), Ok(None), "F is not known");
        assert_eq!(told("x +"), Ok(None));
        assert_eq!(told("as the law of F says"), Ok(None));
    }

    #[test]
    fn the_first_part_that_is_not_finite_is_found() {
        for (text, part, arguments) in [
            ("x + ln(v / x) * w", "ln(v / x)", vec![0.0]),
            ("3 * sqrt(w + 1) - x / v", "sqrt(w + 1)", vec![-2.0]),
            (
                "(x - 1) / (v * w) + 1",
                "(x - 1) / (v * w)",
                vec![1.0, -0.0],
            ),
            ("powf(w, 0.5)", "powf(w, 0.5)", vec![-3.0, 0.5]),
            ("exp(400 * x)", "exp(400 * x)", vec![800.0]),
            ("F * ln(v)", "ln(v)", vec![0.0]),
        ] {
            let found = told(text).unwrap_err();
            assert_eq!(
                (found.text.as_str(), found.arguments),
                (part, arguments),
                "{text}"
            );
        }
    }
}
