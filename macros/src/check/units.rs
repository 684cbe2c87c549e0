//! Units: known symbols, and agreement wherever units are stated.

use std::collections::HashMap;

use proc_macro2::Ident;

use super::dimension::Dimension;
use crate::errors::Errors;
use crate::formula::{Formula, Kind, Operator};
use crate::syntax::{Declaration, Line, Rule, Unit};

/// The dimension of each name that has one, and of time.
#[derive(Default)]
pub(super) struct Units {
    known: HashMap<Ident, Dimension>,
    pub(super) time: Dimension,
}

impl Units {
    /// Reads the stated units and follows the `let` lines from top to bottom.
    ///
    /// Where all that is stated is `1`, the declaration is nondimensional and so is its time. Otherwise the
    /// sliding speed of a law is in m/s.
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
        if !plain {
            let speeds = written.slips().chain(written.rebounds());
            for line in speeds.chain(written.forces()) {
                let (first, rate) = (line.name.clone(), line.rate.clone());
                let of_first = match rate {
                    Some(_) => Dimension::LENGTH,
                    None => Dimension::SPEED,
                };
                units.known.entry(first).or_insert(of_first);
                if let Some(rate) = rate {
                    units.known.entry(rate).or_insert(Dimension::SPEED);
                }
            }
            for drive in written.drives() {
                units.known.insert(drive.name.clone(), Dimension::NONE);
            }
        }
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

    /// The dimension of a formula in which everything agrees, if it is known.
    pub(super) fn of_formula(&self, formula: &Formula) -> Option<Dimension> {
        let mut found = Errors::new();
        let dimension = self.measure(formula, &mut found);
        found.finish().ok().and(dimension)
    }

    /// Reports, besides, a formula that is known not to have the wanted dimension: in the words that `message` has for
    /// the two.
    pub(super) fn demand(
        &self,
        formula: &Formula,
        wanted: Option<Dimension>,
        errors: &mut Errors,
        message: impl FnOnce(Dimension, Dimension) -> String,
    ) {
        let found = self.measure(formula, errors);
        if let (Some(wanted), Some(found)) = (wanted, found)
            && wanted != found
        {
            errors.at(
                formula,
                format!("unit mismatch: {}", message(wanted, found)),
            );
        }
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
        match function.to_string().as_str() {
            "sqrt" => return inside?.to_real_power(0.5),
            "abs" => return inside,
            "sign" => return Some(Dimension::NONE),
            _ => {}
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

/// Every name with a stated unit.
fn stated(written: &Declaration) -> impl Iterator<Item = (&Ident, &Unit)> {
    let measured = written.structures.stated.iter();
    let lines = written.lines.iter().filter_map(|line| match line {
        Line::State(line) | Line::Param(line) => Some((&line.name, line.unit.as_ref()?)),
        Line::Friction(line) | Line::Press(line) => Some((&line.name, line.unit.as_ref()?)),
        _ => None,
    });
    lines.chain(measured.map(|(name, unit)| (name, unit)))
}

/// Loads at points of structures are forces, or torques where the point turns.
pub(super) fn check_loads(written: &Declaration, units: &Units, errors: &mut Errors) {
    for load in written.structures.loads.iter().filter(|load| load.si) {
        let wanted = match load.turns {
            true => Dimension::FORCE.times(Dimension::LENGTH),
            false => Dimension::FORCE,
        };
        let lines = written.lets().filter(|line| line.name == load.name);
        for Rule { formula, .. } in lines {
            units.demand(formula, Some(wanted), errors, |wanted, found| {
                format!(
                    "the load at `{}` is in {wanted}, but `{formula}` is in {found}",
                    load.place
                )
            });
        }
    }
}

/// The dimension of a stated unit; reports unknown and scaled symbols.
fn dimension_of(unit: &Unit, errors: &mut Errors) -> Option<Dimension> {
    let mut whole = Some(Dimension::NONE);
    for factor in &unit.factors {
        let sign = if factor.divides { -1 } else { 1 };
        match Dimension::of_symbol(&factor.symbol) {
            Ok(symbol) => {
                let power = symbol.to_twelfths(factor.twelfths.saturating_mul(sign));
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
    for Rule { name, formula, .. } in written.derivatives() {
        let state = written.states().find(|state| state.name == *name);
        let state = state.and_then(|state| units.of_name(&state.name));
        let wanted = state.map(|state| state.over(units.time));
        units.demand(formula, wanted, errors, |wanted, found| {
            format!("`der({name})` is in {wanted}, but `{formula}` is in {found}")
        });
    }
}

/// A drive advances so many radians in a unit of time.
pub(super) fn check_drive(written: &Declaration, units: &Units, errors: &mut Errors) {
    for Rule { name, formula, .. } in written.drives() {
        let wanted = Dimension::NONE.over(units.time);
        units.demand(formula, Some(wanted), errors, |_, found| {
            format!("the rate of `{name}` is in rad/s, but this is in {found}")
        });
    }
}

/// Both lines of a law are forces.
pub(super) fn check_law(written: &Declaration, units: &Units, errors: &mut Errors) {
    let plain = units.time == Dimension::NONE;
    let force = if plain {
        Dimension::NONE
    } else {
        Dimension::FORCE
    };
    let speed = if plain {
        Dimension::NONE
    } else {
        Dimension::SPEED
    };
    for Rule { word, formula, .. } in written.rebounds() {
        units.demand(formula, Some(speed), errors, |speed, found| {
            format!("`{word}` is a speed, in {speed}, but `{formula}` is in {found}")
        });
    }
    let reads_speed = |formula: &Formula| {
        let names = formula.names();
        written.slips().any(|slip| names.contains(&&slip.name))
    };
    let sticks = written.sticks();
    let sticks = sticks.filter(|stick| !reads_speed(&stick.formula));
    for Rule { word, formula, .. } in sticks.chain(written.slips()).chain(written.forces()) {
        units.demand(formula, Some(force), errors, |force, found| {
            format!("`{word}` is the contact's force, in {force}, but `{formula}` is in {found}")
        });
    }
}
