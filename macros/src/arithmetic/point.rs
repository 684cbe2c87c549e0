//! Points of structures: `beam.tip`, `der(beam.tip)` and `beam.tip.flexibility`.

use proc_macro2::Ident;
use syn::{Expr, ExprCall, ExprField, ExprPath, Member};

use super::Arithmetic;
use crate::formula::Kind;
use crate::structure::{Quantity, number};

const FORM: &str = "a point of a structure is written `beam.tip`, its speed `der(beam.tip)`, and what it gives way under \
     a unit load by the modes that are left out `beam.tip.flexibility`";

impl Arithmetic<'_> {
    /// The displacement of a point, or its flexibility.
    pub(super) fn point(&mut self, field: &ExprField) -> Kind {
        match (field.base.as_ref(), &field.member) {
            (Expr::Path(base), Member::Named(name)) if base.path.is_ident("self") => self.refuse(
                field,
                format!("names of the declaration stand alone: write `{name}`, not `self.{name}`"),
            ),
            (Expr::Path(base), Member::Named(point)) => {
                self.quantity(field, base, point, Quantity::Displacement)
            }
            (Expr::Field(inner), Member::Named(what)) if what == "flexibility" => {
                self.flexibility(inner)
            }
            _ => self.refuse(field, FORM),
        }
    }

    /// `der(beam.tip)`
    pub(super) fn speed(&mut self, function: &Ident, call: &ExprCall) -> Option<Kind> {
        let mut arguments = call.args.iter();
        match (arguments.next(), arguments.next()) {
            (Some(Expr::Field(field)), None) if function == "der" => {
                Some(match (field.base.as_ref(), &field.member) {
                    (Expr::Path(base), Member::Named(point)) => {
                        self.quantity(field, base, point, Quantity::Speed)
                    }
                    _ => self.refuse(field, FORM),
                })
            }
            _ => None,
        }
    }

    fn quantity(
        &mut self,
        field: &ExprField,
        base: &ExprPath,
        point: &Ident,
        quantity: Quantity,
    ) -> Kind {
        let Some(structure) = base.path.get_ident() else {
            return self.refuse(field, FORM);
        };
        match self.structures.find(structure, point, self.errors) {
            Some((found, _)) => Kind::Name(found.at(point, quantity)),
            None => self.refused(),
        }
    }

    fn flexibility(&mut self, field: &ExprField) -> Kind {
        if let (Expr::Path(base), Member::Named(point)) = (field.base.as_ref(), &field.member)
            && let Some(structure) = base.path.get_ident()
        {
            return match self.structures.find(structure, point, self.errors) {
                Some((found, index)) => {
                    Kind::Number(number(point.span(), found.flexibility(index)))
                }
                None => self.refused(),
            };
        }
        self.refuse(field, FORM)
    }
}
