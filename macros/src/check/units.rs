//! Units: known symbols, and agreement wherever units are stated.

use std::collections::HashMap;

use proc_macro2::Ident;

use super::dimension::Dimension;
use crate::errors::Errors;
use crate::syntax::{Declaration, Formula, Kind, Line, Operator, Unit};

/// The dimension of each name that has one, and of time.
pub(super) struct Units {
    known: HashMap<Ident, Dimension>,
    time: Dimension,
}

impl Units {
    /// Reads the stated units and follows the `let` lines from top to bottom.
    ///
    /// Where all that is stated is `1`, the model is nondimensional and so is its time.
    pub(super) fn of(written: &Declaration, errors: &mut Errors) -> Self {
        let stated: Vec<(&Ident, Dimension)> = stated(written)
            .filter_map(|(name, unit)| Some((name, dimension_of(unit, errors)?)))
            .collect();
        let plain = stated
            .iter()
            .all(|(_, dimension)| *dimension == Dimension::NONE);
        let time = if plain {
            Dimension::NONE
        } else {
            Dimension::TIME
        };
        let known = stated
            .into_iter()
            .map(|(name, dimension)| (name.clone(), dimension))
            .collect();
        let mut units = Self { known, time };
        for line in &written.lines {
            if let Line::Let(quantity) = line
                && let Some(dimension) = units.measure(&quantity.formula, errors)
            {
                units.known.insert(quantity.name.clone(), dimension);
            }
        }
        units
    }

    /// The dimension of a name, if one is known.
    pub(super) fn of_name(&self, name: &Ident) -> Option<Dimension> {
        self.known.get(name).copied()
    }

    /// The dimension of a formula, if it is known; reports what does not agree inside it.
    pub(super) fn measure(&self, formula: &Formula, errors: &mut Errors) -> Option<Dimension> {
        match &formula.kind {
            Kind::Number(_) | Kind::Constant(_) => None,
            Kind::Name(name) => self.of_name(name),
            Kind::Group(inner) | Kind::Minus(inner) => self.measure(inner, errors),
            Kind::Binary(left, operator, right) => self.combined(left, *operator, right, errors),
            Kind::Call(function, argument) => self.call(function, argument, errors),
            Kind::Power(base, exponent) => Some(self.measure(base, errors)?.to_power(*exponent)),
            Kind::RealPower(_, base, exponent) => self.real_power(base, exponent, errors),
        }
    }

    fn combined(
        &self,
        left: &Formula,
        operator: Operator,
        right: &Formula,
        errors: &mut Errors,
    ) -> Option<Dimension> {
        let (l, r) = (self.measure(left, errors), self.measure(right, errors));
        match operator {
            Operator::Multiply => Some(l?.times(r?)),
            Operator::Divide => Some(l?.over(r?)),
            Operator::Add | Operator::Subtract => {
                if let (Some(l), Some(r)) = (l, r)
                    && l != r
                {
                    errors.at(
                        right,
                        format!("unit mismatch: `{left}` is in {l}, but `{right}` is in {r}"),
                    );
                    return None;
                }
                l.or(r)
            }
        }
    }

    fn call(&self, function: &Ident, argument: &Formula, errors: &mut Errors) -> Option<Dimension> {
        let inside = self.measure(argument, errors);
        if function == "sqrt" {
            return inside?.to_real_power(0.5);
        }
        match inside {
            Some(dimension) if dimension != Dimension::NONE => {
                errors.at(argument, format!(
                    "unit mismatch: the argument of `{function}` must be a plain number, but `{argument}` is in {dimension}"
                ));
                None
            }
            _ => Some(Dimension::NONE),
        }
    }

    fn real_power(
        &self,
        base: &Formula,
        exponent: &Formula,
        errors: &mut Errors,
    ) -> Option<Dimension> {
        let (inside, power) = (self.measure(base, errors), self.measure(exponent, errors));
        if let Some(dimension) = power
            && dimension != Dimension::NONE
        {
            errors.at(exponent, format!(
                "unit mismatch: an exponent must be a plain number, but `{exponent}` is in {dimension}"
            ));
        }
        let inside = inside?;
        if let Kind::Number(number) = &exponent.bare().kind {
            return inside.to_real_power(number.value);
        }
        if inside == Dimension::NONE {
            return Some(inside);
        }
        errors.at(base, format!(
            "unit mismatch: what is raised to `{exponent}` must be a plain number, but `{base}` is in {inside}"
        ));
        None
    }
}

/// Every name with a stated unit; the sliding speed of a law is in m/s.
fn stated(written: &Declaration) -> impl Iterator<Item = (&Ident, &Unit)> {
    written.lines.iter().filter_map(|line| match line {
        Line::State(line) => Some((&line.name, line.unit.as_ref()?)),
        Line::Param(line) => Some((&line.name, line.unit.as_ref()?)),
        Line::Friction(line) => Some((&line.name, line.unit.as_ref()?)),
        _ => None,
    })
}

/// The dimension of a stated unit; reports unknown and scaled symbols.
fn dimension_of(unit: &Unit, errors: &mut Errors) -> Option<Dimension> {
    let mut whole = Some(Dimension::NONE);
    for factor in &unit.factors {
        let sign = if factor.divides { -1 } else { 1 };
        match Dimension::of_symbol(&factor.symbol) {
            Ok(symbol) => {
                let power = symbol.to_power(factor.exponent.saturating_mul(sign));
                whole = whole.map(|before| before.times(power));
            }
            Err(message) => {
                errors.at(&factor.symbol, message);
                whole = None;
            }
        }
    }
    if whole.is_some_and(|dimension| dimension.exponents().is_none()) {
        errors.at(unit, "the exponents of this unit are too large");
        return None;
    }
    whole
}

/// The unit of each equation is that of its state over time.
pub(super) fn check_equations(written: &Declaration, units: &Units, errors: &mut Errors) {
    for line in &written.lines {
        match line {
            Line::Derivative(line) => {
                let found = units.measure(&line.formula, errors);
                let state = units
                    .of_name(&line.state)
                    .map(|state| state.over(units.time));
                if let (Some(wanted), Some(found)) = (state, found)
                    && wanted != found
                {
                    let name = &line.state;
                    errors.at(
                        &line.formula,
                        format!(
                            "unit mismatch: `der({name})` is in {wanted}, but this is in {found}"
                        ),
                    );
                }
            }
            Line::Friction(line) => {
                for field in &line.fields {
                    units.measure(&field.formula, errors);
                }
                units.measure(&line.speed, errors);
            }
            _ => {}
        }
    }
}

/// Both lines of a law are forces.
pub(super) fn check_law(written: &Declaration, units: &Units, errors: &mut Errors) {
    let sticks = written.sticks().map(|stick| ("stick", &stick.formula));
    let slips = written.slips().map(|slip| ("slip", &slip.formula));
    for (line, formula) in sticks.chain(slips) {
        if let Some(found) = units.measure(formula, errors)
            && found != Dimension::FORCE
        {
            errors.at(
                formula,
                format!(
                    "unit mismatch: `{line}` is the contact's force, in N, but this is in {found}"
                ),
            );
        }
    }
}
