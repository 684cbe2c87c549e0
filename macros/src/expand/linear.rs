//! The right-hand side of a model with its derivatives, differentiated line by line.

use std::collections::HashMap;

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::lift::{Lift, scalar};
use super::tangent::{Quantity, Slope, Slopes, Tangents};
use super::{builder, model as whole, pattern};
use crate::check::{Contact, Model, Step};

/// The body of `entries`.
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
    let rates = model.states.iter().map(|state| state.rate.as_ref());
    let rates: Vec<Quantity> = rates.map(|rate| tangents.formula(rate)).collect();
    let linear = gathered(&rates, &tangents);
    let lines = tangents.lines();
    quote!(#opening #lines #linear)
}

/// The direction of the design variable; the others are those of the states.
fn design(model: &Model) -> usize {
    model.states.len()
}

/// The derivatives of states and parameters.
fn independent<'m>(model: &'m Model<'_>) -> HashMap<&'m Ident, Slopes> {
    let states = model.states.iter().map(|state| state.name).enumerate();
    let states = states.map(|(index, name)| (name, Slopes::from([(index, Slope::One)])));
    let parameters = model.parameters.iter().enumerate();
    let parameters = parameters.map(|(index, parameter)| {
        let place = Literal::usize_unsuffixed(index);
        let slope = Slope::of(quote!(__seeds[#place]));
        (&parameter.line.name, Slopes::from([(design(model), slope)]))
    });
    states.chain(parameters).collect()
}

/// Computes a step with its derivatives.
fn follow<'m>(step: &'m Step<'_>, model: &Model, tangents: &mut Tangents<'m>) {
    let computed = match step {
        Step::Let(quantity) => {
            let quantity = tangents.formula(&quantity.line.formula);
            vec![(tangents.value(&quantity), quantity.slopes)]
        }
        Step::Contact(contact) if contact.has_memory() => answer(contact, model, tangents),
        Step::Contact(contact) => vec![force(contact, model, tangents)],
    };
    for (name, (value, slopes)) in step.computes().into_iter().zip(computed) {
        let place = whole::field(name);
        tangents.assign(&place, &value);
        tangents.known.insert(name, slopes);
    }
}

/// The rates and the force of a law with internal state, in this order.
fn answer(contact: &Contact, model: &Model, tangents: &mut Tangents) -> Vec<(TokenStream, Slopes)> {
    let asked = Asked::of(contact, tangents);
    let design = design(model);
    let mut answers = vec![(design, asked.along(design, tangents))];
    for state in asked.moving(design) {
        answers.push((state, asked.along(state, tangents)));
    }
    let first = answers[0].1.clone();
    let places = (0..asked.states.len()).map(Literal::usize_unsuffixed);
    let rates = places.map(|place| quote!(rates[#place]));
    let mut chain = |part: TokenStream| {
        let by_speed = scalar(quote!(#first.#part.by_speed));
        let mut total = tangents.scaled(&asked.speed.slopes, &by_speed);
        for (place, state) in asked.states.iter().enumerate() {
            let place = Literal::usize_unsuffixed(place);
            let by_state = scalar(quote!(#first.#part.by_memory[#place]));
            let through = tangents.scaled(&state.slopes, &by_state);
            total = tangents.sum(total, &through);
        }
        let along = answers
            .iter()
            .map(|(direction, answer)| (*direction, Slope::of(quote!(#answer.#part.along))));
        let along = along.collect();
        (quote!(#first.#part.value), tangents.sum(total, &along))
    };
    let mut computed: Vec<_> = rates.map(&mut chain).collect();
    computed.push(chain(quote!(force)));
    computed
}

/// A force by the chain rule: through the speed, or the gap and its rate, the fields of its law, and the rule that decides
/// it.
fn force(contact: &Contact, model: &Model, tangents: &mut Tangents) -> (TokenStream, Slopes) {
    let asked = Asked::of(contact, tangents);
    let design = design(model);
    let slopes = asked.along(design, tangents);
    let by_first = match asked.rate {
        Some(_) => quote!(#slopes.by_gap),
        None => quote!(#slopes.by_speed),
    };
    let by_speed = scalar(by_first);
    let mut total: Slopes = asked.speed.slopes.clone();
    for slope in total.values_mut() {
        *slope = tangents.times(slope, &by_speed);
    }
    if let Some(rate) = &asked.rate {
        let by_rate = scalar(quote!(#slopes.by_rate));
        let through = tangents.scaled(&rate.slopes, &by_rate);
        total = tangents.sum(total, &through);
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
struct Asked<'a> {
    contact: &'a Contact<'a>,
    law: Ident,
    fields: Vec<Quantity>,
    /// The internal states of the law, if it has such.
    states: Vec<Quantity>,
    /// The speed, or the gap.
    speed: Quantity,
    /// The rate of the gap, if it is a press.
    rate: Option<Quantity>,
}

impl<'a> Asked<'a> {
    fn of(contact: &'a Contact<'a>, tangents: &mut Tangents) -> Self {
        let fields = contact.line.fields.iter();
        let fields: Vec<_> = fields
            .map(|field| tangents.formula(&field.formula))
            .collect();
        let speed = tangents.formula(&contact.line.speed);
        let rate = contact.rate.as_ref().map(|rate| tangents.formula(rate));
        let (builder, values) = (
            builder::name(contact),
            fields.iter().map(|field| tangents.value(field)),
        );
        let law = quote!(Self::#builder::<f64>([#(#values),*]));
        let law = tangents.bind(law);
        let carriers = contact.carriers.iter();
        let states = carriers.map(|carrier| tangents.formula(&carrier.formula));
        Self {
            contact,
            law,
            fields,
            states: states.collect(),
            speed,
            rate,
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

    /// What the law answers and its derivatives, its fields moving in one direction.
    fn along(&self, direction: usize, tangents: &mut Tangents) -> Ident {
        let fields = self.fields.iter();
        let along = fields.map(|field| tangents.slope(&field.slopes, direction));
        let (law, builder) = (&self.law, builder::name(self.contact));
        let along = quote!(Self::#builder::<f64>([#(#along),*]));
        let place = Literal::usize_unsuffixed(self.contact.place);
        let speed = tangents.value(&self.speed);
        if let Some(rate) = &self.rate {
            let rate = tangents.value(rate);
            return tangents.bind(quote!(__contacts.press(#place, &#law, &#along, #speed, #rate)));
        }
        if !self.contact.has_memory() {
            return tangents.bind(quote!(__contacts.force(#place, &#law, &#along, #speed)));
        }
        let states = self.states.iter().map(|state| tangents.value(state));
        let states = quote!([#(#states),*]);
        tangents.bind(quote!(__contacts.recall(#place, &#law, &#along, #states, #speed)))
    }
}

/// The derivatives of all rates by the states, one by one where they can differ from zero, and their values.
fn gathered(rates: &[Quantity], tangents: &Tangents) -> TokenStream {
    let states = rates.len();
    let values = rates.iter().map(|rate| tangents.value(rate));
    let entries = rates.iter().enumerate().flat_map(|(row, rate)| {
        let row = Literal::usize_unsuffixed(row);
        let columns = rate.slopes.keys().filter(move |column| **column < states);
        columns.map(move |column| {
            let slope = tangents.slope(&rate.slopes, *column);
            let column = Literal::usize_unsuffixed(*column);
            quote!(__entry(#row, #column, #slope);)
        })
    });
    let design = rates
        .iter()
        .map(|rate| tangents.slope(&rate.slopes, states));
    quote! {
        #(#entries)*
        ::stickslip::model::Rates {
            f: [#(#values),*],
            design: [#(#design),*],
        }
    }
}
