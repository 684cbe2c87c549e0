//! Structures as data.

use proc_macro2::{Literal, TokenStream};
use quote::quote;
use syn::ext::IdentExt;

use super::info::number;
use super::option;
use crate::check::Model;
use crate::structure::{Mode, Structure};

/// The `Structure` of a structure: all modes of its file, those first that are kept.
pub(super) fn tokens(structure: &Structure, model: &Model) -> TokenStream {
    let name = structure.name.unraw().to_string();
    let points = structure.reduced.points.iter();
    let points = points.zip(&structure.reduced.residual);
    let points = points.map(|(point, residual)| {
        let (name, turns, residual) = (&point.name, point.turns, number(*residual));
        quote!(::stickslip::model::StructurePoint { name: #name, turns: #turns, residual: #residual })
    });
    let modes = structure.reduced.modes.iter().enumerate();
    let modes = modes.map(|(k, one)| mode(&name, k, one, model));
    let kept = Literal::usize_unsuffixed(structure.kept);
    quote! {
        ::stickslip::model::Structure {
            name: #name,
            points: &[#(#points),*],
            modes: &[#(#modes),*],
            kept: #kept,
        }
    }
}

fn mode(structure: &str, k: usize, mode: &Mode, model: &Model) -> TokenStream {
    let (frequency, shape) = (number(mode.frequency), mode.shape.iter().copied());
    let shape = shape.map(number);
    let place = |what: &str, mut all: Box<dyn Iterator<Item = String> + '_>| {
        let wanted = format!("{structure}_{what}_{k}");
        let place = all.position(|known| known == wanted);
        option(place.map(|place| {
            let place = Literal::usize_unsuffixed(place);
            quote!(#place)
        }))
    };
    let states = || {
        let names = model.states.iter().map(|state| state.name.unraw());
        Box::new(names.map(|name| name.to_string()))
    };
    let parameters = model.parameters.iter();
    let parameters = parameters.map(|one| one.line.name.unraw().to_string());
    let (amplitude, rate) = (place("mode", states()), place("rate", states()));
    let share = place("share", Box::new(parameters));
    quote! {
        ::stickslip::model::StructureMode {
            frequency: #frequency,
            shape: &[#(#shape),*],
            amplitude: #amplitude,
            rate: #rate,
            share: #share,
        }
    }
}
