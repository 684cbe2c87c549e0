//! A model: its struct, its right-hand side over any scalar, and itself as data.

use std::collections::HashSet;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::items::{Items, Sizes};
use super::lift::Lift;
use super::shell::Shell;
use super::{agreement, builder, info, linear, page, pattern};
use crate::check::{Contact, Memory, Model, Step};

pub(super) fn tokens(model: &Model) -> TokenStream {
    let shell = Shell {
        header: model.header,
        page: page::of_model(model),
        fields: model.parameters.iter().map(Into::into).collect(),
        bounded: model
            .parameters
            .iter()
            .filter_map(|parameter| parameter.bounded)
            .collect(),
    };
    let laws = builder::named(model).into_iter();
    let (shell, laws) = (shell.tokens(), builder::builders(model.header.name, laws));
    let items = items(model).tokens();
    let agreements = agreement::assertions(model);
    quote!(#shell #laws #items #agreements)
}

fn items<'a>(model: &Model<'a>) -> Items<'a> {
    let fields: Vec<&Ident> = model
        .parameters
        .iter()
        .map(|parameter| parameter.name)
        .collect();
    let places = (0..fields.len()).map(Literal::usize_unsuffixed);
    Items {
        name: model.header.name,
        sizes: Sizes {
            states: model.states.len(),
            parameters: model.parameters.len(),
            contacts: model.contacts().count(),
            observables: model.lets().count(),
        },
        info: info::of_model(model),
        kinematic: kinematic(model),
        sparsity: sparsity(model),
        values: quote!([#(self.#fields),*]),
        from_values: quote!(Self { #(#fields: __values[#places]),* }),
        rhs: rhs(model),
        entries: linear::body(model),
        observables: observables(model),
    }
}

fn kinematic(model: &Model) -> TokenStream {
    let rows = pattern::kinematic(model).into_iter().map(|row| match row {
        None => quote!(::core::option::Option::None),
        Some(state) => {
            let state = Literal::usize_unsuffixed(state);
            quote!(::core::option::Option::Some(#state))
        }
    });
    quote!([#(#rows),*])
}

fn sparsity(model: &Model) -> TokenStream {
    let rows = pattern::sparsity(model).into_iter().map(|row| {
        let columns = row.into_iter().map(Literal::usize_unsuffixed);
        quote!(&[#(#columns),*])
    });
    quote!(::stickslip::declared::pattern([#(#rows),*]))
}

/// The body of `rhs`: the steps that the equations need, then the rates in the order of the states.
fn rhs(model: &Model) -> TokenStream {
    let needed = pattern::needed(model);
    let lift = Lift {
        scalar: quote!(D),
        quantity: &field,
    };
    let steps = steps(model, &needed, &lift);
    let names: Vec<&Ident> = model.states.iter().map(|state| state.name).collect();
    let left = model.states.iter().map(|state| state.left);
    let rates = model.states.iter().map(|state| lift.formula(&state.rate));
    quote! {
        #steps
        struct __Rates<D> { #(#names: D),* }
        let __rates = __Rates { #(#left: #rates),* };
        [#(__rates.#names),*]
    }
}

/// The body of `observables`.
fn observables(model: &Model) -> TokenStream {
    if model.lets().next().is_none() {
        return quote!([]);
    }
    let all = model.steps.iter().map(Step::name).collect();
    let lift = Lift {
        scalar: quote!(f64),
        quantity: &field,
    };
    let steps = steps(model, &all, &lift);
    let names = model.lets().map(|quantity| quantity.name);
    quote! {
        #steps
        [#(__quantities.#names),*]
    }
}

/// Every quantity is a field: a field keeps its name and its span, and nothing can capture it.
pub(super) fn field(name: &Ident) -> TokenStream {
    quote!(__quantities.#name)
}

fn steps(model: &Model, wanted: &HashSet<&Ident>, lift: &Lift) -> TokenStream {
    let steps = among(model, wanted);
    let opening = opening(model, &steps, &lift.scalar);
    let lines = steps.iter().map(|step| line(step, model, lift));
    quote!(#opening #(#lines)*)
}

/// The steps of these names.
pub(super) fn among<'m, 'a>(model: &'m Model<'a>, wanted: &HashSet<&Ident>) -> Vec<&'m Step<'a>> {
    let steps = model.steps.iter();
    let wanted = |step: &&Step| step.computes().iter().any(|name| wanted.contains(name));
    steps.filter(wanted).collect()
}

/// The fields of all quantities: of states and parameters their values, of the steps nothing yet.
pub(super) fn opening(model: &Model, steps: &[&Step], scalar: &TokenStream) -> TokenStream {
    let structure = quantities(model, steps);
    let states = model.states.iter().map(|state| state.name);
    let parameters = model.parameters.iter().map(|parameter| parameter.name);
    let state_places = (0..model.states.len()).map(Literal::usize_unsuffixed);
    let parameter_places = (0..model.parameters.len()).map(Literal::usize_unsuffixed);
    let computed = steps.iter().flat_map(|step| step.computes());
    let mutable = (!steps.is_empty()).then(|| quote!(mut));
    quote! {
        #structure
        let #mutable __quantities = __Quantities {
            #(#states: __state[#state_places],)*
            #(#parameters: __params[#parameter_places],)*
            #(#computed: #scalar::from(0.0),)*
        };
    }
}

fn quantities(model: &Model, steps: &[&Step]) -> TokenStream {
    let states = model.states.iter().map(|state| (state.docs, state.name));
    let parameters = model
        .parameters
        .iter()
        .map(|parameter| (parameter.docs, parameter.name));
    let computed = steps
        .iter()
        .flat_map(|step| step.computes().into_iter().map(|name| (step.docs(), name)));
    let fields = states
        .chain(parameters)
        .chain(computed)
        .map(|(docs, name)| quote!(#(#docs)* #name: D));
    quote!(struct __Quantities<D> { #(#fields),* })
}

fn line(step: &Step, model: &Model, lift: &Lift) -> TokenStream {
    let scalar = &lift.scalar;
    match step {
        Step::Let(quantity) => {
            let (name, formula) = (quantity.name, lift.formula(quantity.formula));
            quote!(__quantities.#name = #formula;)
        }
        Step::Contact(contact) => {
            let name = contact.name;
            let index = place(contact, model);
            let (law, index) = (builder::name(index), Literal::usize_unsuffixed(index));
            let fields = contact
                .fields
                .iter()
                .map(|field| lift.formula(field.formula));
            let speed = lift.formula(contact.speed);
            quote! {
                __quantities.#name = __contacts.force(
                    #index,
                    &Self::#law::<#scalar>([#(#fields),*]),
                    #speed,
                );
            }
        }
        Step::Memory(memory) => answer(memory, model, lift),
    }
}

/// Force and rates of a law with internal state.
fn answer(memory: &Memory, model: &Model, lift: &Lift) -> TokenStream {
    let (scalar, contact) = (&lift.scalar, &memory.contact);
    let index = element(memory, model);
    let (law, index) = (
        builder::memory_name(index),
        Literal::usize_unsuffixed(index),
    );
    let fields = contact.fields.iter();
    let fields = fields.map(|field| lift.formula(field.formula));
    let (name, speed) = (contact.name, lift.formula(contact.speed));
    let carriers = memory.carriers.iter();
    let states = carriers
        .clone()
        .map(|carrier| lift.formula(&carrier.formula));
    let rates = carriers.map(|carrier| &carrier.rate);
    let places = (0..memory.carriers.len()).map(Literal::usize_unsuffixed);
    quote! {
        let __answer = __contacts.recall(
            #index,
            &Self::#law::<#scalar>([#(#fields),*]),
            [#(#states),*],
            #speed,
        );
        __quantities.#name = __answer.force;
        #(__quantities.#rates = __answer.rates[#places];)*
    }
}

/// The number of a law with internal state.
pub(super) fn element(memory: &Memory, model: &Model) -> usize {
    let mut memories = model.memories();
    memories
        .position(|other| other.contact.name == memory.contact.name)
        .unwrap_or_default()
}

/// The number of a contact.
pub(super) fn place(contact: &Contact, model: &Model) -> usize {
    let mut contacts = model.contacts();
    contacts
        .position(|other| other.name == contact.name)
        .unwrap_or_default()
}
