//! Models and laws as data.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, quote};
use syn::ext::IdentExt;
use syn::{Attribute, Expr, ExprLit, Lit, Meta};

use crate::check::{Bounds, Contact, Law, Let, Model, Parameter, State, Unit};

/// The `ModelInfo` of a model.
pub(super) fn of_model(model: &Model) -> TokenStream {
    let (name, command) = (text(model.header.name), command(model.header.name));
    let doc = doc(model.header.docs);
    let states = model.states.iter().map(state);
    let parameters = model.parameters.iter().map(parameter);
    let observables = model.lets().map(observable);
    let contacts = model
        .contacts()
        .enumerate()
        .map(|(index, line)| contact(index, line));
    quote! {
        ::stickslip::model::ModelInfo {
            name: #name,
            command: #command,
            doc: #doc,
            states: &[#(#states),*],
            parameters: &[#(#parameters),*],
            observables: &[#(#observables),*],
            contacts: &[#(#contacts),*],
        }
    }
}

/// The `LawInfo` of a law.
pub(super) fn of_law(law: &Law) -> TokenStream {
    let (name, doc) = (text(law.header.name), doc(law.header.docs));
    let parameters = law.parameters.iter().map(law_parameter);
    let (stick, slip) = (law.stick.to_string(), law.slip.to_string());
    quote! {
        ::stickslip::friction::LawInfo {
            name: #name,
            doc: #doc,
            parameters: &[#(#parameters),*],
            stick: #stick,
            slip: #slip,
        }
    }
}

fn state(state: &State) -> TokenStream {
    let (name, doc, unit) = (text(state.name), doc(state.docs), unit(state.unit.as_ref()));
    let (start, equation) = (number(state.start), state.rate.to_string());
    quote! {
        ::stickslip::model::State {
            name: #name,
            doc: #doc,
            unit: #unit,
            start: #start,
            equation: #equation,
        }
    }
}

fn parameter(parameter: &Parameter) -> TokenStream {
    let (name, doc) = (text(parameter.name), doc(parameter.docs));
    let (unit, bounds) = (unit(parameter.unit.as_ref()), bounds(&parameter.bounds));
    let default = number(parameter.default.unwrap_or_default());
    quote! {
        ::stickslip::model::Parameter {
            name: #name,
            doc: #doc,
            unit: #unit,
            default: #default,
            bounds: #bounds,
        }
    }
}

fn law_parameter(parameter: &Parameter) -> TokenStream {
    let (name, doc) = (text(parameter.name), doc(parameter.docs));
    let (unit, bounds) = (unit(parameter.unit.as_ref()), bounds(&parameter.bounds));
    quote! {
        ::stickslip::friction::LawParameter {
            name: #name,
            doc: #doc,
            unit: #unit,
            bounds: #bounds,
        }
    }
}

fn observable(quantity: &Let) -> TokenStream {
    let (name, doc) = (text(quantity.name), doc(quantity.docs));
    let formula = quantity.formula.to_string();
    quote!(::stickslip::model::Observable { name: #name, doc: #doc, formula: #formula })
}

fn contact(index: usize, contact: &Contact) -> TokenStream {
    let (name, doc, unit) = (
        text(contact.name),
        doc(contact.docs),
        unit(contact.unit.as_ref()),
    );
    let law = super::builder::name(index);
    let fields = contact
        .fields
        .iter()
        .map(|field| format!("{}: {}", text(field.name), field.formula));
    let (fields, speed) = (
        fields.collect::<Vec<_>>().join(", "),
        contact.speed.to_string(),
    );
    quote! {
        ::stickslip::model::Contact {
            name: #name,
            doc: #doc,
            unit: #unit,
            law: ::stickslip::declared::info_of(Self::#law::<f64>),
            fields: #fields,
            speed: #speed,
        }
    }
}

fn unit(unit: Option<&Unit>) -> TokenStream {
    let Some(unit) = unit else {
        return quote!(::core::option::Option::None);
    };
    let text = &unit.text;
    let exponents = unit.dimension.exponents().unwrap_or_default();
    let exponents = exponents.map(Literal::i8_unsuffixed);
    quote! {
        ::core::option::Option::Some(::stickslip::model::Unit {
            text: #text,
            dimension: [#(#exponents),*],
        })
    }
}

fn bounds(bounds: &Bounds) -> TokenStream {
    let end = |end: Option<(f64, bool)>| match end {
        None => quote!(::core::option::Option::None),
        Some((value, inclusive)) => {
            let value = number(value);
            quote! {
                ::core::option::Option::Some(::stickslip::model::Bound {
                    value: #value,
                    inclusive: #inclusive,
                })
            }
        }
    };
    let (lower, upper) = (end(bounds.lower), end(bounds.upper));
    quote!(::stickslip::model::Bounds { lower: #lower, upper: #upper })
}

/// A number with its sign.
pub(super) fn number(value: f64) -> TokenStream {
    let magnitude = Literal::f64_suffixed(value.abs());
    if value.is_sign_negative() {
        quote!(-#magnitude)
    } else {
        magnitude.into_token_stream()
    }
}

fn text(name: &Ident) -> String {
    name.unraw().to_string()
}

/// The name on the command line: `BeltOscillator` is `belt-oscillator`.
pub(super) fn command(name: &Ident) -> String {
    let letters: Vec<char> = text(name).chars().collect();
    let mut command = String::new();
    for (i, letter) in letters.iter().enumerate() {
        let after_small = i > 0 && !letters[i - 1].is_uppercase();
        let before_small = letters.get(i + 1).is_some_and(|next| next.is_lowercase());
        let begins_word = i > 0 && letter.is_uppercase() && (after_small || before_small);
        if begins_word && !command.ends_with('-') {
            command.push('-');
        }
        command.extend(if *letter == '_' {
            vec!['-']
        } else {
            letter.to_lowercase().collect()
        });
    }
    command
}

/// Doc comments as one text, without the space after the slashes.
pub(super) fn doc(docs: &[Attribute]) -> String {
    let lines: Vec<String> = docs.iter().filter_map(doc_line).collect();
    lines.join("\n").trim().to_owned()
}

fn doc_line(attribute: &Attribute) -> Option<String> {
    let Meta::NameValue(doc) = &attribute.meta else {
        return None;
    };
    let Expr::Lit(ExprLit {
        lit: Lit::Str(line),
        ..
    }) = &doc.value
    else {
        return None;
    };
    let line = line.value();
    Some(
        line.strip_prefix(' ')
            .unwrap_or(&line)
            .trim_end()
            .to_owned(),
    )
}
