//! A model: its struct, its right-hand side over any scalar, and itself as data.

use std::collections::HashSet;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::lift::Lift;
use super::shell::Shell;
use super::{agreement, builder, items, page, pattern};
use crate::check::{Contact, Model, Step};
use crate::syntax::Declaration;

pub(super) fn tokens(model: &Model, written: &Declaration) -> TokenStream {
    let shell = Shell {
        header: model.header,
        page: page::of_model(model),
        parameters: &model.parameters,
    };
    let (shell, laws) = (shell.tokens(), builder::builders(written));
    let (items, agreements) = (items::tokens(model), agreement::assertions(model));
    // An edited file is a new build.
    let files = written.structures.all.iter().map(|one| &one.path);
    quote!(#shell #laws #items #agreements #(const _: &[u8] = ::core::include_bytes!(#files);)*)
}

/// The body of `rhs`: the steps that the equations need, then the rates in the order of the states.
pub(super) fn rhs(model: &Model) -> TokenStream {
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
pub(super) fn observables(model: &Model) -> TokenStream {
    if model.lets().next().is_none() {
        return quote!([]);
    }
    let all = model.steps.iter().map(Step::name).collect();
    let lift = Lift {
        scalar: quote!(f64),
        quantity: &field,
    };
    let steps = steps(model, &all, &lift);
    let names = model.lets().map(|quantity| &quantity.line.name);
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
    let lines = steps.iter().map(|step| line(step, lift));
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
    let parameters = model.parameters.iter();
    let parameters = parameters.map(|parameter| &parameter.line.name);
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
    let parameters = model.parameters.iter().map(|parameter| parameter.line);
    let parameters = parameters.map(|line| (line.docs.as_slice(), &line.name));
    let computed = steps
        .iter()
        .flat_map(|step| step.computes().into_iter().map(|name| (step.docs(), name)));
    let fields = states
        .chain(parameters)
        .chain(computed)
        .map(|(docs, name)| quote!(#(#docs)* #name: D));
    quote!(struct __Quantities<D> { #(#fields),* })
}

fn line(step: &Step, lift: &Lift) -> TokenStream {
    match step {
        Step::Let(quantity) => {
            let line = quantity.line;
            let (name, formula) = (&line.name, lift.formula(&line.formula));
            quote!(__quantities.#name = #formula;)
        }
        Step::Contact(contact) => force(contact, lift),
    }
}

/// The force of a contact, and the rates of its internal states.
fn force(contact: &Contact, lift: &Lift) -> TokenStream {
    let (scalar, line) = (&lift.scalar, contact.line);
    let (law, place) = (
        builder::name(contact),
        Literal::usize_unsuffixed(contact.place),
    );
    let fields = line.fields.iter();
    let fields = fields.map(|field| lift.formula(&field.formula));
    let law = quote!(&Self::#law::<#scalar>([#(#fields),*]));
    let (name, speed) = (&line.name, lift.formula(&line.speed));
    if let Some(rate) = &contact.rate {
        let rate = lift.formula(rate);
        return quote!(__quantities.#name = __contacts.press(#place, #law, #speed, #rate,););
    }
    if !contact.has_memory() {
        return quote!(__quantities.#name = __contacts.force(#place, #law, #speed,););
    }
    let carriers = contact.carriers.iter();
    let states = carriers
        .clone()
        .map(|carrier| lift.formula(&carrier.formula));
    let rates = carriers.map(|carrier| &carrier.rate);
    let places = (0..contact.carriers.len()).map(Literal::usize_unsuffixed);
    quote! {
        let __answer = __contacts.recall(#place, #law, [#(#states),*], #speed,);
        __quantities.#name = __answer.force;
        #(__quantities.#rates = __answer.rates[#places];)*
    }
}
