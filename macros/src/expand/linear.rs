//! The right-hand side of a model with its derivatives, differentiated line by line.

use std::collections::HashMap;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::lift::{Lift, scalar};
use super::tangent::{Quantity, Slope, Slopes, Tangents};
use super::{builder, model as whole, pattern};
use crate::check::{Contact, Model, Step};

/// The body of `linearise`.
pub(super) fn body(model: &Model) -> TokenStream {
    let needed = pattern::needed(model);
    let steps = whole::among(model, &needed);
    let lift = Lift {
        scalar: quote!(f64),
        quantity: &whole::field,
    };
    let opening = whole::opening(model, &steps, &lift.scalar);
    let mut tangents = Tangents::new(lift, independent(model));
    for step in steps {
        follow(step, model, &mut tangents);
    }
    let rates = model.states.iter().map(|state| state.rate);
    let rates: Vec<Quantity> = rates.map(|rate| tangents.formula(rate)).collect();
    let linear = gathered(&rates, &tangents);
    let lines = tangents.lines;
    quote!(#opening #lines #linear)
}

/// The direction of the design variable; the others are those of the states.
fn design(model: &Model) -> usize {
    model.states.len()
}

/// The derivatives of states and parameters.
fn independent<'a>(model: &Model<'a>) -> HashMap<&'a Ident, Slopes> {
    let states = model.states.iter().map(|state| state.name).enumerate();
    let states = states.map(|(index, name)| (name, Slopes::from([(index, Slope::One)])));
    let parameters = model.parameters.iter().enumerate();
    let parameters = parameters.map(|(index, parameter)| {
        let place = Literal::usize_unsuffixed(index);
        let slope = Slope::of(quote!(__seeds[#place]));
        (parameter.name, Slopes::from([(design(model), slope)]))
    });
    states.chain(parameters).collect()
}

/// Computes a step with its derivatives.
fn follow<'a>(step: &Step<'a>, model: &Model, tangents: &mut Tangents<'a>) {
    let name = step.name();
    let (value, slopes) = match step {
        Step::Let(quantity) => {
            let quantity = tangents.formula(quantity.formula);
            (tangents.value(&quantity), quantity.slopes)
        }
        Step::Contact(contact) => force(contact, model, tangents),
    };
    let place = whole::field(name);
    tangents.lines.extend(quote!(#place = #value;));
    tangents.known.insert(name, slopes);
}

/// A friction force by the chain rule: through the speed, the fields of its law, and the rule that decides it.
fn force(contact: &Contact, model: &Model, tangents: &mut Tangents) -> (TokenStream, Slopes) {
    let asked = Asked::of(contact, model, tangents);
    let design = design(model);
    let slopes = asked.along(design, tangents);
    let by_speed = scalar(quote!(#slopes.by_speed));
    let mut total: Slopes = asked.speed.slopes.clone();
    for slope in total.values_mut() {
        *slope = tangents.times(slope, &by_speed);
    }
    let own = tangents.bind(quote!(#slopes.along + #slopes.by_design));
    let mut through = Slopes::from([(design, Slope::of(quote!(#own)))]);
    for state in asked.moving(design) {
        let slopes = asked.along(state, tangents);
        through.insert(state, Slope::of(quote!(#slopes.along)));
    }
    (quote!(#slopes.force), tangents.sum(total, &through))
}

/// What is asked of the rule for one contact.
struct Asked {
    contact: usize,
    law: Ident,
    fields: Vec<Quantity>,
    speed: Quantity,
}

impl Asked {
    fn of(contact: &Contact, model: &Model, tangents: &mut Tangents) -> Self {
        let fields = contact.fields.iter();
        let fields: Vec<_> = fields
            .map(|field| tangents.formula(field.formula))
            .collect();
        let speed = tangents.formula(contact.speed);
        let place = whole::place(contact, model);
        let values = fields.iter().map(|field| tangents.value(field));
        let builder = builder::name(place);
        let law = quote!(Self::#builder::<f64>([#(#values),*]));
        Self {
            contact: place,
            law: tangents.bind(law),
            fields,
            speed,
        }
    }

    /// The states that the law's fields read.
    fn moving(&self, design: usize) -> Vec<usize> {
        let read = self.fields.iter().flat_map(|field| field.slopes.keys());
        let mut states: Vec<usize> = read.copied().filter(|d| *d != design).collect();
        states.sort_unstable();
        states.dedup();
        states
    }

    /// The force and its derivatives, the fields of the law moving in one direction.
    fn along(&self, direction: usize, tangents: &mut Tangents) -> Ident {
        let fields = self.fields.iter();
        let slopes = fields.map(|field| tangents.slope(&field.slopes, direction));
        let (builder, law) = (builder::name(self.contact), &self.law);
        let along = quote!(Self::#builder::<f64>([#(#slopes),*]));
        let (contact, speed) = (
            Literal::usize_unsuffixed(self.contact),
            tangents.value(&self.speed),
        );
        tangents.bind(quote!(__contacts.force(#contact, &#law, &#along, #speed)))
    }
}

/// The values and derivatives of all rates.
fn gathered(rates: &[Quantity], tangents: &Tangents) -> TokenStream {
    let states = rates.len();
    let values = rates.iter().map(|rate| tangents.value(rate));
    let row = |rate: &Quantity| {
        let row = (0..states).map(|state| tangents.slope(&rate.slopes, state));
        quote!([#(#row),*])
    };
    let rows = rates.iter().map(row);
    let design = rates
        .iter()
        .map(|rate| tangents.slope(&rate.slopes, states));
    quote! {
        ::stickslip::model::Linear {
            f: [#(#values),*],
            jacobian: [#(#rows),*],
            design: [#(#design),*],
        }
    }
}
