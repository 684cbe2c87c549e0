use proc_macro2::{Group, TokenStream, TokenTree};
use quote::{ToTokens, quote};

use crate::arithmetic::Arithmetic;
use crate::errors::Errors;
use crate::expand::lifted;
use crate::parse::Grammar;
use crate::repeated::Repeated;
use crate::structure::Structures;

/// A formula as it is lifted, and as it is written in the data of a model.
fn both(written: &str) -> (String, String) {
    let expression = syn::parse_str(written).expect("the test is an expression");
    let mut errors = Errors::new();
    let mut arithmetic = Arithmetic {
        grammar: Grammar::Model,
        repeated: &mut Repeated::default(),
        structures: &Structures::default(),
        errors: &mut errors,
    };
    let formula = arithmetic.read(&expression);
    errors.finish().expect("the test is a formula");
    (lifted(&formula).to_string(), formula.to_string())
}

fn assert_lifted(written: &str, expected: &str) {
    let expected: proc_macro2::TokenStream = expected.parse().expect("the test is made of tokens");
    assert_eq!(both(written).0, expected.to_string(), "{written}");
}

#[test]
fn constants_meet_scalars_unlifted() {
    assert_lifted("2 * zeta", "zeta * 2f64");
    assert_lifted("x - 1", "x - 1f64");
    assert_lifted("1 + x", "x + 1f64");
    assert_lifted("1 - x", "-x + 1f64");
    assert_lifted("1 - (x - y)", "-(x - y) + 1f64");
    assert_lifted("1 - x * y", "-x * y + 1f64");
    assert_lifted("1 - -x", "-(-x) + 1f64");
    assert_lifted("1 / x", "D::from(1f64) / x");
    assert_lifted("-2 * zeta * omega", "zeta * -2f64 * omega");
    assert_lifted("2 * 3 * x", "x * (2f64 * 3f64)");
    assert_lifted("3", "D::from(3f64)");
}

#[test]
fn parentheses_are_written_only_where_needed() {
    assert_lifted("(x)", "x");
    assert_lifted("((x + y))", "x + y");
    assert_lifted("sin((x + y))", "::stickslip::math::sin(x + y)");
    assert_lifted("x * (y + 1)", "x * (y + 1f64)");
    assert_lifted("x - (y - 1)", "x - (y - 1f64)");
    assert_lifted("x / (y * z)", "x / (y * z)");
    assert_lifted("(x * y) / z", "x * y / z");
    assert_lifted("-(x * y)", "-x * y");
    assert_lifted("-(x + y)", "-(x + y)");
    assert_lifted("x - (-y)", "x - -y");
}

#[test]
fn whole_powers_are_products_of_squares() {
    assert_lifted(
        "powi(x, 2)",
        "{ let __power_1 = x; let __power_2 = __power_1 * __power_1; __power_2 }",
    );
    assert_lifted("powf(x, 1.0)", "x");
    assert_lifted("powi(x, 0)", "D::from(1f64)");
    assert_lifted(
        "powi(x + y, -3)",
        "{ let __power_1 = x + y; let __power_2 = __power_1 * __power_1; __power_1 * __power_2 }.recip()",
    );
}

#[test]
fn real_powers_depend_on_what_is_constant() {
    assert_lifted("powf(x, 1.5)", "::stickslip::math::power(x, 1.5f64)");
    assert_lifted("powf(x, y)", "::stickslip::math::powf(x, y)");
    assert_lifted("powf(2, y)", "::stickslip::math::powf(D::from(2f64), y)");
}

#[test]
fn formulas_are_shown_as_written() {
    for (written, shown) in [
        ("(F-k*x)/m", "(F - k * x) / m"),
        ("-2*zeta*omega - psi+T_c", "-2 * zeta * omega - psi + T_c"),
        ("limit/(1.0+decay*s)", "limit / (1.0 + decay * s)"),
        ("powi( x ,2 )*sin(y)", "powi(x, 2) * sin(y)"),
        (
            "std::f64::consts::PI*powf(x,-0.5)",
            "std::f64::consts::PI * powf(x, -0.5)",
        ),
    ] {
        assert_eq!(both(written).1, shown);
    }
}

