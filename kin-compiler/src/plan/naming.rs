//! Names for rates and partial derivatives.

use crate::algebra::Symbol;
use crate::derive::{Definition, Dependent, Derivatives, Rate, Regularity};
use crate::program::{Names, order_name};

/// Names the rates of all orders: `theta4_velocity`, `theta4_q2`.
pub(super) fn name_rates(
    names: &mut Names,
    derivatives: &Derivatives,
    inputs: usize,
    unknowns: &[usize],
    outputs: usize,
) {
    for order in 1..=derivatives.orders.len() {
        let inputs = (0..inputs).map(|index| (Symbol::Input(index), Symbol::InputRate(index, order)));
        let unknowns = unknowns
            .iter()
            .map(|&index| (Symbol::Unknown(index), Symbol::UnknownRate(index, order)));
        let outputs = (0..outputs).map(|index| (Symbol::OutputRate(index, 0), Symbol::OutputRate(index, order)));
        for (base, rate) in inputs.chain(unknowns).chain(outputs) {
            let wish = format!("{}_{}", names.of(base), order_name(order));
            names.name(rate, &wish);
        }
    }
    for symbol in derivatives.orders.iter().flatten().flat_map(Rate::symbols) {
        if let Symbol::Turning(unknown, order) = *symbol {
            let wish = format!("{}_q{order}", names.of(Symbol::Unknown(unknown)));
            names.name(*symbol, &wish);
        }
    }
    for block in &derivatives.regularity {
        if let Regularity::Factors { factors, .. } = block {
            names.name(*factors, "factors");
        }
    }
}

/// Names for the partial derivatives: `theta4_velocity_by_r3`.
pub(super) fn name_sensitivities(definitions: &[Definition], names: &mut Names) {
    for definition in definitions {
        let symbols = match definition {
            Definition::Value { symbol, .. } => std::slice::from_ref(symbol),
            Definition::System { results, .. } => results,
            Definition::Entry {
                symbol,
                row,
                unknown,
                order,
                ..
            } => {
                let row = match *row {
                    Dependent::Equation(equation) => (equation + 1).to_string(),
                    Dependent::Output(output) => names.of(Symbol::OutputRate(output, 0)).to_owned(),
                };
                let unknown = names.of(Symbol::Unknown(*unknown));
                let wish = format!("entry_{row}_{unknown}_{}", order_name(*order));
                names.name(*symbol, &wish);
                continue;
            }
        };
        for &symbol in symbols {
            let (base, parameter, order) = match symbol {
                Symbol::Sensitivity(unknown, parameter, order) => (Symbol::Unknown(unknown), parameter, order),
                Symbol::OutputSensitivity(output, parameter, order) => {
                    (Symbol::OutputRate(output, 0), parameter, order)
                }
                _ => unreachable!("sensitivities are of unknowns and outputs"),
            };
            let parameter = names.of(Symbol::Parameter(parameter));
            let wish = format!("{}_{}_by_{parameter}", names.of(base), order_name(order));
            names.name(symbol, &wish);
        }
    }
}
