//! Formulas as MathML, for the pages of `cargo doc`.

use proc_macro2::Ident;
use syn::Path;
use syn::ext::IdentExt;

use crate::formula::{Formula, Kind, Operator, last_word};
use crate::symbol::symbol;

const TIMES: &str = "<mo>&#x2062;</mo><mspace width=\"0.17em\"/>";

/// A formula inside a line of text.
pub(super) fn inline(formula: &Formula) -> String {
    format!("<math>{}</math>", row(formula))
}

/// Equations one below the other, their signs aligned.
pub(super) fn aligned(equations: impl Iterator<Item = (String, String)>) -> String {
    let cell = |side: &str, content: &str| {
        format!("<mtd style=\"text-align:{side};padding:0.45em 0.2em\">{content}</mtd>")
    };
    let rows = equations.map(|(left, right)| {
        let sign = cell("center", "<mo>=</mo>");
        format!(
            "<mtr>{}{sign}{}</mtr>",
            cell("right", &left),
            cell("left", &right)
        )
    });
    format!(
        "<div style=\"overflow-y:hidden;padding:0.2em 0\"><math display=\"block\" style=\"font-size:112%\">\
         <mtable displaystyle=\"true\">{}</mtable></math></div>",
        rows.collect::<String>()
    )
}

/// The derivative of a state: a dot above a symbol, a quotient for a word.
pub(super) fn derivative(state: &Ident) -> String {
    let name = state.unraw().to_string();
    match symbol(&name) {
        Some((letter, index)) => {
            let dotted =
                format!("<mover accent=\"true\"><mi>{letter}</mi><mo>&#x02D9;</mo></mover>");
            indexed(&dotted, &index)
        }
        None => format!(
            "<mfrac><mrow><mi>d</mi>{}</mrow><mrow><mi>d</mi><mi>t</mi></mrow></mfrac>",
            word(&name)
        ),
    }
}

/// A name: a letter, perhaps Greek, with its index; or a word.
pub(super) fn name(name: &Ident) -> String {
    let name = name.unraw().to_string();
    match symbol(&name) {
        Some((letter, index)) => indexed(&format!("<mi>{letter}</mi>"), &index),
        None => word(&name),
    }
}

/// A function of ours at an argument, as `slip(s)`.
pub(super) fn applied(function: &str, argument: &str) -> String {
    format!("<mi>{function}</mi><mo>&#x2061;</mo><mo>(</mo>{argument}<mo>)</mo>")
}

fn word(name: &str) -> String {
    format!("<mi>{name}</mi>")
}

fn indexed(base: &str, index: &str) -> String {
    if index.is_empty() {
        return base.to_owned();
    }
    let tag = if index.chars().all(|c| c.is_ascii_digit()) {
        "mn"
    } else {
        "mi"
    };
    format!("<msub>{base}<{tag}>{index}</{tag}></msub>")
}

/// A formula as one row.
pub(super) fn row(formula: &Formula) -> String {
    match &formula.kind {
        Kind::Number(number) => numeral(&number.to_string()),
        Kind::Constant(path) => constant(path),
        Kind::Name(ident) => name(ident),
        Kind::Group(inner) => fenced(inner),
        Kind::Minus(inner) => format!("<mo form=\"prefix\">−</mo>{}", row(inner)),
        Kind::Binary(left, operator, right) => binary(left, *operator, right),
        Kind::Call(function, argument) => call(&function.to_string(), argument),
        Kind::Power(base, exponent) => power(base, &numeral(&exponent.to_string())),
        Kind::RealPower(_, base, exponent) => power(base, &row(exponent.bare())),
    }
}

/// A number as one writes it: `2` for `2.0`, a true minus sign.
fn numeral(text: &str) -> String {
    let text = text.strip_suffix(".0").unwrap_or(text);
    match text.strip_prefix('-') {
        Some(magnitude) => format!("<mo form=\"prefix\">−</mo><mn>{magnitude}</mn>"),
        None => format!("<mn>{text}</mn>"),
    }
}