#[test]
fn a_stub_stands_beside_errors() {
    let tokens = crate::expand::model(quote! {
        pub struct Belt { state x = 1.0; param k: N/m = one; param k = 2.0; der(x) = -kk * x; }
    });
    let file: syn::File = syn::parse2(tokens).expect("stubs are items");
    let items: Vec<String> = file
        .items
        .iter()
        .map(|item| item.to_token_stream().to_string())
        .collect();
    let begins = |text: &str| items.iter().filter(|item| item.contains(text)).count();
    assert_eq!(begins("compile_error"), 3);
    assert_eq!(begins("struct Belt"), 1);
    assert_eq!(begins("const k :"), 1);
    assert_eq!(begins("Model < 1 > for Belt"), 1);
}

/// Each binding is a scope within that of the last one: some thousands of them overflow a compiler's stack.
#[test]
fn few_bindings_stand_within_each_other_however_many_states() {
    let tokens = crate::expand::model(quote! {
        pub struct Row {
            state x[60] = 1.0;
            param k = 1.0;
            for i in 0..60 { der(x[i]) = -k * sin(x[i]) * powi(x[i], 3); }
        }
    });
    let file: syn::File = syn::parse2(tokens).expect("a model is items");
    let functions = file.items.iter().filter_map(|item| match item {
        syn::Item::Impl(one) => Some(&one.items),
        _ => None,
    });
    let functions = functions.flatten().filter_map(|item| match item {
        syn::ImplItem::Fn(function) => Some(&function.block),
        _ => None,
    });
    let deepest = functions.map(depth).max();
    assert!(
        deepest.is_some_and(|deepest| (60..100).contains(&deepest)),
        "{deepest:?}"
    );
}

/// How many bindings stand within each other at most.
fn depth(block: &syn::Block) -> usize {
    let (mut bound, mut most) = (0, 0);
    for statement in &block.stmts {
        let syn::Stmt::Local(local) = statement else {
            continue;
        };
        bound += 1;
        if let Some(syn::LocalInit { expr, .. }) = &local.init
            && let syn::Expr::Block(inner) = &**expr
        {
            most = most.max(bound + depth(&inner.block));
        }
    }
    most.max(bound)
}

/// The tokens with one of them left out, or struck twice, at any depth.
fn mutilated(tokens: &TokenStream) -> Vec<TokenStream> {
    let tokens: Vec<TokenTree> = tokens.clone().into_iter().collect();
    let with = |i: usize, between: &[TokenTree]| {
        let parts = [&tokens[..i], between, &tokens[i + 1..]];
        parts.concat().into_iter().collect::<TokenStream>()
    };
    let mut found = Vec::new();
    for (i, token) in tokens.iter().enumerate() {
        found.push(with(i, &[]));
        found.push(with(i, &[token.clone(), token.clone()]));
        if let TokenTree::Group(group) = token {
            for inner in mutilated(&group.stream()) {
                let group = Group::new(group.delimiter(), inner);
                found.push(with(i, &[group.into()]));
            }
        }
    }
    found
}

#[test]
fn no_mutilated_declaration_is_lost() {
    let belt = format!("pub struct M {{ {} }}", super::BELT);
    let law = "pub struct L { param a: N where 0 <= a < 1e3; stick = a; slip(s) = a / (1.0 + s); }";
    let press = "pub struct L { param a: N/m where 0 <= a < 1e3; let b = a; force(d, v) = b * d * (1.0 + v); }";
    let rigid = "pub struct L { param e: 1 where 0 <= e < 1; rebound(v) = e * v; }";
    let rattle = "pub struct M { state y: m = 0.0; state v: m/s = 0.0; param k: N/m = 1.0; param m: kg = 1.0; \
                  press N: N = Law { stiffness: k } closing y - sin(y / 1.0); der(y) = v; der(v) = N / m; }";
    let cases = [
        (
            belt.as_str(),
            crate::expand::model as fn(TokenStream) -> TokenStream,
        ),
        (law, crate::expand::law),
        (press, crate::expand::press_law),
        (rigid, crate::expand::press_law),
        (rattle, crate::expand::model),
    ];
    for (declaration, expand) in cases {
        let tokens: TokenStream = declaration.parse().expect("the test is made of tokens");
        for tokens in mutilated(&tokens) {
            let expanded = expand(tokens.clone());
            assert!(!expanded.is_empty(), "{tokens}");
            assert!(syn::parse2::<syn::File>(expanded).is_ok(), "{tokens}");
        }
    }
}
