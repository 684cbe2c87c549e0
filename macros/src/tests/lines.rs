use super::{NONE, of_belt, of_law, of_model};
use crate::parse::Grammar;

#[test]
fn a_line_begins_with_a_keyword() {
    assert_eq!(
        of_belt("param k", "parm k"),
        ["`parm` does not begin a line; did you mean `param`?"]
    );
    assert_eq!(
        of_belt("param k", "constant k"),
        [
            "`constant` does not begin a line; a number that does not change is a `param`: `param g: m/s^2 = 9.81;`"
        ]
    );
    assert_eq!(
        of_belt("let stretched", "stretched"),
        ["`stretched` does not begin a line; \
          write `der(stretched) = ...;` for an equation, `let stretched = ...;` for an abbreviation"]
    );
    assert_eq!(
        of_law("stick = 1.0; slip(s) = 1.0; (3)"),
        [
            "`(` does not begin a line; a line begins with `param`, `let`, `stick`, `slip`, `state`, `der`, `stop` or `force`"
        ]
    );
}

#[test]
fn a_missing_semicolon_is_found_where_the_next_line_begins() {
    let missing = |next| {
        [format!(
            "missing `;` at the end of the line before `{next}`"
        )]
    };
    assert_eq!(of_belt("k > 0.0;", "k > 0.0"), missing("param"));
    assert_eq!(of_belt("der(x) = v;", "der(x) = v"), missing("der"));
    assert_eq!(of_belt("k * x;", "k * x"), missing("der"));
    assert_eq!(of_belt("v - v_dr;", "v - v_dr"), missing("let"));
    assert_eq!(
        of_belt("v_dr: m/s = 0.2;", "v_dr: m/s = 0.2 /** Limit. */"),
        missing("param")
    );
    assert_eq!(
        of_belt("/ mass;", "/ mass"),
        ["missing `;` at the end of this line"]
    );
}

#[test]
fn a_broken_line_shows_the_form_it_should_have() {
    assert_eq!(
        of_belt("k: N/m = 1.0", "k: N/m 1.0"),
        ["expected `=` before `1.0`; the line has the form `param k: N/m = 1.0 where k > 0.0;`"]
    );
    assert_eq!(
        of_belt("opposing v", "against v"),
        ["what `F` depends on follows `opposing`, not `against`: write `opposing v - v_belt`"]
    );
    assert_eq!(
        of_belt("der(x) = v;", "der(x, v) = v;"),
        ["`,` follows `x`, and between these parentheses stands one name"]
    );
    assert_eq!(
        of_belt("param v_dr: m/s = 0.2", "param v_dr = 0.2 m/s"),
        ["expected `;` before `m`, or `*` if a product is meant; \
          the line has the form `param k: N/m = 1.0 where k > 0.0;`"]
    );
}

#[test]
fn what_a_broken_line_declares_is_known() {
    assert_eq!(of_belt("param k: N/m = 1.0", "param k: N/m = one").len(), 1);
    assert_eq!(of_belt("friction F: N =", "friction F: N").len(), 1);
    assert_eq!(of_belt("let stretched =", "let stretched").len(), 1);
    assert_eq!(of_belt("state v: m/s =", "state v: m/s").len(), 1);
    assert_eq!(of_belt("der(v) =", "der(v)").len(), 1);
}

#[test]
fn only_declarations_are_documented() {
    assert_eq!(
        of_belt("der(x)", "/** Rate. */ der(x)"),
        ["a doc comment describes what a line declares, and this line declares nothing: use `//`"]
    );
    assert_eq!(
        of_belt("let stretched", "/** Force. */ let stretched"),
        NONE
    );
    assert_eq!(
        of_belt("param k", "#[cfg(test)] param k"),
        [
            "`#[cfg]` has no meaning here: only doc comments (`///`) may stand before what is declared; remove it"
        ]
    );
}

#[test]
fn laws_have_no_defaults_and_models_have() {
    assert_eq!(
        of_law("param a: N = 1.0; stick = a; slip(s) = a;"),
        ["a law's parameter has no default: a model gives `a` its value where it names the law"]
    );
    assert_eq!(
        of_belt("v_dr: m/s = 0.2", "v_dr: m/s"),
        [
            "expected `=` and a value before `;`; the line has the form `param k: N/m = 1.0 where k > 0.0;`"
        ]
    );
}

#[test]
fn one_macro_declares_one_struct() {
    let declared = |text| super::messages(text, Grammar::Model);
    assert_eq!(
        declared("enum M {}"),
        ["`enum` declares nothing here: write `pub struct Name { ... }`"]
    );
    assert_eq!(
        declared("struct M { state x = 1.0; der(x) = -x; } struct N {}"),
        [
            "`struct` follows the closing brace: one declaration each, and nothing after it; remove it"
        ]
    );
    assert_eq!(
        of_model(""),
        ["model `M` has no state: add `state x = 1.0;`"]
    );
}

#[test]
fn what_belongs_elsewhere_is_shown_the_way() {
    let first = |told: Vec<String>| told.first().cloned().unwrap_or_default();
    for (text, replacement, way) in [
        (
            "state v: m/s = 0.0",
            "pub state v: m/s = 0.0",
            "is public without it",
        ),
        (
            "state v: m/s = 0.0",
            "state v, w: m/s = 0.0",
            "a line of its own",
        ),
        (
            "state v: m/s = 0.0",
            "state v: m/s = v_dr",
            "not the name `v_dr`",
        ),
        (
            "state v: m/s",
            "state v: m/s^0.5",
            "is a whole number, as in `m^2`, or a fraction",
        ),
        ("der(x) = v;", "der(x) == v;", "by one `=`"),
        ("der(v) =", "der(der(x)) =", "are of first order"),
        ("let stretched", "let mut stretched", "remove it"),
        (
            "opposing v - v_dr",
            "opposing v_dr - 1.0",
            "would never start or stop",
        ),
    ] {
        let told = first(of_belt(text, replacement));
        assert!(told.contains(way), "{replacement}: {told}");
    }
    let told = first(of_model("stick = 1.0;"));
    assert_eq!(
        told,
        "`stick` does not begin a line; it belongs to `friction_law!`"
    );
    let told = first(of_law("der(z) = w; friction = 1.0;"));
    assert_eq!(
        told,
        "`friction` does not begin a line; it belongs to `model!`"
    );
}
