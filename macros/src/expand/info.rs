//! Models and laws as data.

use heck::ToKebabCase;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{ToTokens, quote};
use syn::Attribute;
use syn::ext::IdentExt;

use super::doc::doc;
use super::{builder, option, pattern, straight, structure};
use crate::check::{Contact, Force, Law, LawState, Let, Model, Parameter, State, Unit, Whole};
use crate::formula::Formula;
use crate::syntax::{Bound, Bounds, Friction, Header};

/// The `ModelInfo` of a model.
pub(super) fn of_model(model: &Model) -> TokenStream {
    let (head, command) = (head(model.header), command(&model.header.name));
    let states = model.states.iter().map(state);
    let parameters = model.parameters.iter().map(parameter);
    let observables = model.lets().map(observable);
    let contacts = model.contacts().map(|contact| friction(contact, model));
    // The phase is the last of the states.
    let last = Literal::usize_unsuffixed(model.states.len().saturating_sub(1));
    let drive = option(model.driven.then(|| quote!(#last)));
    let memories = model.memories().map(|contact| friction(contact, model));
    let presses = model.presses().map(|press| self::press(press, model));
    let (moving, straight) = (model.moving(), straight::is_straight(model));
    let structures = model.structures.iter();
    let structures = structures.map(|one| structure::tokens(one, model));
    quote! {
        ::stickslip::model::ModelInfo {
            #head
            command: #command,
            states: &[#(#states),*],
            parameters: &[#(#parameters),*],
            observables: &[#(#observables),*],
            drive: #drive,
            contacts: &[#(#contacts),*],
            memories: &[#(#memories),*],
            presses: &[#(#presses),*],
            moving: #moving,
            straight: #straight,
            structures: &[#(#structures),*],
        }
    }
}

/// The constant `INFO` of a law.
pub(super) fn of_law(law: &Law) -> TokenStream {
    let head = head(law.header);
    let parameters = law.parameters.iter().map(law_parameter);
    let parameters = quote!(parameters: &[#(#parameters),*]);
    match &law.force {
        Force::Static(stick, slip) => {
            let bends = bends(law, &slip.formula);
            let [stick, slip] = [stick, slip].map(|line| line.formula.to_string());
            quote! {
                const INFO: &'static ::stickslip::friction::LawInfo = &::stickslip::friction::LawInfo {
                    #head
                    #parameters,
                    stick: #stick,
                    slip: #slip,
                    bends: &[#(#bends),*],
                };
            }
        }
        Force::Press(force) => {
            let [depth, rate] = [law.speed, law.rate.unwrap_or(law.speed)].map(text);
            let bends = bends(law, &force.formula);
            let force = force.written.to_string();
            let formula = quote!(Compliant { depth: #depth, rate: #rate, force: #force });
            of_press_law(law, &head, [&parameters, &formula], bends)
        }
        Force::Rigid(rebound) => {
            let (speed, rebound) = (text(law.speed), rebound.written.to_string());
            let formula = quote!(Rigid { speed: #speed, rebound: #rebound });
            of_press_law(law, &head, [&parameters, &formula], std::iter::empty())
        }
        Force::Memory(force) => {
            let states = law.states.iter().map(law_state);
            let lets = abbreviations(law);
            let (speed, force) = (text(law.speed), force.written.to_string());
            quote! {
                const INFO: &'static ::stickslip::memory::MemoryLawInfo = &::stickslip::memory::MemoryLawInfo {
                    #head
                    #parameters,
                    states: &[#(#states),*],
                    abbreviations: &[#(#lets),*],
                    speed: #speed,
                    force: #force,
                };
            }
        }
    }
}

fn of_press_law(
    law: &Law,
    head: &TokenStream,
    [parameters, formula]: [&TokenStream; 2],
    bends: impl Iterator<Item = TokenStream>,
) -> TokenStream {
    let lets = abbreviations(law);
    quote! {
        const INFO: &'static ::stickslip::press::PressLawInfo = &::stickslip::press::PressLawInfo {
            #head
            #parameters,
            abbreviations: &[#(#lets),*],
            formula: ::stickslip::press::PressFormula::#formula,
            bends: &[#(#bends),*],
        };
    }
}

/// The pairs of names of which a force holds more than a sum.
fn bends(law: &Law, force: &Formula) -> impl Iterator<Item = TokenStream> {
    let pairs = straight::bends(law, force).into_iter();
    pairs.map(|[a, b]| {
        let (a, b) = (text(a), text(b));
        quote!((#a, #b))
    })
}

/// The fields of the law of a contact that move.
fn moving(contact: &Contact, model: &Model) -> TokenStream {
    let names = straight::moving(contact, model).into_iter().map(text);
    quote!(moving: &[#(#names),*],)
}

/// The `let` lines of a law: name and right side, as written.
fn abbreviations(law: &Law) -> impl Iterator<Item = TokenStream> {
    law.lets.iter().map(|quantity| {
        let line = quantity.line;
        let (name, formula) = (text(&line.name), line.formula.to_string());
        quote!((#name, #formula))
    })
}

fn law_state(state: &LawState) -> TokenStream {
    let named = named(&state.line.name, &state.line.docs, &state.unit);
    let (equation, stop) = (state.rate.written.to_string(), state.stop.as_ref());
    let stop = option(stop.map(stop_of));
    quote! {
        ::stickslip::memory::LawState {
            #named
            equation: #equation,
            stop: #stop,
        }
    }
}

fn stop_of(stop: &Whole) -> TokenStream {
    let bound = stop.written.to_string();
    let reads = stop.formula.names().into_iter().map(text);
    quote!(::stickslip::memory::LawStop { bound: #bound, reads: &[#(#reads),*] })
}

/// The fields of a law as a model gives them.
pub(super) fn fields(line: &Friction) -> String {
    let fields = line.fields.iter();
    let fields = fields.map(|field| format!("{}: {}", text(&field.name), field.formula));
    fields.collect::<Vec<_>>().join(", ")
}

fn state(state: &State) -> TokenStream {
    let named = named(state.name, state.docs, &state.unit);
    let (start, equation) = (number(state.start), equation(state));
    quote!(::stickslip::model::State { #named start: #start, equation: #equation })
}

/// The right side of the equation; of a state that carries the memory of a law, whose it is.
pub(super) fn equation(state: &State) -> String {
    match &state.carries {
        None => state.rate.to_string(),
        Some(owner) => format!("as the law of {owner} says"),
    }
}

fn parameter(parameter: &Parameter) -> TokenStream {
    let line = parameter.line;
    let named = named(&line.name, &line.docs, &parameter.unit);
    let default = number(line.number.as_ref().map_or(0.0, |number| number.value));
    let bounds = bounds(line.bounds.as_ref());
    quote!(::stickslip::model::Parameter { #named default: #default, bounds: #bounds })
}

fn law_parameter(parameter: &Parameter) -> TokenStream {
    let line = parameter.line;
    let named = named(&line.name, &line.docs, &parameter.unit);
    let bounds = bounds(line.bounds.as_ref());
    quote!(::stickslip::friction::LawParameter { #named bounds: #bounds })
}

fn observable(quantity: &Let) -> TokenStream {
    let line = quantity.line;
    let named = named(&line.name, &line.docs, &quantity.unit);
    let formula = line.formula.to_string();
    quote!(::stickslip::model::Observable { #named formula: #formula })
}

fn friction(contact: &Contact, model: &Model) -> TokenStream {
    let line = contact.line;
    let named = named(&line.name, &line.docs, &contact.unit);
    let law = builder::info(&quote!(Self), contact);
    let (fields, speed) = (fields(line), line.speed.to_string());
    let speed_unit = unit(&contact.speed_unit);
    let place = |name: &Ident| model.states.iter().position(|state| state.name == name);
    let states = line.memory.iter().filter_map(place);
    let states = states.map(Literal::usize_unsuffixed);
    let presses = pattern::presses_of(contact, model).into_iter();
    let presses = presses.map(Literal::usize_unsuffixed);
    let moving = moving(contact, model);
    quote! {
        ::stickslip::model::Friction {
            #named
            law: #law,
            fields: #fields,
            speed: #speed,
            speed_unit: #speed_unit,
            states: &[#(#states),*],
            presses: &[#(#presses),*],
            #moving
        }
    }
}

fn press(contact: &Contact, model: &Model) -> TokenStream {
    let (line, moving) = (contact.line, moving(contact, model));
    let named = named(&line.name, &line.docs, &contact.unit);
    let law = builder::info(&quote!(Self), contact);
    let (fields, gap, gap_unit) = (
        fields(line),
        line.speed.to_string(),
        unit(&contact.speed_unit),
    );
    quote! {
        ::stickslip::model::Press {
            #named
            law: #law,
            fields: #fields,
            gap: #gap,
            gap_unit: #gap_unit,
            #moving
        }
    }
}

fn head(header: &Header) -> TokenStream {
    let (name, doc) = (text(&header.name), doc(&header.docs));
    quote!(name: #name, doc: #doc,)
}

fn named(name: &Ident, docs: &[Attribute], unit: &Option<Unit>) -> TokenStream {
    let (name, doc, unit) = (text(name), doc(docs), self::unit(unit));
    quote!(name: #name, doc: #doc, unit: #unit,)
}

fn unit(unit: &Option<Unit>) -> TokenStream {
    option(unit.as_ref().map(|unit| {
        let text = &unit.text;
        let exponents = unit.dimension.exponents().unwrap_or_default();
        let exponents = exponents.map(Literal::i16_unsuffixed);
        quote!(::stickslip::model::Unit { text: #text, dimension: [#(#exponents),*] })
    }))
}

fn bounds(bounds: Option<&Bounds>) -> TokenStream {
    let end = |end: Option<&Bound>| {
        option(end.map(|bound| {
            let (value, inclusive) = (number(bound.number.value), bound.inclusive);
            quote!(::stickslip::model::Bound { value: #value, inclusive: #inclusive })
        }))
    };
    let lower = end(bounds.and_then(|bounds| bounds.lower.as_ref()));
    let upper = end(bounds.and_then(|bounds| bounds.upper.as_ref()));
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
fn command(name: &Ident) -> String {
    text(name).to_kebab_case()
}
