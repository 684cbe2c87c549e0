//! Models and laws as data.

use heck::ToKebabCase;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, quote};
use syn::ext::IdentExt;

use super::doc::doc;
use crate::check::{
    Bounds, Contact, LawState, Let, Memory, MemoryLaw, Model, Parameter, State, StaticLaw, Stop,
    Unit,
};

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
    let drive = drive(model);
    let memories = model.memories().enumerate();
    let memories = memories.map(|(index, line)| memory(index, line, model));
    let moving = model.moving();
    quote! {
        ::stickslip::model::ModelInfo {
            name: #name,
            command: #command,
            doc: #doc,
            states: &[#(#states),*],
            parameters: &[#(#parameters),*],
            observables: &[#(#observables),*],
            drive: #drive,
            contacts: &[#(#contacts),*],
            memories: &[#(#memories),*],
            moving: #moving,
        }
    }
}

/// The `LawInfo` of a law.
pub(super) fn of_law(law: &StaticLaw) -> TokenStream {
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

/// The `MemoryLawInfo` of a law with internal state.
pub(super) fn of_memory_law(law: &MemoryLaw) -> TokenStream {
    let (name, doc) = (text(law.header.name), doc(law.header.docs));
    let parameters = law.parameters.iter().map(law_parameter);
    let states = law.states.iter().map(law_state);
    let lets = law.lets.iter().map(|line| {
        let (name, formula) = (text(line.name), line.formula.to_string());
        quote!((#name, #formula))
    });
    let (speed, force) = (text(law.speed), law.written.to_string());
    quote! {
        ::stickslip::memory::MemoryLawInfo {
            name: #name,
            doc: #doc,
            parameters: &[#(#parameters),*],
            states: &[#(#states),*],
            abbreviations: &[#(#lets),*],
            speed: #speed,
            force: #force,
        }
    }
}

fn law_state(state: &LawState) -> TokenStream {
    let (name, doc, unit) = (text(state.name), doc(state.docs), unit(state.unit.as_ref()));
    let (equation, stop) = (state.written.to_string(), stop(state.stop.as_ref()));
    quote! {
        ::stickslip::memory::LawState {
            name: #name,
            doc: #doc,
            unit: #unit,
            equation: #equation,
            stop: #stop,
        }
    }
}

fn stop(stop: Option<&Stop>) -> TokenStream {
    let Some(stop) = stop else {
        return quote!(::core::option::Option::None);
    };
    let bound = stop.written.to_string();
    let reads = stop.bound.names().into_iter().map(text);
    quote! {
        ::core::option::Option::Some(::stickslip::memory::LawStop {
            bound: #bound,
            reads: &[#(#reads),*],
        })
    }
}

fn memory(index: usize, memory: &Memory, model: &Model) -> TokenStream {
    let line = &memory.contact;
    let (name, doc, unit) = (text(line.name), doc(line.docs), unit(line.unit.as_ref()));
    let law = super::builder::memory_name(index);
    let (fields, speed) = (fields(line), line.speed.to_string());
    let place = |name: &Ident| model.states.iter().position(|state| state.name == name);
    let carriers = memory.carriers.iter();
    let states = carriers.filter_map(|carrier| place(&carrier.state));
    let states = states.map(Literal::usize_unsuffixed);
    quote! {
        ::stickslip::model::Memory {
            name: #name,
            doc: #doc,
            unit: #unit,
            law: ::stickslip::declared::memory_info_of(Self::#law::<f64>),
            fields: #fields,
            speed: #speed,
            states: &[#(#states),*],
        }
    }
}

/// The fields of a law as a model gives them.
pub(super) fn fields(contact: &Contact) -> String {
    let fields = contact.fields.iter();
    let fields = fields.map(|field| format!("{}: {}", text(field.name), field.formula));
    fields.collect::<Vec<_>>().join(", ")
}

fn state(state: &State) -> TokenStream {
    let (name, doc, unit) = (text(state.name), doc(state.docs), unit(state.unit.as_ref()));
    let (start, equation) = (number(state.start), equation(state));
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

/// The place of the phase among the states, if there is a drive.
fn drive(model: &Model) -> TokenStream {
    if !model.driven {
        return quote!(::core::option::Option::None);
    }
    let last = Literal::usize_unsuffixed(model.states.len() - 1);
    quote!(::core::option::Option::Some(#last))
}

/// The right side of the equation; of a state that carries the memory of a law, whose it is.
pub(super) fn equation(state: &State) -> String {
    match &state.carries {
        None => state.rate.to_string(),
        Some(owner) => format!("as the law of {owner} says"),
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
    let (unit, formula) = (unit(quantity.unit.as_ref()), quantity.formula.to_string());
    quote! {
        ::stickslip::model::Observable { name: #name, doc: #doc, unit: #unit, formula: #formula }
    }
}

fn contact(index: usize, contact: &Contact) -> TokenStream {
    let (name, doc, unit) = (
        text(contact.name),
        doc(contact.docs),
        unit(contact.unit.as_ref()),
    );
    let speed_unit = self::unit(contact.speed_unit.as_ref());
    let law = super::builder::name(index);
    let (fields, speed) = (fields(contact), contact.speed.to_string());
    quote! {
        ::stickslip::model::Contact {
            name: #name,
            doc: #doc,
            unit: #unit,
            law: ::stickslip::declared::info_of(Self::#law::<f64>),
            fields: #fields,
            speed: #speed,
            speed_unit: #speed_unit,
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
    text(name).to_kebab_case()
}