fn constant(path: &Path) -> String {
    match last_word(path).as_str() {
        "PI" => "<mi>π</mi>".to_owned(),
        "TAU" => "<mn>2</mn><mi>π</mi>".to_owned(),
        "E" => "<mi>e</mi>".to_owned(),
        other => word(other),
    }
}

fn fenced(formula: &Formula) -> String {
    format!("<mrow><mo>(</mo>{}<mo>)</mo></mrow>", row(formula.bare()))
}

fn binary(left: &Formula, operator: Operator, right: &Formula) -> String {
    if operator == Operator::Divide {
        let (above, below) = (row(left.bare()), row(right.bare()));
        return format!("<mfrac><mrow>{above}</mrow><mrow>{below}</mrow></mfrac>");
    }
    let right_side = if matches!(right.kind, Kind::Minus(_)) {
        fenced(right)
    } else {
        row(right)
    };
    let sign = match operator {
        Operator::Add => "<mo>+</mo>",
        Operator::Subtract => "<mo>−</mo>",
        _ if begins_with_digit(right) => "<mo>⋅</mo>",
        _ => TIMES,
    };
    format!("{}{sign}{right_side}", row(left))
}

fn begins_with_digit(formula: &Formula) -> bool {
    match &formula.kind {
        Kind::Number(_) => true,
        Kind::Binary(left, operator, _) => *operator != Operator::Divide && begins_with_digit(left),
        Kind::Power(base, _) | Kind::RealPower(_, base, _) => begins_with_digit(base),
        _ => false,
    }
}

fn call(function: &str, argument: &Formula) -> String {
    let inside = row(argument.bare());
    match function {
        "abs" => {
            format!("<mrow><mo stretchy=\"true\">|</mo>{inside}<mo stretchy=\"true\">|</mo></mrow>")
        }
        "sign" => applied("sgn", &inside),
        "sqrt" => format!("<msqrt>{inside}</msqrt>"),
        // A fraction would be too small to read up there.
        "exp" if !divides(argument) => format!("<msup><mi>e</mi><mrow>{inside}</mrow></msup>"),
        _ => applied(function, &inside),
    }
}

fn divides(formula: &Formula) -> bool {
    matches!(formula.kind, Kind::Binary(_, Operator::Divide, _))
        || formula.parts().into_iter().any(divides)
}

fn power(base: &Formula, exponent: &str) -> String {
    let plain = matches!(
        base.kind,
        Kind::Number(_) | Kind::Constant(_) | Kind::Name(_) | Kind::Group(_)
    );
    let base = if plain { row(base) } else { fenced(base) };
    format!("<msup><mrow>{base}</mrow><mrow>{exponent}</mrow></msup>")
}

#[cfg(test)]
mod tests {
    use proc_macro2::Span;

    use super::*;

    fn named(text: &str) -> String {
        name(&Ident::new(text, Span::call_site()))
    }

    #[test]
    fn letters_have_indices_and_words_stay_words() {
        assert_eq!(named("x"), "<mi>x</mi>");
        assert_eq!(named("F_s"), "<msub><mi>F</mi><mi>s</mi></msub>");
        assert_eq!(named("x1"), "<msub><mi>x</mi><mn>1</mn></msub>");
        assert_eq!(named("omega"), "<mi>ω</mi>");
        assert_eq!(named("Delta_max"), "<msub><mi>Δ</mi><mi>max</mi></msub>");
        assert_eq!(named("static_level"), "<mi>static_level</mi>");
    }

    #[test]
    fn derivatives_are_dotted_or_quotients() {
        let of = |text| derivative(&Ident::new(text, Span::call_site()));
        assert!(of("psi").contains("<mi>ψ</mi><mo>&#x02D9;</mo>"));
        assert!(of("angle").starts_with("<mfrac><mrow><mi>d</mi><mi>angle</mi>"));
    }

    #[test]
    fn numbers_are_short() {
        assert_eq!(numeral("2.0"), "<mn>2</mn>");
        assert_eq!(numeral("-0.5"), "<mo form=\"prefix\">−</mo><mn>0.5</mn>");
    }
}
